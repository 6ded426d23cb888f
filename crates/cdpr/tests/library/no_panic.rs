//! No numbers make the library panic: robots, poses, lengths, tensions and samples with NaN, infinities, zeros, huge and tiny
//! numbers, anchors on one line or in one point, and too few cables, through everything that takes them.
//!
//! Readers refuse most of these; programs that build a robot in memory do not pass through a reader.

use super::support::{builtin, operate, simulator, with_pulleys};
use cdpr::calibration::candidate::{KnownTensions, Ladder, PlatformAnchors, defaults};
use cdpr::calibration::fit::Prior;
use cdpr::calibration::selection::{self, select};
use cdpr::calibration::unobserved;
use cdpr::calibration::{evaluate, fit};
use cdpr::control::CommandedPose;
use cdpr::control::simulate::simulate;
use cdpr::equilibrium::{elastostatics, forward_kinematics, forward_statics};
use cdpr::geometry::{Pose, Twist, Wrench};
use cdpr::measurement::{Samples, SensorSigmas, Split};
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::Vector3;
use cdpr::reading::Keyword;
use cdpr::robot::{CableStiffness, ParameterKind, Robot};
use cdpr::statics::{Load, Stiffness, balanced_wrench, controlled_lengths, section_wrench, split, wrench_residual};
use cdpr::study::accuracy::assess;
use cdpr::tension::{Limits, Method, Options, Reference, closed_form, quadratic, solve};
use cdpr_testing::property;
use proptest::prelude::*;

/// Numbers that are usual, extreme or none.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => -10.0..10.0,
        2 => 0.0..1e4,
        1 => any::<f64>(),
        2 => prop::sample::select(vec![0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY]),
        2 => prop::sample::select(vec![1e308, -1e308, 1e154, 1e-154, 5e-324, f64::MIN_POSITIVE, 1e-12, 1e12]),
    ]
}

fn vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(number()).prop_map(Vector3::from)
}

fn robots() -> Vec<Robot> {
    let mut turning = builtin("kntu-planar");
    turning.cables.iter_mut().for_each(|cable| cable.stiffness = Some(CableStiffness::Spring(1e4)));
    let calibrated = builtin("cablerobot-simulator-helicopter-elastostatic-calibrated");
    vec![
        builtin("planar-example"),
        turning,
        with_pulleys(&simulator(), 0.161),
        with_pulleys(&calibrated, 0.161),
        builtin("cogiro"),
        builtin("nist-robocrane"),
        builtin("spatial-7-cable"),
    ]
}

/// A change of a robot that no reader would let pass.
#[derive(Clone, Debug)]
enum Fault {
    FrameAnchor(usize, Vector3<f64>),
    PlatformAnchor(usize, Vector3<f64>),
    Axis(usize, Vector3<f64>),
    Scalar(usize, usize, f64),
    Weight(Vector3<f64>, f64, Vector3<f64>),
    FrameAnchorsOnALine(Vector3<f64>, f64),
    AllAnchorsInOnePoint,
    Keep(usize),
}

fn fault() -> impl Strategy<Value = Fault> {
    let cable = || 0..8_usize;
    prop_oneof![
        3 => (cable(), vector()).prop_map(|(cable, v)| Fault::FrameAnchor(cable, v)),
        3 => (cable(), vector()).prop_map(|(cable, v)| Fault::PlatformAnchor(cable, v)),
        1 => (cable(), vector()).prop_map(|(cable, v)| Fault::Axis(cable, v)),
        5 => (cable(), 0..12_usize, number()).prop_map(|(cable, field, x)| Fault::Scalar(cable, field, x)),
        2 => (vector(), number(), vector()).prop_map(|(gravity, mass, center)| Fault::Weight(gravity, mass, center)),
        1 => (vector(), number()).prop_map(|(along, step)| Fault::FrameAnchorsOnALine(along, step)),
        1 => Just(Fault::AllAnchorsInOnePoint),
        1 => (0..9_usize).prop_map(Fault::Keep),
    ]
}

fn apply(mut robot: Robot, fault: &Fault) -> Robot {
    let count = robot.cables.len().max(1);
    let cables = &mut robot.cables;
    match *fault {
        Fault::FrameAnchor(cable, v) => cables.iter_mut().skip(cable % count).take(1).for_each(|c| c.frame_anchor = v),
        Fault::PlatformAnchor(cable, v) => {
            cables.iter_mut().skip(cable % count).take(1).for_each(|c| c.platform_anchor = v);
        }
        Fault::Axis(cable, v) => {
            cables.iter_mut().skip(cable % count).take(1).for_each(|c| c.set_pulley_swivel_axis(v));
        }
        Fault::Scalar(cable, field, number) => {
            for cable in cables.iter_mut().skip(cable % count).take(1) {
                let target = match field {
                    0 => {
                        cable.set_pulley_radius(number);
                        continue;
                    }
                    1..=3 => {
                        let ways = [CableStiffness::Axial, CableStiffness::Compliance, CableStiffness::Spring];
                        cable.stiffness = Some(ways[field - 1](number));
                        continue;
                    }
                    4 => &mut cable.hidden_length,
                    5 => &mut cable.series_compliance,
                    6 => &mut cable.length_scale,
                    7 => &mut cable.length_offset,
                    8 => &mut cable.tension_scale,
                    9 => &mut cable.tension_offset,
                    10 => &mut cable.tension_min,
                    _ => &mut cable.tension_max,
                };
                *target = Some(number);
            }
        }
        Fault::Weight(gravity, mass, center) => {
            robot.external_wrench = None;
            robot.gravity = Some(gravity);
            (robot.platform.mass, robot.platform.center_of_mass) = (Some(mass), Some(center));
        }
        Fault::FrameAnchorsOnALine(along, step) => {
            for (k, cable) in cables.iter_mut().enumerate() {
                cable.frame_anchor = along * (step * k as f64);
            }
        }
        Fault::AllAnchorsInOnePoint => {
            for cable in cables.iter_mut() {
                (cable.frame_anchor, cable.platform_anchor) = (Vector3::zeros(), Vector3::zeros());
            }
        }
        Fault::Keep(kept) => cables.truncate(kept),
    }
    robot
}

/// Everything else that a caller passes.
#[derive(Clone, Debug)]
struct Input {
    position: Vector3<f64>,
    turn: Vector3<f64>,
    lists: [Vec<f64>; 3],
    wrench: [f64; 6],
    sigmas: [f64; 4],
}

impl Input {
    fn pose(&self) -> Pose {
        let turned = Twist::new(0.0, 0.0, 0.0, self.turn[0], self.turn[1], self.turn[2]);
        Pose { position: self.position, ..Pose::identity() }.displaced(&turned)
    }
}

fn input() -> impl Strategy<Value = Input> {
    let list = || prop::collection::vec(number(), 0..10);
    let wrench = [number(), number(), number(), number(), number(), number()];
    let sigmas = [number(), number(), number(), number()];
    (vector(), vector(), [list(), list(), list()], wrench, sigmas)
        .prop_map(|(position, turn, lists, wrench, sigmas)| Input { position, turn, lists, wrench, sigmas })
}

const COMPOSITIONS: [Composition; 4] =
    [Composition::STANDARD, Composition::PULLEY, Composition::ELASTIC, Composition::PULLEY_ELASTIC];

/// A list of the length asked for most of the time: short ones are filled up, a few stay wrong.
fn fitted(list: &[f64], count: usize, filling: f64) -> Vec<f64> {
    let mut list = list.to_vec();
    if list.len() != 3 {
        list.resize(count, filling);
    }
    list
}

fn exercise(robot: &Robot, input: &Input) {
    let Input { turn, lists, wrench, .. } = input;
    robot.warnings();
    let pose = input.pose();
    let home = robot.home_or_middle();
    let axes = vec![(lists[0].first().copied().unwrap_or(0.1), *turn); robot.cables.len()];
    let _ = place_pulleys(robot, &axes, &pose);
    for composition in COMPOSITIONS {
        let Ok(model) = Model::new(robot.clone(), composition) else { continue };
        let m = model.cable_count();
        let (lengths, tensions) = (fitted(&lists[0], m, 5.0), fitted(&lists[1], m, 1000.0));
        let loads = [Load::of(robot).ok(), Some(Load::constant(Wrench::from(*wrench)))];
        for pose in [&pose, &home] {
            let _ = model.cable_lengths(pose);
            let structure_matrix = model.structure_matrix(pose);
            let _ = (split(&model, pose, &tensions), balanced_wrench(&model, pose, &tensions));
            let _ = section_wrench(&model, pose, &tensions, &[0, 3]);
            let _ = controlled_lengths(&model, pose, &tensions);
            let _ = forward_kinematics::solve(&model, &lengths, pose, &forward_kinematics::Settings::default());
            for load in loads.iter().flatten() {
                let _ = wrench_residual(&model, pose, &tensions, load);
                if let Ok(stiffness) = Stiffness::at(&model, pose, &tensions, load) {
                    let _ = (stiffness.eigenvalues(), stiffness.stability(), stiffness.compliance());
                }
                let settings = elastostatics::Settings { max_iterations: 60, max_restarts: 2, ..Default::default() };
                let _ = elastostatics::solve(&model, &lengths, load, pose, &settings);
                let settings = forward_statics::Settings { max_iterations: 60, max_restarts: 2, ..Default::default() };
                let _ = forward_statics::solve(&model, &tensions, load, pose, &settings);
                let limits = Limits::new(fitted(&lists[1], m, 100.0), fitted(&lists[2], m, 9000.0));
                if let (Ok(matrix), Ok(limits)) = (&structure_matrix, limits) {
                    let rows = load.in_pattern(&model, pose);
                    let _ = closed_form::solve(matrix, rows.as_slice(), &limits);
                    let found = quadratic::solve(matrix, rows.as_slice(), &limits, Some(&tensions));
                    let _ = found.map(|found| found.reason());
                    let options = Options {
                        reference: if lists[0].len() % 2 == 0 {
                            Reference::Previous
                        } else {
                            Reference::Given(&lengths)
                        },
                        previous: Some(&tensions),
                        rates: (lists[1].len() % 2 == 0).then_some(&lengths),
                        p: 1.0 + (lists[2].len() % 3) as f64,
                        ..Options::default()
                    };
                    for &method in Method::ALL {
                        let found = solve(method, matrix, rows.as_slice(), &limits, &options);
                        let _ = found.map(|found| found.reason());
                    }
                }
            }
        }
        drive(robot, &model, input, &pose, &home);
        learn(&model, input, &pose);
    }
}

/// The model as control model and as machine.
fn drive(robot: &Robot, model: &Model, input: &Input, pose: &Pose, home: &Pose) {
    let Ok(standard) = Model::new(robot.clone(), Composition::STANDARD) else { return };
    let offsets = fitted(&input.lists[2], model.cable_count(), 0.0);
    let poses = [CommandedPose::at(*pose), CommandedPose::at(*home)];
    for (control, machine) in [(&standard, model), (model, &standard), (model, model)] {
        let _ = operate(control, machine, &offsets, &poses);
        let _ = assess(control, machine, &offsets, &poses);
        let _ = simulate(control, machine, &offsets, &poses, &SensorSigmas::default(), 1);
    }
}

/// Samples around a pose, with the tensions and standard deviations of the input.
fn samples_around(model: &Model, input: &Input, pose: &Pose) -> Samples {
    let m = model.cable_count();
    let mut samples = Samples { cable_count: m, tensions: Some(Vec::new()), ..Samples::default() };
    let stated = |k: usize| (input.sigmas[k] > 1.0).then_some(input.sigmas[k]);
    samples.sigmas = SensorSigmas {
        position: stated(0),
        rotation: stated(1),
        length: stated(2),
        tension: stated(3),
        ..SensorSigmas::default()
    };
    for k in 0..6 {
        let shift = Twist::new(0.1 * f64::from(k), -0.05 * f64::from(k), 0.02 * f64::from(k * k), 0.0, 0.01, 0.0);
        samples.poses.push(pose.displaced(&shift));
        let lengths = model.cable_lengths(&samples.poses[samples.poses.len() - 1]);
        samples
            .lengths
            .extend(lengths.unwrap_or_else(|_| fitted(&input.lists[0], m, 5.0).into_iter().take(m).collect()));
        samples.lengths.resize(samples.poses.len() * m, 5.0);
        if let Some(tensions) = &mut samples.tensions {
            tensions.extend(fitted(&input.lists[1], m, 1000.0).into_iter().take(m));
            tensions.resize(samples.poses.len() * m, 1000.0);
        }
    }
    samples
}

fn fit_settings() -> fit::Settings {
    let priors = vec![Prior { kind: ParameterKind::PlatformAnchor, sigma: 0.02 }];
    fit::Settings { priors, starts: 2, max_iterations: 20, ..fit::Settings::default() }
}

/// Evaluation and identification.
fn learn(model: &Model, input: &Input, pose: &Pose) {
    let samples = samples_around(model, input, pose);
    let _ = samples.check();
    let _ = evaluate(model, &samples).map(|evaluation| evaluation.blocks());
    for free in ["frame-anchor,length-offset", "frame-anchor,platform-anchor,compliance,wrench", "length-scale"] {
        if let Ok(free) = free.parse() {
            let _ = fit::fit(model, &samples, &free, &fit_settings());
        }
    }
}

/// Selection among candidates of the default ladder: every eleventh, from the one given.
fn choose(model: &Model, input: &Input, first: usize) {
    let samples = samples_around(model, input, &input.pose());
    let ladder = Ladder { tensions: KnownTensions::Recorded, platform_anchors: PlatformAnchors::Free };
    let candidates: Vec<_> = defaults(model.robot(), ladder).into_iter().skip(first).step_by(11).collect();
    if let Ok(folds) = Split::Blocks(2).folds(&samples, 1) {
        let settings = selection::Settings { fit: fit_settings(), ..selection::Settings::default() };
        let _ = select(model.robot(), &candidates, &samples, &folds, &settings, &unobserved);
    }
}

proptest! {
    #![proptest_config(property::cases(64))]

    #[test]
    fn no_robot_and_no_numbers_make_the_library_panic(
        robot in prop::sample::select(robots()),
        faults in prop::collection::vec(fault(), 0..4),
        input in input(),
    ) {
        exercise(&faults.iter().fold(robot, apply), &input);
    }
}

// a selection takes as long as all the rest together: fewer cases
proptest! {
    #![proptest_config(property::cases(16))]

    #[test]
    fn no_robot_and_no_samples_make_selection_panic(
        robot in prop::sample::select(robots()),
        faults in prop::collection::vec(fault(), 0..4),
        input in input(),
        composition in prop::sample::select(COMPOSITIONS.to_vec()),
        first in 0..11_usize,
    ) {
        let robot = faults.iter().fold(robot, apply);
        if let Ok(model) = Model::new(robot, composition) {
            choose(&model, &input, first);
        }
    }
}
