//! An inertial unit on the platform: specific force R⁻¹(a − g) and angular velocity R⁻¹ω in its axes.

use nalgebra::Vector3;

use super::entry::{Seen, Sensor, SensorEntry, SensorSetting};
use super::signal::Noise;
use crate::error::PlantError;
use crate::keys::{Key, Shape};
use cdpr_model::geometry::Twist;
use cdpr_model::model::Model;

/// Index of the random stream.
const NOISE: u64 = 6;

pub(super) const IMU: SensorEntry = SensorEntry {
    table: "sensors.imu",
    summary: "Inertial unit on the platform, its axes those of the platform frame.",
    file: "imu.csv",
    keys: &[
        Key::with_default("rate_Hz", 100.0, Shape::Positive, "Rows per second."),
        Key::optional("position_m", Shape::Vector, "Its place (platform frame, m); the platform origin when missing."),
        Key::with_default(
            "acceleration_noise_m_s2",
            0.0,
            Shape::NotNegative,
            "Standard deviation of the specific force per axis (m/s²).",
        ),
        Key::optional("acceleration_bias_m_s2", Shape::Vector, "Bias of the specific force (m/s²); none when missing."),
        Key::with_default(
            "gyro_noise_rad_s",
            0.0,
            Shape::NotNegative,
            "Standard deviation of the angular velocity per axis (rad/s).",
        ),
        Key::optional("gyro_bias_rad_s", Shape::Vector, "Bias of the angular velocity (rad/s); none when missing."),
    ],
    make,
};

#[derive(Clone, Debug)]
struct Imu {
    /// Position (platform frame, m).
    position: Vector3<f64>,
    /// Biases of specific force (m/s²) and angular velocity (rad/s).
    biases: [Vector3<f64>; 2],
    /// Standard deviations of the noise of specific force (m/s²) and angular velocity (rad/s).
    sigmas: [f64; 2],
    noise: Noise,
}

fn make(setting: &SensorSetting<'_>) -> Result<Box<dyn Sensor>, PlantError> {
    let stated = setting.stated;
    Ok(Box::new(Imu {
        position: stated.vector("position_m").into(),
        biases: ["acceleration_bias_m_s2", "gyro_bias_rad_s"].map(|key| stated.vector(key).into()),
        sigmas: ["acceleration_noise_m_s2", "gyro_noise_rad_s"].map(|key| stated.number_or_zero(key)),
        noise: Noise::new(setting.seed, NOISE),
    }))
}

impl Sensor for Imu {
    fn columns(&self, _model: &Model) -> Vec<String> {
        let names = ["fx_m_s2", "fy_m_s2", "fz_m_s2", "wx_rad_s", "wy_rad_s", "wz_rad_s"];
        names.map(str::to_owned).to_vec()
    }

    fn read(&mut self, seen: &Seen<'_>) -> Option<Vec<f64>> {
        let (plant, state) = (seen.plant, seen.state);
        let (twist, rates) = (state.twist(), plant.acceleration(state, seen.further));
        let part = |twist: &Twist, from: usize| Vector3::new(twist[from], twist[from + 1], twist[from + 2]);
        let (omega, alpha) = (part(&twist, 3), part(&rates, 3));
        let arm = state.pose.rotation * self.position;
        let acceleration = part(&rates, 0) + alpha.cross(&arm) + omega.cross(&omega.cross(&arm));
        let to_platform = state.pose.rotation.inverse();
        let mut noisy = |value: Vector3<f64>, which: usize| {
            let sigma = self.sigmas[which];
            to_platform * value + self.biases[which] + Vector3::from_fn(|_, _| self.noise.of(sigma))
        };
        let force = noisy(acceleration - plant.gravity, 0);
        let turning = noisy(omega, 1);
        Some(force.iter().chain(turning.iter()).copied().collect())
    }

    fn boxed_clone(&self) -> Box<dyn Sensor> {
        Box::new(self.clone())
    }
}
