//! Size of what is left of a fit, in units of what its weights let expect.

/// Residuals and changes at an optimum, and the size that they are compared with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Misfit {
    /// Weighted sum of squared residuals and priors.
    pub(super) cost: f64,
    /// Part of the priors in it: Σ ((p − p_start)/σ_prior)².
    pub(super) prior_cost: f64,
    /// Rows that say something, one for each prior included, minus parameters: the mean of the cost where residuals and changes
    /// are as large as weights and priors let expect.
    pub(super) freedom: usize,
}

impl Misfit {
    /// √(cost/freedom); NaN where nothing is left over to judge by.
    pub(super) fn factor(&self) -> f64 {
        if self.freedom == 0 { f64::NAN } else { (self.cost / self.freedom as f64).sqrt() }
    }

    /// Factor of the noise at which the cost would be what its freedom lets expect, to first order: with the noise s times as
    /// large the least cost is data/s² + priors, since parameters at their optimum do not change it.
    pub(super) fn noise(&self) -> f64 {
        let (data, room) = (self.cost - self.prior_cost, self.freedom as f64 - self.prior_cost);
        // priors that cost more than all residuals may: a plain step towards the same end
        let factor = if room > 0.0 { (data / room).sqrt() } else { self.factor() };
        if factor.is_finite() { factor.clamp(LEAST_NOISE, 1.0 / LEAST_NOISE) } else { 1.0 }
    }
}

/// Exact data have no noise; weights stay finite.
const LEAST_NOISE: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use super::*;

    /// Data that cost 300 at the assumed noise and priors that cost 20, 120 in the mean: s² = 300/100.
    #[test]
    fn the_noise_makes_the_cost_what_is_expected() {
        let misfit = Misfit { cost: 320.0, prior_cost: 20.0, freedom: 120 };
        let noise = misfit.noise();
        assert!((300.0 / (noise * noise) + 20.0 - 120.0).abs() < 1e-12, "{noise}");
        assert!(Misfit { freedom: 0, ..misfit }.factor().is_nan());
    }
}
