//! Sensors of a machine in time: what is logged is what they see.
//!
//! [`Sensors`] is a value beside the [`State`]: a clone of both is a snapshot. It looks at every step, since
//! amplifiers remember, and keeps rows at the times of each sensor. Every sensor has a random stream of its own: another sensor more changes
//! no number of the others.

mod cables;
mod checks;
mod imu;
mod signal;
mod table;
#[cfg(test)]
mod tests;
mod tracker;

use super::error::PlantError;
use super::plant::Plant;
use super::state::State;
use crate::geometry::Wrench;
use crate::measurement::{Provenance, SensorSigmas, Sidecar};
use crate::model::Model;

pub use table::{
    CountLoss, EncoderTable, ImuTable, InclinometerTable, LoadPinTable, SensorTable, SwivelTable, TrackerTable,
};

use cables::CableSensors;
use imu::Imu;
use tracker::Tracker;

/// Sensors with what they have seen so far.
#[derive(Clone, Debug)]
pub struct Sensors {
    cables: Option<CableSensors>,
    tracker: Option<Tracker>,
    imu: Option<Imu>,
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
    /// Sensors of a machine by the tables of a scenario.
    pub fn new(table: &SensorTable, model: &Model) -> Result<Self, PlantError> {
        checks::check(table, model)?;
        let accuracies = SensorSigmas {
            position: table.tracker.map(|tracker| tracker.position_noise_m),
            rotation: table
                .tracker
                .map(|tracker| tracker.rotation_noise_rad)
                .or(table.inclinometer.map(|inclinometer| inclinometer.noise_rad)),
            // a count stands for a length of equal probability
            length: table.encoders.as_ref().map(|encoders| encoders.resolution_m / 12f64.sqrt()),
            tension: table.load_pins.as_ref().map(|pins| pins.noise_N),
            swivel: table.swivels.map(|swivels| swivels.noise_rad.hypot(swivels.resolution_rad / 12f64.sqrt())),
        };
        Ok(Self {
            cables: CableSensors::new(table, model),
            tracker: table.tracker.map(|tracker| Tracker::new(tracker, model, table.seed)),
            imu: table.imu.clone().map(|imu| Imu::new(imu, table.seed)),
            sigmas: SensorSigmas {
                position: known(accuracies.position),
                rotation: known(accuracies.rotation),
                length: known(accuracies.length),
                tension: known(accuracies.tension),
                swivel: known(accuracies.swivel),
            },
        })
    }

    /// Looks at a state after each step, under a further wrench on the platform (world axes, moment about its origin; N, N·m).
    pub fn look(&mut self, plant: &Plant, state: &State, further: &Wrench) {
        if let Some(cables) = &mut self.cables {
            cables.look(plant, state);
        }
        if let Some(tracker) = &mut self.tracker {
            tracker.look(state);
        }
        if let Some(imu) = &mut self.imu {
            imu.look(plant, state, further);
        }
    }

    /// Sidecar of their measurement file: accuracies, and the run that it comes from.
    pub fn sidecar(&self, plant: &Plant, source: String) -> Sidecar {
        let robot = Some(plant.model().robot().name.clone());
        let provenance = Some(Provenance { source: Some(source), robot, ..Provenance::default() });
        Sidecar { layout_version: 1, sigmas: self.sigmas, provenance, ..Sidecar::default() }
    }

    /// Rows per second and numbers in a row of the files of the sensors that are there.
    pub(super) fn rates(&self, model: &Model) -> Vec<(f64, usize)> {
        let cables = self.cables.iter().map(|cables| cables.rate_and_columns(model));
        let tracker = self.tracker.iter().map(|tracker| tracker.rate_and_columns(model));
        let imu = self.imu.iter().map(Imu::rate_and_columns);
        cables.chain(tracker).chain(imu).collect()
    }

    /// Files of the sensors that are there.
    pub fn logs(&self, plant: &Plant) -> Vec<SensorLog> {
        let cables = self.cables.iter().map(|cables| SensorLog { name: "measurements.csv", csv: cables.csv(plant) });
        let tracker = self.tracker.iter().map(|tracker| SensorLog { name: "tracker.csv", csv: tracker.csv(plant) });
        let imu = self.imu.iter().map(|imu| SensorLog { name: "imu.csv", csv: imu.csv() });
        cables.chain(tracker).chain(imu).collect()
    }
}

/// An accuracy of 0 is none that a fit can divide by.
fn known(sigma: Option<f64>) -> Option<f64> {
    sigma.filter(|sigma| *sigma > 0.0)
}
