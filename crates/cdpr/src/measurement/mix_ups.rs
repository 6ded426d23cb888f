//! Mistakes of recording that explain why poses and lengths disagree, found by trying them.
//!
//! Lengths of point outlets at the poses, read in another way, are compared with the recorded lengths, cable by cable and up to an
//! offset and a scale, which winches are free to have. A mix-up is named when so read at most a third of the misfit is left.

mod alternatives;
mod marker;
#[cfg(test)]
mod tests;

use alternatives::{Reading, readings};

use super::Samples;
use super::magnitudes::three_digits;
use crate::geometry::Pose;
use crate::robot::Robot;

/// Misfits below this share of the diagonal of the anchors' box are no question of mix-ups.
const IGNORED_SHARE: f64 = 2e-4;
/// The same for a marker, which has six numbers to adapt to anchors that are a little wrong.
const IGNORED_OF_MARKER: f64 = 1e-3;
/// A mix-up explains the misfit when it leaves at most this share of it.
const EXPLAINED: f64 = 1.0 / 3.0;
/// A later way to read the data is told instead of an earlier one when it leaves at most this share of what that leaves.
const CLEARLY: f64 = 0.5;
/// Most samples that are looked at, and fewest that tell.
const LOOKED_AT: usize = 200;
const FEWEST: usize = 6;
/// Scales that a winch may have.
const SCALES: (f64, f64) = (0.8, 1.25);

/// The mix-up that explains the misfit of poses and lengths, in words; `angles` are those that the file gives (rad), if it gives
/// angles.
pub(super) fn found(robot: &Robot, samples: &Samples, angles: &[[f64; 3]]) -> Option<String> {
    let data = Data::of(robot, samples, angles);
    if data.poses.len() < FEWEST {
        return None;
    }
    let as_written = data.misfit(&data.poses);
    if !(as_written > IGNORED_SHARE * robot.anchor_diagonal()) {
        return None;
    }
    let may_be_marker = as_written > IGNORED_OF_MARKER * robot.anchor_diagonal();
    let (left, words) = data.best(EXPLAINED * as_written, may_be_marker)?;
    Some(format!(
        "{words} (misfit {} m as written, {} m so read, offsets and scales of the cables left aside)",
        three_digits(as_written),
        three_digits(left)
    ))
}

/// The samples that are looked at.
struct Data<'a> {
    robot: &'a Robot,
    poses: Vec<Pose>,
    /// Angles rx, ry, rz or the one of the plane (rad), as the file gives them or as the poses have them.
    angles: Vec<[f64; 3]>,
    /// Recorded lengths, cable by cable (m).
    recorded: Vec<Vec<f64>>,
}

impl<'a> Data<'a> {
    fn of(robot: &'a Robot, samples: &Samples, angles: &[[f64; 3]]) -> Self {
        let stride = samples.len().div_ceil(LOOKED_AT).max(1);
        let chosen: Vec<usize> = (0..samples.len()).step_by(stride).collect();
        let of_cable = |cable: usize| chosen.iter().map(|&sample| samples.lengths_of(sample)[cable]).collect();
        let angles_of = |sample: usize| match angles.get(sample) {
            Some(angles) => *angles,
            None => samples.poses[sample].xyz_angles(),
        };
        Self {
            robot,
            poses: chosen.iter().map(|&sample| samples.poses[sample]).collect(),
            angles: chosen.iter().map(|&sample| angles_of(sample)).collect(),
            recorded: (0..samples.cable_count).map(of_cable).collect(),
        }
    }

    /// The mix-up that leaves least, with what it leaves (m), where that is below a limit; of the marker only where no other explains.
    fn best(&self, limit: f64, may_be_marker: bool) -> Option<(f64, String)> {
        let mut best: Option<(f64, String)> = None;
        let mut offer = |left: f64, words: &dyn Fn() -> String| {
            if left <= limit && best.as_ref().is_none_or(|(least, _)| left < CLEARLY * least) {
                best = Some((left, words()));
            }
        };
        let (left, order) = self.permuted();
        offer(left, &|| {
            let order: Vec<String> = order.iter().map(|column| (column + 1).to_string()).collect();
            format!(
                "the cables look permuted: cables 1 to {} of the robot fit the recorded lengths {}",
                order.len(),
                order.join(", ")
            )
        });
        for Reading { words, read } in readings(self.robot) {
            let poses: Option<Vec<Pose>> =
                self.poses.iter().zip(&self.angles).map(|(pose, angles)| read(pose, angles)).collect();
            let Some(poses) = poses else { continue };
            offer(self.misfit(&poses), &|| words.clone());
        }
        best.or_else(|| {
            let marker = marker::Marker::of(self).filter(|_| may_be_marker)?;
            let left = self.misfit(&marker.platform_poses(&self.poses));
            (left <= limit).then(|| (left, marker.words(self.robot)))
        })
    }

    /// Root of the mean square of what the lengths at these poses leave of the recorded ones (m).
    fn misfit(&self, poses: &[Pose]) -> f64 {
        let m = self.recorded.len();
        let squares: f64 = (0..m).map(|cable| left_of(&self.lengths(cable, poses), &self.recorded[cable])).sum();
        (squares / m.max(1) as f64).sqrt()
    }

    /// Lengths of one cable from point to point (m).
    fn lengths(&self, cable: usize, poses: &[Pose]) -> Vec<f64> {
        let cable = &self.robot.cables[cable];
        poses.iter().map(|pose| (cable.frame_anchor - pose.transform(&cable.platform_anchor)).norm()).collect()
    }

    /// What is left when every cable of the robot takes the column that fits it best, and these columns.
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

/// Mean square of what offset and scale of a winch leave of recorded lengths (m²).
fn left_of(modelled: &[f64], recorded: &[f64]) -> f64 {
    let count = modelled.len() as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
    let (l, q) = (mean(modelled), mean(recorded));
    let pairs = || modelled.iter().zip(recorded).map(|(a, b)| (a - l, b - q));
    let (product, square) = pairs().fold((0.0, 0.0), |(product, square), (a, b)| (product + a * b, square + a * a));
    let scale = if square > 0.0 { (product / square).clamp(SCALES.0, SCALES.1) } else { 1.0 };
    pairs().map(|(a, b)| (b - scale * a).powi(2)).sum::<f64>() / count
}
