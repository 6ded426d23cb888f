//! Drums between motors and cables: control models that know them and those that do not, and data of motor angles.

use super::support::{operate, random_poses, simulator};
use cdpr_calibration::evaluate;
use cdpr_model::control::simulate::simulate;
use cdpr_model::control::{InputError, Status, with_motor_angles};
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use cdpr_study::accuracy::assess;

const DRUM: Composition = Composition { drum: true, ..Composition::STANDARD };

fn with_drums() -> Robot {
    super::support::with_drums(&simulator())
}

fn model(robot: &Robot, composition: Composition) -> Model {
    Model::new(robot.clone(), composition).unwrap()
}

#[test]
fn motor_angle_and_controlled_length_are_inverse_to_each_other() {
    let mut robot = with_drums();
    (robot.cables[0].length_scale, robot.cables[0].length_offset) = (Some(1.01), Some(-0.3));
    for composition in [Composition::STANDARD, DRUM] {
        let model = model(&robot, composition);
        for length in [1.0, 4.0, 9.0] {
            let angle = model.motor_angle(0, length).unwrap();
            // rounding of motor angles of 500 rad over a drum of 0.1 m geared 10 : 1
            assert!((model.controlled_length_of_motor_angle(0, angle).unwrap() - length).abs() < 1e-12);
        }
    }
}

/// A control model with the machine's drums makes no error; one that takes them for ideal winches some millimetres.
#[test]
fn a_control_model_without_the_machines_drums_misses_by_millimetres() {
    let robot = with_drums();
    let machine = model(&robot, DRUM);
    let poses = random_poses(&robot, 30, 0.05, 3);
    let error = |control: Composition| {
        let control = model(&robot, control);
        assess(&control, &machine, &[0.0; 8], &poses).unwrap().accuracy.position_error_m
    };
    // the tolerance of the forward kinematics
    assert!(error(DRUM).max < 1e-8);
    let missed = error(Composition::STANDARD);
    assert!(missed.mean > 2e-4 && missed.max < 0.05, "{missed:?}");
}

/// A drum that cannot hold the cable does not move the platform; it says what it holds.
#[test]
fn a_groove_that_is_too_short_commands_nothing() {
    let mut robot = with_drums();
    robot.cables[2].winch.set_groove_length(0.008);
    let (control, machine) = (model(&robot, Composition::STANDARD), model(&robot, DRUM));
    let outcomes = operate(&control, &machine, &[0.0; 8], &random_poses(&robot, 5, 0.0, 3)).unwrap();
    for outcome in outcomes {
        assert_eq!(outcome.status, Status::NotCommanded);
        let reason = outcome.reason.unwrap();
        assert!(reason.contains("cable 3") && reason.contains("drum_groove_length_m"), "{reason}");
    }
}

/// Noise-free motor angles of a machine with drums.
fn recorded_angles(robot: &Robot, count: usize) -> Samples {
    let machine = model(robot, DRUM);
    let poses = random_poses(robot, count, 0.05, 7);
    let simulation = simulate(&machine, &machine, &[0.0; 8], &poses, &SensorSigmas::default(), 1).unwrap();
    with_motor_angles(&machine, &machine, &simulation.samples).unwrap()
}

#[test]
fn recorded_motor_angles_are_read_back_and_explained_by_the_drums() {
    let robot = with_drums();
    let samples = recorded_angles(&robot, 20);
    let text = samples.to_csv(&robot);
    assert!(text.lines().next().unwrap().contains("motor_angle_rad_8"), "{text}");
    let read = Samples::from_csv(text.as_bytes(), "angles.csv", &robot).unwrap().samples;
    assert_eq!(read.motor_angles, samples.motor_angles);
    let misfit = |composition| evaluate(&model(&robot, composition), &read).unwrap().blocks().length_error_m.rms;
    // the tolerance of the forward kinematics
    assert!(misfit(DRUM) < 1e-8, "{}", misfit(DRUM));
    assert!(misfit(Composition::STANDARD) > 2e-4);
}

#[test]
fn degrees_are_converted_and_lengths_go_before_angles() {
    let robot = with_drums();
    let samples = recorded_angles(&robot, 3);
    let in_degrees: Vec<String> = (1..=8).map(|cable| format!("motor_angle_deg_{cable}")).collect();
    let mut text = samples.to_csv(&robot);
    for cable in 1..=8 {
        text = text.replacen(&format!("motor_angle_rad_{cable}"), &in_degrees[cable - 1], 1);
    }
    let read = Samples::from_csv(text.as_bytes(), "angles.csv", &robot).unwrap().samples;
    let (found, expected) = (read.motor_angles.unwrap()[0], samples.motor_angles.as_ref().unwrap()[0].to_radians());
    assert!((found - expected).abs() < 1e-12 * expected.abs());
    let lacking = text.replacen("motor_angle_deg_3", "motor_angel_3", 1);
    let error = Samples::from_csv(lacking.as_bytes(), "angles.csv", &robot).unwrap_err();
    assert!(error.to_string().contains("`motor_angle_rad_3` is missing"), "{error}");
}

#[test]
fn without_drums_there_are_no_motor_angles() {
    let plain = model(&with_drums(), Composition::STANDARD);
    let samples = Samples { cable_count: 8, ..Samples::default() };
    assert_eq!(with_motor_angles(&plain, &plain, &samples), Err(InputError::NoDrum));
    let unknown = model(&simulator(), Composition::STANDARD);
    assert!(unknown.motor_angle(0, 5.0).unwrap_err().to_string().contains("drum_radius_m"));
}
