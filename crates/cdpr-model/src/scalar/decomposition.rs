//! Decompositions of matrices of any size, with bounded iterations; `None` if a number is not finite.
//!
//! The functions of nalgebra do not end if a number is not finite or overflows in between. Here such matrices have no
//! decomposition; others are scaled to entries of size one first.

use cdpr_core::scalar::eigenvalue::magnitude;
use nalgebra::{Complex, DMatrix, Dyn, SVD, Schur, SymmetricEigen};

/// Limit of iterations, far more than any finite matrix needs.
const ITERATIONS: usize = 1000;

/// Singular value decomposition, with singular values in descending order.
pub fn svd(matrix: DMatrix<f64>, left: bool, right: bool) -> Option<SVD<f64, Dyn, Dyn>> {
    let scale = magnitude(&matrix)?;
    if matrix.is_empty() {
        return None;
    }
    let mut decomposition = (matrix / scale).try_svd(left, right, f64::EPSILON, ITERATIONS)?;
    decomposition.singular_values *= scale;
    Some(decomposition)
}

/// Eigenvalues and eigenvectors of a symmetric matrix; only its lower triangle is read.
pub fn symmetric_eigen(matrix: DMatrix<f64>) -> Option<SymmetricEigen<f64, Dyn>> {
    let scale = magnitude(&matrix)?;
    if matrix.is_empty() {
        return None;
    }
    let mut decomposition = SymmetricEigen::try_new(matrix / scale, f64::EPSILON, ITERATIONS)?;
    decomposition.eigenvalues *= scale;
    Some(decomposition)
}

/// Pseudo-inverse without singular values below a share of the largest; zero if the matrix has no decomposition.
pub fn pseudo_inverse(matrix: &DMatrix<f64>, share: f64) -> DMatrix<f64> {
    let inverse = |found: SVD<f64, Dyn, Dyn>| {
        let least = share * found.singular_values.max();
        found.pseudo_inverse(least).ok()
    };
    svd(matrix.clone(), true, true).and_then(inverse).unwrap_or_else(|| DMatrix::zeros(matrix.ncols(), matrix.nrows()))
}

/// Orthonormal rows n with n A = 0, to a share of the largest singular value of A; no rows if there are none, or the matrix has no decomposition.
pub fn left_null_space(matrix: &DMatrix<f64>, share: f64) -> DMatrix<f64> {
    let Some(found) = symmetric_eigen(matrix * matrix.transpose()) else { return DMatrix::zeros(0, matrix.nrows()) };
    let least = share * share * found.eigenvalues.max();
    let own: Vec<usize> = (0..matrix.nrows()).filter(|&place| !(found.eigenvalues[place] > least)).collect();
    found.eigenvectors.select_columns(&own).transpose()
}

/// Eigenvalues of a square matrix.
pub fn eigenvalues(matrix: DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    let scale = magnitude(&matrix)?;
    if matrix.is_empty() {
        return None;
    }
    let schur = Schur::try_new(matrix / scale, f64::EPSILON, ITERATIONS)?;
    Some(schur.complex_eigenvalues().iter().map(|value| value * scale).collect())
}

/// The smallest eigenvalue of a symmetric matrix; NaN if it has no decomposition.
pub(crate) fn smallest_eigenvalue(matrix: DMatrix<f64>) -> f64 {
    symmetric_eigen(matrix).map_or(f64::NAN, |decomposition| decomposition.eigenvalues.min())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Moore and Penrose's conditions and n A = 0 for a matrix of rank 2.
    #[test]
    fn inverses_and_null_spaces_of_lower_rank_are_those_of_their_definition() {
        let matrix = DMatrix::from_row_slice(4, 3, &[1.0, 2.0, 3.0, 0.0, 1.0, 1.0, 1.0, 3.0, 4.0, 2.0, 4.0, 6.0]);
        let inverse = pseudo_inverse(&matrix, 1e-10);
        let is_close = |a: DMatrix<f64>, b: &DMatrix<f64>| (a - b).amax() < 1e-12;
        assert!(is_close(&matrix * &inverse * &matrix, &matrix) && is_close(&inverse * &matrix * &inverse, &inverse));
        let rows = left_null_space(&matrix, 1e-6);
        assert_eq!(rows.shape(), (2, 4));
        assert!((&rows * &matrix).amax() < 1e-12 && is_close(&rows * rows.transpose(), &DMatrix::identity(2, 2)));
        assert_eq!(left_null_space(&DMatrix::identity(3, 3), 1e-6).nrows(), 0);
        let bad = DMatrix::from_element(2, 3, f64::NAN);
        assert!(pseudo_inverse(&bad, 0.0) == DMatrix::zeros(3, 2) && left_null_space(&bad, 0.0).nrows() == 0);
    }

    #[test]
    fn matrices_of_any_numbers_are_decomposed_or_refused() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut matrix = DMatrix::<f64>::identity(6, 6);
            matrix[(3, 2)] = bad;
            assert!(svd(matrix.clone(), true, true).is_none() && symmetric_eigen(matrix).is_none());
        }
        for size in [1e300, 1.0, 1e-300, 5e-324, 0.0] {
            let matrix = DMatrix::from_fn(6, 6, |i, j| size * if i == j { 2.0 } else { 1.0 });
            // the matrix of ones has eigenvalues 6 and five times 0, the identity adds 1
            let values = svd(matrix.clone(), false, false).expect("is finite").singular_values;
            let smallest = smallest_eigenvalue(matrix);
            if size >= 1e-300 {
                assert!((values[0] / size - 7.0).abs() < 1e-13 && (smallest / size - 1.0).abs() < 1e-13, "{size}");
            }
        }
        assert!(svd(DMatrix::zeros(0, 3), true, true).is_none());
    }
}
