//! The criterion in the units of the report: mm, degrees or N.

use cdpr::identification::selection::SelectionCriterion;

use crate::number_format::{decimals_for, fixed, significant};

/// A value with its unit; nothing where there is none.
pub(super) fn words(criterion: SelectionCriterion, value: f64) -> Option<String> {
    value.is_finite().then(|| with_unit(criterion, significant(criterion.in_unit(value), 4)))
}

/// A value with as many digits as its standard error deserves, the error, and the unit; nothing where there is none.
pub(super) fn with_error(criterion: SelectionCriterion, value: f64, standard_error: f64) -> Option<String> {
    if !value.is_finite() {
        return None;
    }
    let (value, error) = number_and_error(criterion, value, standard_error);
    let words = if error.is_empty() { value } else { format!("{value} ± {error}") };
    Some(with_unit(criterion, words))
}

/// The same as two numbers without unit; no error when it is unknown.
pub(super) fn number_and_error(criterion: SelectionCriterion, value: f64, standard_error: f64) -> (String, String) {
    let (value, error) = (criterion.in_unit(value), criterion.in_unit(standard_error));
    match error > 1e-7 && error < 1e7 && value.abs() < 1e7 {
        true => (fixed(value, decimals_for(Some(error))), fixed(error, decimals_for(Some(error)))),
        false if error.is_finite() => (significant(value, 4), significant(error, 2)),
        false => (significant(value, 4), String::new()),
    }
}

fn with_unit(criterion: SelectionCriterion, number: String) -> String {
    // the sign for degrees stands next to its number
    let space = if criterion == SelectionCriterion::Rotation { "" } else { " " };
    format!("{number}{space}{}", criterion.unit())
}
