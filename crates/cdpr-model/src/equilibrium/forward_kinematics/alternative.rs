//! Other poses that fit the lengths better than the one found from the guess.

use super::descent::{Problem, Stop};
use super::{Scratch, Solver, Status};
use crate::equilibrium::restarts::restart_poses;
use crate::geometry::Pose;

/// Fraction of the residual below which another pose fits better.
const BETTER: f64 = 0.999;

/// A pose that fits the lengths better than the answer does, and to which no descent from the guess leads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alternative {
    /// Platform pose.
    pub pose: Pose,
    /// Root mean square of its length residuals (m).
    pub residual_rms: f64,
}

impl Solver<'_> {
    /// The best-fitting pose from other starts, if the last solution has a residual larger than errors of measurement
    /// explain (`suspicious_residual`); `None` if no other start leads to a better fit.
    ///
    /// It takes as many descents as `max_restarts`, each as long as that of a solution.
    pub fn alternative(&mut self) -> Option<Alternative> {
        let (model, settings) = (self.model, &self.settings);
        let Scratch { solution, targets, residuals, .. } = &self.scratch;
        let rms = solution.residual_rms;
        let is_explained = !(rms > settings.suspicious_residual * self.mean_length);
        if solution.status != Status::Converged || is_explained || model.cable_count() == model.dof() {
            return None;
        }
        let problem =
            Problem { model, settings, targets, mean_length: self.mean_length, platform_radius: self.platform_radius };
        let mut residuals = residuals.clone();
        let ends = restart_poses(model, &solution.pose)
            .take(settings.max_restarts as usize)
            .map(|start| problem.descend(&start, &mut residuals));
        let best = ends
            .filter(|end| end.stop == Stop::Stationary && end.rms < BETTER * rms)
            .min_by(|a, b| a.rms.total_cmp(&b.rms))?;
        Some(Alternative { pose: best.pose, residual_rms: best.rms })
    }
}
