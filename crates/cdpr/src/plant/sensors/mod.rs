//! Sensors of a machine in time: what is logged is what they see.
//!
//! [`Sensors`] is a value beside the [`State`](super::State): a clone of both is a snapshot. It looks at every step, since
//! amplifiers remember, and keeps rows at the times of each sensor. Every sensor has a random stream of its own: another sensor more changes
//! no number of the others.

mod cables;
mod imu;
mod table;
#[cfg(test)]
mod tests;
mod tracker;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::error::{PlantError, ScenarioKey};
use super::plant::Plant;
use super::state::State;
use crate::geometry::Wrench;
use crate::measurement::SensorSigmas;
use crate::model::Model;

pub use table::{
    CountLoss, EncoderTable, ImuTable, InclinometerTable, LoadPinTable, SensorTable, SwivelTable, TrackerTable,
};

use cables::CableSensors;
use imu::Imu;
use tracker::Tracker;

/// Times that differ by less than this are one (s).
const SAME_TIME: f64 = 1e-9;

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
        check(table, model)?;
        let accuracies = SensorSigmas {
            position: table.tracker.map(|tracker| tracker.position_noise_m),
            rotation: table
                .tracker
                .map(|tracker| tracker.rotation_noise_rad)
                .or(table.inclinometer.map(|inclinometer| inclinometer.noise_rad)),
            // a count stands for a length of equal probability
            length: table.encoders.as_ref().map(|encoders| encoders.resolution_m / 12f64.sqrt()),
            tension: table.load_pins.as_ref().map(|pins| pins.noise_N),
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

    /// Accuracies of the sensors, as a sidecar of measurements states them.
    pub fn sigmas(&self) -> SensorSigmas {
        self.sigmas
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

/// Times at which a sensor is read: the first step at or after each multiple of its interval.
#[derive(Clone, Debug, PartialEq)]
struct Clock {
    interval: f64,
    next: u64,
}

impl Clock {
    fn new(rate: f64) -> Self {
        Self { interval: 1.0 / rate, next: 0 }
    }

    /// True where the sensor is read at a time.
    fn is_due(&mut self, time: f64) -> bool {
        let due = time + SAME_TIME >= self.next as f64 * self.interval;
        if due {
            // steps longer than the interval skip what they pass
            self.next = ((time + SAME_TIME) / self.interval).floor() as u64 + 1;
        }
        due
    }
}

/// Normal noise of one sensor.
#[derive(Clone, Debug)]
struct Noise(ChaCha8Rng);

impl Noise {
    fn new(seed: u64, stream: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(stream);
        Self(random)
    }

    /// A normal number of this standard deviation.
    fn of(&mut self, sigma: f64) -> f64 {
        let normal: f64 = StandardNormal.sample(&mut self.0);
        sigma * normal
    }
}

/// A low-pass of first order that is told its input at the end of every step.
#[derive(Clone, Debug, PartialEq)]
struct LowPass {
    /// Cut-off (Hz); everything passes without one.
    cut_off: Option<f64>,
    value: Option<f64>,
}

impl LowPass {
    fn new(cut_off: Option<f64>) -> Self {
        Self { cut_off, value: None }
    }

    /// Output after an input held over a time (s).
    fn pass(&mut self, input: f64, time: f64) -> f64 {
        let output = match (self.cut_off, self.value) {
            (Some(cut_off), Some(value)) => {
                value + (input - value) * -(-std::f64::consts::TAU * cut_off * time).exp_m1()
            }
            _ => input,
        };
        self.value = Some(output);
        output
    }
}

/// The nearest whole multiple of a resolution; the value itself where that is 0.
fn counted(value: f64, resolution: f64) -> f64 {
    if resolution > 0.0 { (value / resolution).round() * resolution } else { value }
}

fn check(table: &SensorTable, model: &Model) -> Result<(), PlantError> {
    let wrong = |name: &'static str, key: &'static str, message: String| {
        Err(PlantError::Value { key: ScenarioKey { table: name, index: None, key }, message })
    };
    let rates = [
        ("sensors", table.rate_Hz),
        ("sensors.tracker", table.tracker.map_or(1.0, |tracker| tracker.rate_Hz)),
        ("sensors.imu", table.imu.as_ref().map_or(1.0, |imu| imu.rate_Hz)),
    ];
    if let Some((name, rate)) = rates.into_iter().find(|(_, rate)| !(*rate > 0.0 && rate.is_finite())) {
        return wrong(name, "rate_Hz", format!("rate_Hz is {rate}; it is above 0"));
    }
    for (name, key, value) in not_negative(table) {
        if !(value >= 0.0 && value.is_finite()) {
            return wrong(name, key, format!("{key} is {value}; it is 0 or more"));
        }
    }
    let cables = model.cable_count();
    if let Some(bias) =
        table.load_pins.as_ref().and_then(|pins| pins.bias_N.as_ref()).filter(|bias| bias.len() != cables)
    {
        let message = format!("bias_N has {} numbers; the robot has {cables} cables", bias.len());
        return wrong("sensors.load_pins", "bias_N", message);
    }
    let losses = table.encoders.iter().flat_map(|encoders| &encoders.loss);
    if let Some(loss) = losses.into_iter().find(|loss| !(1..=cables).contains(&loss.cable)) {
        let message = format!("cable {} does not exist: cables count from 1 to {cables}", loss.cable);
        return wrong("sensors.encoders", "loss", message);
    }
    if table.swivels.is_some()
        && (0..cables).all(|cable| cables::swivel_angle(model, cable, &crate::geometry::Pose::identity()).is_none())
    {
        let message = "the model has no pulleys that swivel: take one with the effect `pulley`".to_owned();
        return wrong("sensors", "swivels", message);
    }
    if table.inclinometer.is_some() && !model.robot().motion_pattern.has_rotation() {
        return wrong("sensors", "inclinometer", "the platform is a point and does not turn".to_owned());
    }
    Ok(())
}

/// Numbers of the tables that are 0 or more, with their keys.
fn not_negative(table: &SensorTable) -> Vec<(&'static str, &'static str, f64)> {
    let mut all = Vec::new();
    if let Some(encoders) = &table.encoders {
        all.push(("sensors.encoders", "resolution_m", encoders.resolution_m));
    }
    if let Some(pins) = &table.load_pins {
        all.push(("sensors.load_pins", "noise_N", pins.noise_N));
        all.push(("sensors.load_pins", "bandwidth_Hz", pins.bandwidth_Hz.unwrap_or(0.0)));
        all.push(("sensors.load_pins", "range_N", pins.range_N.unwrap_or(0.0)));
    }
    if let Some(swivels) = table.swivels {
        all.push(("sensors.swivels", "noise_rad", swivels.noise_rad));
        all.push(("sensors.swivels", "resolution_rad", swivels.resolution_rad));
    }
    if let Some(inclinometer) = table.inclinometer {
        all.push(("sensors.inclinometer", "noise_rad", inclinometer.noise_rad));
    }
    if let Some(tracker) = table.tracker {
        all.push(("sensors.tracker", "latency_s", tracker.latency_s));
        all.push(("sensors.tracker", "position_noise_m", tracker.position_noise_m));
        all.push(("sensors.tracker", "rotation_noise_rad", tracker.rotation_noise_rad));
        all.push(("sensors.tracker", "dropouts_per_s", tracker.dropouts_per_s));
        all.push(("sensors.tracker", "dropout_s", tracker.dropout_s));
    }
    if let Some(imu) = &table.imu {
        all.push(("sensors.imu", "acceleration_noise_m_s2", imu.acceleration_noise_m_s2));
        all.push(("sensors.imu", "gyro_noise_rad_s", imu.gyro_noise_rad_s));
    }
    all
}
