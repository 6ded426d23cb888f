//! Promises of the block solver on every machine.

use nalgebra::Vector3;

use super::checks::is_at_bound;
use super::{Fit, Prior, checked_parameters, fit};
use crate::fit::{Minimizer, Settings};
use crate::recorded_curves::curve;
use crate::residual::lengths::blocks::{Accumulate, Block};
use crate::residual::lengths::pose_lanes::PoseLanes;
use crate::residual::lengths::weights::length_weights;
use crate::stopping::StoppingRule;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model, place_pulleys};
use cdpr_model::robot::{ParameterKind, Robot};
use cdpr_model::scalar::{Unit, dispatch_on};

/// Thirteen poses, so that the last group is padded; lengths of the model itself plus millimetres.
fn samples(model: &Model) -> Samples {
    let poses = curve(model, 13, 1.0);
    let lengths = poses.iter().flat_map(|pose| model.cable_lengths(pose).unwrap());
    let lengths = lengths.enumerate().map(|(index, length)| length + 1e-3 * (index as f64).sin()).collect();
    let sigmas =
        SensorSigmas { length: Some(1e-3), position: Some(2e-4), rotation: Some(1e-4), ..SensorSigmas::default() };
    Samples { poses, lengths, cable_count: model.cable_count(), sigmas, ..Samples::default() }
}

#[test]
fn normal_equations_have_the_same_bits_on_every_unit() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let pulleys = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).unwrap();
    for (model, free) in [
        (Model::new(robot, Composition::STANDARD).unwrap(), "frame-anchor,platform-anchor,length-offset,length-scale"),
        (Model::new(pulleys, Composition::PULLEY).unwrap(), "frame-anchor,platform-anchor,length-offset,pulley-radius"),
    ] {
        let samples = samples(&model);
        let poses = PoseLanes::new(&samples);
        let weights = length_weights(&model, &samples, &poses).unwrap();
        let parameters = checked_parameters(&model, &samples, &free.parse().unwrap(), &Settings::default()).unwrap();
        for cable in 0..8 {
            let own = parameters.iter().filter(|parameter| parameter.cable == cable).copied().collect();
            let block = Block::new(&model, cable, own, &samples, &weights);
            let on = |unit| {
                let kernel = Accumulate::<8> { block: &block, poses: &poses, values: &block.start, recordings: None };
                let equations = dispatch_on(unit, kernel).unwrap();
                let numbers = equations.matrix.as_flattened().iter().chain(&equations.gradient);
                numbers.chain([&equations.cost]).map(|x| x.to_bits()).collect::<Vec<_>>()
            };
            for unit in Unit::available() {
                assert_eq!(on(unit), on(Unit::Portable), "{unit:?}");
            }
        }
    }
}

/// Points near a line leave each anchor two places, mirrored in it; the wrong one fits worse. From the file's values the descent
/// ends there, and other starts find the right one.
#[test]
fn other_starts_of_a_kinematic_fit_find_a_better_optimum() {
    let mut truth = Robot::builtin("planar-example").unwrap();
    let axis = truth.plane.second_axis();
    truth.cables.iter_mut().for_each(|cable| {
        let height = cable.frame_anchor.dot(&axis);
        cable.frame_anchor += axis * (0.3 - height);
    });
    let model = Model::new(truth.clone(), Composition::STANDARD).unwrap();
    let first = truth.plane.first_axis();
    let middle = truth.cables.iter().map(|cable| cable.frame_anchor.dot(&first)).sum::<f64>() / 4.0;
    let pose = |index: i32| Pose {
        position: first * (middle + 0.1 * f64::from(index)) + axis * (0.004 * f64::from(index % 3)),
        ..Pose::identity()
    };
    let poses: Vec<Pose> = (-10..10).map(pose).collect();
    let lengths = poses.iter().flat_map(|pose| model.cable_lengths(pose).unwrap()).collect();
    let samples = Samples { poses, lengths, cable_count: 4, ..Samples::default() };
    let mut start = truth.clone();
    start.cables.iter_mut().for_each(|cable| cable.frame_anchor -= axis * 0.5);
    let start = Model::new(start, Composition::STANDARD).unwrap();
    let found = |starts| {
        let settings = Settings { starts, ..Settings::default() };
        fit(&start, &samples, &"frame-anchor".parse().unwrap(), &settings).unwrap()
    };
    let farthest = |fit: &Fit| {
        let pairs = fit.model.robot().cables.iter().zip(&truth.cables);
        pairs.map(|(found, truth)| (found.frame_anchor - truth.frame_anchor).norm()).fold(0.0, f64::max)
    };
    let (one, many) = (found(1), found(20));
    assert!(farthest(&one) > 0.3, "the file's values lead to a mirrored anchor: {}", farthest(&one));
    // the data are exact: only the tolerance of the fit is left
    assert!(farthest(&many) < 1e-6, "{}", farthest(&many));
    assert!(
        many.starts.optima.len() > 1 && many.starts.optima[0].cost < 1e-6 * many.starts.optima.last().unwrap().cost,
        "{:?}",
        many.starts
    );
    assert_eq!((one.starts.count, one.starts.optima.len()), (1, 1));
}

/// Nobody has to know the noise: where no accuracy is stated, parameters, deviations and noise factor are those of the accuracy
/// that the residuals tell, prior and all.
#[test]
fn unknown_accuracies_give_the_answer_of_the_true_ones() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let model = Model::new(robot.clone(), Composition::STANDARD).unwrap();
    let mut samples = samples(&model);
    samples.lengths.iter_mut().enumerate().for_each(|(index, length)| *length += 4e-3 * (1.7 * index as f64).cos());
    samples.sigmas = SensorSigmas::default();
    let prior = |kind| Prior { kind, sigma: 0.005 };
    let settings = Settings {
        priors: vec![prior(ParameterKind::PlatformAnchor), prior(ParameterKind::FrameAnchor)],
        ..Settings::default()
    };
    let free = "frame-anchor,platform-anchor".parse().unwrap();
    let unknown = fit(&model, &samples, &free, &settings).unwrap();
    // noise of some millimetres in units of the assumed one
    assert!((2.0..6.0).contains(&unknown.noise_factor), "{}", unknown.noise_factor);
    samples.sigmas.length = Some(1e-3 * unknown.noise_factor);
    let stated = fit(&model, &samples, &free, &settings).unwrap();
    assert!((stated.noise_factor - 1.0).abs() < 1e-8, "{}", stated.noise_factor);
    for (unknown, stated) in unknown.parameters.iter().zip(&stated.parameters) {
        assert!((unknown.value - stated.value).abs() < 1e-9, "{}: {} {}", stated.name, unknown.value, stated.value);
        let (unknown, stated) = (unknown.sigma.unwrap(), stated.sigma.unwrap());
        assert!((unknown / stated - 1.0).abs() < 1e-7, "{unknown} {stated}");
    }
}

/// A bound is where rounding ends: 0.0010000000000000009 is not free of 0.001.
#[test]
fn values_within_rounding_of_a_bound_are_at_it() {
    let scale = (1e-3, f64::INFINITY);
    assert!(is_at_bound(0.0010000000000000009, 1.0, scale) && is_at_bound(1e-3, 1.0, scale));
    assert!(!is_at_bound(0.0011, 1.0, scale) && !is_at_bound(1.0, 1.0, scale));
    let compliance = (0.0, f64::INFINITY);
    assert!(is_at_bound(1e-18, 5e-7, compliance) && !is_at_bound(1e-9, 5e-7, compliance));
    assert!(!is_at_bound(0.0, 0.0, (f64::NEG_INFINITY, f64::INFINITY)));
}

/// Each way ends at the same optimum, one of pulleys that want to be smaller than none too. The bound is met by an active set, from inside
/// only to rounding.
#[test]
fn every_minimizer_ends_at_the_same_cost() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let plain = Model::new(robot.clone(), Composition::STANDARD).unwrap();
    let pulleys = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).unwrap();
    let pulleys = Model::new(pulleys, Composition::PULLEY).unwrap();
    let samples = samples(&plain);
    for (model, free, bounds) in
        [(&plain, "frame-anchor,length-offset", 0), (&pulleys, "frame-anchor,pulley-radius", 1)]
    {
        let of = |minimizer| {
            let settings = Settings { minimizer, ..Settings::default() };
            let found = fit(model, &samples, &free.parse().unwrap(), &settings).unwrap();
            assert_ne!(found.status, super::Status::NotConverged, "{minimizer:?} {free}: {}", found.reason);
            let stopped = found.stopped_by;
            assert!(stopped.rule < StoppingRule::IterationLimit && stopped.value <= stopped.limit, "{stopped:?}");
            for estimate in &found.parameters {
                let (low, high) = estimate.parameter.bounds();
                assert!(estimate.value >= low && estimate.value <= high, "{minimizer:?}: {estimate:?}");
            }
            found
        };
        let reference = of(Minimizer::LevenbergMarquardt);
        let at_bound = reference.parameters.iter().filter(|parameter| parameter.at_bound).count();
        assert!(at_bound >= bounds, "{at_bound} of {free} at a bound");
        for minimizer in [Minimizer::GaussNewton, Minimizer::Dogleg, Minimizer::TrustRegion] {
            let other = of(minimizer);
            let (cost, expected) = (other.noise_factor.powi(2), reference.noise_factor.powi(2));
            assert!((cost / expected - 1.0).abs() < 1e-10, "{minimizer:?} {free}: {cost} {expected}");
            for (other, reference) in other.parameters.iter().zip(&reference.parameters) {
                // an interior search ends this near to its bound
                let is_same = (other.value - reference.value).abs() < 1e-6;
                assert!(is_same || !reference.at_bound, "{minimizer:?}: {other:?} {reference:?}");
            }
        }
    }
}
