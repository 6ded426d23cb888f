//! Calibration by partly measured poses in the frame of the tracker: positions of one reflector, or orientations of an inclinometer.

use super::support::{builtin, random_pose};
use cdpr_calibration::fit::{InputError, Settings, Status};
use cdpr_calibration::{SelfCalibration, self_calibrate, unobserved};
use cdpr_model::geometry::{Pose, inverse, product};
use cdpr_model::measurement::{InternalSamples, Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{Component, ParameterKind};
use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const SIGMA: f64 = 0.001;
const POSES: usize = 30;

/// The tracker's world in the robot's frame, and the marker on the platform.
fn frames() -> (Pose, Pose) {
    (
        Pose::from_xyz_angles(Vector3::new(6.0, -4.0, 1.5), [0.1, -0.2, 2.0]),
        Pose::from_xyz_angles(Vector3::new(0.3, -0.2, 0.4), [0.3, 0.1, -0.4]),
    )
}

/// The machine, whose winches are off by up to 30 mm.
fn machine() -> Model {
    let mut robot = builtin("cogiro");
    for (cable, own) in robot.cables.iter_mut().enumerate() {
        own.length_offset = Some(0.03 * (1.7 * cable as f64).sin());
    }
    Model::new(robot, Composition::STANDARD).unwrap()
}

/// Record with measured positions, orientations, both or neither.
fn recorded(known: [bool; 2], seed: u64) -> InternalSamples {
    let (machine, (tracker, marker)) = (machine(), frames());
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut samples = Samples {
        cable_count: 8,
        sigmas: SensorSigmas {
            length: Some(SIGMA),
            position: known[0].then_some(SIGMA),
            rotation: known[1].then_some(SIGMA),
            ..SensorSigmas::default()
        },
        ..Samples::default()
    };
    for _ in 0..POSES {
        let pose = random_pose(machine.robot(), 0.25, &mut rng);
        let mut noise = || {
            let unit: f64 = StandardNormal.sample(&mut rng);
            SIGMA * unit
        };
        let lengths = machine.cable_lengths(&pose).unwrap();
        let recorded = lengths.iter().enumerate().map(|(cable, q)| machine.recorded_length(cable, *q));
        samples.lengths.extend(recorded.map(|length| length + noise()));
        let seen = product(&inverse(&tracker), &product(&pose, &marker));
        let noise = nalgebra::Vector6::from_fn(|_, _| noise());
        let seen = seen.displaced(&noise);
        samples.poses.push(match known {
            [true, false] => Pose { rotation: Pose::identity().rotation, ..seen },
            [false, true] => Pose { position: Vector3::zeros(), ..seen },
            _ => seen,
        });
    }
    let known = [known[0], known[0], known[0], known[1], known[1], known[1]].to_vec();
    InternalSamples { known: vec![known; POSES], ..InternalSamples::without_poses(samples, 6, false) }
}

fn calibrated(internal: &InternalSamples, free: &str) -> Result<SelfCalibration, InputError> {
    let file = Model::new(builtin("cogiro"), Composition::STANDARD).unwrap();
    self_calibrate(&file, internal, &free.parse().unwrap(), &Settings::default(), &unobserved)
}

/// Winches of eight cables by one reflector, of which neither the place on the platform nor the tracker's world is known: offsets within their 95 % intervals in 93 to 97 %
/// of the records, frames found.
#[test]
fn one_reflector_tells_winches_in_an_unknown_frame() {
    let (machine, (tracker, marker)) = (machine(), frames());
    let (mut held, mut all) = (0, 0);
    for seed in 0..40 {
        let found = calibrated(&recorded([true, false], seed), "length-offset,tracker-frame,marker-frame").unwrap();
        assert_eq!((found.fit.status, found.fit.parameters.len()), (Status::Converged, 8 + 6 + 3));
        let told = found.fit.model.robot().tracked.unwrap();
        for estimate in &found.fit.parameters {
            let truth = match (estimate.parameter.kind, machine.robot().frame_component(estimate.parameter.axis)) {
                (ParameterKind::TrackerFrame, Some(Component::Shift(axis))) => axis.dot(&tracker.position),
                (ParameterKind::TrackerFrame, Some(Component::Turn(axis))) => axis.dot(&tracker.rotation.scaled_axis()),
                (ParameterKind::MarkerFrame, Some(Component::Shift(axis))) => axis.dot(&marker.position),
                _ => estimate.parameter.value(machine.robot()),
            };
            held +=
                u32::from((estimate.value - truth).abs() <= found.fit.analysis.quantile_95 * estimate.sigma.unwrap());
            all += 1;
        }
        assert!((told.marker.position - marker.position).norm() < 0.2, "{told:?}");
        let sensors: Vec<(&str, &str)> = found.sensors.iter().map(|sensor| (sensor.sensor, sensor.unit)).collect();
        assert_eq!(sensors, [("length", "m"), ("position", "m")]);
    }
    let share = f64::from(held) / f64::from(all);
    println!("{all} intervals, {:.2} % hold the truth", 100.0 * share);
    // 17 intervals of a record hang together: 40 records have a standard deviation of 1 % or so
    assert!((0.92..=0.98).contains(&share), "{share}");
}

/// An orientation in the axes of its own sensor: only turns of the frames show.
#[test]
fn an_inclinometer_tells_turns_alone() {
    let found = calibrated(&recorded([false, true], 1), "length-offset,tracker-frame,marker-frame").unwrap();
    let names: Vec<&str> = found.fit.parameters.iter().skip(8).map(|own| own.name.as_str()).collect();
    assert_eq!(found.fit.status, Status::Converged, "{}", found.fit.reason);
    assert_eq!(names[..3], ["tracker-frame.turn_x", "tracker-frame.turn_y", "tracker-frame.turn_z"]);
    assert_eq!(names.len(), 6);
    assert_eq!(found.sensors[1].sensor, "rotation");
    let nothing = calibrated(&recorded([false, false], 1), "length-offset,tracker-frame").unwrap_err();
    assert!(matches!(nothing, InputError::FramesOfNothing { .. }), "{nothing}");
}
