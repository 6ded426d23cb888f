//! Whether rows tell as much as their number says.

use super::examined::Examined;
use crate::identifiability::FEW_ROWS;
use cdpr_model::finding::{Finding, FindingKind, Severity};

/// Residuals that repeat those of the samples before, with the rows that they are worth; `None` where they are independent.
///
/// Standard deviations account for the correlation time, so that this is a remark; of few independent rows the time itself is hardly known.
pub(super) fn finding(examined: &Examined<'_>) -> Option<Finding> {
    let fit = examined.fit;
    let words = fit.analysis.repeated_rows()?;
    let independent = fit.samples as f64 / fit.analysis.correlation_time;
    let severity = if independent < FEW_ROWS { Severity::Caution } else { Severity::Remark };
    Some(Finding::new(FindingKind::Order, severity, words).of_size(independent, "rows"))
}
