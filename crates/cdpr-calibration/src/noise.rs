//! Noise of the rows of a fit, and half widths of intervals that follow from it.

use super::misfit::Misfit;
use super::norms::Norms;
use super::student::{NORMAL_95, t_95};

/// Noise that residuals tell, in units of the weights.
#[derive(Clone, Copy, Debug)]
pub(super) struct Noise {
    pub(super) factor: f64,
    /// Factor of the standard deviations that the weights give by least squares; never below 1 with stated accuracies.
    pub(super) inflation: f64,
    /// Degrees of freedom that the factor is estimated from; `None` where it is that of stated accuracies, or where nothing is left to estimate it from.
    freedom: Option<usize>,
}

impl Noise {
    pub(super) fn of(misfit: &Misfit, norms: &Norms, absolute: bool) -> Self {
        let (factor, inflation) = match norms.loss {
            None => (misfit.factor(), inflation(misfit.factor(), absolute)),
            Some(loss) => (norms.own_deviation, norms.inflation(&loss, misfit.prior_cost, misfit.freedom)),
        };
        let is_estimated = misfit.freedom > 0 && (!absolute || inflation > 1.0);
        Self { factor, inflation, freedom: is_estimated.then_some(misfit.freedom) }
    }

    /// Half width of 95 % intervals in standard deviations: Student's t where residuals tell the noise, of samples that repeat each other for so many samples.
    pub(super) fn quantile(&self, correlation_time: f64) -> f64 {
        let independent = |freedom: usize| ((freedom as f64 / correlation_time.max(1.0)) as usize).max(1);
        self.freedom.map_or(NORMAL_95, |freedom| t_95(independent(freedom)))
    }
}

/// Factor of the standard deviations that the weights give: residuals that are smaller than stated accuracies are luck.
fn inflation(misfit: f64, absolute: bool) -> f64 {
    match misfit.is_finite() {
        true if absolute => misfit.max(1.0),
        true => misfit,
        // nothing is left over to tell
        false => 1.0,
    }
}
