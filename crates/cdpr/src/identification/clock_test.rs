//! The test whether the clocks of winches and tracker agree, and samples on one clock.

#[cfg(test)]
mod tests;

use super::clock::{best_offset, synchronised};
use super::fit::{Fit, Settings, least_cost};
use crate::measurement::Samples;
use crate::model::FreeParameters;

/// Share of the variance that an offset must explain to be told, and to be sought at all.
const TOLD: f64 = 0.1;
const SOUGHT: f64 = 0.03;

impl Fit {
    /// Samples with poses at the times of the winches, where this fit freed the offset of the clocks.
    pub fn synchronised(&self, samples: &Samples) -> Samples {
        match &self.clock_offset {
            Some(clock) => synchronised(samples, clock.seconds),
            None => samples.clone(),
        }
    }
}

/// A warning where an offset of the clocks explains more than a tenth of what a fit leaves, with the value of the fit that frees it.
pub fn clock_warning(fit: &Fit, samples: &Samples, free: &FreeParameters, settings: &Settings) -> Option<String> {
    if fit.clock_offset.is_some() {
        return None;
    }
    let samples = &*fit.model.with_lengths(samples).ok()?;
    let cost = |samples: &Samples| least_cost(&fit.model, samples, free, settings);
    let found = best_offset(&fit.model, samples, fit.parameters.len(), SOUGHT, &cost)?;
    (found.explained > TOLD).then(|| {
        format!(
            "clocks: poses recorded {:.1} ms {} explain {:.0} % of the variance of the residuals (± {:.1} ms, fitted together with the other \
             parameters): free `clock-offset`, or mend the times",
            1e3 * found.seconds.abs(),
            if found.seconds > 0.0 { "late" } else { "early" },
            100.0 * found.explained,
            1e3 * found.sigma
        )
    })
}
