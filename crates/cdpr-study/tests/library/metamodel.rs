//! Control models on machines: identity, winch offsets, initial tensions, what is recorded.

use super::support::{builtin, operate, random_poses, simulator, with_pulleys};
use cdpr_model::control::simulate::simulate;
use cdpr_model::control::{CommandedPose, Initial, Shortening};
use cdpr_model::control::{InputError, Operation, Status, initial_tensions, winch_offsets};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use cdpr_model::statics::controlled_lengths;
use cdpr_model::tension::{Limits, Method, quadratic};
use cdpr_study::accuracy::assess;
use nalgebra::{DVector, Vector3};

const CALIBRATED: &str = "cablerobot-simulator-helicopter-kinematic-calibrated";

const MEASURED: [f64; 8] = [3678.0, 2169.0, 4250.0, 1708.0, 3985.0, 2394.0, 4715.0, 1684.0];

fn model(robot: &Robot, composition: Composition) -> Model {
    Model::new(robot.clone(), composition).unwrap()
}

fn initial() -> Initial {
    Initial::default()
}

fn with_tensions(tensions: &[f64]) -> Initial {
    Initial { tensions_N: Some(tensions.to_vec()), ..initial() }
}

fn with_method(method: Method) -> Initial {
    Initial { tension_method: Some(method), ..initial() }
}

/// The calibrated robot with pulleys, hidden cable and encoders that scale and shift.
fn complete() -> Robot {
    let mut robot = with_pulleys(&builtin(CALIBRATED), 0.161);
    for (index, cable) in robot.cables.iter_mut().enumerate() {
        let k = index as f64;
        cable.hidden_length = Some(8.0);
        (cable.length_scale, cable.length_offset) = (Some(1.0 + 1e-3 * k), Some(0.01 * k - 0.03));
        (cable.tension_scale, cable.tension_offset) = (Some(1.0 - 1e-2 * k), Some(20.0 - 5.0 * k));
    }
    robot
}

/// Random poses at which a distribution within the limits exists.
fn feasible_poses(robot: &Robot, count: usize) -> Vec<CommandedPose> {
    let (model, limits) = (model(robot, Composition::ELASTIC), Limits::of(robot, None, None).unwrap());
    let load = cdpr_model::statics::Load::of(robot).unwrap();
    let mut poses = random_poses(robot, 4 * count, 0.1, 5);
    poses.retain(|command| {
        let structure_matrix = model.structure_matrix(&command.pose).unwrap();
        let wrench = load.in_pattern(&model, &command.pose);
        let found = quadratic::solve(&structure_matrix, wrench.as_slice(), &limits, None).unwrap();
        found.status == quadratic::Status::Feasible
    });
    poses.truncate(count);
    assert_eq!(poses.len(), count);
    poses
}

#[test]
fn a_machine_that_is_like_its_control_model_makes_no_error() {
    let robot = complete();
    let (home, poses) = (robot.home.unwrap(), feasible_poses(&robot, 50));
    for composition in [Composition::STANDARD, Composition::PULLEY, Composition::ELASTIC, Composition::PULLEY_ELASTIC] {
        let model = model(&robot, composition);
        let offsets = winch_offsets(&with_tensions(&MEASURED), &model, &model, &home).unwrap();
        let accuracy = assess(&model, &model, &offsets, &poses).unwrap().accuracy;
        assert_eq!(accuracy.statuses.get("converged"), Some(&50), "{composition}");
        let errors = [accuracy.position_error_m.max, accuracy.rotation_error_rad.max, accuracy.length_error_m.max];
        assert!(errors.iter().all(|error| *error < 1e-9), "{composition}: {errors:?}");
    }
}

/// Whatever the control model is, the winches are set so that the machine starts where it should, with the tensions it should.
#[test]
fn at_the_initial_pose_machine_and_tensions_are_as_asked_for() {
    let machine = model(&complete(), Composition::PULLEY_ELASTIC);
    let home = machine.robot().home.unwrap();
    let control = model(&simulator(), Composition::STANDARD);
    let initial = with_tensions(&MEASURED);
    let offsets = winch_offsets(&initial, &control, &machine, &home).unwrap();
    let outcome = operate(&control, &machine, &offsets, &[CommandedPose::at(home)]).unwrap().remove(0);
    assert_eq!(outcome.status, Status::Converged);
    assert!((outcome.pose.position - home.position).norm() < 1e-9 && outcome.pose.angle_to(&home) < 1e-9);
    let wanted = initial_tensions(&initial, &machine, &home).unwrap();
    for (found, wanted) in outcome.tensions.unwrap().iter().zip(wanted) {
        // 1e-9 m over a stretch compliance of 1e-5 m/N
        assert!((found - wanted).abs() < 1e-4, "{found} {wanted}");
    }
}

#[test]
fn winch_offsets_are_those_that_the_dissertation_prints() {
    let robot = builtin(CALIBRATED);
    let (control, machine) = (model(&robot, Composition::STANDARD), model(&robot, Composition::ELASTIC));
    let offsets = winch_offsets(&with_tensions(&MEASURED), &control, &machine, &robot.home.unwrap()).unwrap();
    let printed = [-0.019, -0.011, -0.022, -0.008, -0.019, -0.01, -0.023, -0.008];
    for (offset, printed) in offsets.iter().zip(printed) {
        assert!((offset - printed).abs() < 0.0008, "{offsets:?}"); // printed to 1 mm
    }
}

/// f = f_ini q_ini/q: offsets set once make the tension at the commanded pose fall with the cable's length.
#[test]
fn the_tension_at_the_commanded_pose_falls_with_the_length() {
    let robot = builtin("planar-example");
    let (control, machine) = (model(&robot, Composition::STANDARD), model(&robot, Composition::ELASTIC));
    let start = robot.home.unwrap();
    let initial = with_method(Method::ClosedForm);
    let tensions = initial_tensions(&initial, &machine, &start).unwrap();
    for (found, expected) in tensions.iter().zip([5807.9, 5908.7, 2390.0, 2421.2]) {
        assert!((found - expected).abs() < 0.05, "{tensions:?}"); // printed to 0.1 N
    }
    let offsets = winch_offsets(&initial, &control, &machine, &start).unwrap();
    let commanded = Pose { position: Vector3::new(-2.0, 3.0, 0.0), ..Pose::identity() };
    let (first, lengths) = (control.cable_lengths(&start).unwrap(), control.cable_lengths(&commanded).unwrap());
    for cable in 0..4 {
        let tension = machine.elasticity(cable).tension(lengths[cable], lengths[cable] + offsets[cable]).value;
        assert!((tension - tensions[cable] * first[cable] / lengths[cable]).abs() < 1e-8, "cable {cable}");
    }
}

/// Offsets belong to the winches: a calibrated controller works with those of the nominal one (eq. 4.30 with the true
/// optimum; recomputed from the calibrated model they would give 43.1 mm).
#[test]
fn the_winches_stay_as_they_were_when_the_controller_is_calibrated() {
    let robot = builtin("planar-example");
    let mut calibrated = robot.clone();
    let change = [14.8, 69.088, -40.866, 74.297, 10.844, -0.003, -13.352, 13.921];
    for (cable, change) in calibrated.cables.iter_mut().zip(change.chunks(2)) {
        cable.frame_anchor += Vector3::new(1e-3 * change[0], 1e-3 * change[1], 0.0);
    }
    let (nominal, machine) = (model(&robot, Composition::STANDARD), model(&robot, Composition::ELASTIC));
    let calibrated = model(&calibrated, Composition::STANDARD);
    let start = robot.home.unwrap();
    let steps = |low: f64, high: f64| (0..5).map(move |k| low + (high - low) * f64::from(k) / 4.0);
    let poses: Vec<CommandedPose> = steps(-4.0, 4.0)
        .flat_map(|x| steps(0.5, 6.0).map(move |y| Vector3::new(x, y, 0.0)))
        .map(|position| CommandedPose::at(Pose { position, ..Pose::identity() }))
        .collect();
    for (set_with, mean) in [(&nominal, 40.49), (&calibrated, 43.1)] {
        let offsets = winch_offsets(&with_method(Method::ClosedForm), set_with, &machine, &start).unwrap();
        let accuracy = assess(&calibrated, &machine, &offsets, &poses).unwrap().accuracy;
        assert!((1e3 * accuracy.position_error_m.mean - mean).abs() < 0.05, "{}", accuracy.position_error_m.mean);
    }
}

/// The change of given tensions has no internal part: it is the smallest that balances the load.
#[test]
fn given_tensions_are_projected_onto_balance() {
    let machine = model(&builtin(CALIBRATED), Composition::ELASTIC);
    let home = machine.robot().home.unwrap();
    let tensions = initial_tensions(&with_tensions(&MEASURED), &machine, &home).unwrap();
    let load = cdpr_model::statics::Load::of(machine.robot()).unwrap();
    let structure_matrix = machine.structure_matrix(&home).unwrap();
    let change = DVector::from_iterator(8, tensions.iter().zip(MEASURED).map(|(found, given)| found - given));
    let residual = &structure_matrix * DVector::from_vec(tensions.clone()) + load.in_pattern(&machine, &home);
    assert!(residual.amax() < 1e-8, "{residual}"); // rounding of 6 kN
    let external = structure_matrix.transpose()
        * (&structure_matrix * structure_matrix.transpose()).try_inverse().unwrap()
        * (&structure_matrix * &change);
    assert!((external - &change).amax() < 1e-8);
    // what is balanced stays
    let again = initial_tensions(&with_tensions(&tensions), &machine, &home).unwrap();
    assert!(tensions.iter().zip(&again).all(|(a, b)| (a - b).abs() < 1e-8));
}

#[test]
fn initial_tensions_that_cannot_be_are_refused_with_the_reason() {
    let (rigid, machine) =
        (model(&builtin(CALIBRATED), Composition::STANDARD), model(&builtin(CALIBRATED), Composition::ELASTIC));
    let home = machine.robot().home.unwrap();
    let refused = |initial: &Initial| winch_offsets(initial, &rigid, &machine, &home).unwrap_err();
    assert_eq!(refused(&initial()), InputError::NoTensions);
    assert_eq!(refused(&with_tensions(&[1.0])), InputError::Count { key: "tensions_N", expected: 8, found: 1 });
    // the shortest tensions that carry the load let the lower cables push
    let pushing = refused(&with_tensions(&[0.0; 8]));
    assert!(pushing.to_string().contains("would have to push"), "{pushing}");
    let mut weak = builtin(CALIBRATED);
    weak.cables.iter_mut().for_each(|cable| cable.tension_max = Some(1500.0));
    let weak = winch_offsets(&with_method(Method::Qp), &rigid, &model(&weak, Composition::ELASTIC), &home);
    assert!(weak.unwrap_err().to_string().contains("cable"), "the reason names cables");
    let mut unlimited = builtin(CALIBRATED);
    unlimited.cables[2].tension_max = None;
    let unlimited = winch_offsets(&with_method(Method::Qp), &rigid, &model(&unlimited, Composition::ELASTIC), &home);
    assert!(unlimited.unwrap_err().to_string().contains("tension_max_N"));
    let mut unloaded = builtin(CALIBRATED);
    unloaded.external_wrench = None;
    let unloaded = model(&unloaded, Composition::ELASTIC);
    let error = operate(&rigid, &unloaded, &[0.0; 8], &[CommandedPose::at(home)]).unwrap_err();
    assert!(error.to_string().contains("mass_kg"), "{error}");
}

/// What the machine's encoders and load cells say is consistent with the machine's own model; winch offsets are the zero of
/// the encoders.
#[test]
fn recorded_lengths_and_tensions_are_those_of_the_machine() {
    let (control, machine) =
        (model(&simulator(), Composition::STANDARD), model(&complete(), Composition::PULLEY_ELASTIC));
    let home = machine.robot().home.unwrap();
    let offsets = winch_offsets(&with_tensions(&MEASURED), &control, &machine, &home).unwrap();
    let poses = random_poses(machine.robot(), 40, 0.05, 3);
    let exact = simulate(&control, &machine, &offsets, &poses, &SensorSigmas::default(), 1).unwrap();
    let tensions = exact.samples.tensions.as_ref().unwrap();
    for (sample, outcome) in exact.outcomes.iter().enumerate() {
        let real = outcome.tensions.as_ref().unwrap();
        let explained = controlled_lengths(&machine, &outcome.pose, real).unwrap();
        for cable in 0..8 {
            assert_eq!(tensions[8 * sample + cable], machine.recorded_tension(cable, real[cable]));
            let recorded = machine.controlled_length(cable, exact.samples.lengths_of(sample)[cable] + offsets[cable]);
            // a slack cable is longer than its path
            let difference = recorded - explained[cable];
            assert!(difference.abs() < 1e-9 || (real[cable] == 0.0 && difference > 0.0), "{difference}");
        }
    }
    let noise = SensorSigmas { tension: Some(50.0), ..SensorSigmas::default() };
    let noisy = simulate(&control, &machine, &offsets, &poses, &noise, 1).unwrap().samples;
    let square: f64 = noisy.tensions.unwrap().iter().zip(tensions).map(|(a, b)| (a - b).powi(2)).sum();
    // standard error of a standard deviation from 320 numbers: 4 %
    assert!(((square / 320.0).sqrt() / 50.0 - 1.0).abs() < 0.12);
}

#[test]
fn a_shortened_cable_pulls_harder() {
    let robot = builtin(CALIBRATED);
    let machine = model(&robot, Composition::ELASTIC);
    let home = robot.home.unwrap();
    let mut operation = Operation::new(&machine, &machine, &[0.0; 8]).unwrap();
    let plain = operation.answer(&CommandedPose::at(home)).tensions.unwrap();
    for cable in 0..8 {
        let shortened = Some(Shortening { cable, by: 0.005 });
        let outcome = operation.answer(&CommandedPose { shortened, ..CommandedPose::at(home) });
        assert_eq!(outcome.status, Status::Converged);
        assert!(outcome.tensions.unwrap()[cable] > plain[cable] + 50.0, "cable {cable}");
    }
}

/// Where the load is too heavy for the limits of an elastic control model, it has nothing to send.
#[test]
fn a_control_model_without_tensions_commands_nothing() {
    let mut robot = builtin(CALIBRATED);
    let machine = model(&robot, Composition::ELASTIC);
    robot.cables.iter_mut().for_each(|cable| cable.tension_max = Some(1200.0));
    let control = model(&robot, Composition::ELASTIC);
    let outcome = operate(&control, &machine, &[0.0; 8], &[CommandedPose::at(robot.home.unwrap())]).unwrap().remove(0);
    assert_eq!(outcome.status, Status::NotCommanded);
    assert!(outcome.reason.unwrap().contains("no tensions"));
}
