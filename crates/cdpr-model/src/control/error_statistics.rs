//! Error statistics of a model (eq. 3.3–3.8): mean, root mean square and more, over poses and over cables.

use nalgebra::Vector3;

/// Mean, root mean square and more of a non-negative error over poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseErrorStatistics {
    /// Mean (eq. 3.4).
    pub mean: f64,
    /// Root mean square.
    pub rms: f64,
    /// Median.
    pub median: f64,
    /// 95 % quantile: 95 % of the errors are smaller.
    pub p95: f64,
    /// Largest.
    pub max: f64,
}

/// Error of the cable lengths over poses and cables (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthErrorStatistics {
    /// Mean of the magnitudes.
    pub mean_abs: f64,
    /// Root mean square.
    pub rms: f64,
    /// 95 % quantile of the magnitudes: 95 % are smaller.
    pub p95: f64,
    /// Largest magnitude.
    pub max: f64,
}

/// Error of the tensions over poses and cables (N).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TensionErrorStatistics {
    /// Mean over poses of the 2-norm over cables.
    pub mean_norm: f64,
    /// Mean of the magnitudes.
    pub mean_abs: f64,
    /// Root mean square.
    pub rms: f64,
    /// Largest magnitude.
    pub max: f64,
}

impl PoseErrorStatistics {
    /// Statistics of magnitudes; NaN if there are none.
    pub fn of(values: &[f64]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        Self {
            mean: mean(values),
            rms: mean_square(values).sqrt(),
            median: quantile(&sorted, 0.5),
            p95: quantile(&sorted, 0.95),
            max: sorted.last().copied().unwrap_or(f64::NAN),
        }
    }
}

impl LengthErrorStatistics {
    /// Statistics of signed errors; NaN if there are none.
    pub fn of(values: &[f64]) -> Self {
        let mut sorted: Vec<f64> = values.iter().map(|x| x.abs()).collect();
        sorted.sort_by(f64::total_cmp);
        Self {
            mean_abs: mean(&sorted),
            rms: mean_square(values).sqrt(),
            p95: quantile(&sorted, 0.95),
            max: sorted.last().copied().unwrap_or(f64::NAN),
        }
    }
}

impl TensionErrorStatistics {
    /// Statistics of signed errors, sample by sample; NaN if there are none.
    pub fn of(values: &[f64], cable_count: usize) -> Self {
        let norms: Vec<f64> = values.chunks(cable_count.max(1)).map(norm).collect();
        let magnitudes: Vec<f64> = values.iter().map(|x| x.abs()).collect();
        Self {
            mean_norm: mean(&norms),
            mean_abs: mean(&magnitudes),
            rms: mean_square(values).sqrt(),
            max: magnitudes.iter().copied().fold(f64::NAN, f64::max),
        }
    }
}

/// Mean; NaN if there are no values.
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// 2-norm.
pub fn norm(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum::<f64>().sqrt()
}

pub(crate) fn mean_square(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum::<f64>() / values.len() as f64
}

/// Quantile by linear interpolation between order statistics (the default of NumPy and R).
pub fn quantile(sorted: &[f64], fraction: f64) -> f64 {
    if sorted.is_empty() {
        return f64::NAN;
    }
    let place = fraction * (sorted.len() - 1) as f64;
    let below = place.floor() as usize;
    let above = (below + 1).min(sorted.len() - 1);
    sorted[below] + (place - below as f64) * (sorted[above] - sorted[below])
}

/// Diagonal of the bounding box of positions, d of eq. 3.5 and 3.7 (m); 0 if there are none.
pub fn diagonal<I: Iterator<Item = Vector3<f64>>>(positions: impl Fn() -> I) -> f64 {
    let extent = |axis: usize| {
        let along = || positions().map(|position| position[axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    let square = (0..3).map(|axis| extent(axis).max(0.0).powi(2)).sum::<f64>();
    square.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_interpolate_between_order_statistics() {
        assert_eq!(quantile(&[1.0, 2.0, 3.0, 4.0], 0.5), 2.5);
        assert_eq!(quantile(&[1.0], 0.95), 1.0);
        assert!((quantile(&[0.0, 1.0, 2.0], 0.95) - 1.9).abs() < 1e-15);
    }

    #[test]
    fn statistics_of_a_known_list() {
        let error = LengthErrorStatistics::of(&[-3.0, 4.0]);
        assert_eq!((error.mean_abs, error.max), (3.5, 4.0));
        assert!((error.rms - 12.5_f64.sqrt()).abs() < 1e-15);
        let error = TensionErrorStatistics::of(&[3.0, -4.0, 0.0, 1.0], 2);
        assert_eq!((error.mean_norm, error.mean_abs, error.max), (3.0, 2.0, 4.0));
    }
}
