//! The Newton step under a constant moment, for eight poses at once.

use crate::scalar::Lanes;

/// `unsymmetric::solve` for eight systems.
#[inline(always)]
pub(super) fn unsymmetric<L: Lanes>(
    n: usize,
    symmetric: &[[L; 6]; 6],
    right: &[L; 6],
    constant_wrench: &[f64; 6],
) -> [L; 6] {
    let l = right[0];
    let mut matrix = *symmetric;
    for row in 0..n {
        for column in row + 1..n {
            matrix[row][column] = symmetric[column][row];
        }
    }
    let m = [0.5 * constant_wrench[3], 0.5 * constant_wrench[4], 0.5 * constant_wrench[5]];
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
