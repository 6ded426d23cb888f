//! Encoders at the swivels of the pulleys: angles about their axes from the direction of gravity.

use super::entry::{Seen, Sensor, SensorEntry, SensorSetting, refused};
use super::record::cable_columns;
use super::signal::{Noise, counted};
use crate::error::PlantError;
use crate::keys::{Key, Shape};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Model;

/// Index of the random stream.
const STREAM: u64 = 2;

pub(super) const SWIVELS: SensorEntry = SensorEntry {
    table: "sensors.swivels",
    summary: "Encoders at the swivels of the pulleys.",
    file: "measurements.csv",
    keys: &[
        Key::with_default("noise_rad", 0.0, Shape::NotNegative, "Standard deviation of the noise (rad)."),
        Key::with_default("resolution_rad", 0.0, Shape::NotNegative, "Angle that a count stands for (rad)."),
    ],
    make,
};

#[derive(Clone, Debug)]
struct Swivels {
    sigma: f64,
    resolution: f64,
    noise: Noise,
}

fn make(setting: &SensorSetting<'_>) -> Result<Box<dyn Sensor>, PlantError> {
    let model = setting.model;
    if (0..model.cable_count()).all(|cable| swivel_angle(model, cable, &Pose::identity()).is_none()) {
        let message = "the model has no pulleys that swivel across gravity: take one with the effect `pulley`, and state `gravity_m_s2`".to_owned();
        return Err(refused("sensors", "swivels", message));
    }
    let [sigma, resolution] = ["noise_rad", "resolution_rad"].map(|key| setting.stated.number_or_zero(key));
    Ok(Box::new(Swivels { sigma, resolution, noise: Noise::new(setting.seed, STREAM) }))
}

/// Angle of a pulley's swivel, right-handed about its axis from the direction of gravity (rad); `None` if the pulley
/// does not swivel or the robot has no gravity.
fn swivel_angle(model: &Model, cable: usize, pose: &Pose) -> Option<f64> {
    model.swivel_angle(cable, pose, &model.robot().gravity?)
}

impl Sensor for Swivels {
    fn columns(&self, model: &Model) -> Vec<String> {
        cable_columns("swivel_rad", model)
    }

    fn read(&mut self, seen: &Seen<'_>) -> Option<Vec<f64>> {
        let model = seen.plant.model();
        let angle = |cable: usize| {
            // the cell of a swivel whose angle is not determined is empty
            let angle = swivel_angle(model, cable, &seen.state.pose).unwrap_or(f64::NAN);
            counted(angle + self.noise.of(self.sigma), self.resolution)
        };
        Some((0..model.cable_count()).map(angle).collect())
    }

    fn add_accuracies(&self, sigmas: &mut SensorSigmas) {
        sigmas.swivel = Some(self.sigma.hypot(self.resolution / 12f64.sqrt()));
    }

    fn boxed_clone(&self) -> Box<dyn Sensor> {
        Box::new(self.clone())
    }
}
