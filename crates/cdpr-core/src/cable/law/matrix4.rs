//! Linear systems of four equations.

/// A 4 × 4 matrix by rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Matrix4(pub(super) [[f64; 4]; 4]);

impl Matrix4 {
    pub(super) fn of_columns(columns: [[f64; 4]; 4]) -> Self {
        Self(core::array::from_fn(|row| core::array::from_fn(|column| columns[column][row])))
    }

    /// Solves for several right-hand sides (rows of `right` are the equations) by elimination with pivoting; entries
    /// are not finite if there is no solution.
    pub(super) fn solve<const N: usize>(mut self, mut right: [[f64; N]; 4]) -> [[f64; N]; 4] {
        let matrix = &mut self.0;
        for pivot in 0..4 {
            let largest =
                (pivot..4).fold(pivot, |a, b| if matrix[b][pivot].abs() > matrix[a][pivot].abs() { b } else { a });
            matrix.swap(pivot, largest);
            right.swap(pivot, largest);
            let inverse = 1.0 / matrix[pivot][pivot];
            for row in pivot + 1..4 {
                let factor = matrix[row][pivot] * inverse;
                for column in pivot + 1..4 {
                    matrix[row][column] -= factor * matrix[pivot][column];
                }
                for column in 0..N {
                    right[row][column] -= factor * right[pivot][column];
                }
            }
        }
        for row in (0..4).rev() {
            for column in 0..N {
                let mut entry = right[row][column];
                for k in row + 1..4 {
                    entry -= matrix[row][k] * right[k][column];
                }
                right[row][column] = entry / matrix[row][row];
            }
        }
        right
    }
}
