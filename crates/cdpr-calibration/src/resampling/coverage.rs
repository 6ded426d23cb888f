//! Share of linear and of bootstrap intervals, ± 1.96 deviations, that hold the truth of seeded records: a point on four cables.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::resampled;
use crate::fit::{Settings, fit};
use crate::loss::Loss;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;

const SIGMA: f64 = 1e-3;

/// Records of one kind: their poses, noise and free parameters.
struct Situation {
    rows: usize,
    free: &'static str,
    /// Correlation of the noise of consecutive rows; poses then move slowly.
    correlation: f64,
    /// One pose in fifteen is far from the others and measured five times worse.
    has_far_poses: bool,
}

/// Shares that hold the truth, and the warnings.
struct Coverage {
    linear: f64,
    bootstrap: f64,
    warnings: Vec<String>,
}

fn camera() -> Model {
    let mut text = String::from("layout_version = 1\nname = \"camera\"\nmotion_pattern = \"3T\"\ncable_count = 4\n");
    for (cable, [x, y]) in [[-6.0, -4.0], [6.0, -4.0], [6.0, 4.0], [-6.0, 4.0]].iter().enumerate() {
        text += &format!("[[cable]]\nname = \"{cable}\"\nframe_anchor_m = [{x:?}, {y:?}, 6.0]\n");
    }
    Model::new(Robot::from_toml(&text, "camera").unwrap(), Composition::STANDARD).unwrap()
}

impl Situation {
    /// Positions anywhere in the workspace, or along sums of two sines.
    fn positions(&self, random: &mut ChaCha8Rng) -> Vec<Vector3<f64>> {
        let (middle, half) = (Vector3::new(0.0, 0.0, 2.75), Vector3::new(4.0, 2.5, 1.75));
        let mut drawn = |least: f64, most: f64| random.random_range(least..most);
        let waves = [(); 3].map(|()| [drawn(60.0, 90.0), drawn(20.0, 35.0), drawn(0.0, 6.0), drawn(0.0, 6.0)]);
        let wave = |[slow, quick, first, second]: [f64; 4], row: f64| {
            let turns = std::f64::consts::TAU * row;
            0.75 * (turns / slow + first).sin() + 0.25 * (turns / quick + second).sin()
        };
        let mut share = |row: usize| match self.correlation > 0.0 {
            true => waves.map(|own| wave(own, row as f64)),
            false => [(); 3].map(|()| drawn(-1.0, 1.0)),
        };
        let mut position = |row: usize| {
            let mut shares = Vector3::from(share(row));
            if self.has_far_poses {
                shares *= 0.2;
                shares.x = if row.is_multiple_of(15) { 1.0 } else { shares.x };
            }
            middle + half.component_mul(&shares)
        };
        (0..self.rows).map(&mut position).collect()
    }

    fn record(&self, model: &Model, seed: u64) -> Samples {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let place = |position: Vector3<f64>| Pose::from_xyz_angles(position, [0.0; 3]);
        let poses: Vec<Pose> = self.positions(&mut random).into_iter().map(place).collect();
        let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
        let mut noise = [(); 4].map(|()| normal());
        let fresh = (1.0 - self.correlation * self.correlation).sqrt();
        let mut lengths = Vec::new();
        for (row, pose) in poses.iter().enumerate() {
            let louder = if self.has_far_poses && row.is_multiple_of(15) { 5.0 } else { 1.0 };
            for (own, length) in noise.iter_mut().zip(model.cable_lengths(pose).unwrap()) {
                *own = self.correlation * *own + fresh * normal();
                lengths.push(length + SIGMA * louder * *own);
            }
        }
        Samples { poses, lengths, cable_count: 4, sigmas: SensorSigmas::default(), ..Samples::default() }
    }

    fn coverage(&self, records: u64, replicates: usize) -> Coverage {
        let (truth, settings) = (camera(), Settings { loss: Loss::Squared, ..Settings::default() });
        let (mut held, mut all) = ([0.0; 2], 0.0);
        let mut warnings = Vec::new();
        for seed in 0..records {
            let samples = self.record(&truth, seed);
            let fit = fit(&truth, &samples, &self.free.parse().unwrap(), &settings).unwrap();
            let found = resampled(&truth, &samples, &fit, &settings, replicates, seed).unwrap();
            for (own, deviation) in fit.parameters.iter().zip(&found.parameters) {
                let error = (own.value - own.parameter.value(truth.robot())).abs();
                let holds = |sigma: f64| f64::from(u8::from(error <= 1.96 * sigma));
                all += 1.0;
                held[0] += holds(own.sigma.unwrap());
                held[1] += holds(deviation.bootstrap);
            }
            warnings.extend(found.warning);
        }
        Coverage { linear: held[0] / all, bootstrap: held[1] / all, warnings }
    }
}

/// 640 numbers of independent noise: 95 % of the intervals hold to 1 %, by either deviation.
#[test]
fn either_deviation_holds_for_independent_noise() {
    let usual = Situation { rows: 60, free: "frame-anchor,length-offset", correlation: 0.0, has_far_poses: false };
    let Coverage { linear, bootstrap, .. } = usual.coverage(40, 60);
    assert!([linear, bootstrap].iter().all(|share| (share - 0.94).abs() < 0.04), "{linear} {bootstrap}");
}

/// Eight blocks of noise that repeats itself, of 400 numbers: the bootstrap holds six of a hundred fewer, and is not advised.
#[test]
fn few_blocks_are_told_and_the_linear_deviations_hold_better() {
    let repeating = Situation { rows: 300, free: "length-offset", correlation: 0.9, has_far_poses: false };
    let Coverage { linear, bootstrap, warnings } = repeating.coverage(100, 60);
    assert!((linear - 0.91).abs() < 0.06 && bootstrap < linear, "{linear} {bootstrap}");
    assert!(!warnings.is_empty());
    let is_right = |words: &String| words.contains(" blocks of ") && words.contains("keep the linear ones");
    assert!(warnings.iter().all(|words| is_right(words) && !words.contains("take those")), "{warnings:?}");
}

/// Scales that depend on the noisy poses alone: of 320 numbers the linear deviations hold half, those of the bootstrap nine of ten, and the warning advises
/// the bootstrap.
#[test]
fn noise_that_sits_at_some_poses_is_told_and_the_bootstrap_holds_better() {
    let far = Situation { rows: 150, free: "length-offset,length-scale", correlation: 0.0, has_far_poses: true };
    let Coverage { linear, bootstrap, warnings } = far.coverage(40, 100);
    assert!(linear < 0.65 && bootstrap > 0.82, "{linear} {bootstrap}");
    assert_eq!(warnings.len(), 40);
    assert!(warnings.iter().all(|words| words.contains("take those of the bootstrap where they are larger")));
}
