//! Sensors as a scenario states them.

use schemars::JsonSchema;
use serde::Deserialize;

/// Sensors of the machine; each is there where its table is. A machine without tables is measured by nothing.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct SensorTable {
    /// Seed of all noise.
    #[serde(default)]
    pub seed: u64,
    /// Rows of measurements.csv per second: encoders, load pins, swivels and inclinometer at one time; 100 when missing.
    #[serde(default = "hundred")]
    #[schemars(range(min = 0))]
    pub rate_Hz: f64,
    /// Encoders of the winches: recorded lengths.
    pub encoders: Option<EncoderTable>,
    /// Load pins: recorded tensions.
    pub load_pins: Option<LoadPinTable>,
    /// Encoders at the swivels of the pulleys.
    pub swivels: Option<SwivelTable>,
    /// Orientation of the platform.
    pub inclinometer: Option<InclinometerTable>,
    /// Poses of the platform, with a clock of their own.
    pub tracker: Option<TrackerTable>,
    /// Inertial unit on the platform.
    pub imu: Option<ImuTable>,
}

fn hundred() -> f64 {
    100.0
}

/// Encoders of the winches.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EncoderTable {
    /// Length of cable that a count stands for (m); 0 for encoders that resolve everything.
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub resolution_m: f64,
    /// Counts that get lost.
    #[serde(default)]
    pub loss: Vec<CountLoss>,
}

/// Counts of an encoder that get lost at a time.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CountLoss {
    /// Time since the start (s).
    pub time_s: f64,
    /// Number of the cable, from 1.
    pub cable: usize,
    /// Length by which the record is too short from then on (m).
    pub length_m: f64,
}

/// Load pins at the outlets.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct LoadPinTable {
    /// Standard deviation of the noise (N).
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub noise_N: f64,
    /// Bias of each pin (N); none when missing.
    pub bias_N: Option<Vec<f64>>,
    /// Cut-off of the amplifier's low-pass of first order (Hz); none when missing.
    pub bandwidth_Hz: Option<f64>,
    /// Largest tension that a pin shows (N), none below zero; no limits when missing.
    pub range_N: Option<f64>,
}

/// Encoders at the swivels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SwivelTable {
    /// Standard deviation of the noise (rad).
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub noise_rad: f64,
    /// Angle that a count stands for (rad).
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub resolution_rad: f64,
}

/// Orientation of the platform by its own sensor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InclinometerTable {
    /// Standard deviation of the noise per axis (rad).
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub noise_rad: f64,
}

/// A tracker of the platform.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct TrackerTable {
    /// Poses per second.
    #[serde(default = "hundred")]
    pub rate_Hz: f64,
    /// Time from a pose to its row (s): rows state when they arrive.
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub latency_s: f64,
    /// Standard deviation of the position per axis (m).
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub position_noise_m: f64,
    /// Standard deviation of the orientation per axis (rad).
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub rotation_noise_rad: f64,
    /// Dropouts per second of sight, at random times; their rows are missing.
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub dropouts_per_s: f64,
    /// Length of a dropout (s).
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub dropout_s: f64,
}

/// An inertial unit fixed to the platform, its axes those of the platform frame.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct ImuTable {
    /// Rows per second.
    #[serde(default = "hundred")]
    pub rate_Hz: f64,
    /// Its place (platform frame, m); the platform origin when missing.
    #[serde(default)]
    pub position_m: [f64; 3],
    /// Standard deviation of the specific force per axis (m/s²).
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub acceleration_noise_m_s2: f64,
    /// Bias of the specific force (m/s²).
    #[serde(default)]
    pub acceleration_bias_m_s2: [f64; 3],
    /// Standard deviation of the angular velocity per axis (rad/s).
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub gyro_noise_rad_s: f64,
    /// Bias of the angular velocity (rad/s).
    #[serde(default)]
    pub gyro_bias_rad_s: [f64; 3],
}
