//! Gaussian process over points with many values at each: one kernel, one factor, one weight per point and value.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use crate::scalar::decomposition::symmetric_eigen;

/// Correlation lengths that are tried, as multiples of the points' root mean square distance from their mean.
const LENGTHS: [f64; 5] = [0.5, 1.0, 2.0, 4.0, 8.0];

/// Variances of noise that are tried, as multiples of the variance of the smooth part.
const NOISES: [f64; 9] = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0, 10.0, 100.0];

/// Smooth functions through scattered points.
#[derive(Clone, Debug)]
pub(super) struct Field {
    /// Points (m).
    pub(super) points: Vec<Vec<f64>>,
    /// Correlation length of the values (m).
    pub(super) length_scale: f64,
    /// Variance of noise as a multiple of the variance of the smooth part.
    pub(super) noise_ratio: f64,
    /// Mean of every value.
    pub(super) mean: Vec<f64>,
    /// Weights of the kernels, point by value.
    pub(super) weights: DMatrix<f64>,
    pub(super) factor: Cholesky<f64, Dyn>,
}

/// Matérn kernel of smoothness 5/2: (1 + s + s²/3) e⁻ˢ with s = √5 d/ℓ; value and slope are continuous (Rasmussen &
/// Williams 2006, eq. 4.17).
fn kernel(a: &[f64], b: &[f64], length_scale: f64) -> f64 {
    let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum();
    let s = (5.0 * square).sqrt() / length_scale;
    (1.0 + s + s * s / 3.0) * (-s).exp()
}

fn kernels(points: &[Vec<f64>], length_scale: f64) -> DMatrix<f64> {
    DMatrix::from_fn(points.len(), points.len(), |i, j| kernel(&points[i], &points[j], length_scale))
}

impl Field {
    /// The field with the correlation length and noise that give the smallest leave-one-out error; `None` if all points
    /// coincide.
    pub(super) fn fit(points: Vec<Vec<f64>>, values: &DMatrix<f64>) -> Option<Self> {
        let extent = extent(&points);
        let mean: Vec<f64> = values.column_iter().map(|column| column.mean()).collect();
        let centred = DMatrix::from_fn(values.nrows(), values.ncols(), |i, k| values[(i, k)] - mean[k]);
        let mut best: Option<(f64, f64, f64)> = None;
        for length_scale in LENGTHS.map(|multiple| multiple * extent).into_iter().filter(|length| *length > 0.0) {
            let eigen = symmetric_eigen(kernels(&points, length_scale))?;
            let turned = eigen.eigenvectors.tr_mul(&centred);
            for noise_ratio in NOISES {
                let inverse = eigen.eigenvalues.map(|value| 1.0 / (value.max(0.0) + noise_ratio));
                let error = left_out(&eigen.eigenvectors, &inverse, &turned);
                if best.is_none_or(|(least, ..)| error < least) {
                    best = Some((error, length_scale, noise_ratio));
                }
            }
        }
        let (_, length_scale, noise_ratio) = best?;
        let factor = factor(&points, length_scale, noise_ratio)?;
        let weights = factor.solve(&centred);
        Some(Self { points, length_scale, noise_ratio, mean, weights, factor })
    }

    /// Values at a point, and the fraction of the smooth part's variance that the samples leave unknown there, 0 to 1.
    pub(super) fn at(&self, point: &[f64]) -> (Vec<f64>, f64) {
        let own = DVector::from_iterator(
            self.points.len(),
            self.points.iter().map(|other| kernel(point, other, self.length_scale)),
        );
        let smooth = self.weights.tr_mul(&own);
        let unknown = 1.0 - own.dot(&self.factor.solve(&own));
        (self.mean.iter().zip(smooth.iter()).map(|(mean, smooth)| mean + smooth).collect(), unknown.max(0.0))
    }
}

/// Cholesky factor of K + λI; `None` if it is not positive definite.
pub(super) fn factor(points: &[Vec<f64>], length_scale: f64, noise_ratio: f64) -> Option<Cholesky<f64, Dyn>> {
    let mut matrix = kernels(points, length_scale);
    (0..points.len()).for_each(|k| matrix[(k, k)] += noise_ratio);
    Cholesky::new(matrix)
}

/// Σ of the squared leave-one-out errors, [K⁻¹y]ᵢ/[K⁻¹]ᵢᵢ (Rasmussen & Williams 2006, eq. 5.12), from the eigenvectors
/// of K, its inverse eigenvalues, and the values along the eigenvectors.
fn left_out(vectors: &DMatrix<f64>, inverse: &DVector<f64>, turned: &DMatrix<f64>) -> f64 {
    let scaled = DMatrix::from_fn(turned.nrows(), turned.ncols(), |i, k| inverse[i] * turned[(i, k)]);
    let weights = vectors * scaled;
    let squares = vectors.component_mul(vectors) * inverse;
    let row = |i: usize| weights.row(i).norm_squared() / (squares[i] * squares[i]);
    (0..weights.nrows()).map(row).sum()
}

/// Root mean square distance from the mean (m).
fn extent(points: &[Vec<f64>]) -> f64 {
    let count = points.len() as f64;
    let along = |k: usize| {
        let mean = points.iter().map(|point| point[k]).sum::<f64>() / count;
        points.iter().map(|point| (point[k] - mean).powi(2)).sum::<f64>() / count
    };
    (0..points.first().map_or(0, Vec::len)).map(along).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points() -> Vec<Vec<f64>> {
        (0..25).map(|k| vec![f64::from(k % 5) - 2.0, f64::from(k / 5) - 2.0]).collect()
    }

    /// The leave-one-out formula agrees with fits without each point.
    #[test]
    fn errors_of_points_left_out_are_those_of_fields_without_them() {
        let points = points();
        let values = DMatrix::from_fn(25, 1, |i, _| (points[i][0] * 0.7).sin() + 0.1 * points[i][1]);
        let (length_scale, noise) = (3.0, 1e-2);
        let eigen = symmetric_eigen(kernels(&points, length_scale)).unwrap();
        let inverse = eigen.eigenvalues.map(|value| 1.0 / (value + noise));
        let fast = left_out(&eigen.eigenvectors, &inverse, &eigen.eigenvectors.tr_mul(&values));
        let mut slow = 0.0;
        for left in 0..25 {
            let others: Vec<usize> = (0..25).filter(|own| *own != left).collect();
            let near: Vec<Vec<f64>> = others.iter().map(|&own| points[own].clone()).collect();
            let factor = factor(&near, length_scale, noise).unwrap();
            let weights = factor.solve(&values.select_rows(&others));
            let found = Field { points: near, length_scale, noise_ratio: noise, mean: vec![0.0], weights, factor };
            slow += (found.at(&points[left]).0[0] - values[left]).powi(2);
        }
        assert!((fast - slow).abs() < 1e-10 * slow, "{fast} {slow}");
    }

    /// A smooth function is followed between the points to a thousandth of its size, and far away the variance is
    /// unknown.
    #[test]
    fn smooth_functions_are_followed_and_far_away_nothing_is_known() {
        let points = points();
        let function = |point: &[f64]| (point[0] * 0.4).sin() * (1.0 + 0.2 * point[1]);
        let values = DMatrix::from_fn(25, 1, |i, _| function(&points[i]));
        let field = Field::fit(points, &values).unwrap();
        for point in [[0.5, 0.5], [-1.3, 0.2], [1.6, -1.4]] {
            let (found, unknown) = field.at(&point);
            assert!((found[0] - function(&point)).abs() < 2e-3 && unknown < 0.05, "{found:?} {unknown}");
        }
        let far = field.at(&[1e3, 0.0]);
        assert!((far.0[0] - field.mean[0]).abs() < 1e-9 && far.1 > 0.999);
    }
}
