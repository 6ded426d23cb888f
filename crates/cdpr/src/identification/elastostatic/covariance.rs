//! Sensor accuracies that the weights use, and Cholesky factors of the rows' covariances.

use super::rows::Sigmas;
use crate::identification::fit::ASSUMED_NOISE;
use crate::measurement::Samples;

/// Share of the mean tension assumed as the force sensors' noise where none is stated.
const ASSUMED_TENSION_SHARE: f64 = 0.01;

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

/// Solves L Lᵀ x = right in place with the factor of [`factorize`].
pub(super) fn solve(factor: &[f64], right: &mut [f64]) {
    let count = right.len();
    for row in 0..count {
        for k in 0..row {
            right[row] -= factor[row * count + k] * right[k];
        }
        right[row] *= factor[row * count + row];
    }
    for row in (0..count).rev() {
        for k in row + 1..count {
            right[row] -= factor[k * count + row] * right[k];
        }
        right[row] *= factor[row * count + row];
    }
}

/// Replaces a symmetric matrix by its lower Cholesky factor with inverted diagonal.
pub(super) fn factorize(matrix: &mut [f64], count: usize) -> Option<()> {
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
