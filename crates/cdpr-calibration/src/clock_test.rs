//! The test whether the clocks of winches and tracker agree, and samples on one clock.

#[cfg(test)]
mod tests;

use super::clock::best_offset;
use super::fit::{Fit, Settings, least_cost};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, RecordingParameter};

/// Share of the variance that an offset must explain to be told, and to be sought at all.
const TOLD: f64 = 0.1;
const SOUGHT: f64 = 0.03;

/// A warning where an offset of the clocks explains more than a tenth of what a fit leaves, with the value of the fit that frees it.
pub fn clock_warning(fit: &Fit, samples: &Samples, free: &FreeParameters, settings: &Settings) -> Option<String> {
    if fit.clock_offset.is_some() {
        return None;
    }
    let samples = &*fit.model.with_lengths(samples).ok()?;
    let samples = &fit.as_fitted(samples);
    let free = &free.without_recording(&RecordingParameter::FRAMES);
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
