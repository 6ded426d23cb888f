//! What data determine, and how that is told.

use super::support::{NOISE, measured, random_poses, simulator};
use cdpr_calibration::fit::{Fit, Prior, Settings, Status, fit};
use cdpr_model::control::simulate::simulate;
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, FreeParameters, Model};
use cdpr_model::robot::ParameterKind;

const ANCHORS: [ParameterKind; 2] = [ParameterKind::FrameAnchor, ParameterKind::PlatformAnchor];

/// Exact samples of the nominal simulator with orientations within ± `angle` (rad).
fn exact(angle: f64) -> Samples {
    let model = Model::new(simulator(), Composition::STANDARD).unwrap();
    let poses = random_poses(model.robot(), 91, angle, 1);
    let mut samples = simulate(&model, &model, &[0.0; 8], &poses, &Default::default(), 1).unwrap().samples;
    samples.sigmas = NOISE;
    samples
}

fn fit_anchors(samples: &Samples, settings: &Settings) -> Fit {
    let model = Model::new(simulator(), Composition::STANDARD).unwrap();
    fit(&model, samples, &FreeParameters::of(&ANCHORS), settings).unwrap()
}

#[test]
fn constant_orientation_determines_half_of_the_anchors() {
    let fit = fit_anchors(&exact(0.0), &Settings::default());
    assert_eq!((fit.status, fit.analysis.rank, fit.parameters.len()), (Status::NotIdentifiable, 24, 48));
    assert!(fit.analysis.condition.is_infinite());
    for axis in ["x", "y", "z"] {
        let words = format!("all frame anchors and all platform anchors together along {axis} (not determined at all)");
        assert!(fit.analysis.weak_directions.contains(&words), "{:?}", fit.analysis.weak_directions);
    }
    assert_eq!(fit.analysis.weak_directions.len(), 3);
    assert!(fit.parameters.iter().all(|parameter| parameter.sigma.is_none()));
}

/// The orientation is measured with 0.1° of noise: formally everything is determined, in fact the same directions are not.
#[test]
fn noise_on_a_constant_orientation_leaves_the_same_directions_weak() {
    let model = Model::new(simulator(), Composition::STANDARD).unwrap();
    let poses = random_poses(model.robot(), 91, 0.0, 1);
    let noise = cdpr_model::measurement::SensorSigmas { rotation: Some(0.1_f64.to_radians()), ..NOISE };
    let samples = simulate(&model, &model, &[0.0; 8], &poses, &noise, 1).unwrap().samples;
    let fit = fit_anchors(&samples, &Settings::default());
    assert_eq!((fit.status, fit.analysis.rank), (Status::Converged, 48), "{}", fit.reason);
    assert!(fit.analysis.condition > 500.0 && fit.analysis.condition < 1e5, "{}", fit.analysis.condition);
    for axis in ["x", "y", "z"] {
        let words =
            format!("all frame anchors and all platform anchors together along {axis} (standard deviation up to");
        let told = fit.analysis.weak_directions.iter().any(|direction| direction.starts_with(&words));
        assert!(told, "{axis}: {:?}", fit.analysis.weak_directions);
    }
}

/// sec. 6.3: anchors of the frame alone are determined, with a condition of 20 to 37 for spread poses: here the corners and
/// the middle of the box of sec. 6.1.
#[test]
fn frame_anchors_alone_are_determined() {
    let model = Model::new(simulator(), Composition::STANDARD).unwrap();
    let corner = |k: i32| if k == 0 { -1.0 } else { 1.0 };
    let mut poses = random_poses(model.robot(), 9, 0.0, 1);
    for (k, commanded) in poses.iter_mut().enumerate() {
        let k = k as i32;
        let scale = if k == 8 { 0.0 } else { 1.0 };
        let (x, y, z) = (corner(k & 1), corner(k & 2), corner(k & 4));
        commanded.pose.position = nalgebra::Vector3::new(1.5 * x, 1.5 * y, 0.375 * z) * scale;
        commanded.pose.position.z += 1.625;
    }
    let samples = simulate(&model, &model, &[0.0; 8], &poses, &Default::default(), 1).unwrap().samples;
    let free = FreeParameters::of(&ANCHORS[..1]);
    let fit = fit(&model, &samples, &free, &Settings::default()).unwrap();
    assert_eq!((fit.status, fit.analysis.rank), (Status::Converged, 24));
    assert!(fit.analysis.condition > 20.0 && fit.analysis.condition < 37.0, "{}", fit.analysis.condition);
    assert!(fit.analysis.weak_directions.is_empty());
}

#[test]
fn a_prior_on_the_platform_anchors_closes_the_gap() {
    let prior = Prior { kind: ParameterKind::PlatformAnchor, sigma: 0.02 };
    let fit = fit_anchors(&exact(0.0), &Settings { priors: vec![prior], ..Settings::default() });
    assert_eq!((fit.status, fit.analysis.rank), (Status::Converged, 24), "{}", fit.reason);
    // the frame anchors inherit the prior's 20 mm along the gauge
    let sigma = fit.parameters[0].sigma.unwrap();
    assert!(sigma > 0.0199 && sigma < 0.03, "{sigma}");
    assert!(fit.analysis.weak_directions.is_empty(), "{:?}", fit.analysis.weak_directions);
}

/// From anchors up to 0.5 m off the kinematic optimum is unique to 1e-6 m.
#[test]
fn the_optimum_of_the_frame_anchors_is_unique() {
    use rand::{RngExt, SeedableRng};
    let samples = measured(
        &super::support::builtin("cablerobot-simulator-helicopter-kinematic-calibrated"),
        Composition::STANDARD,
        91,
        0.09,
        7,
    );
    let free = FreeParameters::of(&ANCHORS[..1]);
    let optimum = |robot| {
        let model = Model::new(robot, Composition::STANDARD).unwrap();
        let fit = fit(&model, &samples, &free, &Settings::default()).unwrap();
        assert_eq!(fit.status, Status::Converged);
        fit.parameters.iter().map(|parameter| parameter.value).collect::<Vec<f64>>()
    };
    let expected = optimum(simulator());
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(9);
    for _ in 0..50 {
        let mut robot = simulator();
        for cable in &mut robot.cables {
            cable.frame_anchor += nalgebra::Vector3::from_fn(|_, _| rng.random_range(-0.5..0.5));
        }
        for (found, expected) in optimum(robot).iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-6, "{found} {expected}");
        }
    }
}

/// A scale and an offset of cables whose length hardly changes cannot be told apart.
#[test]
fn offset_and_scale_without_excursion_are_told_in_words() {
    let model = Model::new(simulator(), Composition::STANDARD).unwrap();
    let mut poses = random_poses(model.robot(), 40, 0.0, 3);
    for commanded in &mut poses {
        commanded.pose.position = commanded.pose.position * 0.01 + nalgebra::Vector3::new(0.0, 0.0, 1.5);
    }
    let samples = simulate(&model, &model, &[0.0; 8], &poses, &NOISE, 1).unwrap().samples;
    let free = FreeParameters::of(&[ParameterKind::LengthOffset, ParameterKind::LengthScale]);
    let fit = fit(&model, &samples, &free, &Settings::default()).unwrap();
    assert!(
        fit.analysis.weak_directions.iter().any(|w| w.contains("length-offset[1]") && w.contains("length-scale[1]"))
    );
    assert!(fit.correlations().iter().any(|c| c.first == "length-offset[1]" && c.coefficient < -0.95));
}

/// A column in the wrong unit is told before anyone wonders about anchors kilometres away.
#[test]
fn lengths_in_another_unit_are_suspected() {
    let mut samples = exact(0.1);
    for sample in 0..samples.len() {
        samples.lengths[8 * sample + 2] *= 1e-3;
    }
    let fit = fit_anchors(&samples, &Settings::default());
    assert!(
        fit.warnings.iter().any(|w| w.starts_with("cable 3: the recorded lengths") && w.contains("unit")),
        "{:?}",
        fit.warnings
    );
    assert!(!fit.warnings.iter().any(|w| w.starts_with("cable 2:")));
}
