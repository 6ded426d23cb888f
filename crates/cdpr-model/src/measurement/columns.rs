//! Column names of measurement files: their quantities and units.

use crate::reading::did_you_mean;

/// Quantity of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Quantity {
    /// Component of the position, from 0: of the world while names are read, of the robot's plane after the header is
    /// read.
    Position(usize),
    /// Component of the quaternion x, y, z, w, from 0.
    Quaternion(usize),
    /// One of the angles of R = Rx Ry Rz, from 0.
    Euler(usize),
    /// Angle of a planar platform.
    Angle,
    /// Length of a cable, from 0.
    Length(usize),
    /// Length of a cable counted from one unknown pose, from 0.
    LengthChange(usize),
    /// Motor angle of a cable's winch, from 0.
    MotorAngle(usize),
    /// Tension of a cable, from 0.
    Tension(usize),
    /// Swivel angle of a cable's pulley, from 0.
    Swivel(usize),
    /// Mass of the platform with its load.
    Mass,
    /// Subset.
    Set,
    /// Time.
    Time,
}

impl Quantity {
    /// True for quantities that only calibration without poses uses.
    pub(super) fn is_internal(self) -> bool {
        matches!(self, Self::Swivel(_) | Self::Mass)
    }

    /// True for a quantity that each cable has.
    pub(super) fn is_of_cable(self) -> bool {
        matches!(
            self,
            Self::Length(_) | Self::LengthChange(_) | Self::MotorAngle(_) | Self::Tension(_) | Self::Swivel(_)
        )
    }

    /// True for a component of the platform's pose.
    pub(super) fn is_of_pose(self) -> bool {
        matches!(self, Self::Position(_) | Self::Quaternion(_) | Self::Euler(_) | Self::Angle)
    }
}

/// Quantity and unit of a column name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Column {
    pub(super) quantity: Quantity,
    /// SI value = factor × written value.
    pub(super) factor: f64,
}

const LENGTH_UNITS: &[(&str, f64)] = &[("m", 1.0), ("mm", 1e-3)];
const ANGLE_UNITS: &[(&str, f64)] = &[("rad", 1.0), ("deg", std::f64::consts::PI / 180.0)];
const TENSION_UNITS: &[(&str, f64)] = &[("N", 1.0), ("kN", 1e3)];
const TIME_UNITS: &[(&str, f64)] = &[("s", 1.0), ("ms", 1e-3)];

/// A known stem with an unknown unit.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct UnknownUnit {
    pub(super) unit: String,
    pub(super) help: String,
}

/// The quantity and unit of a column name; `None` if it names no quantity.
pub(super) fn meaning(name: &str) -> Result<Option<Column>, UnknownUnit> {
    let name = name.trim();
    let plain = |quantity| Ok(Some(Column { quantity, factor: 1.0 }));
    match name {
        "set" => return plain(Quantity::Set),
        "mass_kg" => return plain(Quantity::Mass),
        "qx" => return plain(Quantity::Quaternion(0)),
        "qy" => return plain(Quantity::Quaternion(1)),
        "qz" => return plain(Quantity::Quaternion(2)),
        "qw" => return plain(Quantity::Quaternion(3)),
        _ => {}
    }
    for (stem, unit_list, quantity) in [
        ("x", LENGTH_UNITS, Quantity::Position(0)),
        ("y", LENGTH_UNITS, Quantity::Position(1)),
        ("z", LENGTH_UNITS, Quantity::Position(2)),
        ("rx", ANGLE_UNITS, Quantity::Euler(0)),
        ("ry", ANGLE_UNITS, Quantity::Euler(1)),
        ("rz", ANGLE_UNITS, Quantity::Euler(2)),
        ("angle", ANGLE_UNITS, Quantity::Angle),
        ("t", TIME_UNITS, Quantity::Time),
        ("time", TIME_UNITS, Quantity::Time),
    ] {
        // the stem and one more word: `x_m`, but not `x_controller_estimate_m`
        if let Some(unit) = name.strip_prefix(stem).and_then(|rest| rest.strip_prefix('_'))
            && !unit.contains('_')
        {
            return in_unit(stem, unit, unit_list, "").map(|factor| Some(Column { quantity, factor }));
        }
    }
    for (stem, units, build) in [
        ("cable_length_change", LENGTH_UNITS, Quantity::LengthChange as fn(usize) -> Quantity),
        ("cable_length", LENGTH_UNITS, Quantity::Length as fn(usize) -> Quantity),
        ("motor_angle", ANGLE_UNITS, Quantity::MotorAngle as fn(usize) -> Quantity),
        ("tension", TENSION_UNITS, Quantity::Tension as fn(usize) -> Quantity),
        ("swivel", ANGLE_UNITS, Quantity::Swivel as fn(usize) -> Quantity),
    ] {
        let Some(rest) = name.strip_prefix(stem).and_then(|rest| rest.strip_prefix('_')) else { continue };
        let Some((unit, number)) = rest.rsplit_once('_') else { continue };
        // `swivel_change_rad_1` has another origin
        if stem == "swivel" && unit.contains('_') {
            continue;
        }
        let Some(cable) = number.parse::<usize>().ok().filter(|&cable| cable > 0 && cable <= 10_000) else { continue };
        return in_unit(stem, unit, units, &format!("_{cable}"))
            .map(|factor| Some(Column { quantity: build(cable - 1), factor }));
    }
    Ok(None)
}

fn in_unit(stem: &str, unit: &str, known: &[(&str, f64)], suffix: &str) -> Result<f64, UnknownUnit> {
    if let Some((_, factor)) = known.iter().find(|(name, _)| *name == unit) {
        return Ok(*factor);
    }
    let names: Vec<String> = known.iter().map(|(name, _)| format!("`{stem}_{name}{suffix}`")).collect();
    let meant = did_you_mean(unit, known.iter().map(|(name, _)| *name));
    let hint = meant.map(|name| format!("did you mean `{stem}_{name}{suffix}`? ")).unwrap_or_default();
    Err(UnknownUnit { unit: unit.to_owned(), help: format!("{hint}accepted are {}", names.join(" and ")) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_mean_what_the_contract_says() {
        let found = |name| meaning(name).unwrap().map(|column| (column.quantity, column.factor));
        assert_eq!(found("x_m"), Some((Quantity::Position(0), 1.0)));
        assert_eq!(found("z_mm"), Some((Quantity::Position(2), 1e-3)));
        assert_eq!(found("cable_length_mm_12"), Some((Quantity::Length(11), 1e-3)));
        assert_eq!(found("tension_kN_1"), Some((Quantity::Tension(0), 1e3)));
        assert_eq!(found("motor_angle_rad_3"), Some((Quantity::MotorAngle(2), 1.0)));
        assert_eq!(found("swivel_rad_4"), Some((Quantity::Swivel(3), 1.0)));
        assert_eq!(found("t_s"), Some((Quantity::Time, 1.0)));
        assert_eq!(found("cable_length_change_m_2"), Some((Quantity::LengthChange(1), 1.0)));
        for unclaimed in
            ["t_log_s", "mocap_gap_s", "x_controller_estimate_m", "cable_length_m", "swivel_change_rad_1", ""]
        {
            assert_eq!(found(unclaimed), None, "{unclaimed}");
        }
        for wrong in ["x_furlong", "angle_grad", "cable_length_inch_1", "tension_lbf_2", "motor_angle_turns_1"] {
            assert!(meaning(wrong).is_err(), "{wrong}");
        }
    }
}
