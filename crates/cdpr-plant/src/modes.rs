//! Natural frequencies and mode shapes of small motions.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::linearization::Linearization;
use cdpr_model::scalar::decomposition::{eigenvalues, symmetric_eigen};
use cdpr_model::statics::Stability;

/// Asymmetry of M⁻¹ K, as a fraction of its largest entry, that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// A mode of small, undamped motions.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Natural frequency (Hz); −√(−λ)/2π, thus negative, if the motion grows; 0 if its stiffness counts as zero.
    pub frequency: f64,
    /// Stiffness along the mode (N/m): φᵀ K φ over the squared path length of φ, with rotations at the platform radius
    /// and drums at theirs.
    pub stiffness: f64,
    /// Stability under a small displacement along the mode.
    pub stability: Stability,
    /// Damping by the dampers as a fraction of critical damping; NaN if the mode does not oscillate.
    pub damping_ratio: f64,
    /// Shape: displacements along the degrees of freedom (m, rad), then angles of drums (rad), for modal mass 1.
    pub shape: DVector<f64>,
    /// Fraction of each degree of freedom in the kinetic energy of the mode; the fractions add up to 1.
    pub participation: DVector<f64>,
}

impl Linearization {
    /// Modes of M δz̈ + K δz = 0, as many as there are degrees of freedom, slowest first; `None` if a mass is missing,
    /// or if an eigenvalue is complex (constant moments may make the stiffness so unsymmetric).
    pub fn modes(&self) -> Option<Vec<Mode>> {
        let lower = self.mass.clone().cholesky()?.l();
        // with M = L Lᵀ the eigenvalues of M⁻¹ K are those of L⁻¹ K L⁻ᵀ
        let half = lower.solve_lower_triangular(&self.stiffness)?;
        let whole = lower.solve_lower_triangular(&half.transpose())?.transpose();
        let pairs = match (&whole - whole.transpose()).amax() <= ROUNDING * whole.amax() {
            true => symmetric(whole)?,
            false => unsymmetric(&whole)?,
        };
        let mode = |(value, vector): (f64, DVector<f64>)| {
            let shape = lower.transpose().solve_upper_triangular(&vector)?;
            Some(self.mode(value, shape))
        };
        let mut modes = pairs.into_iter().map(mode).collect::<Option<Vec<_>>>()?;
        modes.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
        Some(modes)
    }

    fn mode(&self, value: f64, shape: DVector<f64>) -> Mode {
        let momentum = &self.mass * &shape;
        let modal_mass = shape.dot(&momentum);
        let stiffness = value * modal_mass / shape.component_mul(&self.ways).norm_squared();
        let stability = Stability::of(stiffness, self.indifferent_stiffness);
        let omega = match stability {
            Stability::Indifferent => 0.0,
            _ => value.abs().sqrt().copysign(value),
        };
        let damping = shape.dot(&(&self.damping * &shape)) / modal_mass;
        Mode {
            frequency: omega / TAU,
            stiffness,
            stability,
            damping_ratio: if omega > 0.0 { damping / (2.0 * omega) } else { f64::NAN },
            participation: shape.component_mul(&momentum) / modal_mass,
            shape: shape / modal_mass.sqrt(),
        }
    }
}

fn symmetric(matrix: DMatrix<f64>) -> Option<Vec<(f64, DVector<f64>)>> {
    let eigen = symmetric_eigen(matrix)?;
    let vectors = eigen.eigenvectors.column_iter().map(|column| column.into_owned());
    Some(eigen.eigenvalues.iter().copied().zip(vectors).collect())
}

/// Real eigenvalues with their vectors by inverse iteration; `None` if an eigenvalue is complex.
fn unsymmetric(matrix: &DMatrix<f64>) -> Option<Vec<(f64, DVector<f64>)>> {
    let size = matrix.nrows();
    let largest = matrix.amax();
    let pair = |(index, value): (usize, nalgebra::Complex<f64>)| {
        if value.im.abs() > 1e-7 * largest {
            return None;
        }
        let shift = value.re + 1e-10 * largest;
        let factors = (matrix - DMatrix::identity(size, size) * shift).lu();
        // different starts find different vectors of a multiple eigenvalue
        let mut vector = DVector::from_fn(size, |row, _| if row == index { 1.0 } else { 0.1 });
        for _ in 0..4 {
            vector = factors.solve(&vector)?.normalize();
        }
        Some((value.re, vector))
    };
    eigenvalues(matrix.clone())?.into_iter().enumerate().map(pair).collect()
}
