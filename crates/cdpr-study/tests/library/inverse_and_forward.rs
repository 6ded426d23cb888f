//! Laws of the two doors, `Model::inverse` and `Model::forward`, for every composition of effects and for robots with more cables than
//! degrees of freedom, as many, and fewer; and of everything that goes through them.

use cdpr_calibration::evaluate;
use cdpr_model::control;
use cdpr_model::control::simulate::simulate_operation;
use cdpr_model::control::{CommandedPose, History, Reach};
use cdpr_model::control::{Operation, Outcome};
use cdpr_model::equilibrium::{ForwardProblem, State, Status, distribution};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::{Cables, Composition, Model, SpanEffect, StretchEffect};
use cdpr_model::robot::{CableStiffness, HysteresisTable, LAWS, Pulley, Robot};
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_study::accuracy::assess_operation;
use cdpr_study::sweep::{PreparedSweep, Subjects, Sweep};
use cdpr_study::{Experiment, Robots, Study};
use cdpr_workspace::grid::{self, Grid};
use nalgebra::Vector3;

/// A built-in robot with everything that an effect asks for, and these of its cables.
fn equipped(name: &str, cables: &[usize]) -> Robot {
    let mut robot = Robot::builtin(name).expect("a built-in robot");
    robot.cables = cables.iter().map(|&cable| robot.cables[cable].clone()).collect();
    robot.external_wrench = None;
    let down = if robot.motion_pattern.is_planar() { -Vector3::y() } else { -Vector3::z() };
    robot.gravity = Some(down * 9.81);
    robot.platform.mass.get_or_insert(120.0);
    robot.platform.center_of_mass.get_or_insert_with(Vector3::zeros);
    for cable in &mut robot.cables {
        LAWS.iter().for_each(|law| law.exemplify(cable, 1e6));
        cable.stiffness = Some(CableStiffness::Axial(1e6));
        let swivel_axis = if robot.motion_pattern.is_planar() { Vector3::y() } else { Vector3::z() };
        cable.pulley = Some(Pulley::Whole { radius: 0.05, swivel_axis: swivel_axis.into() });
        cable.pulley_wrap_side = None;
        cable.linear_density = Some(0.1);
        cable.finite_elements = Some(4);
        cable.tension_of_strain = Some(vec![8e5, 8e7]);
        cable.hysteresis = Some(HysteresisTable {
            strain: vec![0.0, 0.005, 0.02],
            loading_N: vec![0.0, 6e3, 3e4],
            unloading_N: vec![0.0, 5e3, 3e4],
            loading_slope_N: None,
            unloading_slope_N: None,
            transition_strain: vec![4e-4],
            transition_share: None,
        });
        (cable.length_scale, cable.length_offset) = (Some(1.002), Some(0.03));
        (cable.winch.radius, cable.winch.guided) = (Some(0.1), Some(true));
        cable.winch.set_pitch(0.01);
        cable.winch.start_length = Some(8.0);
        cable.tension_min = Some(100.0);
        cable.tension_max = Some(9000.0);
    }
    robot
}

/// Point in a plane, platform in a plane, and bodies in space on more, as many and fewer cables than degrees of freedom.
fn robots() -> Vec<Robot> {
    vec![
        equipped("planar-example", &[0, 1, 2, 3]),
        equipped("planar-example", &[0, 1]),
        equipped("cucablerobot-planar", &[0, 1, 2, 3]),
        equipped("cablerobot-simulator-helicopter", &[0, 1, 2, 3, 4, 5, 6, 7]),
        equipped("cogiro", &[0, 1, 2, 3, 4, 5, 6, 7]),
        equipped("nist-robocrane", &[0, 1, 2, 3, 4, 5]),
        equipped("cogiro", &[0, 2, 4, 6]),
    ]
}

/// Forward problem from the lengths that the inverse problem gives leads back, for every composition, in one state throughout: to the pose
/// where lengths determine it, and where they do not, from an equilibrium to itself, with its tensions.
#[test]
fn the_forward_problem_leads_back_to_where_the_inverse_problem_came_from() {
    for robot in robots() {
        let mut answered = 0;
        for composition in Composition::all() {
            let model = Model::new(robot.clone(), composition).unwrap();
            let mut state = State::at_home(&model);
            let home = state.pose();
            let name = format!("{} with {} cables, {composition}", robot.name, model.cable_count());
            let under = model.cable_count() < model.dof();
            let expected = under || composition.cables() != Cables::Rigid;
            let problem = model.forward_problem(None, &mut state).unwrap();
            assert_eq!(problem == ForwardProblem::Equilibrium, expected, "{name}");

            // somewhere at rest: where lengths near those of the home pose lead
            let level = if under { 600.0 } else { 2000.0 };
            let near = model.inverse(&home, &vec![level; model.cable_count()], &mut state).unwrap();
            let Ok(lengths) = near.controlled_lengths() else { continue };
            let found = model.forward(&lengths, None, Some(&home), &mut state).unwrap().clone();
            if found.status != Status::Converged || found.slack > 0 {
                continue;
            }
            let tensions = match expected {
                true => found.tensions.clone(),
                false => vec![f64::NAN; model.cable_count()],
            };
            // by now every cable remembers the way to there
            state.settle_forward(&model);
            let memories = state.memories().to_vec();
            let command = model.inverse(&found.pose, &tensions, &mut state).unwrap();
            let lengths = command.controlled_lengths().unwrap();
            let guess = found.pose.displaced(&model.twist_basis().iter().fold(Twist::zeros(), |sum, b| sum + b * 0.01));
            let back = model.forward(&lengths, None, Some(&guess), &mut state).unwrap().clone();
            let is_inextensible =
                composition.span != SpanEffect::Straight && composition.stretch == StretchEffect::Rigid;
            if is_inextensible && back.status == Status::NotConverged {
                // from beside, a cable that does not stretch may be too short for any shape: no answer, and no wrong one
                assert!(back.reason.is_some(), "{name}");
                continue;
            }
            assert_eq!(back.status, Status::Converged, "{name}: {:?}", back.reason);
            let missed = back.pose.displacement_to(&found.pose).norm();
            // both ends are known to 1e-10 of the lengths; the least stiff platform, on four cables, magnifies that a hundred times
            assert!(missed < 1e-7, "{name}: {missed} m");
            for (tension, expected) in back.tensions.iter().zip(&tensions) {
                // 1e-7 m over the shortest cable of half a metre, EA of 1e6 N
                assert!((tension - expected).abs() < 0.2, "{name}: {tension} N, {expected} N");
            }
            assert_eq!(state.memories(), memories, "{name}: asking is no motion");
            assert_eq!(memories.is_empty(), composition.stretch != StretchEffect::Hysteresis, "{name}");
            answered += 1;
        }
        // those that sag without stretch are too short for the chord where lengths are those of straight cables
        assert!(answered >= 36, "{} with {} cables: {answered} compositions", robot.name, robot.cables.len());
    }
}

/// Poses around the home pose on a way there and back.
fn path(robot: &Robot) -> Vec<CommandedPose> {
    let home = robot.home_or_middle();
    let basis = robot.motion_pattern.twist_basis(robot.plane);
    let at = |step: f64| {
        let twist = basis
            .iter()
            .enumerate()
            .fold(Twist::zeros(), |sum, (axis, b)| sum + b * (0.1 * step * if axis < 2 { 1.0 } else { 0.2 }));
        CommandedPose::at(home.displaced(&twist))
    };
    [0.5, 1.0, 1.5, 1.0, -0.5].map(at).to_vec()
}

fn driven<'a>(control: &'a Model, machine: &'a Model) -> Operation {
    let operation = Operation::new(control, machine, &vec![0.0; machine.cable_count()]).unwrap();
    let history = History { reach: Reach::InOrder, sub_steps: 3 };
    operation.with_history(&history, &machine.robot().home_or_middle())
}

/// A control model that is the machine brings it where it commands, whatever the effects: also cables that remember, for the control
/// model remembers with them.
#[test]
fn a_control_model_that_is_the_machine_makes_no_error() {
    for robot in [equipped("planar-example", &[0, 1, 2, 3]), equipped("cogiro", &[0, 1, 2, 3, 4, 5, 6, 7])] {
        let (load, limits) = (Load::of(&robot).unwrap(), Limits::of(&robot, None, None).unwrap());
        for composition in Composition::all() {
            let model = Model::new(robot.clone(), composition).unwrap();
            let poses = path(&robot);
            if model.needs_tensions() {
                let feasible = |command: &CommandedPose| {
                    distribution::solve(&model, &command.pose, &load, &limits).is_ok_and(|found| found.reason.is_none())
                };
                assert!(poses.iter().all(feasible), "{} {composition}: tensions at every pose", robot.name);
            }
            let assessed = assess_operation(&mut driven(&model, &model), &poses).unwrap();
            for (command, outcome) in poses.iter().zip(&assessed.outcomes) {
                assert_eq!(outcome.status, control::Status::Converged, "{} {composition}: {outcome:?}", robot.name);
                let missed = command.pose.displacement_to(&outcome.pose).norm();
                assert!(missed < 1e-8, "{} {composition}: {missed} m", robot.name);
            }
        }
    }
}

/// The bits of an outcome.
fn bits(outcomes: &[Outcome]) -> Vec<u64> {
    let numbers = |outcome: &Outcome| {
        let tensions = outcome.tensions.clone().unwrap_or_default();
        let (position, rotation) = (outcome.pose.position.as_slice(), outcome.pose.rotation.coords.as_slice());
        [position, rotation, &outcome.sent, &outcome.recorded, &tensions].concat()
    };
    outcomes.iter().flat_map(numbers).map(f64::to_bits).collect()
}

/// A snapshot in the middle of a path, put back twice: the same bytes each time, and those of the path without a stop.
#[test]
fn a_snapshot_of_a_machine_that_remembers_goes_on_as_the_machine_does() {
    let robot = equipped("cogiro", &[0, 1, 2, 3, 4, 5, 6, 7]);
    let control = Model::new(robot.clone(), Composition::PULLEY_ELASTIC).unwrap();
    let machine = Model::new(robot.clone(), "pulley+hysteresis".parse().unwrap()).unwrap();
    let poses = path(&robot);
    let (first, rest) = poses.split_at(2);
    let mut operation = driven(&control, &machine);
    let drive = |operation: &mut Operation, poses: &[CommandedPose]| -> Vec<Outcome> {
        poses.iter().map(|command| operation.answer(command)).collect()
    };
    let before = drive(&mut operation, first);
    let snapshot = operation.clone();
    let went_on = drive(&mut operation, rest);
    assert!(went_on.iter().all(|outcome| outcome.status == control::Status::Converged), "{went_on:?}");
    for _ in 0..2 {
        assert_eq!(bits(&drive(&mut snapshot.clone(), rest)), bits(&went_on));
    }
    assert_eq!(bits(&drive(&mut driven(&control, &machine), &poses)), [bits(&before), bits(&went_on)].concat());
    // and the way matters: straight to the end it lies elsewhere
    let straight = drive(&mut driven(&control, &machine), &poses[4..]);
    assert!(straight[0].pose.displacement_to(&went_on[2].pose).norm() > 1e-7);
}

/// Prediction error of a control model on exact records: it predicts what it commanded from the lengths that it sent, so that its error is
/// the machine's.
#[test]
fn evaluation_of_exact_records_is_the_accuracy_of_the_control_model() {
    let robots = [
        equipped("planar-example", &[0, 1, 2, 3]),
        equipped("cablerobot-simulator-helicopter", &[0, 1, 2, 3, 4, 5, 6, 7]),
        equipped("cogiro", &[0, 2, 4, 6]),
    ];
    for robot in robots {
        let under = robot.cables.len() < 6 && !robot.motion_pattern.is_planar();
        let machine = Model::new(robot.clone(), Composition::PULLEY_ELASTIC).unwrap();
        for words in ["standard", "pulley", "pulley+drum", "elastic", "pulley+elastic"] {
            let control = Model::new(robot.clone(), words.parse().unwrap()).unwrap();
            if under && control.needs_tensions() {
                // four cables hold no pose that a controller could choose tensions for
                continue;
            }
            let poses = path(&robot);
            let offsets = vec![0.0; robot.cables.len()];
            let operation = || Operation::new(&control, &machine, &offsets).unwrap();
            let assessed = assess_operation(&mut operation(), &poses).unwrap();
            let recorded = simulate_operation(&mut operation(), &poses, &SensorSigmas::default(), 1).unwrap();
            let evaluation = evaluate(&control, &recorded.samples).unwrap();
            let settled = assessed.outcomes.iter().zip(&poses).filter(|(o, _)| o.status == control::Status::Converged);
            let errors: Vec<f64> =
                settled.map(|(outcome, command)| (outcome.pose.position - command.pose.position).norm()).collect();
            assert_eq!(errors.len(), evaluation.len(), "{} {words}", robot.name);
            for (sample, (error, found)) in errors.iter().zip(&evaluation.position).enumerate() {
                if under {
                    // a rigid platform on four cables hangs where its weight leads it, not where it was commanded
                    assert!(found.is_finite(), "{} {words}", robot.name);
                    continue;
                }
                assert!((error - found).abs() < 1e-8, "{} {words}, sample {sample}: {error} m, {found} m", robot.name);
            }
        }
    }
}

/// The search of a caller without a guess begins at the home pose, or in the middle of the anchors, and says so.
#[test]
fn a_caller_without_a_guess_is_told_where_the_search_began() {
    use cdpr_model::equilibrium::Start;
    let robot = equipped("planar-example", &[0, 1, 2, 3]);
    let homeless = Robot { home: None, ..robot.clone() };
    for (robot, expected) in [(robot, Start::HomePose), (homeless, Start::MiddleOfAnchors)] {
        let model = Model::new(robot, Composition::STANDARD).unwrap();
        let mut state = State::at_home(&model);
        let lengths = model.cable_lengths(&Pose::from_xyz_angles(Vector3::new(0.3, 4.0, 0.0), [0.0; 3])).unwrap();
        let found = model.forward(&lengths, None, None, &mut state).unwrap().pose;
        assert_eq!(state.start(), expected);
        let guessed = model.forward(&lengths, None, Some(&found), &mut state).unwrap().pose;
        assert_eq!(state.start(), Start::Guess);
        assert!(guessed.displacement_to(&found).norm() < 1e-9);
    }
}

/// One study says one thing: the sweep over a parameter at its own value reaches what the study's experiment reaches, to the bit, for
/// every composition of effects as the machine, by thresholds and by requirements of the study.
#[test]
fn a_sweep_reaches_what_the_experiment_of_its_study_reaches() {
    let robot = equipped("planar-example", &[0, 1, 2, 3]).to_toml();
    let (ends, step, most) = ([-4.0, 4.0, 1.0, 7.0], 1.0, 0.05);
    let mut reached = 0;
    for composition in Composition::all() {
        let text = format!(
            "[control]\nrobot = \"r\"\n[machine]\nrobot = \"r\"\nmodel = \"{composition}\"\n\
             [initial]\npose = [0, 4.5]\ntension_method = \"closed-form\"\n\
             [limits]\ntension_min_N = 100\ntension_max_N = 9000\nposition_error_max_m = {most}\n"
        );
        let sweep = format!(
            "study = \"s\"\nbounds_m = {ends:?}\nstep_m = {step:?}\nposition_error_max_m = [{most}]\n\
             [[parameter]]\nkey = \"study.initial.pose[1]\"\nvalues = [0]\n"
        );
        let sweep = Sweep::from_toml_bytes(sweep.as_bytes(), "sweep").unwrap();
        let subjects =
            Subjects { study: text.clone(), control: robot.clone(), machine: robot.clone(), offset_robot: None };
        let row = PreparedSweep::new(&sweep, &subjects).unwrap().row(0, &[0.0]);

        let study = Study::from_toml_bytes(text.as_bytes(), "study").unwrap();
        let robots = Robots::of(&study, |name| Robot::from_toml(&robot, name)).unwrap();
        let experiment = match Experiment::new(study, robots) {
            Ok(experiment) => experiment,
            // cables that sag and do not stretch have no lengths at the tensions of straight ones
            Err(error) => {
                assert_eq!(row.reason, Some(error.to_string()), "{composition}");
                continue;
            }
        };
        let reachable = experiment.reachable().unwrap();
        let region = experiment.region(&reachable, experiment.start.rotation).unwrap();
        let grid = Grid::new(&experiment.bounds(Some(&ends)).unwrap(), step).unwrap();
        let size = grid::count(&region, &grid).outcome(&grid).size;
        assert_eq!(row.by_accuracy.len(), 1, "{composition}: {:?}", row.reason);
        assert_eq!(row.by_accuracy[0].to_bits(), size.to_bits(), "{composition}: {} {size}", row.by_accuracy[0]);
        let held = experiment.feasible_cells(&experiment.machine, &region, &grid).unwrap();
        assert_eq!(row.physical, Some(held.size), "{composition}");
        reached += usize::from(size > 0.0);
    }
    assert!(reached >= 40, "{reached} compositions reach anything");
}
