//! Models compared without measured poses, by sensors of samples that were held out.

use super::self_calibration::{exact, five_lines, generic};
use cdpr_calibration::candidate::parse_list;
use cdpr_calibration::fit::{Prior, Settings};
use cdpr_calibration::selection::{self, SelectionCriterion, select_without_poses};
use cdpr_calibration::unobserved;
use cdpr_calibration::{evaluate_lengths, self_calibrate};
use cdpr_model::measurement::{InternalSamples, Samples, Split};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::ParameterKind;

/// Samples with normal noise of lengths.
fn noisy(samples: &Samples, sigma: f64, seed: u64) -> Samples {
    use rand::SeedableRng;
    use rand_distr::{Distribution, Normal};
    let (mut random, normal) = (rand_chacha::ChaCha8Rng::seed_from_u64(seed), Normal::new(0.0, sigma).unwrap());
    let lengths = samples.lengths.iter().map(|length| length + normal.sample(&mut random)).collect();
    Samples { lengths, ..samples.clone() }
}

/// Noise of σ makes predicted lengths err by σ, though poses take up three of five residuals: the mean over 300 samples has a standard error of 3 %.
#[test]
fn errors_of_predicted_lengths_are_those_of_the_noise() {
    let truth = Model::new(five_lines(), Composition::STANDARD).unwrap();
    let exact_ones = InternalSamples::without_poses(exact(&truth, &generic(&truth, 30, (0.5, 0.0))), 3, false);
    let free = "frame-anchor".parse().unwrap();
    let found = self_calibrate(&truth, &exact_ones, &free, &Settings::default(), &unobserved).unwrap();
    let sigma = 3e-4;
    let samples = noisy(&exact(&truth, &generic(&truth, 300, (0.5, 0.0))), sigma, 1);
    let held = InternalSamples::without_poses(samples, 3, false);
    let predicted = found.predict(&held).unwrap().blocks().length_error_m.rms;
    assert!((predicted / sigma - 1.0).abs() < 0.09, "{predicted}");
    let plain = evaluate_lengths(&found.fit.model, &held).unwrap().blocks().length_error_m.rms;
    assert!((plain / predicted - 0.4_f64.sqrt()).abs() < 1e-9, "{plain} {predicted}");
    // heights measured well, by the leverages of all rows: poses take up two residuals then
    let mut samples = held.samples.clone();
    samples.poses = generic(&truth, 300, (0.5, 0.0));
    samples.sigmas.position = Some(1e-6);
    let measured = InternalSamples { samples, known: vec![vec![false, false, true]; 300], ..held };
    let by_leverages = found.predict(&measured).unwrap().blocks().length_error_m.rms;
    assert!((by_leverages / sigma - 1.0).abs() < 0.07, "{by_leverages}");
}

/// Winches that count from elsewhere are found out without poses; where they do not, and anchors are as accurate as they are said to be, the model as given is taken and those that contain it
/// are named beside it. Anchors of which nobody says how accurate they are may be off by more than the lengths let free ones be.
#[test]
fn candidates_are_told_apart_without_poses_where_the_data_do_so() {
    let given = five_lines();
    let model = Model::new(given.clone(), Composition::STANDARD).unwrap();
    let samples = noisy(&exact(&model, &generic(&model, 60, (0.5, 0.0))), 2e-4, 2);
    let candidates = parse_list("standard;standard:length-offset;standard:frame-anchor").unwrap();
    let chosen = |offset: f64, accuracy: Option<f64>| {
        let mut shifted = samples.clone();
        shifted.lengths.iter_mut().step_by(5).for_each(|length| *length += offset);
        let folds = Split::Blocks(4).folds(&shifted, 0).unwrap();
        let internal = InternalSamples::without_poses(shifted, 3, false);
        let prior = |sigma: f64| Prior { kind: ParameterKind::FrameAnchor, sigma };
        let fit = Settings { priors: accuracy.map(prior).into_iter().collect(), ..Settings::default() };
        let settings = selection::Settings { criterion: SelectionCriterion::Length, fit, ..Default::default() };
        select_without_poses(&given, &candidates, &internal, &folds, &settings, &unobserved).unwrap()
    };
    let (selection, found) = chosen(0.004, Some(2e-4));
    assert_eq!(selection.recommended, Some(1), "{}", selection.reason);
    let criterion = |index: usize| selection.candidates[index].outcome.as_ref().unwrap().criterion;
    // 4 mm in one of five lines, of which two remain
    assert!(criterion(0) > 3.0 * criterion(1), "{} {}", criterion(0), criterion(1));
    let error = |k: usize| (found.poses[k].position - samples.poses[k].position).norm();
    assert!((0..60).all(|k| error(k) < 2e-3), "{:?}", (0..60).map(error).fold(0.0, f64::max));
    let (selection, _) = chosen(0.0, None);
    assert_eq!(selection.recommended, Some(2), "{}", selection.reason);
    assert!(selection.reason.contains("narrowest band"), "{}", selection.reason);
    let (selection, _) = chosen(0.0, Some(2e-4));
    assert_eq!(selection.recommended, Some(0), "{}", selection.reason);
    println!("{}", selection.reason);
    assert!(selection.reason.contains("do not tell apart"), "{}", selection.reason);
}
