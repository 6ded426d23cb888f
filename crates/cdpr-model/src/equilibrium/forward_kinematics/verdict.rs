//! Verdict on the best end of a search: status and reason in words.

use super::Status;
use super::descent::{PoseEnd, Problem, Stop};
use crate::geometry::Pose;

/// Residual relative to the mean length above which a converged answer has a remark.
const REMARKABLE_RESIDUAL: f64 = 0.01;

/// Smallest pivot of the scaled normal equations at which lengths determine a pose.
const REGULAR: f64 = 1e-12;

impl Problem<'_> {
    /// True if the residual is so small that no other start can give a better one.
    pub(super) fn is_good(&self, end: &PoseEnd) -> bool {
        end.stop == Stop::Stationary && end.rms <= self.good_residual()
    }

    /// True for an answer that further starts need not replace: a good pose, or one that the lengths determine as well
    /// as their errors allow.
    pub(super) fn is_answer(&self, end: &PoseEnd) -> bool {
        let fits = !self.is_square() && end.rms <= self.settings.plausible_residual * self.mean_length;
        self.is_good(end) || (end.stop == Stop::Stationary && end.pivot_ratio >= REGULAR && fits)
    }

    fn is_square(&self) -> bool {
        self.model.cable_count() == self.model.dof()
    }

    fn exact_residual(&self) -> f64 {
        self.settings.length_tolerance * self.mean_length.max(1.0)
    }

    /// Measured lengths give residuals of millimetres per metre; a wrong local minimum gives more.
    fn good_residual(&self) -> f64 {
        if self.is_square() { self.exact_residual() } else { self.settings.suspicious_residual * self.mean_length }
    }

    /// Status and reason for the best end.
    pub(super) fn judge(&self, end: &PoseEnd, restarts: u32) -> (Status, Option<String>) {
        let starts = restarts + 1;
        let rms = end.rms;
        match end.stop {
            Stop::Degenerate => (Status::NotConverged, Some(self.degenerate_reason(&end.pose))),
            _ if rms > self.settings.plausible_residual * self.mean_length => (
                Status::NotConverged,
                Some(format!(
                    "the best of {starts} starts leaves {rms:.3} m rms of {:.3} m mean length: these lengths do not belong to \
                     this robot; check order, units, scale and offset",
                    self.mean_length
                )),
            ),
            Stop::IterationLimit => (
                Status::NotConverged,
                Some(format!(
                    "the limit of {} iterations was reached; the residual is {rms:.3e} m rms",
                    self.settings.max_iterations
                )),
            ),
            _ if end.pivot_ratio < REGULAR => (
                Status::Singular,
                Some("the structure matrix has lost rank: the pose can move while all cable lengths stay".to_owned()),
            ),
            _ if self.is_square() && rms > self.exact_residual() => (
                Status::NotConverged,
                Some(format!(
                    "the best of {starts} starts is a stationary point that leaves {rms:.3e} m rms; with as many cables as \
                     degrees of freedom only a vanishing residual is a solution, so no pose near it has these lengths"
                )),
            ),
            Stop::Stalled => (
                Status::NotConverged,
                Some(format!(
                    "no step lowers the residual of {rms:.3e} m rms any further, though the steps are not yet small"
                )),
            ),
            Stop::Stationary | Stop::Singular => (Status::Converged, self.remark(rms, restarts)),
        }
    }

    /// Remark on a converged answer: with m = n there may be other exact solutions; the pose may belong to another
    /// start than the guess; for m > n the lengths may contradict each other by more than a percent.
    fn remark(&self, rms: f64, restarts: u32) -> Option<String> {
        if self.is_square() {
            let text = "exact: the pose has these lengths; with as many cables as degrees of freedom other poses may have them too";
            return Some(text.to_owned());
        }
        let elsewhere = (restarts > 0).then(|| {
            format!("the guess leads to no answer: the pose was found from other starts, {restarts} of them, and may not be the only one")
        });
        let contradicts = (rms > REMARKABLE_RESIDUAL * self.mean_length).then(|| {
            let fraction = 100.0 * rms / self.mean_length;
            format!(
                "the lengths contradict each other by {rms:.3} m rms ({fraction:.1} % of their mean): this is the pose that fits \
                 them best near its start; an uncalibrated scale or offset, or the wrong robot, would explain it"
            )
        });
        match (elsewhere, contradicts) {
            (Some(elsewhere), Some(contradicts)) => Some(format!("{elsewhere}; {contradicts}")),
            (elsewhere, contradicts) => elsewhere.or(contradicts),
        }
    }

    fn degenerate_reason(&self, pose: &Pose) -> String {
        let cables = 0..self.model.cable_count();
        let found = cables.into_iter().find_map(|cable| self.model.path(cable, pose).err());
        found.map_or_else(
            || "the cable lengths cannot be computed at the start".to_owned(),
            |reason| format!("at the start, {reason}"),
        )
    }
}
