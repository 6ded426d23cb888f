//! Cholesky factors of the rows' covariances, sample by sample.

use super::rows::{RowModel, Sigmas};
use crate::identification::fit::ASSUMED_NOISE;
use crate::measurement::Samples;

/// Share of the mean tension assumed as the force sensors' noise where none is stated.
const ASSUMED_TENSION_SHARE: f64 = 0.01;

/// Whitening of every sample: the lower Cholesky factor of its covariance, each diagonal entry inverted.
#[derive(Clone, Debug)]
pub(super) struct Whitening {
    /// Rows of one sample.
    pub(super) count: usize,
    /// Row-major factors, one after the other.
    factors: Vec<f64>,
    /// False when no sensor accuracy is known, so that only the ratio of the rows' weights is assumed.
    pub(super) absolute: bool,
}

/// What the weights take for the sensors' accuracies, and whether any of it was stated.
///
/// An accuracy that is not stated counts as exact beside a stated one of the same kind of row; floors far below any
/// sensor keep the covariances regular.
pub(super) fn sigmas(samples: &Samples, mean_tension: f64) -> (Sigmas, bool) {
    let stated = samples.sigmas;
    let absolute = stated.length.is_some() || stated.position.is_some() || stated.tension.is_some();
    let length_rows_known = stated.length.is_some() || stated.position.is_some();
    let assumed_length = if length_rows_known { 0.0 } else { ASSUMED_NOISE };
    let sigmas = Sigmas {
        position: stated.position.unwrap_or(0.0),
        rotation: stated.rotation.unwrap_or(0.0),
        length: stated.length.unwrap_or(assumed_length).max(1e-6),
        tension: stated.tension.unwrap_or(ASSUMED_TENSION_SHARE * mean_tension).max(1e-6 * mean_tension).max(1e-9),
    };
    (sigmas, absolute)
}

impl Whitening {
    /// The factors at a model's parameters; `None` when a covariance is not positive definite, which only numbers that are
    /// not finite can make it.
    pub(super) fn new(
        model: &RowModel<'_>,
        samples: &Samples,
        tensions: &[f64],
        sigmas: &Sigmas,
        absolute: bool,
    ) -> Option<Self> {
        let count = model.model.dof() + model.model.cable_count();
        let mut factors = vec![0.0; samples.len() * count * count];
        for (sample, factor) in factors.chunks_mut(count * count).enumerate() {
            model.add_covariance(samples, tensions, sample, sigmas, factor);
            factorize(factor, count)?;
        }
        Some(Self { count, factors, absolute })
    }

    /// Factor of one sample.
    pub(super) fn factor(&self, sample: usize) -> &[f64] {
        let size = self.count * self.count;
        &self.factors[sample * size..][..size]
    }

    /// The factors for covariances multiplied by the square of `scale`.
    pub(super) fn scaled(mut self, scale: f64) -> Self {
        for factor in self.factors.chunks_mut(self.count * self.count) {
            for row in 0..self.count {
                for column in 0..row {
                    factor[row * self.count + column] *= scale;
                }
                factor[row * self.count + row] /= scale;
            }
        }
        self
    }

    /// Largest relative change of a row's own weight.
    pub(super) fn distance_to(&self, other: &Self) -> f64 {
        let size = self.count * self.count;
        let diagonal = |index: &usize| (index % size) % (self.count + 1) == 0;
        (0..self.factors.len())
            .filter(diagonal)
            .map(|index| (other.factors[index] / self.factors[index] - 1.0).abs())
            .fold(0.0, f64::max)
    }
}

/// Replaces a symmetric matrix by its lower Cholesky factor with inverted diagonal.
fn factorize(matrix: &mut [f64], count: usize) -> Option<()> {
    for column in 0..count {
        let mut pivot = matrix[column * count + column];
        for k in 0..column {
            pivot -= matrix[column * count + k] * matrix[column * count + k];
        }
        // written so that NaN is refused too
        if !(pivot > 0.0 && pivot.is_finite()) {
            return None;
        }
        let inverse = 1.0 / pivot.sqrt();
        matrix[column * count + column] = inverse;
        for row in column + 1..count {
            let mut entry = matrix[row * count + column];
            for k in 0..column {
                entry -= matrix[row * count + k] * matrix[column * count + k];
            }
            matrix[row * count + column] = entry * inverse;
        }
    }
    Some(())
}
