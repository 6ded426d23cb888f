//! The smallest eigenvalue of small symmetric matrices, without allocation.

#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The largest magnitude among some numbers, 1 if all are zero or subnormal; `None` if one is not finite.
pub fn magnitude<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> Option<f64> {
    let mut largest = 0.0_f64;
    for number in numbers {
        if !number.is_finite() {
            return None;
        }
        largest = largest.max(number.abs());
    }
    // dividing by a subnormal number overflows
    Some(if largest < f64::MIN_POSITIVE { 1.0 } else { largest })
}
/// The smallest eigenvalue of a small symmetric matrix (lower triangle read), without allocation; NaN if an entry is
/// not finite. Accurate to about 1e-14 of the largest entry.
///
/// Householder reflections make the matrix tridiagonal; Laguerre's iteration on its characteristic polynomial, whose
/// roots are all real, then climbs from a bound below all eigenvalues to the first one and cannot pass it.
pub fn smallest_eigenvalue_of<const N: usize>(mut matrix: [[f64; N]; N]) -> f64 {
    let lower = (0..N).flat_map(|row| &matrix[row][..=row]);
    let Some(scale) = magnitude(lower) else { return f64::NAN };
    for row in 0..N {
        for column in 0..=row {
            matrix[row][column] /= scale;
            matrix[column][row] = matrix[row][column];
        }
    }
    let (diagonal, squares) = tridiagonal(matrix);
    let root = |row: usize| if row < N { squares[row].sqrt() } else { 0.0 };
    // Gershgorin's circles
    let mut value =
        (0..N).map(|row| diagonal[row] - root(row) - root(row + 1)).fold(f64::INFINITY, f64::min) - f64::EPSILON;
    for _ in 0..60 {
        let Some(step) = laguerre_step(&diagonal, &squares, value) else { break };
        value += step;
        if !(step > 1e-15 * value.abs().max(1.0)) {
            break;
        }
    }
    value * scale
}

/// Diagonal and squared off-diagonal entries (the first of them unused) of a similar tridiagonal matrix.
fn tridiagonal<const N: usize>(mut matrix: [[f64; N]; N]) -> ([f64; N], [f64; N]) {
    let (mut diagonal, mut squares) = ([0.0; N], [0.0; N]);
    for column in 0..N {
        diagonal[column] = matrix[column][column];
        let first = column + 1;
        if first >= N {
            break;
        }
        let below: f64 = (first + 1..N).map(|row| matrix[row][column] * matrix[row][column]).sum();
        let entry = matrix[first][column];
        squares[first] = entry * entry + below;
        if below == 0.0 {
            continue;
        }
        // I − 2 v vᵀ/(vᵀv) takes the column below the diagonal to ∓|column| in its first entry
        let mut v = [0.0; N];
        (first..N).for_each(|row| v[row] = matrix[row][column]);
        v[first] += squares[first].sqrt().copysign(entry);
        let factor = 2.0 / (v[first] * v[first] + below);
        let mut p = [0.0; N];
        for row in first..N {
            p[row] = factor * (first..N).map(|k| matrix[row][k] * v[k]).sum::<f64>();
        }
        let half = 0.5 * factor * (first..N).map(|k| p[k] * v[k]).sum::<f64>();
        (first..N).for_each(|row| p[row] -= half * v[row]);
        for row in first..N {
            for k in first..N {
                matrix[row][k] -= v[row] * p[k] + p[row] * v[k];
            }
        }
    }
    (diagonal, squares)
}

/// Laguerre's step from below the smallest root of det(T − λ) towards it; `None` at a root, or if rounding hides it.
fn laguerre_step<const N: usize>(diagonal: &[f64; N], squares: &[f64; N], value: f64) -> Option<f64> {
    // the determinant of the leading block with its first two derivatives by λ, and the same for the block before it
    let (mut now, mut before) = ([1.0, 0.0, 0.0], [0.0; 3]);
    for row in 0..N {
        let entry = diagonal[row] - value;
        let square = if row == 0 { 0.0 } else { squares[row] };
        let next = [
            entry * now[0] - square * before[0],
            entry * now[1] - now[0] - square * before[1],
            entry * now[2] - 2.0 * now[1] - square * before[2],
        ];
        (before, now) = (now, next);
    }
    // below all roots the determinant is positive
    if !(now[0] > 0.0) {
        return None;
    }
    let n = N as f64;
    let slope = now[1] / now[0];
    let curvature = slope * slope - now[2] / now[0];
    let root = f64::max((n - 1.0) * (n * curvature - slope * slope), 0.0).sqrt();
    let step = n / (root - slope);
    step.is_finite().then_some(step)
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, SymmetricEigen};

    use super::*;

    /// Against nalgebra's eigenvalues: random, clustered, multiple, diagonal and rank-deficient matrices.
    #[test]
    fn the_smallest_eigenvalue_of_small_matrices_is_that_of_the_library() {
        fn compare<const N: usize>(matrix: [[f64; N]; N]) {
            let whole = DMatrix::from_fn(N, N, |i, j| matrix[i.max(j)][i.min(j)]);
            let expected = SymmetricEigen::new(whole).eigenvalues.min();
            let largest = matrix.iter().flatten().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            let found = smallest_eigenvalue_of(matrix);
            // both lose some digits of the largest entry
            assert!((found - expected).abs() <= 3e-14 * N as f64 * largest, "{matrix:?}: {found:e} {expected:e}");
        }
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        for case in 0..3000 {
            let spread = [1.0, 1e3, 1e-3, 0.0][case % 4];
            let mut matrix = [[0.0; 6]; 6];
            for row in 0..6 {
                for column in 0..=row {
                    let off = if case % 8 < 4 { random() } else { 0.0 };
                    matrix[row][column] = if row == column { 2.0 + spread * random() } else { spread * off };
                }
            }
            compare(matrix);
            let vector: [f64; 6] = std::array::from_fn(|_| random());
            compare(std::array::from_fn::<_, 6, _>(|i| std::array::from_fn(|j| vector[i] * vector[j])));
            compare([[matrix[0][0], 0.0], [matrix[1][0], matrix[1][1]]]);
            compare(std::array::from_fn::<_, 3, _>(|i| std::array::from_fn(|j| matrix[i][j])));
        }
        compare([[0.0; 6]; 6]);
        assert!(smallest_eigenvalue_of([[f64::NAN, 0.0], [0.0, 1.0]]).is_nan());
    }
}
