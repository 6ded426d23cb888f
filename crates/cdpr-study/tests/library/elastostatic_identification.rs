//! Elastostatic identification of the dissertation's machine from virtual measurements: 75 poses of a grid, 16 turned ones,
//! 64 tension tests, noise of the study `twin-measurements`.

use super::studies::study;
use super::support::builtin;
use cdpr_calibration::fit::{Fit, Prior, Settings, Status, fit};
use cdpr_calibration::{ErrorBlocks, evaluate};
use cdpr_model::control::simulate::simulate;
use cdpr_model::control::winch_offsets;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{ParameterKind, Robot};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const SIXTY_TWO: &str = "frame-anchor,platform-anchor,compliance,wrench";
const MACHINE: &str = "cablerobot-simulator-helicopter-elastostatic-calibrated";

/// What the study records on a machine: with noise, and the truth behind it.
fn measured(machine: &Robot, with_tension_tests: bool, seed: u64) -> (Samples, Samples) {
    let mut study = study("twin-measurements");
    if !with_tension_tests {
        study.poses.as_mut().unwrap().tension_tests = None;
    }
    let control = Model::new(builtin(&study.control.robot), Composition::STANDARD).unwrap();
    let machine = Model::new(machine.clone(), Composition::ELASTIC).unwrap();
    let pose = study.initial_pose(machine.robot()).unwrap();
    let offsets = winch_offsets(&study.initial, &control, &machine, &pose).unwrap();
    let poses = study.commanded_poses(machine.robot(), Vec::new(), seed).unwrap();
    let record = |noise: &SensorSigmas| simulate(&control, &machine, &offsets, &poses, noise, seed).unwrap().samples;
    (record(&study.noise.unwrap()), record(&SensorSigmas::default()))
}

fn settings(starts: u32) -> Settings {
    let prior = Prior { kind: ParameterKind::PlatformAnchor, sigma: 0.02 };
    Settings { priors: vec![prior], starts, ..Settings::default() }
}

fn identified(start: &Robot, composition: Composition, free: &str, samples: &Samples, settings: &Settings) -> Fit {
    let model = Model::new(start.clone(), composition).unwrap();
    let found = fit(&model, samples, &free.parse().unwrap(), settings).unwrap();
    assert_eq!(found.status, Status::Converged, "{}", found.reason);
    found
}

fn errors(found: &Fit, samples: &Samples) -> ErrorBlocks {
    let blocks = evaluate(&found.model, samples).unwrap().blocks();
    assert_eq!(blocks.not_converged, 0);
    blocks
}

/// The dissertation's chapter 6 on its rebuilt machine. Against noisy poses no model can be better than about 1.7 mm in the
/// mean, the size of the noise of 1.155 mm per axis.
#[test]
fn sixty_two_parameters_predict_the_twin_to_the_noise_from_ten_starts() {
    let (noisy, truth) = measured(&builtin(MACHINE), true, 1);
    assert_eq!(noisy.len(), 75 + 16 + 64);
    let nominal = builtin("cablerobot-simulator-helicopter");
    let kinematic = identified(&nominal, Composition::STANDARD, "frame-anchor", &noisy, &Settings::default());
    let mean = 1e3 * errors(&kinematic, &noisy).position_error_m.mean;
    assert!((3.0..5.0).contains(&mean), "kinematic: {mean} mm");

    let found = identified(&nominal, Composition::ELASTIC, SIXTY_TWO, &noisy, &settings(10));
    assert_eq!(found.parameters.len(), 62);
    assert_eq!((found.starts.optima.len(), found.starts.optima[0].starts), (1, 10), "{:?}", found.starts);
    let (noisy, truth) = (errors(&found, &noisy), errors(&found, &truth));
    let position = [noisy, truth].map(|blocks| 1e3 * blocks.position_error_m.mean);
    let tension = [noisy, truth].map(|blocks| blocks.tension_error.unwrap().mean_norm);
    println!("kinematic {mean:.2} mm; elastostatic {position:?} mm, {tension:?} N (noisy record, truth)");
    // below 2.3 mm and 260 N as asked; the full covariances come nearer to the noise than diagonal ones
    assert!(position[0] < 2.3 && position[1] < 1.2, "{position:?} mm");
    assert!((130.0..260.0).contains(&tension[0]), "{tension:?} N");
    // the printed platform anchors lie 119 mm rms from the nominal ones
    assert!(found.warnings.iter().any(|warning| warning.starts_with("prior conflict")), "{:?}", found.warnings);
}

/// What tension tests are worth: without them some cables' stiffness is hardly known, and the fit says of which.
#[test]
fn without_tension_tests_the_stiffness_of_some_cables_is_unknown_and_named() {
    let unknown = |with_tests: bool| {
        let (noisy, truth) = measured(&builtin(MACHINE), with_tests, 1);
        let start = builtin("cablerobot-simulator-helicopter");
        let found = identified(&start, Composition::ELASTIC, SIXTY_TWO, &noisy, &settings(1));
        let truth = 1e3 * errors(&found, &truth).position_error_m.mean;
        let largest = found.parameters.iter().filter(|e| e.parameter.kind == ParameterKind::Compliance);
        let largest = largest.map(|e| e.sigma.unwrap() / e.value).fold(0.0, f64::max);
        println!("tension tests {with_tests}: {truth:.2} mm against the truth, compliance ± {:.0} %", 100.0 * largest);
        (found.analysis.weak_directions.iter().any(|words| words.contains("the stiffness of cables")), largest)
    };
    let (with_tests, without) = (unknown(true), unknown(false));
    assert!(!with_tests.0 && without.0);
    assert!(without.1 > 2.0 * with_tests.1);
}

/// Machines drawn for coverage; the mean noise factor of so many deviates by 0.003.
const MACHINES: u64 = 40;

/// Intervals of 95 % hold the truth in 90 to 98 % of all cases, over all parameters of many machines whose platform anchors
/// are drawn from the prior.
#[test]
fn intervals_cover_the_truth_when_the_prior_holds() {
    let file = builtin(MACHINE);
    let (mut inside, mut all) = (0, 0);
    let mut noise_factor = 0.0;
    for seed in 0..MACHINES {
        let mut rng = ChaCha8Rng::seed_from_u64(1000 + seed);
        let mut machine = file.clone();
        for cable in &mut machine.cables {
            for k in 0..3 {
                let error: f64 = StandardNormal.sample(&mut rng);
                cable.platform_anchor[k] += 0.02 * error;
            }
        }
        let (noisy, _) = measured(&machine, true, seed);
        let found = identified(&file, Composition::ELASTIC, SIXTY_TWO, &noisy, &settings(1));
        let truth = Model::new(machine, Composition::ELASTIC).unwrap();
        for estimate in &found.parameters {
            let error = estimate.value - estimate.parameter.value(truth.robot());
            inside += usize::from(error.abs() <= 1.96 * estimate.sigma.unwrap());
            all += 1;
        }
        noise_factor += found.noise_factor / MACHINES as f64;
    }
    let fraction = inside as f64 / all as f64;
    println!("{:.1} % of {all} intervals hold the truth, noise factor {noise_factor:.3}", 100.0 * fraction);
    assert!((0.90..=0.98).contains(&fraction), "{fraction}");
    // residuals are as large as the sensors explain
    assert!((noise_factor - 1.0).abs() < 0.02, "{noise_factor}");
}
