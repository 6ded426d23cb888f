//! Sensors of a machine in time: the log has their readings.
//!
//! [`Sensors`] is a value beside the [`PlantState`]: a clone of both is a snapshot. It is updated at every step, since
//! amplifiers have a memory, and keeps rows at the times of each file. Every sensor has a file of its own in this
//! folder, a row in [`SENSORS`], and a random stream, so that adding a sensor changes no number of the others.

mod encoders;
mod entries;
mod entry;
mod imu;
mod inclinometer;
mod load_pins;
mod record;
mod signal;
mod swivels;
#[cfg(test)]
mod tests;
mod tracker;

use super::error::{PlantError, ScenarioKey};
use super::plant::Plant;
use super::state::PlantState;
use cdpr_model::geometry::Wrench;
use cdpr_model::measurement::{Provenance, SensorSigmas, Sidecar};
use cdpr_model::model::Model;

pub use entries::{SENSORS, SensorTable};
pub use entry::SensorEntry;

use entries::OWN;
use entry::{Seen, SensorSetting};
use record::Record;

/// Sensors with their readings so far.
#[derive(Clone, Debug)]
pub struct Sensors {
    records: Vec<Record>,
    sigmas: SensorSigmas,
}

/// Rows of sensors that share a clock, as a CSV file.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorLog {
    /// Name of the file.
    pub name: &'static str,
    /// Text of the file.
    pub csv: String,
}

impl Sensors {
    /// Sensors of a machine from the tables of a scenario.
    pub fn new(table: &SensorTable, model: &Model) -> Result<Self, PlantError> {
        table.stated.check_ranges(OWN, |key| ScenarioKey::of("sensors", key))?;
        let seed = table.stated.whole("seed").unwrap_or(0);
        let (mut records, mut sigmas) = (Vec::<Record>::new(), SensorSigmas::default());
        for entry in SENSORS {
            let Some(stated) = table.stated.table(entry.name()) else { continue };
            stated.check_ranges(entry.keys, |key| ScenarioKey::of(entry.table, key))?;
            let sensor = (entry.make)(&SensorSetting { model, stated, seed })?;
            sensor.add_accuracies(&mut sigmas);
            match records.iter_mut().find(|record| record.file == entry.file) {
                Some(record) => record.add(sensor),
                None => {
                    let rate = stated.number("rate_Hz").unwrap_or_else(|| table.stated.number_or_zero("rate_Hz"));
                    let mut record = Record::new(entry.file, rate);
                    record.add(sensor);
                    records.push(record);
                }
            }
        }
        let sigmas = SensorSigmas {
            position: known(sigmas.position),
            rotation: known(sigmas.rotation),
            length: known(sigmas.length),
            tension: known(sigmas.tension),
            swivel: known(sigmas.swivel),
            length_scale: None,
            balance_force: None,
            balance_moment: None,
        };
        Ok(Self { records, sigmas })
    }

    /// Updates the sensors with a state after each step, under a further wrench on the platform (world axes, moment
    /// about its origin; N, N·m).
    pub fn look(&mut self, plant: &Plant, state: &PlantState, further: &Wrench) {
        self.records.iter_mut().for_each(|record| record.look(&Seen { plant, state, further }));
    }

    /// Columns of a file after the time; empty if no sensor writes it.
    pub fn columns(&self, file: &str, model: &Model) -> Vec<String> {
        self.records.iter().filter(|record| record.file == file).flat_map(|record| record.columns(model)).collect()
    }

    /// Time (s) and numbers of the last row of a file, NaN for an empty cell; `None` before the first.
    pub fn last_row(&self, file: &str) -> Option<(f64, &[f64])> {
        self.records.iter().find(|record| record.file == file)?.last()
    }

    /// Sidecar of the measurement file: accuracies, and the run as its source.
    pub fn sidecar(&self, plant: &Plant, source: String) -> Sidecar {
        let robot = Some(plant.model().robot().name.clone());
        let provenance = Some(Provenance { source: Some(source), robot, ..Provenance::default() });
        Sidecar { layout_version: 1, sigmas: self.sigmas, provenance, ..Sidecar::default() }
    }

    /// Rows per second and numbers in a row, for each file of the sensors.
    pub(super) fn rates(&self, model: &Model) -> Vec<(f64, usize)> {
        self.records.iter().map(|record| record.rate_and_columns(model)).collect()
    }

    /// Files of all sensors.
    pub fn logs(&self, plant: &Plant) -> Vec<SensorLog> {
        let log = |record: &Record| SensorLog { name: record.file, csv: record.csv(plant.model()) };
        self.records.iter().map(log).collect()
    }
}

/// `None` for an accuracy of 0, by which a fit cannot divide.
fn known(sigma: Option<f64>) -> Option<f64> {
    sigma.filter(|sigma| *sigma > 0.0)
}
