//! The table of all controllers, and the reading of `[control]` from a scenario.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{Deserialize, DeserializeSeed, Deserializer};

use super::entry::{Control, ControlSetting, ControllerEntry};
use super::length_changes::LENGTH_CHANGES;
use super::lengths::LENGTHS;
use super::torques::TORQUES;
#[cfg(feature = "files")]
use crate::Winches;
use crate::controller::Controller;
use crate::error::{PlantError, ScenarioKey};
use crate::keys::{Key, Kind, Shape, Stated, TableSeed, Word, allowed_keys, kinds_schema};

/// All controllers; the first one is the default.
const CONTROLLERS: &[ControllerEntry] = &[LENGTHS, LENGTH_CHANGES, TORQUES];

/// Keys that every kind has.
const OWN: &[Key] = &[Key::optional("kind", Shape::Word(words), "Kind of command.")];

fn words() -> Vec<Word> {
    CONTROLLERS.iter().map(|entry| entry.kind.word).collect()
}

fn kinds() -> Vec<Kind> {
    CONTROLLERS.iter().map(|entry| entry.kind).collect()
}

impl Default for Control {
    fn default() -> Self {
        Self { kind: CONTROLLERS[0].kind.word.name, stated: Stated::default() }
    }
}

impl<'de> Deserialize<'de> for Control {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let stated = TableSeed(&allowed_keys(OWN, &kinds())).deserialize(deserializer)?;
        Ok(Self { kind: stated.word("kind").unwrap_or(CONTROLLERS[0].kind.word.name), stated })
    }
}

impl JsonSchema for Control {
    fn schema_name() -> Cow<'static, str> {
        "Control".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        kinds_schema("Commands to the winches.", OWN, &kinds())
    }
}

impl Control {
    /// Row of its kind in the table; the default if there is none.
    fn entry(&self) -> &'static ControllerEntry {
        CONTROLLERS.iter().find(|entry| entry.kind.word.name == self.kind).unwrap_or(&CONTROLLERS[0])
    }

    /// Checks that the kind fits the winches and that no key belongs to another kind; the error names the key.
    #[cfg(feature = "files")]
    pub(crate) fn check(&self, winches: Winches) -> Result<(), (&'static str, String)> {
        let entry = self.entry();
        if !entry.winches.contains(&winches) {
            return Err(("kind", wrong_winches(entry)));
        }
        entry.kind.check(&self.stated, &kinds())
    }

    /// The controller for a machine; an error if it does not fit the winches.
    pub(crate) fn controller(&self, setting: &ControlSetting<'_>) -> Result<Box<dyn Controller>, PlantError> {
        let entry = self.entry();
        if !entry.winches.contains(&setting.plant.winches()) {
            return Err(PlantError::Value { key: ScenarioKey::of("control", "kind"), message: wrong_winches(entry) });
        }
        (entry.make)(setting)
    }
}

fn wrong_winches(entry: &ControllerEntry) -> String {
    let allowed: Vec<String> = entry.winches.iter().map(|winches| format!("\"{}\"", winches.word())).collect();
    let (kind, allowed) = (entry.kind.word.name, allowed.join(" or "));
    format!("kind = \"{kind}\" is for winches = {allowed}: say so in [machine], or take another kind")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys::{book_rows, missing_in_book};

    #[test]
    fn words_are_different_and_the_book_has_all_of_them() {
        let names: std::collections::BTreeSet<&str> = words().iter().map(|word| word.name).collect();
        assert_eq!(names.len(), CONTROLLERS.len());
        let rows = book_rows(CONTROLLERS.iter().map(|entry| (entry.kind.word, entry.kind.keys)));
        assert_eq!(missing_in_book(rows), [] as [String; 0]);
    }
}
