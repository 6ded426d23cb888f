//! Norms of the samples' residuals, their robust size, and the samples that lie beyond it.

use super::loss::{Loss, RobustLoss, Tail, median_norm};

/// Robust standard deviations beyond which a sample is named.
pub(super) const OUTLIER_DEVIATIONS: f64 = 8.0;

/// Most descents with the scale that the residuals tell between them.
pub(super) const RESCALINGS: usize = 10;
/// The scale is found when it changes by less than this share: no parameter moves by a hundredth of its deviation then.
pub(super) const SAME_SCALE: f64 = 1e-3;

/// Standard deviation of normal values per median distance from their median.
const PER_MEDIAN_DISTANCE: f64 = 1.4826;

/// Least deviation where no accuracy is stated, in units of the assumed 1 mm: exact data leave rounding, and rounding has no outliers.
const LEAST_DEVIATION: f64 = 1e-3;

/// Rows and parameters that norms come from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Extent {
    /// Rows of all samples that say something.
    pub(super) rows: usize,
    /// Parameters that were fitted to them.
    pub(super) parameters: usize,
    /// False when no sensor accuracy is known, so that residuals alone tell the noise.
    pub(super) absolute: bool,
}

/// Squared norms of the samples' residuals in units of their weights, at the optimum of a loss.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Norms {
    /// z² of each sample.
    pub(super) squares: Vec<f64>,
    /// The loss of the optimum; `None` for least squares.
    pub(super) loss: Option<RobustLoss>,
    extent: Extent,
    /// Robust standard deviation of a row, never below the stated accuracy.
    pub(super) deviation: f64,
    /// The same as the residuals tell it.
    pub(super) own_deviation: f64,
    /// Norm beyond which a sample is an outlier.
    limit: f64,
    /// Norms at the optimum of least squares where an outlier lies beyond their limit as well; `None` where these say enough.
    witness: Option<Box<Self>>,
}

impl Norms {
    /// Norms at an optimum.
    ///
    /// The deviation is the median norm over that of standard normal rows, enlarged by √(rows/(rows − parameters)). The limit is 8 of
    /// them, or the median norm and 8 robust deviations of the norms themselves where that is more: a model that lacks something has
    /// norms that spread more widely than noise has, and none of them is an outlier.
    pub(super) fn new(squares: Vec<f64>, loss: Option<RobustLoss>, extent: Extent) -> Self {
        let mut norms = Self { loss, extent, squares, ..Self::default() };
        norms.measure();
        norms
    }

    /// The same, whose outliers lie beyond the limit of these norms, too.
    pub(super) fn with_witness(self, witness: Self) -> Self {
        Self { witness: Some(Box::new(witness)), ..self }
    }

    /// The robust loss to ask after a fit of least squares with these norms; `None` where its answer stands.
    ///
    /// Least squares smear an outlier over all samples, which hides it and others: the automatic choice asks from half the limit on. A fit
    /// that found no optimum has other troubles than outliers.
    pub(super) fn to_ask(&self, loss: Loss, is_converged: bool) -> Option<Tail> {
        match loss {
            _ if !self.are_finite() || !is_converged => None,
            Loss::Auto => self.any_beyond(0.5).then_some(Tail::Huber),
            Loss::Squared => None,
            Loss::Huber => Some(Tail::Huber),
            Loss::Cauchy => Some(Tail::Cauchy),
        }
    }

    /// Whether these norms, of an optimum under a robust loss, are the answer to the loss that was asked for: the automatic choice
    /// leaves least squares only for samples beyond the limit.
    pub(super) fn answer(&self, loss: Loss) -> bool {
        loss != Loss::Auto || self.any_beyond(1.0)
    }

    /// Takes deviation and limit from the squares anew.
    pub(super) fn measure(&mut self) {
        let mut sorted: Vec<f64> = self.squares.iter().map(|square| square.sqrt()).collect();
        let middle = median(&mut sorted);
        sorted.iter_mut().for_each(|norm| *norm = (*norm - middle).abs());
        let spread = PER_MEDIAN_DISTANCE * median(&mut sorted);
        let Extent { rows, parameters, absolute } = self.extent;
        let lost = if rows > parameters { rows as f64 / (rows - parameters) as f64 } else { 1.0 };
        let least = if absolute { 1.0 } else { LEAST_DEVIATION };
        self.own_deviation = middle / median_norm(self.dimension()) * lost.sqrt();
        self.deviation = self.own_deviation.max(least);
        self.limit = (OUTLIER_DEVIATIONS * self.deviation).max(middle + OUTLIER_DEVIATIONS * spread);
    }

    /// Rows of one sample that say something, to the nearest number.
    pub(super) fn dimension(&self) -> usize {
        let samples = self.squares.len().max(1);
        ((self.extent.rows + samples / 2) / samples).max(1)
    }

    /// False when no sensor accuracy is known.
    pub(super) fn is_absolute(&self) -> bool {
        self.extent.absolute
    }

    pub(super) fn are_finite(&self) -> bool {
        self.squares.iter().all(|square| square.is_finite()) && self.deviation.is_finite()
    }

    /// True where a sample lies beyond this share of the limit.
    pub(super) fn any_beyond(&self, fraction: f64) -> bool {
        (0..self.squares.len()).any(|sample| self.is_beyond(sample, fraction))
    }

    /// True where a sample lies beyond this share of the limit.
    fn is_beyond(&self, sample: usize, fraction: f64) -> bool {
        let limit = fraction * self.limit;
        let is_beyond = self.squares[sample] > limit * limit;
        is_beyond && self.witness.as_ref().is_none_or(|witness| witness.is_beyond(sample, fraction))
    }

    /// Samples beyond the limit, from 0.
    pub(super) fn outliers(&self) -> impl Iterator<Item = usize> {
        (0..self.squares.len()).filter(|sample| self.is_beyond(*sample, 1.0))
    }

    /// Norm of a sample in robust standard deviations, of which the limit is 8.
    pub(super) fn deviations(&self, sample: usize) -> f64 {
        OUTLIER_DEVIATIONS * self.squares[sample].sqrt() / self.limit
    }

    /// Weight of a sample, 1 where it counts fully.
    pub(super) fn weight(&self, sample: usize) -> f64 {
        self.loss.map_or(1.0, |loss| loss.weight(self.squares[sample]))
    }

    /// Multiplies values, one for each sample, by the samples' weights.
    pub(super) fn weigh(&self, values: &mut [f64]) {
        if self.loss.is_some() {
            values.iter_mut().enumerate().for_each(|(sample, value)| *value *= self.weight(sample));
        }
    }

    /// Factor of the standard deviations that the rows' weights give by least squares, at the optimum of a robust loss with priors
    /// that cost this much on top; at least 1 with stated accuracies.
    ///
    /// Huber's covariance (Huber 1981, section 7.6) for residuals that have no direction within a sample of d rows: with ψ = w r,
    /// K² (Σ ‖ψ‖²/freedom) / (mean ψ′)² of (JᵀWJ)⁻¹, mean ψ′ the mean of w + z w′/d, K = 1 + parameters/rows · var ψ′/(mean ψ′)².
    /// J has all rows, since outliers happen wherever the platform is.
    pub(super) fn inflation(&self, loss: &RobustLoss, prior_cost: f64, freedom: usize) -> f64 {
        let count = self.squares.len() as f64;
        let dimension = self.dimension() as f64;
        let (mut pull, mut mean, mut mean_square) = (prior_cost, 0.0, 0.0);
        for &square in &self.squares {
            let weight = loss.weight(square);
            let slope = weight + loss.weight_slope(square) / dimension;
            pull += weight * weight * square;
            mean += slope / count;
            mean_square += slope * slope / count;
        }
        let variance = (mean_square - mean * mean).max(0.0);
        let Extent { rows, parameters, absolute } = self.extent;
        let correction = 1.0 + parameters as f64 / rows.max(1) as f64 * variance / (mean * mean);
        let factor = correction * (pull / freedom as f64).sqrt() / mean;
        match factor.is_finite() {
            true if absolute => factor.max(1.0),
            true => factor,
            // nothing is left over to tell
            false => 1.0,
        }
    }
}

/// Median of values, which are put in another order; 0 without any.
pub(super) fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    match values.get(middle) {
        Some(_) => *values.select_nth_unstable_by(middle, f64::total_cmp).1,
        None => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    use super::*;

    fn normal(samples: usize, rows: usize, deviation: f64) -> Vec<f64> {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let mut draw = || -> f64 { StandardNormal.sample(&mut rng) };
        (0..samples).map(|_| (0..rows).map(|_| (deviation * draw()).powi(2)).sum()).collect()
    }

    /// 4000 samples of noise tell its size within 3 %; a tenth of them thrown far away moves the median to the quantile of 55.6 %, 13 %
    /// more for one row and less for several; the far ones alone are beyond the limit.
    #[test]
    fn the_size_of_noise_survives_outliers() {
        for rows in [1, 4, 8, 14] {
            let mut squares = normal(4000, rows, 0.7);
            let extent = Extent { rows: 4000 * rows, parameters: 0, absolute: false };
            let clean = Norms::new(squares.clone(), None, extent);
            assert!((clean.deviation / 0.7 - 1.0).abs() < 0.03, "{rows}: {}", clean.deviation);
            assert_eq!(clean.outliers().count(), 0, "{rows}");
            squares[..400].iter_mut().for_each(|square| *square += 400.0);
            let dirty = Norms::new(squares, None, extent);
            assert!((dirty.deviation / clean.deviation - 1.0).abs() < 0.16, "{rows}: {}", dirty.deviation);
            assert!(dirty.outliers().eq(0..400), "{rows}");
            assert_eq!(Norms::new(clean.squares, None, Extent { absolute: true, ..extent }).deviation, 1.0);
        }
    }
}
