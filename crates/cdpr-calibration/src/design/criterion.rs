//! Measures of what a set of poses tells (eq. 4.19–4.23).

use nalgebra::{Cholesky, DMatrix};

use cdpr_model::reading::keywords;
use cdpr_model::scalar::decomposition::symmetric_eigen;

/// Measure of a design.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DesignCriterion {
    /// Largest det M: the smallest volume of the parameters' confidence ellipsoid.
    #[default]
    D,
    /// Smallest tr M⁻¹: the least mean variance of the parameters, counted in metres of cable.
    A,
    /// Largest smallest eigenvalue of M: the direction that is known least, counted in metres of cable.
    E,
    /// Smallest mean variance of all lengths over the candidates.
    I,
    /// Smallest κ of the Jacobian, counted in metres of cable.
    Condition,
    /// Poses of a plain grid, whatever they tell.
    Factorial,
}

keywords!(DesignCriterion: D = "d", A = "a", E = "e", I = "i", Condition = "condition", Factorial = "factorial");

impl DesignCriterion {
    /// Score of a block of M, in the unit of its `scales` (m); smaller is better. Blocks join by [`DesignCriterion::joined`].
    pub(super) fn of_block(self, block: &DMatrix<f64>, region: &DMatrix<f64>, scales: &[f64]) -> BlockScore {
        match self {
            Self::D | Self::Factorial => BlockScore::Sum(log_det(block).map_or(f64::INFINITY, |log_det| -log_det)),
            Self::A | Self::I => BlockScore::Sum(inverse(block).map_or(f64::INFINITY, |inverse| match self {
                Self::A => (0..scales.len()).map(|k| inverse[(k, k)] * scales[k] * scales[k]).sum(),
                _ => inverse.component_mul(region).sum(),
            })),
            Self::E | Self::Condition => {
                let scaled =
                    DMatrix::from_fn(scales.len(), scales.len(), |i, j| block[(i, j)] / (scales[i] * scales[j]));
                let values = symmetric_eigen(scaled).map(|found| found.eigenvalues);
                let ends = values.map_or((0.0, 0.0), |values| (values.min().max(0.0), values.max()));
                BlockScore::Ends(ends.0, ends.1)
            }
        }
    }

    /// Score of all blocks together; smaller is better.
    pub(super) fn joined(self, scores: impl Iterator<Item = BlockScore>) -> f64 {
        let (mut sum, mut smallest, mut largest) = (0.0, f64::INFINITY, 0.0_f64);
        for score in scores {
            match score {
                BlockScore::Sum(own) => sum += own,
                BlockScore::Ends(least, most) => (smallest, largest) = (smallest.min(least), largest.max(most)),
            }
        }
        match self {
            Self::E => -smallest,
            Self::Condition => largest / smallest,
            _ => sum,
        }
    }
}

/// Part of a score that a block of M has.
#[derive(Clone, Copy)]
pub(super) enum BlockScore {
    /// Summand.
    Sum(f64),
    /// Smallest and largest eigenvalue.
    Ends(f64, f64),
}

/// log det of a positive definite matrix; `None` where it is not.
pub(super) fn log_det(matrix: &DMatrix<f64>) -> Option<f64> {
    let factor = Cholesky::new(matrix.clone())?;
    let sum: f64 = factor.l_dirty().diagonal().iter().map(|entry| entry.ln()).sum();
    Some(2.0 * sum).filter(|log_det| log_det.is_finite())
}

/// Inverse of a positive definite matrix; `None` where it is not.
pub(super) fn inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    Some(Cholesky::new(matrix.clone())?.inverse())
}
