//! Entry of a sensor in the table of all: its name, its keys, its file, and its constructor from a scenario.

use std::fmt::Debug;

use crate::Plant;
use crate::error::{PlantError, ScenarioKey};
use crate::keys::{Key, Stated};
use crate::state::PlantState;
use cdpr_model::geometry::Wrench;
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Model;

/// Sensor that a scenario can have.
pub struct SensorEntry {
    /// Table of the sensor in a scenario, e.g. `sensors.tracker`.
    pub table: &'static str,
    /// Description in one line.
    pub summary: &'static str,
    /// File of the sensor's rows. Sensors with the same file share its clock, which is that of `[sensors]` unless they
    /// have a key `rate_Hz`.
    pub file: &'static str,
    /// Keys of the sensor's table.
    pub(super) keys: &'static [Key],
    pub(super) make: fn(&SensorSetting<'_>) -> Result<Box<dyn Sensor>, PlantError>,
}

impl SensorEntry {
    /// Name of the sensor's table within `[sensors]`.
    pub(super) fn name(&self) -> &'static str {
        self.table.trim_start_matches("sensors.")
    }
}

/// Inputs for the construction of a sensor.
pub(super) struct SensorSetting<'a> {
    /// Model of the measured machine.
    pub(super) model: &'a Model,
    /// Values of the sensor's keys.
    pub(super) stated: &'a Stated,
    /// Seed of the sensor's noise.
    pub(super) seed: u64,
}

/// An error at a key of a table.
pub(super) fn refused(table: &'static str, key: &'static str, message: String) -> PlantError {
    PlantError::Value { key: ScenarioKey::of(table, key), message }
}

/// Machine that a sensor measures.
pub(super) struct Seen<'a> {
    pub(super) plant: &'a Plant,
    pub(super) state: &'a PlantState,
    /// Wrench in addition to that of the state (world axes, moment about the platform origin; N, N·m).
    pub(super) further: &'a Wrench,
}

/// A sensor with its internal state.
pub(super) trait Sensor: Debug + Send + Sync {
    /// Names of the sensor's columns.
    fn columns(&self, model: &Model) -> Vec<String>;

    /// Updates the sensor at the end of a step, even if it is not read there.
    fn follow(&mut self, _seen: &Seen<'_>) {}

    /// Numbers of a row; `None` if there is no measurement. NaN stands for an empty cell.
    fn read(&mut self, seen: &Seen<'_>) -> Option<Vec<f64>>;

    /// Time stamp of a row that is read at a time (s).
    fn time_of_row(&self, time: f64) -> f64 {
        time
    }

    /// Adds the sensor's accuracies to those of measurement files.
    fn add_accuracies(&self, _sigmas: &mut SensorSigmas) {}

    /// A copy of the sensor with the same state.
    fn boxed_clone(&self) -> Box<dyn Sensor>;
}

impl Clone for Box<dyn Sensor> {
    fn clone(&self) -> Self {
        self.boxed_clone()
    }
}
