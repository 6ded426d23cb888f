//! Quantities, limits and places of a box in words.

use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use cdpr_workspace::capability::{Capability, Found, Limit, LimitedBy, Quantity, Settings};
use cdpr_workspace::{Bounds, Point};

use super::pose_answer::{axis_names, components};
use crate::number_format::{NONE, fixed, short, significant};

/// Columns of the table.
pub(super) const COLUMNS: [&str; 6] = ["quantity", "value", "at least", "gap", "at", "limited by"];

/// The question, as it was asked.
pub struct AskedCapability<'a> {
    /// The model.
    pub model: &'a Model,
    /// Question about it.
    pub capability: &'a Capability<'a>,
    /// The box.
    pub bounds: &'a Bounds,
    /// When the search stops.
    pub settings: &'a Settings,
    /// Distance of the payload from the platform origin along each axis (m).
    pub payload_place: f64,
}

/// Name of a quantity, and its unit.
pub(super) fn name_of(robot: &Robot, quantity: Quantity) -> (String, &'static str) {
    match quantity {
        Quantity::Payload => ("payload".to_owned(), "kg"),
        Quantity::Acceleration => ("acceleration, any direction".to_owned(), "m/s²"),
        Quantity::AxisAcceleration(axis) => (format!("acceleration along ± {}", axis_names(robot)[axis]), "m/s²"),
        _ => ("speed, any direction".to_owned(), "m/s"),
    }
}

/// Row of the table of a quantity.
pub(super) fn row_of(asked: &AskedCapability<'_>, found: &Found) -> Vec<String> {
    let robot = asked.model.robot();
    let (name, unit) = name_of(robot, found.quantity);
    let number = |value: f64| match value.is_finite() {
        true => format!("{} {unit}", significant(value, 4)),
        false => NONE.to_owned(),
    };
    let direction = found.limited_by.direction.map(|direction| {
        let parts: Vec<String> = components(robot, &direction).into_iter().map(|part| fixed(part, 2)).collect();
        format!(", towards ({})", parts.join(", "))
    });
    vec![
        name,
        number(found.value),
        number(rounded_down(found.at_least, 4)),
        format!("{} %", significant(1e2 * found.gap(), 2)),
        format!("({}) m", point_words(robot, &found.at)),
        limit_words(robot, &found.limited_by) + &direction.unwrap_or_default(),
    ]
}

/// The number cut off after so many significant digits: a bound must not be rounded up.
pub(super) fn rounded_down(value: f64, digits: i32) -> f64 {
    if !value.is_finite() || value <= 0.0 {
        return value;
    }
    let scale = 10_f64.powi(digits - 1 - value.log10().floor() as i32);
    // what is a number of so many digits but for rounding stays it
    (value * scale * (1.0 + 1e-12)).floor() / scale
}

pub(super) fn point_words(robot: &Robot, point: &Point) -> String {
    let parts: Vec<String> =
        point.iter().take(axis_names(robot).len()).map(|part| short((1e4 * part).round() / 1e4 + 0.0)).collect();
    parts.join(", ")
}

/// The limit and its cable.
pub(super) fn limit_words(robot: &Robot, limited_by: &LimitedBy) -> String {
    let cable = limited_by.cable.map(|cable| {
        let (number, name) = ((cable + 1).to_string(), &robot.cables[cable].name);
        let says_no_more = name.strip_prefix("cable").unwrap_or(name).trim() == number;
        if says_no_more { format!("cable {number}") } else { format!("cable {number} (“{name}”)") }
    });
    let of = cable.unwrap_or_else(|| "the cables".to_owned());
    let words = match limited_by.limit {
        Limit::TensionMax => format!("largest tension of {of}"),
        Limit::TensionMin => format!("least tension of {of}"),
        Limit::Gravity => "gravity alone acts this way: cables do not push".to_owned(),
        Limit::NoWrenchClosure => "no wrench closure: no cable pulls this way".to_owned(),
        Limit::CableSpeed => format!("speed of {of}"),
        Limit::DriveSpeed => format!("speed of the drive of {of}"),
        _ => format!("{of} has no path"),
    };
    let others = |cables: &[usize]| -> Vec<String> {
        cables.iter().filter(|other| Some(**other) != limited_by.cable).map(|other| (other + 1).to_string()).collect()
    };
    let (most, least) = (others(&limited_by.at_largest), others(&limited_by.at_least));
    if !is_of_tension(limited_by.limit) || most.len() + least.len() == 0 {
        return words;
    }
    let list =
        |cables: Vec<String>, end: &str| (!cables.is_empty()).then(|| format!("{} at the {end}", cables.join(", ")));
    let rest: Vec<String> = [list(most, "largest"), list(least, "least")].into_iter().flatten().collect();
    format!("{words} (with {})", rest.join(" and "))
}

/// True of a limit that a cable's tensions are.
pub(super) fn is_of_tension(limit: Limit) -> bool {
    matches!(limit, Limit::TensionMax | Limit::TensionMin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_rounded_down() {
        for (value, digits, cut) in [(19.397, 3, 19.3), (0.998_99, 3, 0.998), (2.5, 4, 2.5), (1234.9, 2, 1200.0)] {
            assert!((rounded_down(value, digits) - cut).abs() < 1e-12, "{value}");
        }
        assert_eq!(rounded_down(f64::NEG_INFINITY, 3), f64::NEG_INFINITY);
    }
}
