//! Frames of recordings that are made with known ones.

use nalgebra::{UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::directions::Directions;
use super::frames_that_fit;
use super::poses::Frames;
use crate::fit::{InputError, Settings, fit};
use cdpr_model::geometry::{Pose, Twist, inverse, product};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, FreeParameters, Model, RecordingParameter};
use cdpr_model::robot::Robot;

/// A tracker tilted by 40° and 2 m away, a marker turned by 15° and 0.1 m off; of planar robots within the plane, without the marker where it is
/// not asked for.
fn truth(robot: &Robot, with_marker: bool) -> Frames {
    let turns = robot.motion_pattern.has_rotation();
    let (tracker, marker) = match robot.motion_pattern.is_planar() {
        true => {
            let about = |angle: f64| UnitQuaternion::new(robot.plane.normal() * angle);
            let (first, second) = (robot.plane.first_axis(), robot.plane.second_axis());
            let tracker = Pose { position: 1.6 * first - 1.2 * second, rotation: about(0.7) };
            (tracker, Pose { position: 0.08 * first + 0.06 * second, rotation: about(-0.26) })
        }
        false => {
            let turned = |axis: [f64; 3], degrees: f64| {
                UnitQuaternion::new(Vector3::from(axis).normalize() * degrees.to_radians())
            };
            let tracker = Pose { position: Vector3::new(1.2, -1.4, 0.8), rotation: turned([0.5, 0.3, 0.8], 40.0) };
            let position = Vector3::new(0.06, 0.0, 0.08);
            (tracker, Pose { position, rotation: turned([1.0, -0.4, 0.2], 15.0) })
        }
    };
    Frames { tracker, marker: if with_marker { marker } else { Pose::identity() }, turns }
}

/// Recordings at random poses around the home pose (m, rad), by a tracker in these frames, with noise (m, rad).
fn recorded(model: &Model, frames: &Frames, spread: f64, turn: f64, noise: f64, seed: u64) -> Samples {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let home = model.robot().home_or_middle();
    let mut samples = Samples { cable_count: model.cable_count(), ..Samples::default() };
    for _ in 0..60 {
        let moved = |size: &dyn Fn(&Twist) -> f64, rng: &mut ChaCha8Rng, normal: bool| -> Twist {
            let mut draw = || if normal { StandardNormal.sample(rng) } else { rng.random_range(-1.0..1.0) };
            model.twist_basis().iter().map(|twist| twist * (size(twist) * draw())).sum()
        };
        let is_turn = |twist: &Twist| twist.fixed_rows::<3>(3).norm() > 0.0;
        let pose = home.displaced(&moved(&|twist| if is_turn(twist) { turn } else { spread }, &mut rng, false));
        samples.lengths.extend(model.cable_lengths(&pose).unwrap());
        let measured = match frames.turns {
            true => product(&inverse(&frames.tracker), &product(&pose, &frames.marker)),
            false => Pose { position: inverse(&frames.tracker).transform(&pose.position), rotation: pose.rotation },
        };
        samples.poses.push(measured.displaced(&moved(&|_| noise, &mut rng, true)));
    }
    if noise > 0.0 {
        (samples.sigmas.position, samples.sigmas.rotation) = (Some(noise), Some(noise));
    }
    samples
}

fn model(name: &str) -> Model {
    Model::new(Robot::builtin(name).unwrap(), Composition::STANDARD).unwrap()
}

fn free(text: &str) -> FreeParameters {
    text.parse().unwrap()
}

/// Exact recordings give exact frames, whichever pattern the robot has; anchors that are free too stay where the file has them.
#[test]
fn frames_of_exact_recordings_are_found() {
    for (name, anchors, with_marker) in [
        ("cogiro", "", true),
        ("cogiro", "frame-anchor,", true),
        ("ipanema-1", "frame-anchor,platform-anchor,", true),
        ("kntu-planar", "frame-anchor,", true),
        ("planar-example", "frame-anchor,", false),
    ] {
        let model = model(name);
        let truth = truth(model.robot(), with_marker);
        let samples = recorded(&model, &truth, 0.5, 0.3, 0.0, 3);
        let list = if with_marker { "tracker-frame,marker-frame" } else { "tracker-frame" };
        let found = fit(&model, &samples, &free(&format!("{anchors}{list}")), &Settings::default()).unwrap();
        let frames = found.frames.unwrap().frames;
        for (measured, pose) in samples.poses.iter().map(|pose| (frames.platform(pose), truth.platform(pose))) {
            // ends of the search and of the descents
            assert!(measured.displacement_to(&pose).norm() < 1e-7, "{name} {anchors}: {frames:?}");
        }
        assert!(found.parameters.iter().all(|estimate| estimate.change.abs() < 1e-7), "{name} {anchors}");
    }
}

/// The motion of the platform by each direction is that of the frames moved along it, to the square of the step.
#[test]
fn motions_are_those_of_moved_frames() {
    let model = model("cogiro");
    let frames = truth(model.robot(), true);
    let samples = recorded(&model, &frames, 0.5, 0.3, 0.0, 4);
    let poses: Vec<Pose> = samples.poses.iter().map(|pose| frames.platform(pose)).collect();
    let directions = Directions::of(&model, &RecordingParameter::FRAMES, &poses);
    let step = 1e-6;
    for k in 0..12 {
        let moved = |amount: f64| {
            let mut steps = vec![0.0; 12];
            steps[k] = amount;
            directions.moved(&frames, &steps)
        };
        for (measured, pose) in samples.poses.iter().zip(&poses).take(5) {
            let [ahead, behind] = [step, -step].map(|amount| moved(amount).platform(measured));
            let difference = behind.displacement_to(&ahead) / (2.0 * step);
            let motion = directions.motions(pose).nth(k).unwrap();
            // rounding over the step
            assert!((difference - motion).norm() < 1e-8, "{k}: {difference} {motion}");
        }
    }
}

/// Pooled over the numbers of both frames and 60 recordings, errors are as large as their deviations: in a fit of the frames alone, and with frame
/// anchors in the gauge of least change, where the frames are compared after the anchors are laid on the file's.
#[test]
fn deviations_of_frames_are_those_of_their_errors() {
    let model = model("cogiro");
    let truth = truth(model.robot(), true);
    for list in ["tracker-frame,marker-frame", "frame-anchor,tracker-frame,marker-frame"] {
        let (mut squares, mut count) = (0.0, 0.0);
        let (mut of_anchors, mut anchors) = (0.0, 0.0);
        for seed in 0..60 {
            let samples = recorded(&model, &truth, 0.5, 0.3, 1e-3, seed);
            let found = fit(&model, &samples, &free(list), &Settings::default()).unwrap();
            let frames = found.frames.as_ref().unwrap();
            for (estimate, pose) in [(&frames.tracker, &truth.tracker), (&frames.marker, &truth.marker)] {
                let estimate = estimate.as_ref().unwrap();
                let at = Pose::from_xyz_angles(estimate.position_m.into(), estimate.rotation_rad);
                let error = pose.displacement_to(&at);
                for k in 0..3 {
                    squares += (error[k] / estimate.sigma_position_m[k]).powi(2);
                    squares += (error[3 + k] / estimate.sigma_rotation_rad[k]).powi(2);
                    count += 2.0;
                }
            }
            let of_parameters = found.parameters.iter().map(|e| (e.change / e.sigma.unwrap()).powi(2));
            of_anchors += of_parameters.sum::<f64>();
            anchors += found.parameters.len() as f64;
            let free: &[&str] = if list.contains("anchor") { &["translation", "rotation"] } else { &[] };
            assert_eq!(frames.gauge.free, free);
        }
        let ratio = (squares / count).sqrt();
        // 720 numbers that hang together six by six
        assert!((0.85..1.15).contains(&ratio), "{list}: {ratio}");
        assert!(anchors == 0.0 || (0.85..1.15).contains(&(of_anchors / anchors).sqrt()));
    }
}

/// Frames are asked for where poses fit no other way, and only those; not where offsets of winches or wrong anchors explain the misfit.
#[test]
fn frames_are_needed_where_poses_fit_no_other_way() {
    let model = model("cogiro");
    let both = truth(model.robot(), true);
    let none = FreeParameters::default();
    let asked = |samples: &Samples| frames_that_fit(model.robot(), samples, &none).map(|(frames, _)| frames);
    let tracker = Frames { marker: Pose::identity(), ..both };
    let marker = Frames { tracker: Pose::identity(), ..both };
    let identity = Frames::identity(&model);
    let noisy = |frames: &Frames| recorded(&model, frames, 0.5, 0.3, 1e-3, 5);
    assert_eq!(asked(&noisy(&both)), Some(RecordingParameter::FRAMES.to_vec()));
    assert_eq!(asked(&noisy(&tracker)), Some(vec![RecordingParameter::TrackerFrame]));
    assert_eq!(asked(&noisy(&marker)), Some(vec![RecordingParameter::MarkerFrame]));
    assert_eq!(asked(&noisy(&identity)), None);
    let mut shifted = noisy(&identity);
    shifted.lengths.iter_mut().enumerate().for_each(|(k, length)| *length += 0.2 + 0.1 * (k % 8) as f64);
    assert_eq!(asked(&shifted), None);
    let mut mirrored = noisy(&identity);
    mirrored.poses.iter_mut().for_each(|pose| pose.position.x = -pose.position.x);
    assert_eq!(asked(&mirrored), None);
    let mut robot = model.robot().clone();
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    for cable in &mut robot.cables {
        (0..3).for_each(|k| cable.frame_anchor[k] += rng.random_range(-0.2..0.2));
    }
    assert_eq!(frames_that_fit(&robot, &noisy(&identity), &none), None);
    let held = free("tracker-frame,marker-frame");
    assert_eq!(frames_that_fit(model.robot(), &noisy(&both), &held), None);
}

/// A point platform has no marker apart from the tracker, and gross rows do not turn the frames.
#[test]
fn a_marker_of_a_point_is_refused_and_gross_rows_count_less() {
    let planar = model("planar-example");
    let samples = recorded(&planar, &truth(planar.robot(), false), 0.5, 0.0, 1e-3, 6);
    let refused = fit(&planar, &samples, &free("marker-frame"), &Settings::default());
    assert_eq!(refused.unwrap_err(), InputError::MarkerOfPoint);

    let model = model("cogiro");
    let truth = truth(model.robot(), true);
    let mut samples = recorded(&model, &truth, 0.5, 0.3, 1e-3, 7);
    (0..60).step_by(20).for_each(|row| samples.poses[row].position += Vector3::new(0.2, -0.1, 0.1));
    let list = free("frame-anchor,tracker-frame,marker-frame");
    let found = fit(&model, &samples, &list, &Settings::default()).unwrap();
    assert_eq!(found.outliers.iter().map(|outlier| outlier.sample).collect::<Vec<_>>(), [1, 21, 41]);
    let marker = found.frames.unwrap().marker.unwrap();
    for k in 0..3 {
        let error = marker.position_m[k] - truth.marker.position[k];
        assert!(error.abs() < 4.0 * marker.sigma_position_m[k], "{error} {marker:?}");
    }
    let few = samples.subset(&[0, 1, 2]);
    assert!(matches!(
        fit(&model, &few, &free("tracker-frame"), &Settings::default()),
        Err(InputError::NoFrames { poses: 3, needed: 6 })
    ));
}
