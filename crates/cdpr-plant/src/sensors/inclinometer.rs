//! An inclinometer: orientation of the platform from its own sensor, at the times of the winches' clock.

use super::entry::{Seen, Sensor, SensorEntry, SensorSetting, refused};
use super::signal::Noise;
use crate::error::PlantError;
use crate::keys::{Key, Shape};
use cdpr_model::geometry::Twist;
use cdpr_model::measurement::{SensorSigmas, turn_columns, turn_numbers};
use cdpr_model::model::Model;

/// Index of the random stream.
const STREAM: u64 = 3;

pub(super) const INCLINOMETER: SensorEntry = SensorEntry {
    table: "sensors.inclinometer",
    summary: "Orientation of the platform.",
    file: "measurements.csv",
    keys: &[Key::with_default("noise_rad", 0.0, Shape::NotNegative, "Standard deviation of the noise per axis (rad).")],
    make,
};

#[derive(Clone, Debug)]
struct Inclinometer {
    sigma: f64,
    noise: Noise,
    /// Directions about which the platform turns.
    turns: Vec<Twist>,
}

fn make(setting: &SensorSetting<'_>) -> Result<Box<dyn Sensor>, PlantError> {
    if !setting.model.robot().motion_pattern.has_rotation() {
        return Err(refused("sensors", "inclinometer", "the platform is a point and does not turn".to_owned()));
    }
    let is_turn = |basis: &&Twist| basis.fixed_rows::<3>(3).norm() > 0.0;
    let turns = setting.model.twist_basis().iter().filter(is_turn).copied().collect();
    let (sigma, noise) = (setting.stated.number_or_zero("noise_rad"), Noise::new(setting.seed, STREAM));
    Ok(Box::new(Inclinometer { sigma, noise, turns }))
}

impl Sensor for Inclinometer {
    fn columns(&self, model: &Model) -> Vec<String> {
        turn_columns(model.robot().motion_pattern).iter().map(|name| (*name).to_owned()).collect()
    }

    fn read(&mut self, seen: &Seen<'_>) -> Option<Vec<f64>> {
        let error: Twist = self.turns.iter().map(|basis| basis * self.noise.of(self.sigma)).sum();
        Some(turn_numbers(seen.plant.model().robot(), &seen.state.pose.displaced(&error)))
    }

    fn add_accuracies(&self, sigmas: &mut SensorSigmas) {
        sigmas.rotation = Some(self.sigma);
    }

    fn boxed_clone(&self) -> Box<dyn Sensor> {
        Box::new(self.clone())
    }
}
