use nalgebra::Vector3;

use super::{Profile, profiles};
use crate::fit::{Fit, InputError, Prior, Settings, fit};
use crate::objective::{Minimize, Objective};
use crate::recorded_curves::{SIGMA, curve, noisy, points};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, FreeParameters, Model};
use cdpr_model::robot::ParameterKind;

fn samples(count: usize, seed: u64) -> Samples {
    noisy(&points(), curve(&points(), count, 0.0), seed, Some(SIGMA), 0.0)
}

fn profiled(samples: &Samples, free: &str, settings: &Settings, place: usize) -> (Fit, Profile) {
    let free: FreeParameters = free.parse().unwrap();
    let fit = fit(&points(), samples, &free, settings).unwrap();
    let mut found = profiles(&points(), samples, &fit, settings, &[place]).unwrap();
    (fit, found.remove(0))
}

/// Offsets are a linear problem, each alone in its cable: the weighted squares rise by n δ²/σ², held and refitted alike, and the interval is
/// that of the linear deviation.
#[test]
fn a_linear_problem_has_the_parabola_of_its_deviation() {
    let samples = samples(30, 1);
    let (fit, profile) = profiled(&samples, "length-offset", &Settings::default(), 2);
    assert_eq!(profile.points.len(), 13);
    for point in &profile.points {
        let expected = 30.0 * (point.shift / SIGMA).powi(2);
        // the optimum is found to 1e-10 m, the sum of 240 squares is rounded
        assert!((point.held - expected).abs() < 1e-5, "{point:?} {expected}");
        assert!((point.refitted - expected).abs() < 1e-5, "{point:?} {expected}");
    }
    let half = fit.analysis.quantile_95 * fit.parameters[2].sigma.unwrap();
    let [low, high] = profile.interval.map(Option::unwrap);
    // ends are found to 1e-4 of their distance
    assert!(((profile.value - low) / half - 1.0).abs() < 2e-4 && ((high - profile.value) / half - 1.0).abs() < 2e-4);
    assert!(profile.points.iter().all(|point| point.length_rms_m >= profile.length_rms_m));
}

/// Offset and anchor of one cable explain each other in part: the others refitted make up for a shift, and only that profile has the curvature of
/// the linear deviation, 1/σ² near the optimum.
#[test]
fn refitting_the_others_gives_the_curvature_of_the_deviation() {
    let samples = samples(40, 2);
    let (fit, profile) = profiled(&samples, "frame-anchor,length-offset", &Settings::default(), 0);
    let sigma = fit.parameters[0].sigma.unwrap();
    let inflation = fit.analysis.inflation.powi(2);
    for point in profile.points.iter().filter(|point| point.shift != 0.0 && point.shift.abs() < 1.1 * sigma) {
        let expected = inflation * (point.shift / sigma).powi(2);
        // the deviation is 36 mm along the cables: their directions bend, by 4 % at three deviations
        assert!((point.refitted / expected - 1.0).abs() < 0.02, "{point:?} {expected}");
        assert!(point.held > 1.5 * point.refitted, "{point:?}");
    }
}

/// A prior narrows the profile as it narrows the deviation: curvature n/σ² + 1/σ_prior².
#[test]
fn a_prior_is_part_of_the_profile() {
    let samples = samples(25, 3);
    let priors = vec![Prior { kind: ParameterKind::LengthOffset, sigma: SIGMA / 5.0 }];
    let settings = Settings { priors, ..Settings::default() };
    let (_, profile) = profiled(&samples, "length-offset", &settings, 5);
    let weight = 25.0 / SIGMA.powi(2) + 25.0 / SIGMA.powi(2);
    for point in &profile.points {
        assert!((point.refitted - weight * point.shift.powi(2)).abs() < 1e-5, "{point:?}");
    }
}

/// A radius of nothing is a bound: the interval is open below.
#[test]
fn an_interval_that_meets_a_bound_is_open_there() {
    let robot = points().robot().clone();
    let pulleys =
        cdpr_model::model::place_pulleys(&robot, &[(0.001, Vector3::z()); 8], &robot.home_or_middle()).unwrap();
    let given = Model::new(pulleys, Composition::PULLEY).unwrap();
    let samples = samples(30, 4);
    let fit = fit(&given, &samples, &"pulley-radius".parse().unwrap(), &Settings::default()).unwrap();
    let place = (0..8).max_by(|&a, &b| fit.parameters[a].value.total_cmp(&fit.parameters[b].value)).unwrap();
    let sigma = fit.parameters[place].sigma.unwrap();
    let profile = profiles(&given, &samples, &fit, &Settings::default(), &[place]).unwrap().remove(0);
    assert_eq!(profile.interval[0].is_none(), fit.parameters[place].value < 1.9 * sigma, "{profile:?}");
    assert!(profile.points.iter().all(|point| profile.value + point.shift >= 0.0));
}

/// Errors of predicted poses have profiles of their own squares. Offsets move them almost linearly: the interval is that of the linear deviation but
/// for the bend of a millimetre in metres, and it is not that of the lengths.
#[test]
fn predicted_poses_have_the_profile_of_their_own_squares() {
    let samples = noisy(&points(), curve(&points(), 30, 1.0), 4, Some(SIGMA), 0.0);
    let of_poses = Settings { objective: Objective::Pose, ..Settings::default() };
    let (fit, profile) = profiled(&samples, "length-offset", &of_poses, 2);
    let half = fit.analysis.quantile_95 * fit.parameters[2].sigma.unwrap();
    let [low, high] = profile.interval.map(Option::unwrap);
    for one in [profile.value - low, high - profile.value] {
        assert!((one / half - 1.0).abs() < 1e-2, "{one} {half}");
    }
    assert!(profile.points.iter().all(|point| point.refitted > -1e-9 && point.held >= point.refitted - 1e-9));
    let (by_lengths, _) = profiled(&samples, "length-offset", &Settings::default(), 2);
    assert!(half > 1.2 * by_lengths.analysis.quantile_95 * by_lengths.parameters[2].sigma.unwrap());
}

#[test]
fn costs_that_are_no_squares_have_no_profile() {
    let samples = samples(20, 5);
    let settings = Settings { minimize: Minimize::Max, ..Settings::default() };
    let fit = fit(&points(), &samples, &"length-offset".parse().unwrap(), &settings).unwrap();
    let refused = profiles(&points(), &samples, &fit, &settings, &[0]);
    assert_eq!(refused, Err(InputError::ProfileCost { minimize: Minimize::Max }));
    assert_eq!(fit.without_deviation(), 8);
    let home = points().robot().home_or_middle();
    assert_eq!(fit.pose_bands(&[home]).unwrap(), [None]);
}
