//! Recordings along a curve, which tests of identifications share.

use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;

/// Noise of the lengths of [`noisy`] (m).
pub(super) const SIGMA: f64 = 1e-3;

/// The helicopter's cables as points and lines.
pub(super) fn points() -> Model {
    Model::new(Robot::builtin("cablerobot-simulator-helicopter").unwrap(), Composition::STANDARD).unwrap()
}

/// So many poses within a metre of the home pose, with so many times 0.1 rad of rotation.
pub(super) fn curve(model: &Model, count: usize, turn: f64) -> Vec<Pose> {
    let home = model.robot().home_or_middle();
    let pose = |index: usize| {
        let t = index as f64;
        let shift = Vector3::new(t.sin(), (1.7 * t).cos(), 0.5 * (2.3 * t).sin());
        let angles = [0.1 * t.cos(), 0.1 * (1.3 * t).sin(), 0.2 * (0.7 * t).sin()].map(|angle| turn * angle);
        Pose::from_xyz_angles(home.position + shift, angles)
    };
    (0..count).map(pose).collect()
}

/// Exact poses, lengths of the model with seeded noise and what `more` adds for a cable (m); the accuracy of lengths is stated as given.
pub(super) fn noisy(model: &Model, poses: Vec<Pose>, seed: u64, stated: Option<f64>, more: f64) -> Samples {
    let (mut rng, noise) = (ChaCha8Rng::seed_from_u64(seed), Normal::new(0.0, SIGMA).unwrap());
    let cables = model.cable_count();
    let exact: Vec<f64> = poses.iter().flat_map(|pose| model.cable_lengths(pose).unwrap()).collect();
    let lengths = exact.into_iter().enumerate();
    let lengths = lengths.map(|(row, length)| length + more * (row % cables) as f64 + noise.sample(&mut rng)).collect();
    let sigmas = SensorSigmas { length: stated, ..SensorSigmas::default() };
    Samples { poses, lengths, cable_count: cables, sigmas, ..Samples::default() }
}
