//! Sensor accuracies that the weights use, and Cholesky factors of the rows' covariances.

use super::noise::Sigmas;
use crate::fit::{ASSUMED_NOISE, ASSUMED_TENSION_SHARE};
use cdpr_model::measurement::Samples;
use cdpr_model::scalar::{Kernel, LANES, Lanes, dispatch};

/// Standard deviations of the sensors for the weights (m, rad, N), and whether any of them was stated.
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
        slack: 0.0,
    };
    (sigmas.with_sensor(), absolute)
}

/// Solves L Lᵀ x = right in place with a row-major Cholesky factor whose diagonal is inverted.
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

/// Writes Σ⁻¹ = L⁻ᵀ L⁻¹ for such a factor, rows rounded up to whole lanes; `scratch` is as large and is left
/// with L⁻¹.
pub(super) fn invert(factor: &[f64], count: usize, scratch: &mut [f64], inverse: &mut [f64]) {
    dispatch(Invert { factor, count, scratch, inverse });
}

struct Invert<'a> {
    factor: &'a [f64],
    count: usize,
    scratch: &'a mut [f64],
    inverse: &'a mut [f64],
}

impl Kernel for Invert<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        let Self { factor, count, scratch, inverse } = self;
        let groups = count.div_ceil(LANES);
        let (rows, inverse) = (scratch.as_chunks_mut::<LANES>().0, inverse.as_chunks_mut::<LANES>().0);
        for row in 0..count {
            let own = &factor[row * count..][..count];
            let diagonal = l.constant(own[row]);
            for group in 0..groups {
                let mut sum = l.constant(0.0);
                for k in group * LANES..row {
                    sum = sum - l.constant(own[k]) * l.load(&rows[k * groups + group]);
                }
                (sum * diagonal).store(&mut rows[row * groups + group]);
            }
            rows[row * groups + row / LANES][row % LANES] = own[row];
        }
        for row in 0..count {
            for group in 0..groups {
                let mut sum = l.constant(0.0);
                for k in row.max(group * LANES)..count {
                    let along = rows[k * groups + row / LANES][row % LANES];
                    sum = sum + l.constant(along) * l.load(&rows[k * groups + group]);
                }
                sum.store(&mut inverse[row * groups + group]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;

    /// The product with the matrix is the identity to rounding, whatever part of a lane the size leaves over.
    #[test]
    fn the_inverse_is_that_of_the_factored_matrix() {
        for count in [1, 2, 7, 8, 9, 14, 17] {
            let root = DMatrix::from_fn(count, count, |i, j| ((3 * i + 5 * j) as f64).sin());
            let matrix = &root * root.transpose() + DMatrix::identity(count, count);
            let lower = nalgebra::Cholesky::new(matrix.clone()).unwrap().l();
            let entry = |i: usize, j: usize| if i == j { 1.0 / lower[(i, i)] } else { lower[(i, j)] };
            let factor: Vec<f64> = (0..count * count).map(|place| entry(place / count, place % count)).collect();
            let stride = count.next_multiple_of(LANES);
            let (mut scratch, mut inverse) = (vec![0.0; count * stride], vec![f64::NAN; count * stride]);
            invert(&factor, count, &mut scratch, &mut inverse);
            let found = DMatrix::from_row_slice(count, stride, &inverse).columns(0, count).into_owned();
            let error = (found * matrix - DMatrix::identity(count, count)).amax();
            assert!(error < 1e-13 * count as f64, "{count}: {error:e}");
        }
    }
}
