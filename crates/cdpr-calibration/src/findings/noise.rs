//! Residuals as noise: of the stated accuracies, and independent from sample to sample.

use super::examined::Examined;
use crate::correlated_rows::FEW_ROWS;
use crate::loss::Loss;
use cdpr_model::finding::{Finding, FindingKind, Severity};

/// Standard deviations of χ² beyond which residuals are too large for the stated accuracies, the factor from which on that matters, and the one from which on errors
/// far beyond the accuracies say the same.
const SURE: f64 = 5.0;
const MATTERS: f64 = 1.1;
const GROSS: f64 = 5.0;

/// Lack of fit by χ² where accuracies of poses and lengths are stated; `None` where nothing is stated, or residuals agree.
pub(super) fn lack_of_fit(examined: &Examined<'_>) -> Option<Finding> {
    let fit = examined.fit;
    let sigmas = &examined.samples.sigmas;
    if sigmas.length.is_none() || sigmas.position.is_none() || fit.loss != Loss::Squared {
        return None;
    }
    let factor = fit.noise_factor;
    let rows = (fit.samples * fit.model.cable_count()) as f64;
    // rows that depend on their neighbours count as fewer
    let freedom = (rows - fit.parameters.len() as f64) / fit.analysis.correlation_time;
    let deviations = (factor * factor - 1.0) * (freedom / 2.0).sqrt();
    (factor > MATTERS && factor < GROSS && deviations > SURE).then(|| {
        let text = format!(
            "residuals are {factor:.2} times what the stated accuracies say, {deviations:.0} standard deviations of χ² with {freedom:.0} degrees of freedom: the \
             model lacks something that its parameters take up in part, so that their σ are too small, or the accuracies are wrong"
        );
        Finding::new(FindingKind::LackOfFit, Severity::Caution, text).of_size(factor, "")
    })
}

/// Residuals that repeat those of the samples before, with the number of independent rows; `None` where all are independent.
///
/// A remark, since standard deviations account for the correlation time; a caution where independent rows are so few that it is uncertain itself.
pub(super) fn repeated_rows(examined: &Examined<'_>) -> Option<Finding> {
    let fit = examined.fit;
    let words = fit.analysis.repeated_rows.as_ref()?;
    let independent = fit.samples as f64 / fit.analysis.correlation_time;
    let severity = if independent < FEW_ROWS { Severity::Caution } else { Severity::Remark };
    Some(Finding::new(FindingKind::Order, severity, words).of_size(independent, "rows"))
}
