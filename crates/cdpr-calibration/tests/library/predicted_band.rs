//! Calibrations without poses say how far their poses may be off by what they hold, and seek samples that no pose explains.

use super::self_calibration::exact;
use super::self_calibration_coverage::belts;
use cdpr_calibration::fit::{Prior, Settings};
use cdpr_calibration::{PredictedBand, SelfCalibration, self_calibrate, unobserved};
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::InternalSamples;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{ParameterKind, Robot};
use cdpr_testing::property;
use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// Belts in a plane: two equations a sample, which tell something of the scale.
const BELTS: [[f64; 2]; 4] = [[0.0, 0.0], [2.5, 0.0], [2.4, 1.9], [0.0, 1.8]];

/// A machine with free offsets.
struct Machine {
    truth: Model,
    poses: Vec<Pose>,
    dof: usize,
}

impl Machine {
    fn belts() -> Self {
        let places = (0..25).map(|k| (0.3 + 0.45 * f64::from(k % 5), 0.25 + 0.33 * f64::from(k / 5)));
        let poses = places.map(|(x, y)| Pose::from_xyz_angles(Vector3::new(x, y, 0.0), [0.0; 3])).collect();
        Self { truth: belts(BELTS), poses, dof: 2 }
    }

    /// Camera on four cables from the corners of a rectangle: l₁² − l₂² + l₃² − l₄² = 0 for any scale, so that offsets take the scale up.
    fn camera() -> Self {
        let places = (0..48).map(|k| (f64::from(k % 4) - 1.5, f64::from(k / 4 % 4) - 1.5, f64::from(k / 16)));
        let pose = |(x, y, z)| Pose::from_xyz_angles(Vector3::new(2.0 * x, 1.2 * y, 1.5 + z), [0.0; 3]);
        Self { truth: suspended_camera(), poses: places.map(pose).collect(), dof: 3 }
    }
}
/// Accuracy of a length (m).
const LENGTH: f64 = 2e-4;
/// Of a coordinate of a held anchor (m).
const ANCHOR: f64 = 5e-4;
/// Of the common scale.
const SCALE: f64 = 5e-3;

fn suspended_camera() -> Model {
    let head = "layout_version = 1\nname = \"camera\"\nmotion_pattern = \"3T\"\ncable_count = 4\n[home_pose]\nposition_m = [0.0, 0.0, 3.0]\n";
    let cable = |(x, y)| format!("[[cable]]\nname = \"{x} {y}\"\nframe_anchor_m = [{x}.0, {y}.0, 6.0]\n");
    let cables: String = [(-6, -4), (6, -4), (6, 4), (-6, 4)].map(cable).concat();
    Model::new(Robot::from_toml(&format!("{head}{cables}"), "camera.toml").unwrap(), Composition::STANDARD).unwrap()
}

impl Machine {
    /// Its lengths with noise and a common scale, unknown offsets included.
    fn recorded(&self, scale: f64, rng: &mut ChaCha8Rng) -> InternalSamples {
        let mut samples = exact(&self.truth, &self.poses);
        for (k, length) in samples.lengths.iter_mut().enumerate() {
            let noise: f64 = StandardNormal.sample(rng);
            *length = (1.0 + scale) * *length + 0.01 * (k % 4) as f64 + LENGTH * noise;
        }
        samples.sigmas.length = Some(LENGTH);
        samples.sigmas.length_scale = Some(SCALE);
        InternalSamples::without_poses(samples, self.dof, false)
    }

    /// Its file, whose anchors are off.
    fn file(&self, mut draw: impl FnMut() -> f64) -> Model {
        let mut robot = self.truth.robot().clone();
        for cable in &mut robot.cables {
            for axis in 0..self.dof {
                cable.frame_anchor[axis] += draw();
            }
        }
        Model::new(robot, Composition::STANDARD).unwrap()
    }

    /// Root mean square of the distances of poses from others.
    fn apart(&self, found: &[Pose], others: &[Pose]) -> f64 {
        let apart = |(own, other): (&Pose, &Pose)| (own.position - other.position).norm_squared();
        (found.iter().zip(others).map(apart).sum::<f64>() / self.poses.len() as f64).sqrt()
    }
}

fn calibrated(file: &Model, internal: &InternalSamples, free: &str) -> SelfCalibration {
    let prior = Prior { kind: ParameterKind::FrameAnchor, sigma: ANCHOR };
    let priors = if free.contains("frame-anchor") { Vec::new() } else { vec![prior] };
    let settings = Settings { priors, ..Settings::default() };
    self_calibrate(file, internal, &free.parse().unwrap(), &settings, &unobserved).unwrap()
}

fn band(found: &SelfCalibration) -> &PredictedBand {
    found.band.as_ref().unwrap()
}

fn of_scale(found: &SelfCalibration) -> Option<&Finding> {
    let is_of_scale = |finding: &&Finding| finding.kind == FindingKind::Unseen && finding.text.contains("common scale");
    band(found).findings.iter().find(is_of_scale)
}

/// Share of calibrations whose poses are within 1.96 bands of the true ones, and mean of the squares of their distances in bands; anchors and the scale of lengths are
/// drawn within their accuracies.
fn coverage(machine: &Machine) -> [f64; 2] {
    let (mut within, mut squares, mut count) = (0.0, 0.0, 0.0);
    for seed in property::seeds(60) {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut draw = |sigma: f64| -> f64 { sigma * Distribution::<f64>::sample(&StandardNormal, &mut rng) };
        let (scale, file) = (draw(SCALE), machine.file(|| draw(ANCHOR)));
        let found = calibrated(&file, &machine.recorded(scale, &mut rng), "length-offset");
        let ratio = machine.apart(&found.samples.poses, &machine.poses) / band(&found).band_m;
        within += f64::from(u8::from(ratio < 1.96));
        squares += ratio * ratio;
        count += 1.0;
    }
    println!("{count} calibrations, {} within 1.96 bands, mean square {}", within / count, squares / count);
    [within / count, squares / count]
}

/// The true error of the poses is that of the told band, whether the lengths tell something of the scale or nothing.
#[test]
fn poses_are_as_far_off_as_their_band_says() {
    for machine in [Machine::camera(), Machine::belts()] {
        let [within, square] = coverage(&machine);
        // 95 % of one direction that is drawn, more of several; 60 draws have a deviation of 2.8 %
        assert!((0.88..=1.0).contains(&within), "{within}");
        // χ² of one direction: deviation of a mean of 60 √(2/60)
        assert!((square - 1.0).abs() < 4.0 * (2.0_f64 / 60.0).sqrt(), "{square}");
    }
}

/// Offsets take a scale up: the finding gives the motion of the poses for 0.5 %; with two known positions the scale is determined.
#[test]
fn a_scale_is_unseen_until_a_distance_is_known() {
    let machine = Machine::camera();
    let recorded = |scale: f64| machine.recorded(scale, &mut ChaCha8Rng::seed_from_u64(4));
    let mut internal = recorded(0.0);
    let found = calibrated(&machine.truth, &internal, "length-offset");
    let told = of_scale(&found).unwrap();
    let moved = calibrated(&machine.truth, &recorded(SCALE), "length-offset");
    let change = machine.apart(&found.samples.poses, &moved.samples.poses);
    assert!((told.value.unwrap() / change - 1.0).abs() < 0.05, "{told:?} {change}");
    assert!(found.band.iter().any(|band| band.findings.iter().any(|one| one.text.contains("measure the distance"))));
    for sample in [0, 47] {
        internal.known[sample] = vec![true; 3];
        internal.samples.poses[sample] = machine.poses[sample];
    }
    let found = calibrated(&machine.truth, &internal, "length-offset");
    assert_eq!(of_scale(&found), None);
}

/// Where anchors are free, a scale makes everything larger by its share, and is no reason for distrust.
#[test]
fn a_scale_of_everything_is_a_caution() {
    let machine = Machine::belts();
    let mut internal = machine.recorded(0.0, &mut ChaCha8Rng::seed_from_u64(5));
    internal.samples.lengths.iter_mut().enumerate().for_each(|(k, length)| *length -= 0.01 * (k % 4) as f64);
    let found = calibrated(&machine.truth, &internal, "frame-anchor");
    let told = of_scale(&found).unwrap();
    // distances from the mean position grow by 0.5 %
    let mean = machine.poses.iter().map(|pose| pose.position).sum::<Vector3<f64>>() / 25.0;
    let size = (machine.poses.iter().map(|pose| (pose.position - mean).norm_squared()).sum::<f64>() / 25.0).sqrt();
    assert_eq!(told.severity, Severity::Caution);
    assert!((told.value.unwrap() / (SCALE * size) - 1.0).abs() < 0.01, "{told:?} {size}");
}

/// A slipped cable in one sample: named with its place and left out; poses stand for all samples.
#[test]
fn a_sample_that_no_pose_explains_is_left_out() {
    let machine = Machine::belts();
    let clean = machine.recorded(0.0, &mut ChaCha8Rng::seed_from_u64(6));
    let mut spoilt = clean.clone();
    spoilt.samples.lengths[4 * 7 + 2] += 0.03;
    spoilt.samples.lines = Some((2..27).collect());
    let (clean, found) =
        (calibrated(&machine.truth, &clean, "length-offset"), calibrated(&machine.truth, &spoilt, "length-offset"));
    assert!(clean.doubts.is_empty() && clean.fit.outliers.is_empty());
    let findings: Vec<&Finding> = found.doubts.iter().map(|doubt| &doubt.finding).collect();
    assert_eq!(findings.len(), 1, "{findings:?}");
    assert_eq!((findings[0].kind, findings[0].line), (FindingKind::Outlier, Some(9)));
    assert_eq!((found.fit.outliers[0].sample, found.samples.len()), (8, 25));
    for (own, other) in found.fit.parameters.iter().zip(&clean.fit.parameters) {
        assert!((own.value - other.value).abs() < 2.0 * other.sigma.unwrap(), "{}", own.name);
    }
}
