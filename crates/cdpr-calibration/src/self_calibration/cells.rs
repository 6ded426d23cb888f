//! Doubt about load cells that equilibrium hardly tells.

use crate::fit::{Fit, Settings, prior_sigma};
use cdpr_model::robot::ParameterKind;

/// Standard deviation of a scale, beside its value, from which on it is not told.
const UNTOLD: f64 = 0.05;

/// Warning of scales of load cells that the data do not determine, where no prior holds them.
pub(super) fn warning(fit: &Fit, settings: &Settings) -> Option<String> {
    let is_scale = |kind: ParameterKind| kind == ParameterKind::TensionScale;
    if prior_sigma(settings, ParameterKind::TensionScale).is_some() {
        return None;
    }
    let fraction = |sigma: Option<f64>, value: f64| sigma.map_or(f64::INFINITY, |sigma| (sigma / value).abs());
    let cells = fit.parameters.iter().filter(|estimate| is_scale(estimate.parameter.kind));
    let largest = cells.map(|cell| fraction(cell.sigma, cell.value)).fold(0.0, f64::max);
    (largest > UNTOLD).then(|| {
        let known = if largest.is_finite() { format!("to {:.0} %", 100.0 * largest) } else { "not at all".to_owned() };
        format!(
            "load cells are not determined by these equilibria: a scale is known {known} (scaled condition {:.0}); take bench values into the robot file and give \
             their accuracy, as with --prior tension-scale=…,tension-offset=…, or record other loads at other poses",
            fit.analysis.condition_scaled
        )
    })
}
