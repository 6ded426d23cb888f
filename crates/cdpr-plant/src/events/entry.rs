//! Entry of an event in the table of all: its word, its keys, and its constructor from a scenario.

use std::sync::Arc;

use super::happening::Happening;
use crate::Plant;
use crate::error::{PlantError, ScenarioKey};
use crate::keys::{Key, Kind, Shape, Stated};
use cdpr_model::geometry::Twist;

/// Key of the cable that an event concerns.
pub(super) const CABLE: Key = Key::needed("cable", Shape::Cable, "number of the cable, from 1.");

/// Event that a scenario can state.
pub(super) struct EventEntry {
    /// Word of `kind`, meaning and keys in a table `[[event]]`.
    pub(super) kind: Kind,
    pub(super) make: fn(&EventSetting<'_>) -> Result<Arc<dyn Happening>, PlantError>,
}

/// Table `[[event]]` of a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct EventTable {
    /// Time since the start (s).
    pub time_s: f64,
    /// Word of the event.
    pub kind: &'static str,
    /// Values of the event's keys.
    pub(crate) stated: Stated,
}

/// Inputs for the construction of an event.
pub(super) struct EventSetting<'a> {
    /// Machine that the event changes.
    pub(super) plant: &'a Plant,
    /// Index in the list of events, from 0.
    pub(super) index: usize,
    /// Values of the event's keys.
    pub(super) stated: &'a Stated,
}

impl EventSetting<'_> {
    /// The scenario key for a key of the event.
    pub(super) fn key(&self, key: &'static str) -> ScenarioKey {
        ScenarioKey { table: "event", index: Some(self.index), key }
    }

    /// An error at a key of the event.
    pub(super) fn refused(&self, key: &'static str, message: String) -> PlantError {
        PlantError::Value { key: self.key(key), message }
    }

    /// Cable that the event concerns, from 0.
    pub(super) fn cable(&self) -> Result<usize, PlantError> {
        let (number, cables) = (self.stated.whole(CABLE.name).unwrap_or(0), self.plant.model().cable_count());
        match usize::try_from(number) {
            Ok(number) if (1..=cables).contains(&number) => Ok(number - 1),
            _ => {
                Err(self.refused(CABLE.name, format!("cable {number} does not exist: cables count from 1 to {cables}")))
            }
        }
    }

    /// A twist or wrench from its components in the degrees of freedom.
    pub(super) fn components(&self, key: &'static str) -> Result<Twist, PlantError> {
        let (robot, numbers) = (self.plant.model().robot(), self.stated.numbers(key).unwrap_or_default());
        let twist = robot.motion_pattern.twist(robot.plane, numbers);
        twist.map_err(|reason| PlantError::Components { key: self.key(key), reason })
    }
}
