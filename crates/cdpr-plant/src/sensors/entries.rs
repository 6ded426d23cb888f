//! The table of all sensors, and the reading of `[sensors]` from a scenario.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{Deserialize, DeserializeSeed, Deserializer};

use super::encoders::ENCODERS;
use super::entry::SensorEntry;
use super::imu::IMU;
use super::inclinometer::INCLINOMETER;
use super::load_pins::LOAD_PINS;
use super::swivels::SWIVELS;
use super::tracker::TRACKER;
use crate::keys::{Key, Shape, Stated, TableSeed, table_schema};

/// All sensors, in the order of their files and of the columns in each.
pub const SENSORS: &[SensorEntry] = &[INCLINOMETER, ENCODERS, LOAD_PINS, SWIVELS, TRACKER, IMU];

/// Keys of `[sensors]` in addition to the tables of the sensors.
pub(super) const OWN: &[Key] = &[
    Key::optional("seed", Shape::Whole, "Seed of all noise; 0 when missing."),
    Key::with_default(
        "rate_Hz",
        100.0,
        Shape::Positive,
        "Rows of measurements.csv per second: encoders, load pins, swivels and inclinometer at one time; 100 when missing.",
    ),
];

fn keys() -> Vec<Key> {
    let sensor = |entry: &SensorEntry| Key::optional(entry.name(), Shape::Table(entry.keys), entry.summary);
    OWN.iter().copied().chain(SENSORS.iter().map(sensor)).collect()
}

/// Sensors in a scenario: each exists if its table does. A machine without tables has no sensors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SensorTable {
    /// Values of its keys, tables of the sensors included.
    pub(crate) stated: Stated,
}

impl<'de> Deserialize<'de> for SensorTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Self { stated: TableSeed(&keys()).deserialize(deserializer)? })
    }
}

impl JsonSchema for SensorTable {
    fn schema_name() -> Cow<'static, str> {
        "SensorTable".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let description = "Sensors of the machine, a table each; without a table there is no such sensor.";
        table_schema(description, &keys())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys::{Word, book_rows, missing_in_book};

    #[test]
    fn names_are_different_and_the_book_has_all_of_them() {
        let names: std::collections::BTreeSet<&str> = SENSORS.iter().map(SensorEntry::name).collect();
        assert_eq!(names.len(), SENSORS.len());
        let rows = book_rows(SENSORS.iter().map(|entry| (Word::new(entry.name(), entry.summary), entry.keys)));
        assert_eq!(missing_in_book(rows), [] as [String; 0]);
    }
}
