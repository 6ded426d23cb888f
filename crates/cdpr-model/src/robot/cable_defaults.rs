//! `[cable_defaults]` of a robot file: keys for every cable that does not state them.

use toml::de::DeValue;

use super::file::OWN_KEYS;
use super::reader::Reader;
use crate::reading::{ReadError, Step, TomlDocument};

/// The table's name.
const TABLE: &str = "cable_defaults";

/// Forms of one stiffness: a cable that states one does not take another from the defaults.
pub(super) const STIFFNESS_KEYS: [&str; 3] =
    ["axial_stiffness_EA_N", "axial_compliance_per_N", "spring_constant_N_per_m"];

/// Largest number of values into which defaults may expand for all cables.
const VALUE_LIMIT: usize = 1 << 20;

/// Gives every `[[cable]]` the keys of `[cable_defaults]` that it does not state.
pub(super) fn fill_in_cables(document: &mut TomlDocument<'_>) -> Result<(), ReadError> {
    for key in OWN_KEYS {
        let path = [Step::Key(TABLE), Step::Key(key)];
        if document.value(&path).is_some() {
            let message = format!("`{key}` is each cable's own; [{TABLE}] cannot state it for all");
            return Err(document
                .error_at(&path, "robot::cable-defaults", message)
                .with_help(format!("move `{key}` to the tables [[cable]]")));
        }
    }
    let cables = match document.value(&[Step::Key("cable")]) {
        Some(DeValue::Array(cables)) => cables.len(),
        _ => 0,
    };
    let values = document.values_in(TABLE);
    if values.saturating_mul(cables) > VALUE_LIMIT {
        let message = format!("{values} values for {cables} cables are more than the {VALUE_LIMIT} that are read");
        return Err(document
            .error_at(&[Step::Key(TABLE)], "robot::cable-defaults", message)
            .with_help("a stretch law has tens of numbers: thin the lists out"));
    }
    document.fill_in("cable", TABLE, &STIFFNESS_KEYS);
    Ok(())
}

/// Adds to an error of a cable that its number is among the defaults, if it is.
pub(super) fn tell_default(reader: &Reader<'_>, mut error: ReadError) -> ReadError {
    if error.place.as_ref().is_some_and(|place| reader.document.stands_in(TABLE, place)) {
        error.message.push_str(&format!("; [{TABLE}] states this for every cable that does not"));
    }
    error
}
