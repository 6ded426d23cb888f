//! Mistakes of recording that explain a disagreement of poses and lengths, found by trying them.
//!
//! Lengths of point outlets at the poses, in another reading, are compared with the recorded lengths, cable by cable
//! and up to an offset and a scale, which winches may have: at the poses as they are, then with the frames of a tracker
//! and a marker that fit best. A mix-up is reported if at most a third of the misfit remains with it.

mod alternatives;
mod marker;
#[cfg(test)]
mod tests;

use alternatives::{Reading, readings};

use super::comparison::frames::Framed;
use super::comparison::{Data, left_of};
use super::{Samples, three_digits};
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
/// Largest residual, as a fraction of that with free frames or anchors, with which a mix-up is the better explanation.
const CLEARLY: f64 = 0.5;
/// Largest ratio of residuals of explanations of which one beats the other.
const TIED: f64 = 0.7;
/// Logarithm of a ratio of residuals that are the same.
const EQUAL: f64 = 0.02;
/// Largest number of explanations in a sentence.
const MOST_TOLD: usize = 3;
/// Least number of samples for a verdict.
const FEWEST: usize = 6;
/// Largest number of samples to which frames are fitted.
const FRAMED: usize = 50;
/// Gain of log likelihood, one residual a sample, that noise does not give.
const BEYOND_NOISE: f64 = 10.0;

/// A mix-up with the misfit that it leaves (m).
struct Explanation {
    left: f64,
    kind: FindingKind,
    words: String,
}

impl Explanation {
    /// True unless frames of tracker and marker explain the poses as written better (misfit in m), which is no mistake of
    /// recording. Axes and cables have no numbers that adapt, and frames that stand for them turn the robot over.
    fn stands_beside(&self, in_frames: f64) -> bool {
        matches!(self.kind, FindingKind::Mirror | FindingKind::Permutation) || in_frames >= CLEARLY * self.left
    }
}

/// The mix-up that explains the misfit of poses and lengths, in words; `None` without one.
pub(super) fn found(robot: &Robot, samples: &Samples) -> Option<Finding> {
    let data = Data::of(robot, samples);
    if data.poses.len() < FEWEST {
        return None;
    }
    let (as_written, diagonal) = (data.misfit(&data.poses), robot.anchor_diagonal());
    if !(as_written > IGNORED_SHARE * diagonal) {
        return None;
    }
    let limit = |misfit: f64| (EXPLAINED * misfit).min(MOST_LEFT * diagonal);
    let few = data.thinned(FRAMED);
    let framed = Framed::of(&few);
    let in_frames = framed.misfit(&few.poses);
    let mut told = data.explanations(limit(as_written));
    if told.is_empty() && as_written > IGNORED_OF_MARKER * diagonal {
        let marker = marker::Marker::of(&data, CLEARLY).filter(|(left, _)| *left <= limit(as_written));
        told.extend(marker.map(|(left, marker)| Explanation {
            left,
            kind: FindingKind::Marker,
            words: marker.words(robot),
        }));
    }
    told.retain(|explanation| explanation.stands_beside(in_frames));
    if !told.is_empty() {
        return finding(told, as_written, "");
    }
    if !(in_frames > IGNORED_SHARE * diagonal) {
        return None;
    }
    let told = few.explanations_in_frames(&framed, limit(in_frames));
    finding(told, in_frames, ", the frames of tracker and marker that fit best")
}

/// The mix-up that a calibrated robot shows, of which only noise decides; `None` without one. `samples` have the poses
/// as they were read from the file.
pub fn with_robot(robot: &Robot, samples: &Samples) -> Option<Finding> {
    let data = Data::of(robot, samples);
    if data.poses.len() < FEWEST {
        return None;
    }
    let few = data.thinned(FRAMED);
    let limit = |misfit: f64, samples: usize| misfit * CLEARLY.min((-BEYOND_NOISE / samples as f64).exp());
    let as_written = data.misfit(&data.poses);
    let told = data.explanations(limit(as_written, data.poses.len()));
    let framed = Framed::of(&few);
    let in_frames = framed.misfit(&few.poses);
    if !told.is_empty() && told.iter().any(|explanation| explanation.stands_beside(in_frames)) {
        return finding(told, as_written, "");
    }
    let told = few.explanations_in_frames(&framed, limit(in_frames, few.poses.len()));
    finding(told, in_frames, ", the frames of tracker and marker that fit best")
}

/// The finding of what explains a misfit best: one cause if it beats the others clearly, otherwise those that do not.
fn finding(mut told: Vec<Explanation>, as_written: f64, with: &str) -> Option<Finding> {
    let least = told.iter().map(|explanation| explanation.left).fold(f64::INFINITY, f64::min);
    told.retain(|explanation| TIED * explanation.left <= least);
    // explanations that are one and the same for a robot's symmetry differ by rounding: the order of trying decides
    told.sort_by_key(|explanation| ((explanation.left / least).ln() / EQUAL).floor() as i64);
    let first = told.first()?;
    let (left, kind) = (first.left, first.kind);
    let mut words: Vec<&str> = told.iter().map(|explanation| explanation.words.as_str()).collect();
    words.truncate(MOST_TOLD);
    let words = if words.len() > 1 { format!("one of: {}", words.join("; or ")) } else { words.concat() };
    let text = format!(
        "{words} (misfit {} m as written, {} m so read{with}, offsets and scales of the cables left aside)",
        three_digits(as_written),
        three_digits(left)
    );
    let explained = 1.0 - (left / as_written).powi(2);
    Some(Finding::new(kind, Severity::Caution, text).of_size(as_written, "m").explaining(explained))
}

impl Data<'_> {
    /// Mix-ups that leave at most this misfit (m).
    fn explanations(&self, limit: f64) -> Vec<Explanation> {
        let mut told = Vec::new();
        for Reading { kind, words, read, .. } in readings(self.robot, !self.angles.is_empty()) {
            let Some(poses) = self.read(&read) else { continue };
            told.push(Explanation { left: self.misfit(&poses), kind, words });
        }
        let (left, order) = self.permuted();
        let names: Vec<String> = order.iter().map(|column| (column + 1).to_string()).collect();
        let words = format!(
            "the cables look permuted: cables 1 to {} of the robot fit the recorded lengths {}",
            order.len(),
            names.join(", ")
        );
        let permuted = Explanation { left, kind: FindingKind::Permutation, words };
        let moved = order.iter().enumerate().filter(|(cable, column)| cable != *column).count();
        // two swapped cables are likelier than swapped axes that leave as much, and these are than an order of many
        match moved {
            0 => {}
            2 => told.insert(0, permuted),
            _ => told.push(permuted),
        }
        told.retain(|explanation| explanation.left <= limit);
        told
    }

    /// The same with the frames of tracker and marker that fit best, of what frames cannot stand for.
    fn explanations_in_frames(&self, framed: &Framed<'_, '_>, limit: f64) -> Vec<Explanation> {
        let mut told = Vec::new();
        let all = readings(self.robot, !self.angles.is_empty());
        for Reading { kind, words, read, .. } in all.into_iter().filter(|reading| reading.differs_by_frames) {
            let Some(poses) = self.read(&read) else { continue };
            told.push(Explanation { left: framed.misfit(&poses), kind, words });
        }
        told.retain(|explanation| explanation.left <= limit);
        told
    }

    /// The poses in another reading; `None` where it does not exist.
    fn read(&self, read: &dyn Fn(&Pose, &[f64; 3]) -> Option<Pose>) -> Option<Vec<Pose>> {
        let angles = |sample: usize| self.angles.get(sample).copied().unwrap_or_default();
        self.poses.iter().enumerate().map(|(sample, pose)| read(pose, &angles(sample))).collect()
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
