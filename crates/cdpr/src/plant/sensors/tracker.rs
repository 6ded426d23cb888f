//! A tracker of the platform: late, noisy, and blind at times.

use std::fmt::Write;

use rand::RngExt;

use super::signal::{Clock, Noise};
use super::table::TrackerTable;
use crate::geometry::{Pose, Twist};
use crate::measurement::{pose_columns, pose_numbers};
use crate::model::Model;
use crate::plant::plant::Plant;
use crate::plant::state::State;

/// Random streams of noise and dropouts.
const NOISE: u64 = 4;
const DROPOUTS: u64 = 5;

/// Tracker with its rows.
#[derive(Clone, Debug)]
pub(super) struct Tracker {
    table: TrackerTable,
    clock: Clock,
    basis: Vec<Twist>,
    noise: Noise,
    dropouts: Noise,
    /// Beginning of the next dropout (s).
    blind_from: f64,
    /// Times of arrival and poses.
    rows: Vec<(f64, Pose)>,
}

impl Tracker {
    pub(super) fn new(table: TrackerTable, model: &Model, seed: u64) -> Self {
        let mut tracker = Self {
            table,
            clock: Clock::new(table.rate_Hz),
            basis: model.twist_basis().to_vec(),
            noise: Noise::new(seed, NOISE),
            dropouts: Noise::new(seed, DROPOUTS),
            blind_from: f64::INFINITY,
            rows: Vec::new(),
        };
        tracker.blind_from = tracker.sight();
        tracker
    }

    /// Time of sight until the next dropout (s), exponentially distributed.
    fn sight(&mut self) -> f64 {
        if self.table.dropouts_per_s > 0.0 && self.table.dropout_s > 0.0 {
            let share: f64 = self.dropouts.0.random();
            -(1.0 - share).ln() / self.table.dropouts_per_s
        } else {
            f64::INFINITY
        }
    }

    pub(super) fn look(&mut self, state: &State) {
        if !self.clock.is_due(state.time) {
            return;
        }
        while state.time >= self.blind_from + self.table.dropout_s {
            self.blind_from += self.table.dropout_s + self.sight();
        }
        let (position, rotation) = (self.table.position_noise_m, self.table.rotation_noise_rad);
        let mut error = Twist::zeros();
        for basis in &self.basis {
            let is_turn = basis.fixed_rows::<3>(3).norm() > 0.0;
            error += basis * self.noise.of(if is_turn { rotation } else { position });
        }
        if state.time < self.blind_from {
            // nanoseconds: a sum shall not show its rounding
            let arrival = ((state.time + self.table.latency_s) * 1e9).round() / 1e9;
            self.rows.push((arrival, state.pose.displaced(&error)));
        }
    }

    /// Rows per second, and numbers in a row.
    pub(super) fn rate_and_columns(&self, model: &Model) -> (f64, usize) {
        (self.clock.rate(), 1 + pose_columns(model.robot()).len())
    }

    /// Columns of measurement files; `t_s` is when a pose arrives.
    pub(super) fn csv(&self, plant: &Plant) -> String {
        let robot = plant.model().robot();
        let mut names = vec!["t_s".to_owned()];
        names.extend(pose_columns(robot));
        let mut text = names.join(",") + "\n";
        for (time, pose) in &self.rows {
            let _ = write!(text, "{time}");
            for number in pose_numbers(robot, pose) {
                let _ = write!(text, ",{}", number + 0.0);
            }
            text.push('\n');
        }
        text
    }
}
