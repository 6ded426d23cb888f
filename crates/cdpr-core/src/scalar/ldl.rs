//! LDLᵀ factorisation of small symmetric matrices, unrolled by the compiler: 3×3 and 6×6 normal equations.

use super::{Lanes, Real};

/// Solves `matrix · x = right` in place for a symmetric positive definite matrix (lower triangle read, destroyed).
///
/// Returns the smallest ratio of a pivot to its own diagonal entry, 1 for orthogonal unknowns and near 0 for dependent
/// ones; `None` if a pivot is not positive, and `right` is then destroyed.
#[inline(always)]
pub fn solve<const N: usize>(matrix: &mut [[f64; N]; N], right: &mut [f64; N]) -> Option<f64> {
    solve_leading(N, matrix, right)
}

/// [`solve`] for the leading `n` unknowns, with the same bits.
#[inline(always)]
pub fn solve_leading<const N: usize>(n: usize, matrix: &mut [[f64; N]; N], right: &mut [f64; N]) -> Option<f64> {
    let mut smallest = 1.0_f64;
    let mut inverse_pivot = [0.0; N];
    for column in 0..n {
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
        for row in column + 1..n {
            let mut entry = matrix[row][column];
            for k in 0..column {
                entry -= matrix[row][k] * weighted[k];
            }
            matrix[row][column] = entry * inverse_pivot[column];
        }
    }
    substitute(n, matrix, &inverse_pivot, right);
    Some(smallest)
}

/// Smallest ratio of a pivot to its own diagonal entry that counts as regular in lanes.
const REGULAR: f64 = 1e-11;

/// [`solve`] for eight systems of `n` unknowns at once, with the same bits: 1 where every pivot is far from zero, 0
/// where the single system must be solved to decide. `n` is no constant: loops unrolled over lanes are too much code.
#[inline(always)]
pub fn solve_in_lanes<L: Lanes, const N: usize>(n: usize, matrix: &mut [[L; N]; N], right: &mut [L; N]) -> L {
    let (is_regular, inverse_pivot) = factorize_in_lanes(n, matrix);
    substitute(n, matrix, &inverse_pivot, right);
    is_regular
}

/// Replaces the lower triangles of eight matrices by their factors; returns the result of [`solve_in_lanes`] and the
/// inverse pivots.
#[inline(always)]
pub fn factorize_in_lanes<L: Lanes, const N: usize>(n: usize, matrix: &mut [[L; N]; N]) -> (L, [L; N]) {
    let (zero, one) = (matrix[0][0].constant(0.0), matrix[0][0].constant(1.0));
    let mut is_regular = one;
    let mut inverse_pivot = [zero; N];
    for column in 0..n {
        let diagonal = matrix[column][column];
        let mut weighted = [zero; N];
        let mut pivot = diagonal;
        for k in 0..column {
            weighted[k] = matrix[column][k] * matrix[k][k];
            pivot = pivot - matrix[column][k] * weighted[k];
        }
        is_regular = is_regular.select((zero.constant(REGULAR) * diagonal).is_less(pivot), zero);
        is_regular = is_regular.select(zero.is_less(pivot), zero);
        matrix[column][column] = pivot;
        inverse_pivot[column] = one / pivot;
        for row in column + 1..n {
            let mut entry = matrix[row][column];
            for k in 0..column {
                entry = entry - matrix[row][k] * weighted[k];
            }
            matrix[row][column] = entry * inverse_pivot[column];
        }
    }
    (is_regular, inverse_pivot)
}

/// Solves in place with the factors of [`factorize_in_lanes`], or with those of one matrix: eight systems or one.
#[inline(always)]
pub fn substitute<T: Real, const N: usize>(n: usize, factor: &[[T; N]; N], inverse_pivot: &[T; N], right: &mut [T; N]) {
    for row in 0..n {
        for k in 0..row {
            right[row] = right[row] - factor[row][k] * right[k];
        }
    }
    for row in (0..n).rev() {
        right[row] = right[row] * inverse_pivot[row];
        for k in row + 1..n {
            right[row] = right[row] - factor[k][row] * right[k];
        }
    }
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
