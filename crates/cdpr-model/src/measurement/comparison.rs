//! Poses and lengths that are compared, with offset and scale of each cable left aside; for mistakes of units and of
//! recording.

mod forward;
pub(super) mod frames;

use super::Samples;
use crate::geometry::Pose;
use crate::robot::Robot;

/// Largest number of samples compared.
const LOOKED_AT: usize = 200;
/// Range of a winch's scale.
const SCALES: (f64, f64) = (0.8, 1.25);

/// The samples that are compared.
#[derive(Clone)]
pub(super) struct Data<'a> {
    pub(super) robot: &'a Robot,
    pub(super) poses: Vec<Pose>,
    /// Angles rx, ry, rz, or the angle in the plane (rad), as in the file; empty if it has none.
    pub(super) angles: Vec<[f64; 3]>,
    /// Recorded lengths, cable by cable (m).
    pub(super) recorded: Vec<Vec<f64>>,
}

impl<'a> Data<'a> {
    /// Data of at most 200 samples, spread over all.
    pub(super) fn of(robot: &'a Robot, samples: &Samples) -> Self {
        let chosen = chosen(samples.len(), LOOKED_AT);
        let of_cable = |cable: usize| chosen.iter().map(|&sample| samples.lengths_of(sample)[cable]).collect();
        let angles = samples.angles.iter().flat_map(|angles| chosen.iter().map(|&sample| angles[sample]));
        Self {
            robot,
            poses: chosen.iter().map(|&sample| samples.poses[sample]).collect(),
            angles: angles.collect(),
            recorded: (0..samples.cable_count).map(of_cable).collect(),
        }
    }

    /// The same with at most so many samples.
    pub(super) fn thinned(&self, most: usize) -> Self {
        let chosen = chosen(self.poses.len(), most);
        let of = |numbers: &Vec<f64>| chosen.iter().map(|&sample| numbers[sample]).collect();
        Self {
            robot: self.robot,
            poses: chosen.iter().map(|&sample| self.poses[sample]).collect(),
            angles: chosen.iter().filter_map(|&sample| self.angles.get(sample).copied()).collect(),
            recorded: self.recorded.iter().map(of).collect(),
        }
    }

    /// Root mean square of the residuals of the recorded lengths at these poses (m).
    pub(super) fn misfit(&self, poses: &[Pose]) -> f64 {
        let m = self.recorded.len();
        let squares: f64 = (0..m).map(|cable| left_of(&self.lengths(cable, poses), &self.recorded[cable])).sum();
        (squares / m.max(1) as f64).sqrt()
    }

    /// Root mean square of the recorded lengths about the mean of their cable (m).
    pub(super) fn spread(&self) -> f64 {
        let squares: f64 = self.recorded.iter().map(|recorded| Fit::of(recorded, recorded).square).sum();
        let count = self.recorded.len() * self.poses.len();
        (squares / count.max(1) as f64).sqrt()
    }

    /// Lengths of one cable between its anchors (m).
    pub(super) fn lengths(&self, cable: usize, poses: &[Pose]) -> Vec<f64> {
        let cable = &self.robot.cables[cable];
        poses.iter().map(|pose| (cable.frame_anchor - pose.transform(&cable.platform_anchor)).norm()).collect()
    }
}

/// At most so many of the indices below a count, evenly spread.
fn chosen(count: usize, most: usize) -> Vec<usize> {
    (0..count).step_by(count.div_ceil(most).max(1)).collect()
}

/// The line through modelled and recorded lengths of a cable.
pub(super) struct Fit {
    /// Means of the modelled and the recorded lengths (m).
    pub(super) means: [f64; 2],
    /// The winch's scale.
    pub(super) scale: f64,
    /// Sum of squares of the modelled lengths about their mean (m²).
    square: f64,
    /// True if the scale is the best one, not one at the end of its range.
    pub(super) is_free: bool,
}

impl Fit {
    /// Offset and scale of a winch that fit best.
    pub(super) fn of(modelled: &[f64], recorded: &[f64]) -> Self {
        let count = modelled.len().max(1) as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
        let means = [mean(modelled), mean(recorded)];
        let pairs = modelled.iter().zip(recorded).map(|(a, b)| (a - means[0], b - means[1]));
        let (product, square) = pairs.fold((0.0, 0.0), |(product, square), (a, b)| (product + a * b, square + a * a));
        let best = if square > 0.0 { product / square } else { 1.0 };
        let scale = best.clamp(SCALES.0, SCALES.1);
        Self { means, scale, square, is_free: square > 0.0 && best == scale }
    }

    /// Residual of one recorded length (m).
    pub(super) fn residual(&self, modelled: f64, recorded: f64) -> f64 {
        recorded - self.means[1] - self.scale * (modelled - self.means[0])
    }
}

/// Mean square residual of recorded lengths after fitting offset and scale of a winch (m²).
pub(super) fn left_of(modelled: &[f64], recorded: &[f64]) -> f64 {
    let fit = Fit::of(modelled, recorded);
    let squares: f64 = modelled.iter().zip(recorded).map(|(l, q)| fit.residual(*l, *q).powi(2)).sum();
    squares / modelled.len().max(1) as f64
}
