//! Guesses at the quantities of unknown column names.

use crate::reading::did_you_mean;

/// Other words for a quantity in logs of laboratories; in lower case, letters and digits only.
const SYNONYMS: &[(&str, &[&str])] = &[
    ("x", &["x", "px", "tx", "posx", "positionx", "xpos"]),
    ("y", &["y", "py", "ty", "posy", "positiony", "ypos"]),
    ("z", &["z", "pz", "tz", "posz", "positionz", "zpos"]),
    ("rx", &["rx", "rotx", "rotationx"]),
    ("ry", &["ry", "roty", "rotationy"]),
    ("rz", &["rz", "rotz", "rotationz"]),
    ("qx", &["qx", "quatx", "quaternionx"]),
    ("qy", &["qy", "quaty", "quaterniony"]),
    ("qz", &["qz", "quatz", "quaternionz"]),
    ("qw", &["qw", "quatw", "quaternionw"]),
    ("angle", &["angle", "phi", "theta", "rotation", "rot"]),
    ("cable_length", &["cablelength", "length", "len", "l", "q", "cable", "rope", "ropelength"]),
    ("tension", &["tension", "cabletension", "force", "cableforce", "f"]),
];

/// Units in names, known or not.
const UNITS: &[&str] = &["", "m", "mm", "cm", "rad", "deg", "n", "kn"];

/// The unknown column that probably is the missing one of this name, e.g. `cable_length_1` or `L1 [mm]`.
pub(super) fn probably_meant<'a>(missing: &str, unclaimed: &[&'a str]) -> Option<&'a str> {
    let (stem, number) = match missing.rsplit_once('_') {
        Some((stem, number)) if number.parse::<usize>().is_ok() => (stem, number),
        _ => (missing, ""),
    };
    let stem = SYNONYMS.iter().find(|(known, _)| stem.strip_prefix(known).is_some_and(is_unit));
    let is_meant = |name: &str| {
        let plain: String = name.chars().filter(|c| c.is_ascii_alphanumeric()).collect::<String>().to_lowercase();
        stem.is_some_and(|(_, synonyms)| {
            synonyms.iter().any(|word| {
                UNITS
                    .iter()
                    .any(|unit| plain == format!("{word}{unit}{number}") || plain == format!("{word}{number}{unit}"))
            })
        })
    };
    let same_number = |name: &&str| number.is_empty() || name.ends_with(number);
    let alike = || did_you_mean(missing, unclaimed.iter().copied().filter(same_number).filter(|name| name.len() > 2));
    unclaimed.iter().copied().find(|name| is_meant(name)).or_else(alike)
}

/// The name of a missing column in the unit of the column that probably is it, e.g. `angle_deg` for `phi_deg`.
pub(super) fn in_its_unit(missing: &str, meant: &str) -> String {
    let meant = meant.to_lowercase();
    let has = |unit: &str| meant.split(|c: char| !c.is_ascii_alphanumeric()).any(|word| word == unit);
    let other = [("m", "mm"), ("rad", "deg"), ("N", "kN")].into_iter().find(|(_, unit)| has(&unit.to_lowercase()));
    let Some((si, unit)) = other else { return missing.to_owned() };
    missing.split('_').map(|part| if part == si { unit } else { part }).collect::<Vec<_>>().join("_")
}

/// True if the text after a stem is empty or `_` and a unit.
fn is_unit(rest: &str) -> bool {
    rest.is_empty() || rest.starts_with('_') && UNITS.contains(&rest[1..].to_lowercase().as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_without_unit_in_capitals_or_of_other_words_are_recognised() {
        for (missing, header, meant) in [
            ("x_m", &["X_M", "y"][..], "X_M"),
            ("x_m", &["qx", "x [mm]"], "x [mm]"),
            ("cable_length_m_2", &["cable_length_1", "cable_length_2", "cable_length_12"], "cable_length_2"),
            ("cable_length_m_2", &["l1", "L2 (m)"], "L2 (m)"),
            ("cable_length_m_2", &["cable_lenght_m_1", "cable_lenght_m_2"], "cable_lenght_m_2"),
            ("tension_N_3", &["Force3_kN"], "Force3_kN"),
            ("qw", &["QW"], "QW"),
            ("angle_rad", &["phi"], "phi"),
        ] {
            assert_eq!(probably_meant(missing, header), Some(meant), "{missing} in {header:?}");
        }
        assert_eq!(probably_meant("z_m", &["time", "operator", ""]), None);
        assert_eq!(probably_meant("cable_length_m_2", &["l1", "l3"]), None);
    }

    #[test]
    fn the_unit_of_the_column_that_was_meant_is_kept() {
        for (missing, meant, named) in [
            ("x_m", "X [mm]", "x_mm"),
            ("angle_rad", "phi_deg", "angle_deg"),
            ("tension_N_3", "Force3_kN", "tension_kN_3"),
            ("cable_length_m_2", "L2 (m)", "cable_length_m_2"),
        ] {
            assert_eq!(in_its_unit(missing, meant), named);
        }
    }
}
