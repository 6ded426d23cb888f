//! Machines whose cables remember: exact along their path, and differences where no derivative leads along it.

use super::*;
use cdpr_model::robot::HysteresisTable;
use cdpr_study::sensitivity::{Kink, PoseSensitivity};

/// Cables whose unloading branch lies a share below, with turns of 4e-4 and 9e-4 of strain between.
fn remembering(mut robot: Robot, fraction: f64) -> Robot {
    for cable in &mut robot.cables {
        cable.hysteresis = Some(HysteresisTable {
            strain: vec![0.0, 0.005, 0.1],
            loading_N: vec![0.0, 1.2e4, 3e5],
            unloading_N: vec![0.0, 1.2e4 * (1.0 - fraction), 3e5],
            loading_slope_N: None,
            unloading_slope_N: None,
            transition_strain: vec![4e-4, 9e-4],
            transition_share: Some(vec![0.6, 0.4]),
        });
    }
    robot
}

/// The planar example with hysteresis, under a control model of these effects.
fn planar_machine(control: &str) -> Case {
    let mut case = planar("standard", "elastic", Method::ClosedForm);
    let robot = case.machine.robot().clone();
    case.machine = model(&remembering(robot.clone(), 0.15), "hysteresis");
    case.control = model(&remembering(robot, 0.1), control);
    case.history = Some(History { reach: Reach::InOrder, sub_steps: 3 });
    case
}

fn along(case: &Case) -> Vec<PoseSensitivity> {
    let offsets = case.offsets(&case.control, &case.machine, None);
    let setting = Setting { initial: &case.initial, pose: case.home, former: None, offsets: Offsets::Kept };
    let sensitivity = Sensitivity::new(&case.control, &case.machine, &offsets, &setting).unwrap();
    sensitivity.with_history(case.history.as_ref(), &case.home).along(&case.poses).unwrap()
}

#[test]
fn machines_that_remember_follow_deviations_along_their_path() {
    for reach in [Reach::FromInitial, Reach::InOrder] {
        let mut case = planar_machine("standard");
        case.history = Some(History { reach, sub_steps: 3 });
        case.check(Offsets::Kept);
        case.check(Offsets::SetAnew);
    }
    let mut case = spatial(model(&controller(), "elastic"), model(&remembering(twin(), 0.15), "pulley+hysteresis"));
    case.history = Some(History { reach: Reach::FromInitial, sub_steps: 2 });
    case.poses.truncate(1);
    case.check(Offsets::Kept);
}

#[test]
fn drums_wind_the_cables_of_a_machine_that_remembers() {
    let machine = model(&remembering(with_drums(&twin()), 0.15), "pulley+drum+hysteresis");
    let mut case = spatial(model(&controller(), "standard"), machine);
    case.history = Some(History { reach: Reach::FromInitial, sub_steps: 2 });
    case.poses.truncate(1);
    case.check(Offsets::Kept);
}

/// Forth, some of the way back, forth again and home, so that small loops close; the control model chooses tensions on the way.
#[test]
fn paths_with_turns_are_followed() {
    for control in ["standard", "elastic", "hysteresis"] {
        let mut case = planar_machine(control);
        let at = |x: f64, z: f64| {
            let robot = case.machine.robot();
            CommandedPose::at(robot.motion_pattern.pose(robot.plane, &[x, z]).unwrap())
        };
        case.poses = vec![at(-1.0, 3.5), at(-0.7, 3.8), at(-0.9, 3.6), at(0.1, 5.1)];
        case.check(Offsets::Kept);
    }
}

/// A control model that is the machine makes no error on any path, whatever deviates in both alike: the two derivatives cancel.
#[test]
fn what_deviates_alike_in_control_model_and_machine_moves_nothing() {
    let mut case = planar_machine("hysteresis");
    case.control = case.machine.clone();
    case.initial = Initial { offset_m: Some(vec![0.0; 4]), ..Initial::default() };
    let setting = Setting { initial: &case.initial, pose: case.home, former: None, offsets: Offsets::Kept };
    let sensitivity = Sensitivity::new(&case.control, &case.machine, &[0.0; 4], &setting).unwrap();
    let mut sensitivity = sensitivity.with_history(case.history.as_ref(), &case.home);
    let causes = sensitivity.causes().to_vec();
    for at in sensitivity.along(&case.poses).unwrap() {
        let derivatives = at.derivatives.unwrap();
        let mut pairs = 0;
        for (own, cause) in causes.iter().enumerate().filter(|(_, cause)| cause.side == Side::Control) {
            let same = ParameterDeviation { side: Side::Machine, ..*cause };
            let Some(other) = causes.iter().position(|cause| *cause == same) else { continue };
            let [own, other] = [own, other].map(|column| derivatives.pose.column(column));
            // what solves and slopes of chosen tensions leave, of derivatives up to 1
            assert!((own + other).amax() < 1e-7 * own.amax().max(1e-3), "{}: {own} {other}", cause.name(&case.machine));
            pairs += 1;
        }
        assert!(pairs > 20);
    }
}

#[test]
fn the_way_decides_on_the_derivatives() {
    let mut case = planar_machine("standard");
    let on_its_way = along(&case).remove(1).derivatives.unwrap();
    case.history = None;
    let at_once = along(&case).remove(1).derivatives.unwrap();
    assert_eq!(at_once.differentiation, Differentiation::Exact);
    assert!((&at_once.pose - &on_its_way.pose).amax() > 1e-3, "another branch of the cables");
}

/// The first cable is loaded to where its first stop would begin to slide, to the bit: no derivative leads away.
#[test]
fn poses_behind_the_end_of_a_branch_have_differences() {
    let mut case = planar_machine("standard");
    case.poses = vec![CommandedPose::at(case.home)];
    case.history = None;
    let tensions = along(&case).remove(0).outcome.tensions.unwrap();
    let strain = case.machine.law(0).stretch.strain(tensions[0]).0;
    let mut robot = case.machine.robot().clone();
    // the virgin cable comes to the end of this transition there, and the law is the one of the loading branch as before
    robot.cables[0].hysteresis.as_mut().unwrap().transition_strain[0] = 2.0 * strain;
    case.machine = model(&robot, "hysteresis");
    let found = along(&case).remove(0).derivatives.unwrap();
    let Differentiation::Differences { errors, kink } = found.differentiation else { panic!("{found:?}") };
    assert_eq!(kink, Kink::Branch { side: Side::Machine, cable: 0 });
    // what rounds over 0.01 mm of a robot of metres
    assert!(errors.iter().all(|error| (0.0..1e-4).contains(error)), "{errors}");
}

/// A control model without tensions for a pose leaves the machine where it is: no derivative leads on, until the cables have forgotten it.
#[test]
fn poses_behind_one_without_an_answer_have_differences() {
    // wide loops, and narrow ones that all motions cross
    for (fraction, transition, is_forgotten) in [(0.15, 2e-3, false), (0.001, 1e-6, true)] {
        let mut case = planar_machine("elastic");
        let mut robot = remembering(case.machine.robot().clone(), fraction);
        for cable in &mut robot.cables {
            cable.hysteresis.as_mut().unwrap().transition_strain = vec![transition, 0.5 * transition];
        }
        case.machine = model(&robot, "hysteresis");
        let at = |x: f64, z: f64| CommandedPose::at(robot.motion_pattern.pose(robot.plane, &[x, z]).unwrap());
        case.history = Some(History { reach: Reach::InOrder, sub_steps: 1 });
        case.poses = vec![at(-0.5, 4.0), at(40.0, 2.0), at(-0.4, 4.1)];
        let found = along(&case);
        assert_eq!(found[0].derivatives.as_ref().unwrap().differentiation, Differentiation::Exact);
        assert!(found[1].derivatives.is_err());
        match &found[2].derivatives.as_ref().unwrap().differentiation {
            Differentiation::Exact => assert!(is_forgotten),
            Differentiation::Differences { kink, .. } => {
                assert_eq!(*kink, Kink::NoRest(Status::NotCommanded));
                assert!(!is_forgotten);
            }
        }
    }
}
