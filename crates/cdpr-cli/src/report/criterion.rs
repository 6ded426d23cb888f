//! The criterion in the units of the report: mm and degrees.

use cdpr::identification::ErrorBlocks;
use cdpr::identification::selection::Criterion;

use super::number::{decimals_for, fixed, significant};

/// Unit shown.
pub(super) fn unit(criterion: Criterion) -> &'static str {
    if is_angle(criterion) { "°" } else { "mm" }
}

fn is_angle(criterion: Criterion) -> bool {
    criterion == Criterion::Rotation
}

/// A value (m or rad) in the unit shown.
pub(super) fn in_unit(criterion: Criterion, value: f64) -> f64 {
    if is_angle(criterion) { value.to_degrees() } else { 1e3 * value }
}

/// A value with its unit.
pub(super) fn words(criterion: Criterion, value: f64) -> String {
    with_unit(criterion, significant(in_unit(criterion, value), 4))
}

/// A value with as many digits as its standard error deserves, the error, and the unit.
pub(super) fn with_error(criterion: Criterion, value: f64, standard_error: f64) -> String {
    let (value, error) = number_and_error(criterion, value, standard_error);
    if error.is_empty() { with_unit(criterion, value) } else { with_unit(criterion, format!("{value} ± {error}")) }
}

/// The same as two numbers without unit; no error when it is unknown.
pub(super) fn number_and_error(criterion: Criterion, value: f64, standard_error: f64) -> (String, String) {
    let (value, error) = (in_unit(criterion, value), in_unit(criterion, standard_error));
    match error > 1e-7 && error < 1e7 && value.abs() < 1e7 {
        true => (fixed(value, decimals_for(Some(error))), fixed(error, decimals_for(Some(error)))),
        false if error.is_finite() => (significant(value, 4), significant(error, 2)),
        false => (significant(value, 4), String::new()),
    }
}

fn with_unit(criterion: Criterion, number: String) -> String {
    // the sign for degrees stands next to its number
    let space = if is_angle(criterion) { "" } else { " " };
    format!("{number}{space}{}", unit(criterion))
}

/// The criterion out of error blocks (m or rad).
pub(super) fn of_blocks(criterion: Criterion, blocks: &ErrorBlocks) -> f64 {
    match criterion {
        Criterion::Position => blocks.position_error_m.mean,
        Criterion::Rotation => blocks.rotation_error_rad.mean,
        Criterion::Length => blocks.length_error_m.mean_abs,
        _ => f64::NAN,
    }
}
