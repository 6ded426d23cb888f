//! Drums identified from recorded motor angles.

use super::support::{builtin, random_poses, simulator, with_drums, with_pulleys};
use cdpr_calibration::evaluate;
use cdpr_calibration::fit::{Fit, InputError, Settings, Status, fit};
use cdpr_model::control::simulate::simulate;
use cdpr_model::control::with_motor_angles;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model, ParameterError};
use cdpr_model::robot::{Parameter, ParameterKind, Robot};
use nalgebra::Vector3;

const DRUM: Composition = Composition { drum: true, ..Composition::STANDARD };
const ELASTIC_DRUM: Composition = Composition { drum: true, ..Composition::ELASTIC };

/// Drums up to 0.4 mm larger or smaller than the drawings say, with start lengths that are centimetres off.
fn as_built(drawn: &Robot) -> Robot {
    let mut built = drawn.clone();
    for (index, cable) in built.cables.iter_mut().enumerate() {
        let k = index as f64 - 3.5;
        cable.winch.radius = Some(0.1 + 1e-4 * k);
        cable.winch.start_length = Some(4.0 - 0.01 * k);
    }
    built
}

/// Poses and motor angles that a machine with drums records.
fn recorded(machine: &Robot, composition: Composition, count: usize, noise: &SensorSigmas, seed: u64) -> Samples {
    let machine = Model::new(machine.clone(), composition).unwrap();
    let poses = random_poses(machine.robot(), count, 0.1, seed);
    let simulation = simulate(&machine, &machine, &[0.0; 8], &poses, noise, seed).unwrap();
    with_motor_angles(&machine, &machine, &simulation.samples).unwrap()
}

fn identified(start: &Robot, composition: Composition, free: &str, samples: &Samples) -> Fit {
    let model = Model::new(start.clone(), composition).unwrap();
    fit(&model, samples, &free.parse().unwrap(), &Settings::default()).unwrap()
}

/// Error of every identified radius and start length in units of its own standard deviation.
fn in_sigmas(found: &Fit, truth: &Robot) -> Vec<f64> {
    let machine = Model::new(truth.clone(), DRUM).unwrap();
    found.parameters.iter().map(|p| (p.value - p.parameter.value(machine.robot())) / p.sigma.unwrap()).collect()
}

/// Wrong radii are found, and the errors left are as large as the standard deviations say: over 10 data sets and 160
/// parameters their root mean square is 1 to ±6 % at one standard deviation, ±18 % at three.
#[test]
fn wrong_drums_are_found_with_honest_standard_deviations() {
    let drawn = with_drums(&simulator());
    let built = as_built(&drawn);
    let noise = SensorSigmas {
        position: Some(5e-4),
        rotation: Some(5e-4),
        length: Some(1e-4),
        tension: None,
        ..SensorSigmas::default()
    };
    let mut all = Vec::new();
    for seed in 1..=10 {
        let samples = recorded(&built, DRUM, 100, &noise, seed);
        let found = identified(&drawn, DRUM, "drum-radius,start-length", &samples);
        assert_eq!(found.status, Status::Converged, "{}", found.reason);
        let radius = found.parameters.iter().find(|p| p.parameter.kind == ParameterKind::DrumRadius).unwrap();
        // 0.35 mm off at the start, known to about 0.01 mm
        assert!((radius.value - 0.09965).abs() < 5e-5 && radius.sigma.unwrap() < 5e-5, "{radius:?}");
        let before = evaluate(&Model::new(drawn.clone(), DRUM).unwrap(), &samples).unwrap().blocks().length_error_m.rms;
        let after = evaluate(&found.model, &samples).unwrap().blocks().length_error_m.rms;
        assert!(after < 1e-3 && before > 1e-2, "{before} {after}");
        all.extend(in_sigmas(&found, &built));
    }
    let rms = (all.iter().map(|x| x * x).sum::<f64>() / all.len() as f64).sqrt();
    assert!((0.82..1.18).contains(&rms), "{rms}");
}

/// With exact data the truth is found to rounding, anchors included, which the first pulley of a fleeting cable moves with.
#[test]
fn exact_motor_angles_give_drums_and_anchors_back() {
    let drawn = with_drums(&simulator());
    let mut built = as_built(&drawn);
    built.cables.iter_mut().for_each(|cable| cable.frame_anchor.x += 0.02);
    let samples = recorded(&built, DRUM, 60, &SensorSigmas::default(), 3);
    let found = identified(&drawn, DRUM, "frame-anchor,drum-radius,start-length", &samples);
    let machine = Model::new(built, DRUM).unwrap();
    for parameter in &found.parameters {
        let error = parameter.value - parameter.parameter.value(machine.robot());
        // the forward kinematics of the virtual machine stops at 1e-9 m, and some directions are thirty times weaker
        assert!(error.abs() < 3e-7, "{}: {error}", parameter.name);
    }
    // a Jacobian that is right converges in a few steps
    assert!(found.iterations <= 12, "{}", found.iterations);
}

#[test]
fn elastic_models_identify_drums_too() {
    let drawn = with_drums(&builtin("cablerobot-simulator-helicopter-elastostatic-calibrated"));
    let built = as_built(&drawn);
    let samples = recorded(&built, ELASTIC_DRUM, 30, &SensorSigmas::default(), 3);
    let found = identified(&drawn, ELASTIC_DRUM, "drum-radius,start-length", &samples);
    let machine = Model::new(built, ELASTIC_DRUM).unwrap();
    for parameter in &found.parameters {
        let error = parameter.value - parameter.parameter.value(machine.robot());
        assert!(error.abs() < 1e-6, "{}: {error}", parameter.name);
    }
}

/// A robot whose parameters of a kind are off by a few hundredths, cable by cable another way.
fn with_wrong(drawn: &Robot, kind: ParameterKind, size: f64) -> Robot {
    let mut built = drawn.clone();
    for cable in 0..drawn.cable_count() {
        // these drums stand below their pulleys, to which the first turn of a horizontal axis leans it
        for axis in 0..if kind == ParameterKind::SwivelAxis { 2 } else { 1 } {
            let parameter = Parameter { cable, kind, axis };
            let off = size * (1.0 + (2.3 * cable as f64 + 1.1 * axis as f64).sin());
            parameter.set(&mut built, parameter.value(drawn) + off);
        }
    }
    built
}

/// Each parameter is found again from noisy data within 3 of its own deviations, which are smaller than what it was off by.
fn is_found(drawn: &Robot, composition: Composition, (kind, size): (ParameterKind, f64), count: usize) {
    let built = with_wrong(drawn, kind, size);
    let noise = SensorSigmas {
        position: Some(1e-4),
        rotation: Some(1e-4),
        length: Some(5e-5),
        tension: Some(5.0),
        swivel: None,
        length_scale: None,
        balance_force: None,
        balance_moment: None,
    };
    let samples = recorded(&built, composition, count, &noise, 7);
    let found = identified(drawn, composition, kind.name(), &samples);
    assert_eq!(found.status, Status::Converged, "{kind}, {composition}: {}", found.reason);
    for estimate in &found.parameters {
        let (truth, sigma) = (estimate.parameter.value(&built), estimate.sigma.unwrap());
        let (error, name) = ((estimate.value - truth) / sigma, &estimate.name);
        assert!(error.abs() < 3.0 && sigma < size, "{composition}, {name}: {} {truth} ± {sigma}", estimate.value);
    }
}

#[test]
fn pitch_axes_and_start_angle_are_found_within_their_deviations() {
    let drums = [(ParameterKind::DrumPitch, 1e-3), (ParameterKind::DrumAxis, 0.02), (ParameterKind::StartAngle, 0.1)];
    let rigid = with_drums(&simulator());
    let elastic = with_drums(&builtin("cablerobot-simulator-helicopter-elastostatic-calibrated"));
    for of in drums {
        is_found(&rigid, DRUM, of, 100);
        is_found(&elastic, ELASTIC_DRUM, of, 40);
    }
    let of = (ParameterKind::SwivelAxis, 0.02);
    is_found(&with_drums(&with_pulleys(&rigid, 0.16)), Composition { pulley: true, ..DRUM }, of, 100);
    is_found(&with_drums(&with_pulleys(&elastic, 0.16)), Composition { pulley: true, ..ELASTIC_DRUM }, of, 40);
}

/// Turned axes are unit vectors, and stay where a file says so: the calibrated robot survives the way through its file.
#[test]
fn calibrated_axes_are_written_as_unit_vectors() {
    let drawn = with_drums(&simulator());
    let built = with_wrong(&drawn, ParameterKind::DrumAxis, 0.02);
    let samples = recorded(&built, DRUM, 60, &SensorSigmas::default(), 3);
    let calibrated = identified(&drawn, DRUM, "drum-axis", &samples).model.robot().clone();
    for (found, truth) in calibrated.cables.iter().zip(&built.cables) {
        let (found, truth): (Vector3<f64>, Vector3<f64>) = (*found.winch.axis.unwrap(), *truth.winch.axis.unwrap());
        // the forward kinematics of the virtual machine stops at 1e-9 m, of which an axis feels a twentieth
        assert!((found - truth).norm() < 1e-6 && (found.norm() - 1.0).abs() < 1e-15, "{found} {truth}");
    }
    assert_eq!(Robot::from_toml(&calibrated.to_toml(), "calibrated.toml").unwrap(), calibrated);
}

/// A start angle shifts lengths as a start length and an offset do, by the radius: with a guide exactly, and over a pulley but for the
/// fleet angle, which hardly tells them apart.
#[test]
fn a_start_angle_beside_a_start_length_or_an_offset_is_told_as_undetermined() {
    for is_guided in [true, false] {
        let mut robot = with_drums(&simulator());
        robot.cables.iter_mut().for_each(|cable| cable.winch.guided = is_guided.then_some(true));
        let samples = recorded(&robot, DRUM, 60, &SensorSigmas { length: Some(1e-4), ..SensorSigmas::default() }, 3);
        for other in ["start-length", "length-offset"] {
            let found = identified(&robot, DRUM, &format!("start-angle,{other}"), &samples);
            let directions = found.analysis.weak_directions.join("; ");
            let status = if is_guided { Status::NotIdentifiable } else { Status::Converged };
            assert_eq!(found.status, status, "{}", found.reason);
            let names = |cable: usize| [format!("{other}[{cable}]"), format!("start-angle[{cable}]")];
            for cable in 1..=8 {
                assert!(names(cable).iter().all(|name| directions.contains(name.as_str())), "{directions}");
            }
            if is_guided {
                assert!(directions.contains("not determined at all"), "{directions}");
                assert!(found.parameters.iter().all(|estimate| estimate.sigma.is_none()));
            }
        }
    }
}

#[test]
fn what_no_data_can_tell_is_refused() {
    let robot = with_drums(&simulator());
    let model = Model::new(robot.clone(), DRUM).unwrap();
    let angles = recorded(&robot, DRUM, 20, &SensorSigmas::default(), 3);
    let refused =
        |free: &str, samples: &Samples| fit(&model, samples, &free.parse().unwrap(), &Settings::default()).unwrap_err();
    let twice = InputError::Parameters(ParameterError::StartLengthTwice { cable: 1 });
    assert_eq!(refused("start-length,length-offset", &angles), twice);
    let lengths = Samples { motor_angles: None, ..angles };
    use ParameterKind::{DrumAxis, DrumPitch, DrumRadius, StartAngle, SwivelAxis};
    for kind in [DrumRadius, DrumPitch, DrumAxis, StartAngle] {
        assert_eq!(refused(kind.name(), &lengths), InputError::NoMotorAngles { kind });
    }
    let no_pulley = refused("swivel-axis", &lengths);
    let effect = "pulley";
    let expected = ParameterError::NotInModel { kind: SwivelAxis, model: DRUM.to_string(), effect };
    assert_eq!(no_pulley, InputError::Parameters(expected));
    let mut guided = with_drums(&simulator());
    guided.cables[2].winch.guided = Some(true);
    let guided = Model::new(guided, DRUM).unwrap();
    let refused = fit(&guided, &lengths, &"drum-axis".parse().unwrap(), &Settings::default()).unwrap_err();
    assert_eq!(refused, InputError::Parameters(ParameterError::GuidedDrum { cable: 3 }));
}
