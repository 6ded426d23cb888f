//! Whitened residuals at an optimum, sample by sample.

use crate::autocorrelation::correlation_time;
use crate::norms::Norms;

/// Rows of a fit at its optimum, as its analysis leaves them: each a series over the samples.
#[derive(Clone, Debug)]
pub(crate) struct FittedRows {
    /// Residuals whitened by the weights.
    pub(crate) series: Vec<Vec<f64>>,
    /// 1/σ of each given the rows of its sample before it; 0 where it says nothing.
    pub(crate) weights: Vec<Vec<f64>>,
    /// Noise that the weights stand for, as a multiple of stated or assumed accuracies.
    pub(crate) noise: f64,
    /// Weights of the samples.
    pub(crate) norms: Norms,
    /// False when no sensor accuracy is known.
    pub(crate) absolute: bool,
    /// Whether wrenches are rows besides lengths.
    pub(crate) with_wrenches: bool,
}

/// Residuals of a fit in units of what the stated or assumed accuracies let expect.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Residuals {
    /// rᵀ Σ⁻¹ r of each sample.
    pub(crate) squares: Vec<f64>,
    /// ln det Σ of each sample.
    pub(crate) log_variances: Vec<f64>,
    /// Rows of each sample that say something.
    pub(crate) rows: Vec<usize>,
    /// Share of rows that are as good as independent: the mean of 1/τ over the rows of a sample.
    pub(crate) independent_share: f64,
    /// False when no sensor accuracy is known.
    pub(crate) absolute: bool,
    /// Whether wrenches are rows besides lengths.
    pub(crate) with_wrenches: bool,
}

/// Some of the samples together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rows {
    pub(crate) count: usize,
    /// Σ rᵀ Σ⁻¹ r.
    pub(crate) cost: f64,
    /// Σ ln det Σ.
    pub(crate) log_variance: f64,
}

impl Residuals {
    /// Of the rows of a fit. Outliers say as little of correlation as of parameters.
    pub(crate) fn of(fitted: &FittedRows) -> Self {
        let FittedRows { series, weights, noise, norms, absolute, with_wrenches } = fitted;
        let samples = series.first().map_or(0, Vec::len);
        let (mut squares, mut log_variances, mut rows) = (vec![0.0; samples], vec![0.0; samples], vec![0; samples]);
        for (row, weights) in series.iter().zip(weights) {
            squares.iter_mut().zip(row).for_each(|(square, value)| *square += (noise * value).powi(2));
            for sample in (0..samples).filter(|&sample| weights[sample] > 0.0) {
                log_variances[sample] -= 2.0 * (noise * weights[sample]).ln();
                rows[sample] += 1;
            }
        }
        let time = |row: &Vec<f64>| {
            let mut row = row.clone();
            norms.weigh(&mut row);
            correlation_time(&row)
        };
        let independent = series.iter().map(|row| 1.0 / time(row)).sum::<f64>();
        Self {
            squares,
            log_variances,
            rows,
            independent_share: independent / series.len().max(1) as f64,
            absolute: *absolute,
            with_wrenches: *with_wrenches,
        }
    }

    /// Kind of the rows, their noise and their number of samples: likelihoods of equal ones can be compared.
    pub(crate) fn kind(&self) -> (bool, bool, usize) {
        (self.with_wrenches, self.absolute, self.rows.len())
    }

    /// These samples together.
    pub(crate) fn over(&self, samples: &[usize]) -> Rows {
        Rows {
            count: samples.iter().map(|&sample| self.rows[sample]).sum(),
            cost: samples.iter().map(|&sample| self.squares[sample]).sum(),
            log_variance: samples.iter().map(|&sample| self.log_variances[sample]).sum(),
        }
    }
}
