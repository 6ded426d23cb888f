//! Entry of a sensor in the table of all: name, keys, file, and how it is made from a scenario.

use std::fmt::Debug;

use crate::Plant;
use crate::error::{PlantError, ScenarioKey};
use crate::keys::{Key, Stated};
use crate::state::PlantState;
use cdpr_model::geometry::Wrench;
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Model;

/// Sensor that a scenario can state.
pub struct SensorEntry {
    /// Its table in a scenario, as `sensors.tracker`.
    pub table: &'static str,
    /// Description in a line.
    pub summary: &'static str,
    /// File with its rows. Sensors of one file share its clock, which is that of `[sensors]` unless they have a key `rate_Hz`.
    pub file: &'static str,
    /// Keys of its table.
    pub(super) keys: &'static [Key],
    pub(super) make: fn(&SensorSetting<'_>) -> Result<Box<dyn Sensor>, PlantError>,
}

impl SensorEntry {
    /// Name of its table within `[sensors]`.
    pub(super) fn name(&self) -> &'static str {
        self.table.trim_start_matches("sensors.")
    }
}

/// Ingredients of a sensor.
pub(super) struct SensorSetting<'a> {
    /// Model of the machine that it measures.
    pub(super) model: &'a Model,
    /// Values of its keys.
    pub(super) stated: &'a Stated,
    /// Seed of its noise.
    pub(super) seed: u64,
}

/// A mistake at a key of a table.
pub(super) fn refused(table: &'static str, key: &'static str, message: String) -> PlantError {
    PlantError::Value { key: ScenarioKey::of(table, key), message }
}

/// Machine as a sensor finds it.
pub(super) struct Seen<'a> {
    pub(super) plant: &'a Plant,
    pub(super) state: &'a PlantState,
    /// Wrench besides that of the state (world axes, moment about the platform origin; N, N·m).
    pub(super) further: &'a Wrench,
}

/// A sensor with what it remembers.
pub(super) trait Sensor: Debug + Send + Sync {
    /// Names of its columns.
    fn columns(&self, model: &Model) -> Vec<String>;

    /// Follows the machine to the end of a step, whether or not it is read there.
    fn follow(&mut self, _seen: &Seen<'_>) {}

    /// Numbers of a row; `None` if there is nothing to see. NaN stands for an empty cell.
    fn read(&mut self, seen: &Seen<'_>) -> Option<Vec<f64>>;

    /// Time of a row that is read at a time (s).
    fn time_of_row(&self, time: f64) -> f64 {
        time
    }

    /// Adds its accuracies to those of measurement files.
    fn add_accuracies(&self, _sigmas: &mut SensorSigmas) {}

    /// A sensor of its own that goes on from the same state.
    fn boxed_clone(&self) -> Box<dyn Sensor>;
}

impl Clone for Box<dyn Sensor> {
    fn clone(&self) -> Self {
        self.boxed_clone()
    }
}
