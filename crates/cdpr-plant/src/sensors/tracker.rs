//! A tracker of the platform with latency, noise and dropouts.

use rand::RngExt;

use super::entry::{Seen, Sensor, SensorEntry, SensorSetting};
use super::signal::Noise;
use crate::error::PlantError;
use crate::keys::{Key, Shape};
use cdpr_model::geometry::Twist;
use cdpr_model::measurement::{SensorSigmas, pose_columns, pose_numbers};
use cdpr_model::model::Model;

/// Indices of the random streams of noise and dropouts.
const NOISE: u64 = 4;
const DROPOUTS: u64 = 5;

pub(super) const TRACKER: SensorEntry = SensorEntry {
    table: "sensors.tracker",
    summary: "Poses of the platform, with a clock of their own.",
    file: "tracker.csv",
    keys: &[
        Key::with_default("rate_Hz", 100.0, Shape::Positive, "Poses per second."),
        Key::with_default(
            "latency_s",
            0.0,
            Shape::NotNegative,
            "Time from a pose to its row (s): rows state when they arrive.",
        ),
        Key::with_default(
            "position_noise_m",
            0.0,
            Shape::NotNegative,
            "Standard deviation of the position per axis (m).",
        ),
        Key::with_default(
            "rotation_noise_rad",
            0.0,
            Shape::NotNegative,
            "Standard deviation of the orientation per axis (rad).",
        ),
        Key::with_default(
            "dropouts_per_s",
            0.0,
            Shape::NotNegative,
            "Dropouts per second of sight, at random times; their rows are missing.",
        ),
        Key::with_default("dropout_s", 0.0, Shape::NotNegative, "Length of a dropout (s)."),
    ],
    make,
};

#[derive(Clone, Debug)]
struct Tracker {
    /// Time from a pose to its row (s).
    latency: f64,
    /// Standard deviations of position (m) and orientation (rad).
    sigmas: [f64; 2],
    /// Dropouts per second of sight, and the length of a dropout (s).
    blindness: [f64; 2],
    basis: Vec<Twist>,
    noise: Noise,
    dropouts: Noise,
    /// Start of the next dropout (s).
    blind_from: f64,
}

fn make(setting: &SensorSetting<'_>) -> Result<Box<dyn Sensor>, PlantError> {
    let numbers = |keys: [&str; 2]| keys.map(|key| setting.stated.number_or_zero(key));
    let mut tracker = Tracker {
        latency: setting.stated.number_or_zero("latency_s"),
        sigmas: numbers(["position_noise_m", "rotation_noise_rad"]),
        blindness: numbers(["dropouts_per_s", "dropout_s"]),
        basis: setting.model.twist_basis().to_vec(),
        noise: Noise::new(setting.seed, NOISE),
        dropouts: Noise::new(setting.seed, DROPOUTS),
        blind_from: f64::INFINITY,
    };
    tracker.blind_from = tracker.sight();
    Ok(Box::new(tracker))
}

impl Tracker {
    /// Time of sight until the next dropout (s), exponentially distributed.
    fn sight(&mut self) -> f64 {
        let [per_second, length] = self.blindness;
        if per_second > 0.0 && length > 0.0 {
            let fraction: f64 = self.dropouts.0.random();
            -(1.0 - fraction).ln() / per_second
        } else {
            f64::INFINITY
        }
    }
}

impl Sensor for Tracker {
    fn columns(&self, model: &Model) -> Vec<String> {
        pose_columns(model.robot())
    }

    fn read(&mut self, seen: &Seen<'_>) -> Option<Vec<f64>> {
        let (state, length) = (seen.state, self.blindness[1]);
        while state.time >= self.blind_from + length {
            self.blind_from += length + self.sight();
        }
        let [position, rotation] = self.sigmas;
        let mut error = Twist::zeros();
        for basis in &self.basis {
            let is_turn = basis.fixed_rows::<3>(3).norm() > 0.0;
            error += basis * self.noise.of(if is_turn { rotation } else { position });
        }
        let is_seen = state.time < self.blind_from;
        is_seen.then(|| pose_numbers(seen.plant.model().robot(), &state.pose.displaced(&error)))
    }

    fn time_of_row(&self, time: f64) -> f64 {
        // to nanoseconds, so that the sum does not show its rounding
        ((time + self.latency) * 1e9).round() / 1e9
    }

    fn add_accuracies(&self, sigmas: &mut SensorSigmas) {
        let [position, rotation] = self.sigmas;
        (sigmas.position, sigmas.rotation) = (Some(position), Some(rotation));
    }

    fn boxed_clone(&self) -> Box<dyn Sensor> {
        Box::new(self.clone())
    }
}
