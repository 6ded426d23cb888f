//! The criterion as two numbers of a table, in the units of the report: mm, degrees or N.

use cdpr_calibration::selection::SelectionCriterion;

use crate::number_format::{decimals_for, fixed, significant};

/// A value with as many digits as its standard error deserves, and the error; empty when it is unknown. Both without unit.
pub fn value_and_error(criterion: SelectionCriterion, value: f64, standard_error: f64) -> (String, String) {
    let (value, error) = (criterion.in_unit(value), criterion.in_unit(standard_error));
    match error > 1e-7 && error < 1e7 && value.abs() < 1e7 {
        true => (fixed(value, decimals_for(Some(error))), fixed(error, decimals_for(Some(error)))),
        false if error.is_finite() => (significant(value, 3), significant(error, 2)),
        false => (significant(value, 3), String::new()),
    }
}

/// A value with its unit and the digits that its standard error allows.
pub(crate) fn within(criterion: SelectionCriterion, value: f64, standard_error: f64) -> String {
    if value.is_nan() {
        return "no value".to_owned();
    }
    // the sign for degrees stands next to its number
    let space = if criterion == SelectionCriterion::Rotation { "" } else { " " };
    format!("{}{space}{}", value_and_error(criterion, value, standard_error).0, criterion.unit())
}
