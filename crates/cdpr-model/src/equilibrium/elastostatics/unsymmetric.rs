//! The Newton step under a constant moment, which makes the stiffness unsymmetric.

/// Solves (K + S) x = right for the symmetric K (lower triangle) and the skew part S that a constant moment M adds to the
/// rotations, −½ \[M\]×.
///
/// K must be positive definite: then no pivoting is needed.
#[inline(always)]
pub(super) fn solve<const N: usize>(
    symmetric: &[[f64; N]; N],
    right: &[f64; N],
    constant_wrench: &[f64; 6],
) -> [f64; N] {
    let mut matrix = *symmetric;
    for row in 0..N {
        for column in row + 1..N {
            matrix[row][column] = symmetric[column][row];
        }
    }
    let m = [0.5 * constant_wrench[3], 0.5 * constant_wrench[4], 0.5 * constant_wrench[5]];
    // −½ [M]× = ½ [[0, M_z, −M_y], [−M_z, 0, M_x], [M_y, −M_x, 0]]
    for (row, column, entry) in [(0, 1, m[2]), (0, 2, -m[1]), (1, 2, m[0])] {
        matrix[3 + row][3 + column] += entry;
        matrix[3 + column][3 + row] -= entry;
    }
    let mut x = *right;
    for pivot in 0..N {
        let inverse = 1.0 / matrix[pivot][pivot];
        for row in pivot + 1..N {
            let factor = matrix[row][pivot] * inverse;
            for column in pivot + 1..N {
                matrix[row][column] -= factor * matrix[pivot][column];
            }
            x[row] -= factor * x[pivot];
        }
    }
    for row in (0..N).rev() {
        for column in row + 1..N {
            x[row] -= matrix[row][column] * x[column];
        }
        x[row] /= matrix[row][row];
    }
    x
}
