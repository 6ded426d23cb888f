//! Starts of an identification: the optima they lead to (requirements, C22).

use super::studies::record;
use super::support::{builtin, measured, with_pulleys};
use cdpr_calibration::Objective;
use cdpr_calibration::fit::{Fit, Settings, Status, fit};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;

#[track_caller]
fn identified(robot: Robot, composition: Composition, free: &str, samples: &Samples, settings: &Settings) -> Fit {
    let model = Model::new(robot, composition).unwrap();
    let fit = fit(&model, samples, &free.parse().unwrap(), settings).unwrap();
    assert_eq!(fit.status, Status::Converged, "{}", fit.reason);
    fit
}

/// All starts, and at least this many, at one optimum.
#[track_caller]
fn assert_one_optimum(fit: &Fit, count: usize, spread: f64) {
    println!("{:?}", fit.starts);
    let [optimum] = &fit.starts.optima[..] else { panic!("{:?}", fit.starts) };
    assert_eq!((fit.starts.count, optimum.starts, optimum.fraction), (count, count, 1.0));
    assert!(optimum.spread_m <= spread, "{} m", optimum.spread_m);
    assert!(!fit.cautions().iter().any(|words| words.contains("optimum")), "{:?}", fit.cautions());
}

/// Frame anchors of the dissertation's machine from a_N + U(−0.5, 0.5) m (section 6.8): another program found one optimum to 5e-6 m.
#[test]
fn all_starts_of_a_kinematic_fit_lead_to_one_optimum() {
    let samples = record("twin-kinematic-measurements", 1);
    let settings = Settings { starts: 50, ..Settings::default() };
    let robot = builtin("cablerobot-simulator-helicopter");
    let fit = identified(robot, Composition::STANDARD, "frame-anchor", &samples, &settings);
    assert_eq!((fit.parameters.len(), &fit.starts.ranges[..]), (24, &["frame-anchor ± 0.5 m".to_owned()][..]));
    assert_one_optimum(&fit, 50, 5e-6);
}

#[test]
fn all_starts_of_a_fit_of_predicted_poses_lead_to_one_optimum() {
    let samples = record("planar-wide-grid", 1);
    let settings = Settings { starts: 7, objective: Objective::Pose, ..Settings::default() };
    let fit = identified(builtin("planar-example"), Composition::STANDARD, "frame-anchor", &samples, &settings);
    // another program: unique from six starts of ± 0.5 m; 45 mm of residual make Gauss–Newton end where rounding hides a gain, some micrometres apart
    assert_one_optimum(&fit, 7, 1e-5);
}

/// Radii have starts of their own, by factors, and so do ratios.
#[test]
fn pulleys_and_winches_have_starts_too() {
    let robot = with_pulleys(&builtin("cablerobot-simulator-helicopter"), 0.05);
    let samples = measured(&robot, Composition::PULLEY, 60, 0.2, 3);
    let start = with_pulleys(&builtin("cablerobot-simulator-helicopter"), 0.06);
    let settings = Settings { starts: 10, ..Settings::default() };
    let fit = identified(start, Composition::PULLEY, "pulley-radius,length-scale,length-offset", &samples, &settings);
    assert_eq!(fit.starts.ranges, ["length-offset ± 0.5 m", "length-scale ± 0.1", "pulley-radius × or ÷ 1.5"]);
    assert_one_optimum(&fit, 10, 5e-6);
}
