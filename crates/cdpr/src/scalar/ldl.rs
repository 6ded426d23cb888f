//! LDLᵀ factorisation of small symmetric matrices, unrolled by the compiler: 3×3 and 6×6 normal equations.

/// Solves `matrix · x = right` in place for a symmetric positive definite matrix (lower triangle read, destroyed).
///
/// Returns the smallest ratio of a pivot to its own diagonal entry, 1 for orthogonal unknowns and near 0 for dependent
/// ones; `None` when a pivot is not positive, with `right` spoilt.
#[inline(always)]
pub(crate) fn solve<const N: usize>(matrix: &mut [[f64; N]; N], right: &mut [f64; N]) -> Option<f64> {
    let mut smallest = 1.0_f64;
    let mut inverse_pivot = [0.0; N];
    for column in 0..N {
        let diagonal = matrix[column][column];
        // row of L times the pivots
        let mut weighted = [0.0; N];
        let mut pivot = diagonal;
        for k in 0..column {
            weighted[k] = matrix[column][k] * matrix[k][k];
            pivot -= matrix[column][k] * weighted[k];
        }
        // written so that NaN is refused too
        if !(pivot > 0.0) {
            return None;
        }
        smallest = smallest.min(pivot / diagonal);
        matrix[column][column] = pivot;
        inverse_pivot[column] = 1.0 / pivot;
        for row in column + 1..N {
            let mut entry = matrix[row][column];
            for k in 0..column {
                entry -= matrix[row][k] * weighted[k];
            }
            matrix[row][column] = entry * inverse_pivot[column];
        }
    }
    for row in 0..N {
        for k in 0..row {
            right[row] -= matrix[row][k] * right[k];
        }
    }
    for row in (0..N).rev() {
        right[row] *= inverse_pivot[row];
        for k in row + 1..N {
            right[row] -= matrix[k][row] * right[k];
        }
    }
    Some(smallest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_solution_satisfies_the_system() {
        let matrix = [[4.0, 1.0, 0.5], [1.0, 3.0, -0.2], [0.5, -0.2, 2.0]];
        let x = [1.0, -2.0, 3.0];
        let mut right = [0, 1, 2].map(|row| (0..3).map(|k| matrix[row][k] * x[k]).sum::<f64>());
        let ratio = solve(&mut matrix.clone(), &mut right).unwrap();
        assert!(ratio > 0.8 && ratio <= 1.0);
        for (found, expected) in right.iter().zip(x) {
            assert!((found - expected).abs() < 1e-14);
        }
    }

    #[test]
    fn an_indefinite_matrix_and_nan_are_refused() {
        assert!(solve(&mut [[1.0, 2.0], [2.0, 1.0]], &mut [1.0, 1.0]).is_none());
        assert!(solve(&mut [[f64::NAN, 0.0], [0.0, 1.0]], &mut [1.0, 1.0]).is_none());
    }
}
