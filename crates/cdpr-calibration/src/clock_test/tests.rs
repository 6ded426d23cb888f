//! Offsets of clocks on a robot that moves on a known curve.

use rand::{RngExt, SeedableRng};

use super::*;
use crate::clock::{synchronised, synchronised_within};
use crate::fit::fit;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;

const INTERVAL: f64 = 0.01;

/// A platform on a curve at half a metre per second, 100 Hz for ten seconds; poses recorded late (s) and with noise (m), winches with offsets.
fn recorded(late: f64, noise: f64) -> (Model, Samples) {
    let robot = Robot::builtin("planar-example").unwrap();
    let model = Model::new(robot.clone(), Composition::STANDARD).unwrap();
    let at = |t: f64| {
        robot.motion_pattern.pose(robot.plane, &[0.5 + 0.8 * (0.7 * t).sin(), 4.0 + 0.5 * (1.1 * t).cos()]).unwrap()
    };
    let mut chance = rand_chacha::ChaCha8Rng::seed_from_u64(5);
    let mut samples = Samples { cable_count: 4, ..Samples::default() };
    let mut time = Vec::new();
    for k in 0..1000 {
        let t = INTERVAL * f64::from(k);
        let mut pose = at(t - late);
        let mut disturb = || noise * 12f64.sqrt() * (chance.random::<f64>() - 0.5);
        pose.position += robot.plane.first_axis() * disturb() + robot.plane.second_axis() * disturb();
        samples.poses.push(pose);
        samples.lengths.extend(model.cable_lengths(&at(t)).unwrap().iter().map(|length| length + 0.1));
        time.push(t);
    }
    samples.time = Some(time);
    (model, samples)
}

#[test]
fn an_offset_is_found_within_its_deviation_and_told_where_it_matters() {
    let free: FreeParameters = "length-offset".parse().unwrap();
    let settings = Settings::default();
    for late in [0.05, -0.034, 0.2] {
        let (model, samples) = recorded(late, 5e-4);
        let plain = fit(&model, &samples, &free, &settings).unwrap();
        let words = clock_warning(&plain, &samples, &free, &settings).unwrap();
        let side = if late > 0.0 { "late" } else { "early" };
        assert!(words.contains(side) && words.contains("clock-offset"), "{words}");
        let freed = fit(&model, &samples, &"length-offset,clock-offset".parse().unwrap(), &settings).unwrap();
        let found = freed.clock_offset.unwrap();
        // four deviations
        assert!((found.seconds - late).abs() < 4.0 * found.sigma && found.sigma < 1e-3, "{late}: {found:?}");
        for estimate in &freed.parameters {
            assert!((estimate.value - 0.1).abs() < 2e-4, "{late}: {} {}", estimate.name, estimate.value);
        }
        assert_eq!(clock_warning(&freed, &samples, &free, &settings), None);
    }
}

/// Poses recorded early lack the first samples; the fit numbers its outliers by the recording all the same.
#[test]
fn outliers_keep_their_numbers_where_samples_at_the_begin_are_left_out() {
    let (model, mut samples) = recorded(-0.05, 5e-4);
    let outlier = 500;
    samples.lengths[4 * outlier + 2] += 0.3;
    let fit = fit(&model, &samples, &"length-offset,clock-offset".parse().unwrap(), &Settings::default()).unwrap();
    let (within, kept) = synchronised_within(&samples, fit.clock_offset.unwrap().seconds);
    assert!(kept[0] > 0 && within.len() == kept.len(), "{:?}", &kept[..3]);
    assert_eq!(fit.outliers.iter().map(|outlier| outlier.sample - 1).collect::<Vec<_>>(), [outlier]);
    let trusted = fit.trusted_samples(samples.len());
    assert!(trusted.len() == samples.len() - 1 && !trusted.contains(&outlier));
}

#[test]
fn synchronous_and_timeless_data_give_no_alarm() {
    let free: FreeParameters = "length-offset".parse().unwrap();
    let settings = Settings::default();
    for noise in [1e-6, 5e-4, 1e-2] {
        let (model, samples) = recorded(0.0, noise);
        let plain = fit(&model, &samples, &free, &settings).unwrap();
        assert_eq!(clock_warning(&plain, &samples, &free, &settings), None, "{noise}");
        let timeless = Samples { time: None, ..samples };
        assert_eq!(clock_warning(&plain, &timeless, &free, &settings), None);
        assert!(fit(&model, &timeless, &"clock-offset".parse().unwrap(), &settings).is_err());
    }
}

/// Poses visited one after the other, seconds apart, far from each other: velocities mean nothing and clocks are not told.
#[test]
fn poses_far_apart_give_no_alarm() {
    let (model, samples) = recorded(0.0, 5e-4);
    let chosen: Vec<usize> = (0..90).map(|k| (k * 367) % 1000).collect();
    let mut sparse = samples.subset(&chosen);
    sparse.time = Some((0..90).map(|k| 5.0 * f64::from(k)).collect());
    let free: FreeParameters = "length-offset".parse().unwrap();
    let plain = fit(&model, &sparse, &free, &Settings::default()).unwrap();
    assert_eq!(clock_warning(&plain, &sparse, &free, &Settings::default()), None);
}

/// A recording that begins anew is no motion from its end to the beginning, and offset 0 leaves every pose as it is.
#[test]
fn poses_are_moved_within_their_own_recording() {
    let (_, samples) = recorded(0.0, 0.0);
    let twice = samples.followed_by(&samples).unwrap();
    assert_eq!(synchronised(&twice, 0.0).poses, twice.poses);
    let moved = synchronised(&twice, 0.025);
    let (_, early) = recorded(-0.025, 0.0);
    for half in [0, 1000] {
        for k in 3..990 {
            let apart = moved.poses[half + k].displacement_to(&early.poses[k]).norm();
            // half an interval along the tangent of a curve with 0.6 m/s²: a quarter of a tenth of a millimetre
            assert!(apart < 1e-5, "{half} {k}: {apart}");
        }
    }
}
