//! An inertial unit on the platform: specific force R⁻¹(a − g) and angular velocity R⁻¹ω in its axes.

use std::fmt::Write;

use nalgebra::Vector3;

use super::signal::{Clock, Noise};
use super::table::ImuTable;
use crate::geometry::Wrench;
use crate::plant::plant::Plant;
use crate::plant::state::State;

/// Random stream.
const NOISE: u64 = 6;

/// Inertial unit with its rows.
#[derive(Clone, Debug)]
pub(super) struct Imu {
    table: ImuTable,
    clock: Clock,
    noise: Noise,
    /// Times, specific forces (m/s²) and angular velocities (rad/s).
    rows: Vec<(f64, Vector3<f64>, Vector3<f64>)>,
}

impl Imu {
    pub(super) fn new(table: ImuTable, seed: u64) -> Self {
        Self { clock: Clock::new(table.rate_Hz), table, noise: Noise::new(seed, NOISE), rows: Vec::new() }
    }

    pub(super) fn look(&mut self, plant: &Plant, state: &State, further: &Wrench) {
        if !self.clock.is_due(state.time) {
            return;
        }
        let (twist, rates) = (state.twist(), plant.acceleration(state, further));
        let part =
            |twist: &crate::geometry::Twist, from: usize| Vector3::new(twist[from], twist[from + 1], twist[from + 2]);
        let (omega, alpha) = (part(&twist, 3), part(&rates, 3));
        let arm = state.pose.rotation * Vector3::from(self.table.position_m);
        let acceleration = part(&rates, 0) + alpha.cross(&arm) + omega.cross(&omega.cross(&arm));
        let to_platform = state.pose.rotation.inverse();
        let mut seen = |value: Vector3<f64>, bias: [f64; 3], sigma: f64| {
            to_platform * value + Vector3::from(bias) + Vector3::from_fn(|_, _| self.noise.of(sigma))
        };
        let force =
            seen(acceleration - plant.gravity, self.table.acceleration_bias_m_s2, self.table.acceleration_noise_m_s2);
        let turning = seen(omega, self.table.gyro_bias_rad_s, self.table.gyro_noise_rad_s);
        self.rows.push((state.time, force, turning));
    }

    /// Rows per second, and numbers in a row.
    pub(super) fn rate_and_columns(&self) -> (f64, usize) {
        (self.clock.rate(), 7)
    }

    pub(super) fn csv(&self) -> String {
        let mut text = "t_s,fx_m_s2,fy_m_s2,fz_m_s2,wx_rad_s,wy_rad_s,wz_rad_s\n".to_owned();
        for (time, force, turning) in &self.rows {
            let _ = write!(text, "{time}");
            for number in force.iter().chain(turning.iter()) {
                let _ = write!(text, ",{}", number + 0.0);
            }
            text.push('\n');
        }
        text
    }
}
