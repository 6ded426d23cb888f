//! The compared poses and lengths, and their misfit.

use crate::geometry::Pose;
use crate::measurement::Samples;
use crate::robot::Robot;

/// Largest number of samples compared.
const LOOKED_AT: usize = 200;
/// Range of a winch's scale.
const SCALES: (f64, f64) = (0.8, 1.25);

/// The samples that are compared.
pub(super) struct Data<'a> {
    pub(super) robot: &'a Robot,
    pub(super) poses: Vec<Pose>,
    /// Angles rx, ry, rz, or the angle in the plane (rad): those of the file, otherwise those of the poses.
    pub(super) angles: Vec<[f64; 3]>,
    /// Recorded lengths, cable by cable (m).
    pub(super) recorded: Vec<Vec<f64>>,
}

impl<'a> Data<'a> {
    pub(super) fn of(robot: &'a Robot, samples: &Samples, angles: &[[f64; 3]]) -> Self {
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

    /// Root mean square of the residuals of the recorded lengths at these poses (m).
    pub(super) fn misfit(&self, poses: &[Pose]) -> f64 {
        let m = self.recorded.len();
        let squares: f64 = (0..m).map(|cable| left_of(&self.lengths(cable, poses), &self.recorded[cable])).sum();
        (squares / m.max(1) as f64).sqrt()
    }

    /// Lengths of one cable between its anchors (m).
    pub(super) fn lengths(&self, cable: usize, poses: &[Pose]) -> Vec<f64> {
        let cable = &self.robot.cables[cable];
        poses.iter().map(|pose| (cable.frame_anchor - pose.transform(&cable.platform_anchor)).norm()).collect()
    }
}

/// Mean square residual of recorded lengths after fitting offset and scale of a winch (m²).
pub(super) fn left_of(modelled: &[f64], recorded: &[f64]) -> f64 {
    let count = modelled.len() as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
    let (l, q) = (mean(modelled), mean(recorded));
    let pairs = || modelled.iter().zip(recorded).map(|(a, b)| (a - l, b - q));
    let (product, square) = pairs().fold((0.0, 0.0), |(product, square), (a, b)| (product + a * b, square + a * a));
    let scale = if square > 0.0 { (product / square).clamp(SCALES.0, SCALES.1) } else { 1.0 };
    pairs().map(|(a, b)| (b - scale * a).powi(2)).sum::<f64>() / count
}
