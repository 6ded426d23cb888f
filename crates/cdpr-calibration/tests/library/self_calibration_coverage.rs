//! Intervals of a calibration without poses mean what they say, with a stated accuracy and few equations.

use super::self_calibration::exact;
use cdpr_calibration::fit::{Settings, Status};
use cdpr_calibration::unobserved;
use cdpr_calibration::{SelfCalibration, self_calibrate};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::InternalSamples;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use cdpr_testing::property;
use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

/// Stated accuracy of a length (m).
const SIGMA: f64 = 0.0005;

/// Four belts in the plane of a sheet with these anchors (m).
pub(super) fn belts(anchors: [[f64; 2]; 4]) -> Model {
    let head = "layout_version = 1\nname = \"belts\"\nmotion_pattern = \"2T\"\naxes = \"xy\"\ncable_count = 4\n";
    let cable =
        |(name, [x, y]): (&str, [f64; 2])| format!("[[cable]]\nname = \"{name}\"\nframe_anchor_m = [{x}, {y}]\n");
    let cables: String = ["bl", "br", "tr", "tl"].into_iter().zip(anchors).map(cable).collect();
    let text = format!("{head}[home_pose]\nposition_m = [1.5, 1.0]\n{cables}");
    Model::new(Robot::from_toml(&text, "belts.toml").unwrap(), Composition::STANDARD).unwrap()
}

/// The frame, 2.48 m by 1.89 m; a calibration from the file keeps bl.y, br.y and tl.x, which are 0 here.
fn truth() -> Model {
    belts([[-0.005, 0.0], [2.476, 0.0], [2.473, 1.890], [0.0, 1.885]])
}

/// Calibration from lengths at six positions 150 mm about the middle, with so many times the noise that is stated: 24 rows, of which 12 components of positions
/// and 5 coordinates of anchors leave 7.
fn calibrated(noise: f64, seed: u64) -> SelfCalibration {
    let (truth, file) = (truth(), belts([[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]]));
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let normal = Normal::new(0.0, noise * SIGMA).unwrap();
    let shifts = [[0.0, 0.0], [0.15, 0.0], [0.15, 0.15], [-0.15, 0.15], [-0.15, -0.15], [0.15, -0.15]];
    let pose = |[x, y]: [f64; 2]| Pose::from_xyz_angles(Vector3::new(1.236 + x, 0.944 + y, 0.0), [0.0; 3]);
    let mut samples = exact(&truth, &shifts.map(pose));
    samples.lengths.iter_mut().for_each(|length| *length += normal.sample(&mut rng));
    samples.sigmas.length = Some(SIGMA);
    let internal = InternalSamples::without_poses(samples, 2, false);
    let settings = Settings { starts: 1, ..Settings::default() };
    self_calibrate(&file, &internal, &"frame-anchor".parse().unwrap(), &settings, &unobserved).unwrap()
}

/// Shares of coordinates of anchors whose error is below 1.96 deviations, and below the half width of their 95 % intervals; and noise factors.
fn coverage(noise: f64, count: u64) -> ([f64; 2], Vec<f64>) {
    let truth = truth();
    let (mut hits, mut all) = ([0.0; 2], 0.0);
    let mut factors = Vec::new();
    for seed in property::seeds(count) {
        let SelfCalibration { fit, .. } = calibrated(noise, seed);
        assert_eq!((fit.status, fit.parameters.len()), (Status::Converged, 5), "{}", fit.reason);
        for estimate in &fit.parameters {
            let error = (estimate.value - estimate.parameter.value(truth.robot())).abs() / estimate.sigma.unwrap();
            hits[0] += f64::from(u8::from(error <= 1.96));
            hits[1] += f64::from(u8::from(error <= fit.analysis.quantile_95));
            all += 1.0;
        }
        factors.push(fit.noise_factor);
    }
    println!(
        "noise {noise}: {} calibrations, held by 1.96 sigma and by intervals {:?}",
        factors.len(),
        hits.map(|hit| hit / all)
    );
    (hits.map(|hit| hit / all), factors)
}

/// Calibrations; a soak draws four times as many, 1 000.
const CALIBRATIONS: u64 = 250;

/// Six positions leave 7 equations, whose residuals are by chance a third or twice of what the accuracy says: 1.96 deviations hold the truth in 93 to 97 % all the same. Multiplied by
/// the residuals' own factor they hold it in 88.5 to 91 %. Intervals are by Student's t where the factor is above 1: no narrower, and right where the noise is twice what is stated.
#[test]
fn intervals_of_stated_lengths_hold_the_truth_with_seven_equations() {
    let ([by_sigma, by_interval], factors) = coverage(1.0, CALIBRATIONS);
    let count = factors.len() as f64;
    // 57 % of χ² with 7 degrees of freedom lie below their mean
    let below = factors.iter().filter(|factor| **factor < 1.0).count() as f64 / count;
    assert!((below - 0.571).abs() < 4.0 * 0.495 / count.sqrt(), "{below}");
    // 96.0 % of 1 000; the five coordinates of a calibration hit and miss together: standard deviation 1.2 % of 250, 0.6 % of 1 000
    let room = 4.0 * (0.96 * 0.04 / count).sqrt();
    assert!((by_sigma - 0.96).abs() < room, "{by_sigma}");
    assert!(by_sigma > 0.92 && by_interval >= by_sigma && by_interval < 0.99, "{by_sigma} {by_interval}");
    // an accuracy that is twice too good: nearly every factor is above 1
    let ([by_sigma, by_interval], factors) = coverage(2.0, CALIBRATIONS / 2);
    let room = 4.0 * (0.95 * 0.05 / factors.len() as f64).sqrt();
    assert!((by_interval - 0.95).abs() < room && by_sigma < by_interval, "{by_sigma} {by_interval}");
}
