//! The table of all events, and the reading of `[[event]]` from a scenario.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{Deserialize, DeserializeSeed, Deserializer};

use super::cable_break::CABLE_BREAK;
use super::entry::{EventEntry, EventSetting, EventTable};
use super::friction_change::FRICTION;
use super::happening::Event;
use super::load_change::LOAD;
use super::slip::SLIP;
use super::winch_stop::WINCH_STOP;
use super::wrench_change::WRENCH;
use crate::Plant;
use crate::error::{PlantError, ScenarioKey};
use crate::keys::{Key, Kind, Shape, TableSeed, Word, allowed_keys, kinds_schema};
use cdpr_model::geometry::MotionPattern;

/// All events.
const EVENTS: &[EventEntry] = &[CABLE_BREAK, WINCH_STOP, SLIP, LOAD, WRENCH, FRICTION];

/// Keys of every event.
const OWN: &[Key] = &[
    Key::needed(
        "time_s",
        Shape::NotNegative,
        "Time since the start (s); a row of the log at this time shows the state before it.",
    ),
    Key::needed("kind", Shape::Word(words), "Kind of event."),
];

fn words() -> Vec<Word> {
    EVENTS.iter().map(|entry| entry.kind.word).collect()
}

fn kinds() -> Vec<Kind> {
    EVENTS.iter().map(|entry| entry.kind).collect()
}

impl<'de> Deserialize<'de> for EventTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let stated = TableSeed(&allowed_keys(OWN, &kinds())).deserialize(deserializer)?;
        let (time_s, kind) = (stated.number_or_zero("time_s"), stated.word("kind").unwrap_or_default());
        Ok(Self { time_s, kind, stated })
    }
}

impl JsonSchema for EventTable {
    fn schema_name() -> Cow<'static, str> {
        "EventTable".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        kinds_schema("Event at a time.", OWN, &kinds())
    }
}

impl EventTable {
    /// Row of its kind in the table; `None` if there is none.
    fn entry(&self) -> Option<&'static EventEntry> {
        EVENTS.iter().find(|entry| entry.kind.word.name == self.kind)
    }

    /// Checks that the time is not before the start and that no key belongs to another kind; the error names the key.
    #[cfg(feature = "files")]
    pub(crate) fn check(&self) -> Result<(), (&'static str, String)> {
        if !(self.time_s >= 0.0 && self.time_s.is_finite()) {
            return Err(("time_s", format!("time_s is {}; it is a time from 0 s on", self.time_s)));
        }
        self.entry().map_or(Ok(()), |entry| entry.kind.check(&self.stated, &kinds()))
    }
}

impl Event {
    /// Events of a scenario, in the order of time.
    pub(crate) fn of(plant: &Plant, tables: &[EventTable]) -> Result<Vec<Self>, PlantError> {
        let mut events = Vec::new();
        for (index, table) in tables.iter().enumerate() {
            let setting = EventSetting { plant, index, stated: &table.stated };
            let Some(entry) = table.entry() else {
                let known: Vec<&str> = words().iter().map(|word| word.name).collect();
                let message = format!("there is no event `{}`; there are {}", table.kind, known.join(", "));
                return Err(setting.refused("kind", message));
            };
            table.stated.check_ranges(entry.kind.keys, |key| setting.key(key))?;
            events.push(Self { time: table.time_s, happening: (entry.make)(&setting)? });
        }
        // a stable sort: events at the same time happen in the order of the file
        events.sort_by(|a, b| a.time.total_cmp(&b.time));
        check_masses(plant, &events)?;
        Ok(events)
    }
}

/// Checks that loads leave a positive mass, and that the file states gravity for their weight.
fn check_masses(plant: &Plant, events: &[Event]) -> Result<(), PlantError> {
    let robot = plant.model().robot();
    let mut body = plant.inertia.body;
    for (index, event) in events.iter().enumerate() {
        let Some(load) = event.happening.load_change() else { continue };
        let key = ScenarioKey { table: "event", index: Some(index), key: "mass_kg" };
        let refused = |message: String| Err(PlantError::Value { key, message });
        if robot.gravity.is_none() {
            return refused("what a load weighs is unknown: add gravity_m_s2 to the robot file".to_owned());
        }
        let turns = robot.motion_pattern == MotionPattern::Spatial;
        match body.with_point_mass(load.mass, &load.place) {
            Some(next) if !turns || next.inertia.cholesky().is_some() => body = next,
            _ => return refused(format!("{} kg leave no body: mass and inertia stay above zero", load.mass)),
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys::{book_rows, missing_in_book};

    #[test]
    fn words_are_different_and_the_book_has_all_of_them() {
        let names: std::collections::BTreeSet<&str> = words().iter().map(|word| word.name).collect();
        assert_eq!(names.len(), EVENTS.len());
        let rows = book_rows(EVENTS.iter().map(|entry| (entry.kind.word, entry.kind.keys)));
        assert_eq!(missing_in_book(rows), [] as [String; 0]);
    }
}
