//! Residual vectors of samples with their derivatives: what every loss of an objective is made of.

use nalgebra::{DMatrix, DVector};

use super::dense::DenseEquations;
use cdpr_model::geometry::Pose;

/// Residual vectors of all samples, one after the other, and their derivatives by the free parameters.
#[derive(Debug)]
pub(crate) struct Stacked {
    /// Entries of one sample's vector.
    pub(super) size: usize,
    /// Unknowns of all samples that are eliminated from their vectors.
    pub(super) unknowns: usize,
    /// Rows of data, and rows behind them that fix by convention what no data tell.
    pub(super) rows: (usize, usize),
    pub(crate) residuals: DVector<f64>,
    /// A row for each residual, a column for each parameter.
    pub(crate) jacobian: DMatrix<f64>,
}

/// Samples whose vectors are told as outliers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outliers {
    /// Those beyond the limit at the optimum.
    Own,
    /// Those beyond it at the optimum of least squares, too: errors of predicted poses are large where the model lacks something or cables hold the
    /// platform weakly, and a robust loss drives such errors into few samples, of which no row is wrong.
    Witnessed,
}

/// Pose and tensions of the platform in one sample, where they are eliminated from its vector.
#[derive(Clone, Debug)]
pub(crate) struct Latent {
    pub(crate) pose: Pose,
    /// As they would be recorded (N); empty if tensions are no unknowns.
    pub(crate) tensions: Vec<f64>,
}

/// Residual vectors as functions of the free parameters.
pub(crate) trait Vectors {
    /// Steps after which a descent from another start than the file's values is given up; `None` if it has as many as any.
    fn patience(&self) -> Option<u32> {
        None
    }

    /// Entries of one sample's vector.
    fn size(&self) -> usize;

    /// Unknowns of all samples that are eliminated from their vectors.
    fn unknowns(&self) -> usize {
        0
    }

    /// Number of samples.
    fn samples(&self) -> usize;

    /// Rows of data, and rows behind them that fix by convention what no data tell: as many directions of the parameters.
    fn rows(&self) -> (usize, usize) {
        (self.size() * self.samples(), 0)
    }

    /// A descent begins: it shall not depend on those before.
    fn restart(&mut self) {}

    /// A descent has ended at these values: seeks what is eliminated from the vectors from other places, too; true where a vector is shorter there, which is taken.
    fn seek_again(&mut self, _values: &[f64]) -> bool {
        false
    }

    /// Pose and tensions that are eliminated from each sample's vector, as found last; empty if no unknown is.
    fn latents(&self) -> Vec<Latent> {
        Vec::new()
    }

    /// Goes on from what another descent has found.
    fn go_on_from(&mut self, _latents: &[Latent]) {}

    /// Writes Σ rᵀr, Jᵀr and JᵀJ at parameter values in a shorter way than by the vectors; false where there is none.
    fn write_squares(&mut self, _values: &[f64], _equations: &mut DenseEquations) -> bool {
        false
    }

    /// Outliers among the samples; `None` if none is looked for.
    fn outliers(&self) -> Option<Outliers> {
        None
    }

    /// ‖r‖² of every sample with the values at which squares were written last; `None` if only the vectors tell.
    fn squares(&self) -> Option<(&[f64], Vec<f64>)> {
        None
    }

    /// Writes vectors and derivatives at parameter values; false where a sample has none.
    fn write(&mut self, values: &[f64], stacked: &mut Stacked) -> bool;
}

impl Clone for Stacked {
    fn clone(&self) -> Self {
        Self { residuals: self.residuals.clone(), jacobian: self.jacobian.clone(), ..*self }
    }

    fn clone_from(&mut self, other: &Self) {
        (self.size, self.unknowns, self.rows) = (other.size, other.unknowns, other.rows);
        self.residuals.copy_from(&other.residuals);
        self.jacobian.copy_from(&other.jacobian);
    }
}

impl Stacked {
    /// Room for the vectors of so many parameters.
    pub(crate) fn new(vectors: &impl Vectors, parameters: usize) -> Self {
        let rows = vectors.size() * vectors.samples();
        Self {
            size: vectors.size(),
            unknowns: vectors.unknowns(),
            rows: vectors.rows(),
            residuals: DVector::zeros(rows),
            jacobian: DMatrix::zeros(rows, parameters),
        }
    }

    /// Entries of one sample's vector.
    pub(crate) fn row_count(&self) -> usize {
        self.size
    }

    /// Entries of all vectors that no unknown of a sample explains.
    pub(crate) fn free_rows(&self) -> usize {
        self.residuals.len().saturating_sub(self.unknowns)
    }

    /// Number of samples.
    pub(super) fn samples(&self) -> usize {
        self.residuals.len() / self.size
    }

    /// ‖r‖² of a sample.
    pub(super) fn square(&self, sample: usize) -> f64 {
        self.residuals.rows(sample * self.size, self.size).norm_squared()
    }

    /// Jᵀ r of a sample: half the derivative of its square.
    pub(super) fn gradient(&self, sample: usize) -> DVector<f64> {
        let rows = self.jacobian.rows(sample * self.size, self.size);
        rows.tr_mul(&self.residuals.rows(sample * self.size, self.size))
    }

    /// Multiplies vector and derivatives of a sample.
    pub(super) fn scale(&mut self, sample: usize, factor: f64) {
        self.residuals.rows_mut(sample * self.size, self.size).scale_mut(factor);
        self.jacobian.rows_mut(sample * self.size, self.size).scale_mut(factor);
    }

    /// True where every number is one.
    pub(crate) fn is_finite(&self) -> bool {
        // without an early end, several numbers at once
        let are_finite = |numbers: &[f64]| numbers.iter().fold(true, |all, number| all & number.is_finite());
        are_finite(self.residuals.as_slice()) && are_finite(self.jacobian.as_slice())
    }
}
