//! Whitened residuals at an optimum, sample by sample.

use crate::identification::autocorrelation::correlation_time;
use crate::identification::norms::Norms;

/// Residuals of a fit in units of what the stated or assumed accuracies let expect.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Residuals {
    /// rᵀ Σ⁻¹ r of each sample.
    pub(in crate::identification) squares: Vec<f64>,
    /// ln det Σ of each sample.
    pub(in crate::identification) log_variances: Vec<f64>,
    /// Rows of each sample that say something.
    pub(in crate::identification) rows: Vec<usize>,
    /// Share of rows that are as good as independent: the mean of 1/τ over the rows of a sample.
    pub(in crate::identification) independent_share: f64,
    /// False when no sensor accuracy is known.
    pub(in crate::identification) absolute: bool,
    /// Whether wrenches are rows besides lengths.
    pub(in crate::identification) with_wrenches: bool,
}

/// Some of the samples together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::identification) struct Rows {
    pub(in crate::identification) count: usize,
    /// Σ rᵀ Σ⁻¹ r.
    pub(in crate::identification) cost: f64,
    /// Σ ln det Σ.
    pub(in crate::identification) log_variance: f64,
}

impl Residuals {
    /// Of whitened rows, each a series over the samples, with ln det Σ of every sample and the number of its rows; `noise` is what the
    /// weights stand for, as a multiple of stated or assumed accuracies. Outliers say as little of correlation as of parameters.
    pub(in crate::identification) fn of(
        series: &[Vec<f64>],
        (mut log_variances, rows): (Vec<f64>, Vec<usize>),
        (noise, norms): (f64, &Norms),
    ) -> Self {
        let mut squares = vec![0.0; rows.len()];
        for row in series {
            squares.iter_mut().zip(row).for_each(|(square, value)| *square += (noise * value).powi(2));
        }
        let less = 2.0 * noise.ln();
        log_variances.iter_mut().zip(&rows).for_each(|(log, &rows)| *log -= rows as f64 * less);
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
            absolute: false,
            with_wrenches: false,
        }
    }

    /// Whether other residuals are of the same kind of rows and the same samples, so that their likelihoods can be compared.
    pub(in crate::identification) fn same_rows(&self, other: &Self) -> bool {
        let kind = |one: &Self| (one.with_wrenches, one.absolute, one.rows.len());
        kind(self) == kind(other)
    }

    /// These samples together.
    pub(in crate::identification) fn over(&self, samples: &[usize]) -> Rows {
        Rows {
            count: samples.iter().map(|&sample| self.rows[sample]).sum(),
            cost: samples.iter().map(|&sample| self.squares[sample]).sum(),
            log_variance: samples.iter().map(|&sample| self.log_variances[sample]).sum(),
        }
    }
}
