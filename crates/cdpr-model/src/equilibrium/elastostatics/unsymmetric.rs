//! The Newton step under a constant moment, which makes the stiffness unsymmetric: for one pose or for poses in lanes.

use crate::scalar::Real;

/// Solves (K + S) x = right in the leading `n` unknowns for the symmetric K (lower triangle) and the skew part S that a
/// constant moment M adds to the rotations, −½ \[M\]×.
///
/// K must be positive definite: then no pivoting is needed.
#[inline(always)]
pub(super) fn solve<T: Real, const N: usize>(
    n: usize,
    symmetric: &[[T; N]; N],
    right: &[T; N],
    constant_wrench: &[f64; 6],
) -> [T; N] {
    let l = right[0];
    let mut matrix = *symmetric;
    for row in 0..n {
        for column in row + 1..n {
            matrix[row][column] = symmetric[column][row];
        }
    }
    let m = [0.5 * constant_wrench[3], 0.5 * constant_wrench[4], 0.5 * constant_wrench[5]];
    // −½ [M]× = ½ [[0, M_z, −M_y], [−M_z, 0, M_x], [M_y, −M_x, 0]]
    for (row, column, entry) in [(3, 4, m[2]), (3, 5, -m[1]), (4, 5, m[0])] {
        matrix[row][column] = matrix[row][column] + l.constant(entry);
        matrix[column][row] = matrix[column][row] - l.constant(entry);
    }
    let mut x = *right;
    for pivot in 0..n {
        let inverse = l.constant(1.0) / matrix[pivot][pivot];
        for row in pivot + 1..n {
            let factor = matrix[row][pivot] * inverse;
            for column in pivot + 1..n {
                matrix[row][column] = matrix[row][column] - factor * matrix[pivot][column];
            }
            x[row] = x[row] - factor * x[pivot];
        }
    }
    for row in (0..n).rev() {
        for column in row + 1..n {
            x[row] = x[row] - matrix[row][column] * x[column];
        }
        x[row] = x[row] / matrix[row][row];
    }
    x
}
