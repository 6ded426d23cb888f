//! Mistakes of recording that explain a disagreement of poses and lengths, found by trying them.
//!
//! Lengths of point outlets at the poses, in another reading, are compared with the recorded lengths, cable by cable
//! and up to an offset and a scale, which winches may have. A mix-up is reported if at most a third of the misfit
//! remains with it.

mod alternatives;
mod data;
mod marker;
#[cfg(test)]
mod tests;

use alternatives::{Reading, readings};
use data::{Data, left_of};

use super::Samples;
use super::three_digits;
use crate::finding::{Finding, FindingKind, Severity};
use crate::geometry::Pose;
use crate::robot::Robot;

/// Fraction of the diagonal of the anchors' box below which a misfit is no question of mix-ups.
const IGNORED_SHARE: f64 = 2e-4;
/// The same for a marker: its six numbers can also adapt to slightly wrong anchors.
const IGNORED_OF_MARKER: f64 = 1e-3;
/// Largest fraction of the misfit that remains with a mix-up that explains it.
const EXPLAINED: f64 = 1.0 / 3.0;
/// Largest residual of a mix-up, as a fraction of the diagonal: a tracker turned by a right angle resembles permuted
/// cables a little.
const MOST_LEFT: f64 = 0.01;
/// Largest residual, as a fraction of that of an earlier reading, with which a later one replaces it.
const CLEARLY: f64 = 0.5;
/// Least number of samples for a verdict.
const FEWEST: usize = 6;

/// The mix-up that explains the misfit of poses and lengths, in words; `None` without one. `angles` are those of the
/// file (rad), empty if it has none.
pub(super) fn found(robot: &Robot, samples: &Samples, angles: &[[f64; 3]]) -> Option<Finding> {
    let data = Data::of(robot, samples, angles);
    if data.poses.len() < FEWEST {
        return None;
    }
    let as_written = data.misfit(&data.poses);
    if !(as_written > IGNORED_SHARE * robot.anchor_diagonal()) {
        return None;
    }
    let may_be_marker = as_written > IGNORED_OF_MARKER * robot.anchor_diagonal();
    let (left, kind, words) =
        data.best((EXPLAINED * as_written).min(MOST_LEFT * robot.anchor_diagonal()), may_be_marker)?;
    let text = format!(
        "{words} (misfit {} m as written, {} m so read, offsets and scales of the cables left aside)",
        three_digits(as_written),
        three_digits(left)
    );
    let explained = 1.0 - (left / as_written).powi(2);
    Some(Finding::new(kind, Severity::Caution, text).of_size(as_written, "m").explaining(explained))
}

impl Data<'_> {
    /// The mix-up with the least residual, with this residual (m), if it is below a limit; a marker only if no other
    /// explains the misfit.
    fn best(&self, limit: f64, may_be_marker: bool) -> Option<(f64, FindingKind, String)> {
        let mut best: Option<(f64, FindingKind, String)> = None;
        let mut offer = |left: f64, kind: FindingKind, words: &dyn Fn() -> String| {
            if left <= limit && best.as_ref().is_none_or(|(least, ..)| left < CLEARLY * least) {
                best = Some((left, kind, words()));
            }
        };
        let (left, order) = self.permuted();
        offer(left, FindingKind::Permutation, &|| {
            let order: Vec<String> = order.iter().map(|column| (column + 1).to_string()).collect();
            format!(
                "the cables look permuted: cables 1 to {} of the robot fit the recorded lengths {}",
                order.len(),
                order.join(", ")
            )
        });
        for Reading { kind, words, read } in readings(self.robot) {
            let poses: Option<Vec<Pose>> =
                self.poses.iter().zip(&self.angles).map(|(pose, angles)| read(pose, angles)).collect();
            let Some(poses) = poses else { continue };
            offer(self.misfit(&poses), kind, &|| words.clone());
        }
        best.or_else(|| {
            let marker = marker::Marker::of(self).filter(|_| may_be_marker)?;
            let left = self.misfit(&marker.platform_poses(&self.poses));
            (left <= limit).then(|| (left, FindingKind::Marker, marker.words(self.robot)))
        })
    }

    /// Misfit if every cable of the robot takes the column that fits it best (m), and these columns.
    fn permuted(&self) -> (f64, Vec<usize>) {
        let m = self.recorded.len();
        let modelled: Vec<Vec<f64>> = (0..m).map(|cable| self.lengths(cable, &self.poses)).collect();
        let mut pairs: Vec<(f64, usize, usize)> = (0..m)
            .flat_map(|cable| (0..m).map(move |column| (cable, column)))
            .map(|(cable, column)| (left_of(&modelled[cable], &self.recorded[column]), cable, column))
            .collect();
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mut order, mut is_taken, mut squares) = (vec![usize::MAX; m], vec![false; m], 0.0);
        for (left, cable, column) in pairs {
            if order[cable] == usize::MAX && !is_taken[column] {
                (order[cable], is_taken[column]) = (column, true);
                squares += left;
            }
        }
        ((squares / m.max(1) as f64).sqrt(), order)
    }
}
