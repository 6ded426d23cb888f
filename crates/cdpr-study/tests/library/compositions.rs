//! Every composition of effects on one machine: the inverse problem and the forward problem lead to each other.

use super::support::operate;
use cdpr_calibration::evaluate;
use cdpr_calibration::fit::{Settings, fit};
use cdpr_model::control::{CommandedPose, History, Initial, Reach};
use cdpr_model::control::{Operation, initial_tensions, winch_offsets};
use cdpr_model::equilibrium::{State, distribution, elastostatics};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Cables, Composition, FreeParameters, Model};
use cdpr_model::robot::{HysteresisTable, LAWS, Robot};
use cdpr_model::statics::{self, Load};
use cdpr_model::tension::{Limits, Method};
use cdpr_study::branches::branches;
use rand::{RngExt, SeedableRng};

/// The CableRobot Simulator with everything that an effect asks for: pulleys of 160 mm, cables of 0.8 kg/m that stiffen.
fn machine() -> Robot {
    let mut robot =
        Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").expect("a built-in robot");
    let middle = robot.home_or_middle().position;
    for cable in &mut robot.cables {
        let upright = if cable.frame_anchor.z > middle.z { 1.0 } else { -1.0 };
        cable.set_pulley_radius(0.16);
        cable.set_pulley_swivel_axis(nalgebra::Vector3::new(0.0, 0.0, upright));
        let stiffness = cable.stiffness;
        LAWS.iter().for_each(|law| law.exemplify(cable, 2e6));
        cable.stiffness = stiffness;
        cable.linear_density = Some(0.8);
        cable.finite_elements = Some(8);
        cable.tension_of_strain = Some(vec![2e6, 2e8]);
        cable.hysteresis = Some(HysteresisTable {
            strain: vec![0.0, 0.005, 0.02],
            loading_N: vec![0.0, 1.2e4, 6e4],
            unloading_N: vec![0.0, 1.0e4, 6e4],
            loading_slope_N: None,
            unloading_slope_N: None,
            transition_strain: vec![4e-4],
            transition_share: None,
        });
    }
    robot
}

/// All compositions of pulleys, stretch and span; drums act before the cable and have their own tests.
fn compositions() -> impl Iterator<Item = Composition> {
    Composition::all().filter(|composition| !composition.drum && composition.cables() != Cables::Rigid)
}

/// Poses over the middle of the frame, turned by up to 6°.
fn poses(home: Pose, count: usize, seed: u64) -> Vec<Pose> {
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    let mut draw = |extent: f64| rng.random_range(-extent..extent);
    (0..count)
        .map(|_| home.displaced(&Twist::new(draw(1.5), draw(1.5), draw(0.8), draw(0.1), draw(0.1), draw(0.1))))
        .collect()
}

/// The tensions that the distribution chooses, the lengths for them, and the pose that these lengths lead to from 5 cm and 2°
/// beside: the same as before to 1e-9 m, at every pose where tensions within the limits exist.
#[test]
fn inverse_and_forward_problem_lead_to_each_other() {
    let robot = machine();
    let home = robot.home_or_middle();
    let count = if cfg!(debug_assertions) { 100 } else { 1000 };
    for composition in compositions() {
        let model = Model::new(robot.clone(), composition).unwrap();
        let load = Load::of(&robot).unwrap();
        let limits = Limits::of(&robot, None, None).unwrap();
        let mut solver = elastostatics::Solver::new(&model, &load, &elastostatics::Settings::default()).unwrap();
        let mut distributions = distribution::Solver::new(&model, &load, &limits);
        let (mut compared, mut refused) = (0, 0);
        for pose in poses(home, 4 * count, 3) {
            if compared == count {
                break;
            }
            let chosen = distributions.solve(&pose).unwrap();
            if let Some(reason) = chosen.reason {
                // the limits leave no tensions towards the corners of the box: nothing to compare there
                assert!(matches!(reason, distribution::Reason::Infeasible(_)), "{composition}: {reason:?}");
                refused += 1;
                continue;
            }
            let lengths = statics::controlled_lengths(&model, &pose, &chosen.tensions).unwrap();
            let guess = pose.displaced(&Twist::new(0.03, -0.04, 0.02, 0.02, -0.02, 0.03));
            let found = solver.solve(&lengths, &guess).unwrap();
            assert_eq!(found.status, elastostatics::Status::Converged, "{composition}: {:?}", found.reason);
            let missed = found.pose.displacement_to(&pose).norm();
            assert!(missed < 1e-9, "{composition}: {missed} m");
            for (tension, expected) in found.tensions.iter().zip(&chosen.tensions) {
                // 1e-9 m over a compliance of 1e-6 m/N and more
                assert!((tension - expected).abs() < 1e-3, "{composition}: {tension} {expected}");
            }
            compared += 1;
        }
        assert_eq!(compared, count, "{composition}: {refused} poses without tensions");
    }
}

/// Exact records of a machine with sagging cables: its own model is found again, frame anchors and stiffness, from anchors 3 cm
/// off; the same model with straight cables cannot explain them.
#[test]
fn a_sagging_machine_is_identified_by_a_sagging_model() {
    let truth = machine();
    let composition: Composition = "pulley+elastic+catenary".parse().expect("a composition");
    let model = Model::new(truth.clone(), composition).expect("everything it needs");
    let load = Load::of(&truth).expect("the file states it");
    let mut samples = Samples { cable_count: 8, ..Samples::default() };
    let mut tensions = Vec::new();
    for (index, pose) in poses(truth.home_or_middle(), 40, 5).into_iter().enumerate() {
        // another level of tension at every pose tells the stiffness
        let level = 1500.0 + 1000.0 * f64::from(u8::try_from(index % 4).expect("below 4"));
        let limits = Limits::uniform(8, level, level + 9000.0).expect("a range");
        let chosen = distribution::solve(&model, &pose, &load, &limits).expect("valid input");
        if chosen.reason.is_some() {
            continue;
        }
        samples.lengths.extend(statics::controlled_lengths(&model, &pose, &chosen.tensions).expect("taut cables"));
        tensions.extend(chosen.tensions);
        samples.poses.push(pose);
    }
    assert!(samples.poses.len() > 25, "{}", samples.poses.len());
    samples.tensions = Some(tensions);
    samples.sigmas = SensorSigmas {
        position: Some(1e-3),
        rotation: Some(1e-3),
        length: Some(2e-4),
        tension: Some(50.0),
        swivel: None,
        length_scale: None,
        balance_force: None,
        balance_moment: None,
    };
    let mut start = truth.clone();
    for (index, cable) in start.cables.iter_mut().enumerate() {
        cable.frame_anchor += nalgebra::Vector3::new(0.03, -0.02, 0.01) * if index % 2 == 0 { 1.0 } else { -1.0 };
    }
    let free: FreeParameters = "frame-anchor,compliance".parse().expect("parameters");
    let fitted = |words: &str| {
        let composition: Composition = words.parse().expect("a composition");
        let model = Model::new(start.clone(), composition).expect("everything it needs");
        fit(&model, &samples, &free, &Settings::default()).expect("data that fit the model")
    };
    let found = fitted("pulley+elastic+catenary");
    for (cable, expected) in found.model.robot().cables.iter().zip(&truth.cables) {
        // the data are exact: only the tolerance of the fit is left
        let missed = (cable.frame_anchor - expected.frame_anchor).norm();
        assert!(missed < 1e-5, "cable {}: {missed} m", cable.name);
    }
    let rms = |model: &Model| {
        let errors = evaluate(model, &samples).expect("the same cables").length;
        (errors.iter().map(|x| x * x).sum::<f64>() / errors.len() as f64).sqrt()
    };
    let (sagging, straight) = (rms(&found.model), rms(&fitted("pulley+elastic").model));
    assert!(sagging < 1e-6 && straight > 20.0 * sagging, "{sagging} m, {straight} m");
}

/// Initial tensions of a sagging machine balance its load as it hangs, not as straight cables would: with its winches set there,
/// a kinematic control model brings it to the initial pose itself.
#[test]
fn winches_of_a_sagging_machine_are_set_where_it_is_in_balance() {
    let robot = machine();
    let sagging = Model::new(robot.clone(), "elastic+catenary".parse().expect("a composition")).expect("a model");
    let control = Model::new(robot.clone(), Composition::STANDARD).expect("a model");
    let pose = robot.home_or_middle();
    let load = Load::of(&robot).expect("the file states it");
    for method in [Method::Qp, Method::ClosedForm] {
        let initial = Initial { tension_method: Some(method), ..Initial::default() };
        let tensions = initial_tensions(&initial, &sagging, &pose).expect("tensions");
        let residual = statics::wrench_residual(&sagging, &pose, &tensions, &load).expect("taut cables");
        // settled to 1e-10 of 5000 N, at levers of 1 m
        assert!(residual.amax() < 1e-5, "{method:?}: {residual}");
        let offsets = winch_offsets(&initial, &control, &sagging, &pose).expect("offsets");
        let commanded = CommandedPose::at(pose);
        let outcomes = operate(&control, &sagging, &offsets, &[commanded]).expect("the same robot");
        let missed = outcomes[0].pose.displacement_to(&pose).norm();
        assert!(missed < 1e-9, "{method:?}: {missed} {:?}", outcomes[0].reason);
    }
}

/// A cable with a memory: pulled in by 4 mm and let out again, it has less tension than before, and after one such cycle the
/// next one repeats it.
#[test]
fn states_remember_the_way_of_cables_with_hysteresis() {
    let robot = machine();
    let model = Model::new(robot.clone(), "hysteresis".parse().expect("a composition")).expect("a model");
    let mut state = State::at_home(&model);
    let home = state.pose();
    let command = model.inverse(&home, &[5000.0; 8], &mut state).expect("eight tensions");
    let lengths = command.controlled_lengths().expect("taut cables");
    let tight: Vec<f64> = lengths.iter().map(|length| length - 4e-3).collect();
    let mut sum_at = |lengths: &[f64]| {
        let solution = model.forward(lengths, None, Some(&home), &mut state).expect("valid input");
        assert_eq!(solution.status, elastostatics::Status::Converged, "{:?}", solution.reason);
        let sum = solution.tensions.iter().sum::<f64>();
        state.settle_forward(&model);
        sum
    };
    let (first, _, second) = (sum_at(&lengths), sum_at(&tight), sum_at(&lengths));
    let (_, third) = (sum_at(&tight), sum_at(&lengths));
    assert!(second < first - 100.0, "{first} {second}");
    // to the pose tolerance of 1e-11 m at 1e6 N/m
    assert!((third - second).abs() < 1e-3, "{second} {third}");
}

/// A machine with hysteresis comes to one pose from its initial pose, and in file order back from another one: loosening cables
/// have less tension than tightening ones, so the platform lies elsewhere. From the initial pose the order of poses is nothing.
#[test]
fn machines_with_hysteresis_come_to_a_pose_on_a_way() {
    let robot = machine();
    let control = Model::new(robot.clone(), Composition::STANDARD).expect("a model");
    let machine = Model::new(robot.clone(), "hysteresis".parse().expect("a composition")).expect("a model");
    let start = robot.home_or_middle();
    let initial = Initial { tensions_N: Some(vec![5000.0; 8]), ..Initial::default() };
    let offsets = winch_offsets(&initial, &control, &machine, &start).expect("balanced");
    let near = start.displaced(&Twist::new(0.2, 0.1, 0.1, 0.0, 0.0, 0.05));
    let far = start.displaced(&Twist::new(0.9, -0.6, 0.4, 0.1, 0.0, 0.1));
    let answers = |reach: Reach, poses: &[Pose]| {
        let history = History { reach, sub_steps: 5 };
        let operation = Operation::new(&control, &machine, &offsets).expect("the same robot");
        let mut operation = operation.with_history(&history, &start);
        let answer = |pose: &Pose| {
            let outcome = operation.answer(&CommandedPose::at(*pose));
            assert_eq!(outcome.status, cdpr_model::control::Status::Converged, "{:?}", outcome.reason);
            outcome.pose
        };
        poses.iter().map(answer).collect::<Vec<_>>()
    };
    let anew = answers(Reach::FromInitial, &[near, far, near]);
    assert_eq!(anew[0], anew[2], "the way starts anew each time");
    assert_eq!(anew[1], answers(Reach::FromInitial, &[far])[0]);
    let in_order = answers(Reach::InOrder, &[near, far, near]);
    assert_eq!(in_order[0], anew[0], "the first pose is reached from the initial one");
    let apart = in_order[0].displacement_to(&in_order[2]).norm();
    assert!(apart > 1e-5 && apart < 0.05, "{apart} m between the way there and the way back");

    // seven ways: straight, and from either side along x, y, z; without a memory all lead to the same end
    let history = History { reach: Reach::FromInitial, sub_steps: 5 };
    let spread = |machine: &Model, stroke: f64| {
        let poses = [near, far];
        let found = branches(&control, machine, &offsets, &history, &start, &poses, stroke).expect("one robot");
        assert_eq!((found.samples, found.ways), (2, 7));
        found
    };
    let found = spread(&machine, 0.1);
    let widest = found.position_spread_m.max;
    assert!(widest > 1e-5 && widest < 0.05, "{found:?}");
    assert!(found.tension_spread_N.max > 1.0, "{found:?}");
    assert!(spread(&machine, 0.02).position_spread_m.mean < found.position_spread_m.mean, "a short way turns less far");
    let elastic = Model::new(machine.robot().clone(), Composition::ELASTIC).expect("a model");
    assert!(spread(&elastic, 0.1).position_spread_m.max < 1e-9);
}
