//! Rows that are wrong: what they do to fits and choices, and who is named.

use super::support::{builtin, measured, random_direction, simulator};
use cdpr_calibration::fit::{Fit, Settings, Status, fit};
use cdpr_calibration::selection::{self, Selection, Warnings, select};
use cdpr_calibration::unobserved;
use cdpr_calibration::{Loss, candidate};
use cdpr_model::measurement::{Samples, Split};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::ParameterKind;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

pub(super) const ANCHORS: &str = "frame-anchor,length-offset";

/// Displaces 3 % of the rows by 0.1 to 0.3 m in random directions; the rows, in order.
pub(super) fn displace(samples: &mut Samples, seed: u64) -> Vec<usize> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut rows = rand::seq::index::sample(&mut rng, samples.len(), samples.len() * 3 / 100).into_vec();
    rows.sort_unstable();
    for &row in &rows {
        let size = rng.random_range(0.1..0.3);
        samples.poses[row].position += size * random_direction(&mut rng);
    }
    rows
}

fn identified(samples: &Samples, loss: Loss) -> Fit {
    let model = Model::new(simulator(), Composition::STANDARD).unwrap();
    let found = fit(&model, samples, &ANCHORS.parse().unwrap(), &Settings { loss, ..Settings::default() }).unwrap();
    assert_eq!(found.status, Status::Converged, "{}", found.reason);
    found
}

/// Eight cables whose frame anchors and offsets are elsewhere, 200 poses.
pub(super) fn record(seed: u64) -> Samples {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut machine = simulator();
    for cable in &mut machine.cables {
        cable.frame_anchor += 0.02 * random_direction(&mut rng);
        cable.length_offset = Some(rng.random_range(-0.02..0.02));
    }
    measured(&machine, Composition::STANDARD, 200, 0.1, seed)
}

/// All six displaced rows of 200 are named and no other, by every loss that looks for them, and on clean data nobody is.
#[test]
fn displaced_rows_of_an_eight_cable_robot_are_named() {
    for seed in 0..10 {
        let clean = record(seed);
        let mut dirty = clean.clone();
        let rows = displace(&mut dirty, seed);
        assert!(identified(&clean, Loss::Auto).outliers.is_empty(), "seed {seed}");
        for loss in [Loss::Auto, Loss::Huber, Loss::Cauchy] {
            let named: Vec<usize> =
                identified(&dirty, loss).outliers.iter().map(|outlier| outlier.sample - 1).collect();
            assert_eq!(named, rows, "seed {seed}, {loss:?}");
        }
    }
}

/// The automatic choice is least squares to the last bit where nothing lies beyond the limit.
#[test]
fn clean_data_are_fitted_by_least_squares_to_the_bit() {
    let clean = record(3);
    let (auto, squared) = (identified(&clean, Loss::Auto), identified(&clean, Loss::Squared));
    assert_eq!((auto.loss, &auto.parameters), (Loss::Squared, &squared.parameters));
    assert_eq!((auto.noise_factor, auto.history), (squared.noise_factor, squared.history));
    assert_eq!(auto.loss_threshold, f64::INFINITY);
}

/// Least squares are told what they do: the rows are named, with the weight that they have.
#[test]
fn least_squares_name_the_rows_that_spoil_them() {
    let mut dirty = record(4);
    displace(&mut dirty, 4);
    let found = identified(&dirty, Loss::Squared);
    assert!(found.outliers.iter().all(|outlier| outlier.weight == 1.0) && !found.outliers.is_empty());
    assert!(found.outlier_warning.unwrap().starts_with("outliers: "));
}

/// A cable whose length jumps in one row is blamed alone, a displaced pose is not blamed on a cable.
#[test]
fn a_slipped_cable_is_told_from_a_wrong_pose() {
    let mut dirty = record(5);
    dirty.lengths[8 * 30 + 2] += 0.05;
    dirty.poses[60].position.y += 0.2;
    let found = identified(&dirty, Loss::Auto);
    let reasons: Vec<(usize, &str)> = found.outliers.iter().map(|o| (o.sample, o.reason.as_str())).collect();
    assert_eq!(reasons.len(), 2, "{reasons:?}");
    assert!(reasons[0].0 == 31 && reasons[0].1.contains("cable 3 alone"), "{reasons:?}");
    assert!(reasons[1].0 == 61 && reasons[1].1.contains("the pose is suspicious"), "{reasons:?}");
}

fn chosen(samples: &Samples) -> Selection {
    let start = simulator();
    let folds = Split::Blocks(5).folds(samples, 0).unwrap();
    let candidates = candidate::defaults(&start, Default::default());
    select(&start, &candidates, samples, &folds, &selection::Settings::default(), &unobserved).unwrap()
}

/// Outliers make every candidate err alike and its standard error large, so that the simplest would win: they are set aside for all.
#[test]
fn outliers_do_not_decide_which_model_wins() {
    for seed in 20..25 {
        let clean = record(seed);
        let mut dirty = clean.clone();
        let rows = displace(&mut dirty, seed);
        let (of_clean, of_dirty) = (chosen(&clean), chosen(&dirty));
        assert_eq!(of_clean.recommended, of_dirty.recommended, "seed {seed}: {}", of_dirty.reason);
        let judged =
            |selection: &Selection| selection.candidates[selection.recommended.unwrap()].outcome.clone().unwrap();
        let doubts = of_dirty.warnings(&dirty, &Warnings::default()).list();
        let (of_clean, of_dirty) = (judged(&of_clean), judged(&of_dirty));
        assert!(of_clean.set_aside.is_empty());
        let aside: Vec<usize> = of_dirty.set_aside.iter().map(|&place| of_dirty.validation_samples[place]).collect();
        assert_eq!(aside, rows, "seed {seed}");
        let ratio = of_dirty.criterion / of_clean.criterion;
        assert!((0.95..1.05).contains(&ratio), "seed {seed}: {ratio}");
        assert!(doubts[0].starts_with("outliers: 6 of "), "{doubts:?}");
    }
}

/// The elastic twin: 62 parameters from wrenches and lengths, every sample weighed as a whole.
#[test]
fn an_elastic_fit_names_displaced_rows_and_keeps_its_parameters() {
    let machine = builtin("cablerobot-simulator-helicopter-elastostatic-calibrated");
    let clean = measured_with_tensions(&machine);
    let mut dirty = clean.clone();
    let rows = displace(&mut dirty, 2);
    let model = Model::new(simulator(), Composition::ELASTIC).unwrap();
    let prior = cdpr_calibration::Prior { kind: ParameterKind::PlatformAnchor, sigma: 0.02 };
    let find = |samples: &Samples, loss| {
        let settings = Settings { loss, priors: vec![prior], ..Settings::default() };
        let free = "frame-anchor,platform-anchor,compliance,wrench".parse().unwrap();
        fit(&model, samples, &free, &settings).unwrap()
    };
    let (of_clean, of_dirty) = (find(&clean, Loss::Auto), find(&dirty, Loss::Auto));
    let squared = find(&dirty, Loss::Squared);
    assert_eq!((of_clean.loss, of_clean.outliers.len()), (Loss::Squared, 0));
    assert_eq!(of_dirty.status, Status::Converged, "{}", of_dirty.reason);
    assert_eq!(of_dirty.outliers.iter().map(|outlier| outlier.sample - 1).collect::<Vec<_>>(), rows);
    // rms of the changes in standard deviations of the clean fit
    let away = |found: &Fit| {
        let pairs = found.parameters.iter().zip(&of_clean.parameters);
        let squares = pairs.map(|(a, b)| ((a.value - b.value) / b.sigma.unwrap()).powi(2));
        (squares.sum::<f64>() / found.parameters.len() as f64).sqrt()
    };
    println!("rms change: {:.2} σ under Huber, {:.2} σ under least squares", away(&of_dirty), away(&squared));
    // 3 % fewer rows and a bounded pull of those displaced
    assert!(away(&of_dirty) < 0.8 && away(&squared) > 2.0);
}

/// Tensions and lengths recorded at the poses of the study of the twin.
fn measured_with_tensions(machine: &cdpr_model::robot::Robot) -> Samples {
    use cdpr_model::control::simulate::simulate;
    use cdpr_model::control::winch_offsets;
    let study = super::studies::study("twin-measurements");
    let control = Model::new(builtin(&study.control.robot), Composition::STANDARD).unwrap();
    let machine = Model::new(machine.clone(), Composition::ELASTIC).unwrap();
    let pose = study.initial_pose(machine.robot()).unwrap();
    let offsets = winch_offsets(&study.initial, &control, &machine, &pose).unwrap();
    let poses = study.commanded_poses(machine.robot(), Vec::new(), 1).unwrap();
    simulate(&control, &machine, &offsets, &poses, &study.noise.unwrap(), 1).unwrap().samples
}
