//! The elastostatic forward problem of robots at the edge: extreme stiffness, hardly any length, suspended, sagging without stretch.

use super::elastostatics::distance;
use super::support::builtin;
use cdpr_model::equilibrium::elastostatics::{Settings, Status, solve};
use cdpr_model::geometry::{MotionPattern, Pose, Twist, Wrench};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{Cable, CableStiffness, Robot};
use cdpr_model::statics::{Load, wrench_residual};
use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Robots of every pattern with anchors anywhere in a frame of 10 m (in a layer above the platform where they are suspended) and
/// a load of 1 kN downwards.
struct RandomRobots {
    rng: ChaCha8Rng,
    pattern: MotionPattern,
    is_suspended: bool,
}

const PATTERNS: [MotionPattern; 4] =
    [MotionPattern::PlanarPoint, MotionPattern::SpatialPoint, MotionPattern::Planar, MotionPattern::Spatial];
const LOAD: f64 = 1000.0;

impl RandomRobots {
    fn new(pattern: MotionPattern, is_suspended: bool, seed: u64) -> Self {
        Self { rng: ChaCha8Rng::seed_from_u64(seed), pattern, is_suspended }
    }

    /// A model with a pose near the middle; `law` writes the elasticity of each cable.
    fn draw(&mut self, mut law: impl FnMut(&mut Cable, &mut ChaCha8Rng)) -> (Model, Pose, Load) {
        let mut robot = builtin("cablerobot-simulator-helicopter");
        let (pattern, rng) = (self.pattern, &mut self.rng);
        let up = if pattern.is_planar() { 1 } else { 2 };
        let plain = Cable { length_scale: None, length_offset: None, ..robot.cables[0].clone() };
        let count = pattern.dof() + rng.random_range(0..4);
        robot.cables = (0..count)
            .map(|_| {
                let mut cable = plain.clone();
                cable.frame_anchor = Vector3::from_fn(|_, _| rng.random_range(-5.0..5.0));
                cable.platform_anchor = Vector3::from_fn(|_, _| rng.random_range(-0.5..0.5));
                if self.is_suspended {
                    cable.frame_anchor[up] = rng.random_range(4.0..5.0);
                }
                if pattern.is_planar() {
                    (cable.frame_anchor.z, cable.platform_anchor.z) = (0.0, 0.0);
                }
                if pattern.dof() == pattern.translations() {
                    cable.platform_anchor = Vector3::zeros();
                }
                law(&mut cable, rng);
                cable
            })
            .collect();
        robot.motion_pattern = pattern;
        (robot.home, robot.travel) = (None, None);
        let model = Model::new(robot, Composition::ELASTIC).unwrap();
        let mut pose = model.robot().home_or_middle();
        pose.position[up] = 0.0;
        let pose = pose.displaced(&self.twist(&model, 1.0, 0.3));
        let mut wrench = Wrench::zeros();
        wrench[up] = -LOAD;
        (model, pose, Load::constant(wrench))
    }

    fn twist(&mut self, model: &Model, shift: f64, turn: f64) -> Twist {
        let translations = self.pattern.translations();
        let mut size =
            |index: usize| self.rng.random_range(-1.0..1.0) * if index < translations { shift } else { turn };
        model.twist_basis().iter().enumerate().map(|(index, direction)| direction * size(index)).sum()
    }
}

/// Wrench out of balance beside the forces at work, by the public formulas.
fn imbalance(model: &Model, lengths: &[f64], load: &Load, pose: &Pose) -> f64 {
    let tension = |cable: usize| {
        let length = model.path(cable, pose).unwrap().0.length;
        model.elasticity(cable).tension(length, lengths[cable]).value.max(0.0)
    };
    let tensions: Vec<f64> = (0..model.cable_count()).map(tension).collect();
    wrench_residual(model, pose, &tensions, load).unwrap().norm() / (LOAD + tensions.iter().sum::<f64>())
}

fn stiffness(cable: &mut Cable, axial_stiffness: f64) {
    cable.stiffness = Some(CableStiffness::Axial(axial_stiffness));
}

/// Cables of a hundredth of their length, cables a hundred million times as strong as the load, and cables a million times as
/// stiff as others beside them: all come to rest, in balance.
#[test]
fn extreme_cables_come_to_rest_in_balance() {
    const CASES: usize = 25;
    type Law = fn(&mut Cable, &mut ChaCha8Rng);
    let soft: Law = |cable, rng| stiffness(cable, LOAD * 10_f64.powf(rng.random_range(1.0..4.0)));
    let hard: Law = |cable, _| stiffness(cable, 1e8 * LOAD);
    let mixed: Law = |cable, rng| stiffness(cable, 1e3 * LOAD * if rng.random_bool(0.5) { 1e6 } else { 1.0 });
    let spring: Law =
        |cable, rng| cable.stiffness = Some(CableStiffness::Spring(LOAD * 10_f64.powf(rng.random_range(-1.0..2.0))));
    for (index, pattern) in PATTERNS.into_iter().enumerate() {
        for (name, law, fractions) in [
            ("long stretch", soft, 0.01..0.3),
            ("hard", hard, 0.999..1.0005),
            ("mixed", mixed, 0.999..1.0005),
            ("springs without free length", spring, 0.0005..0.02),
        ] {
            let mut robots = RandomRobots::new(pattern, index % 2 == 0, 31);
            let mut not_found = Vec::new();
            for case in 0..CASES {
                let (model, pose, load) = robots.draw(law);
                let lengths: Vec<f64> = model.cable_lengths(&pose).unwrap();
                let lengths: Vec<f64> =
                    lengths.iter().map(|length| length * robots.rng.random_range(fractions.clone())).collect();
                let solution = solve(&model, &lengths, &load, &pose, &Settings::default()).unwrap();
                if solution.status != Status::Converged {
                    not_found.push((case, solution.status, solution.reason));
                    continue;
                }
                let imbalance = imbalance(&model, &lengths, &load, &solution.pose);
                // 1e-7 by the settings; rounding of 5 m at 1e9 times the load
                assert!(imbalance < 3e-6, "{name}, {pattern:?}, case {case}: {imbalance:e} of the forces");
            }
            assert!(not_found.is_empty(), "{name}, {pattern:?}: {} of {CASES}, {not_found:?}", not_found.len());
        }
    }
}

/// The planar example wound up to a tenth of a metre: steps that damping makes short are no equilibrium, 13.5 kN were left.
#[test]
fn cables_wound_up_to_almost_nothing_come_to_rest_in_balance() {
    let robot = builtin("planar-example");
    let load = Load::of(&robot).unwrap();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let lengths = [0.1; 4];
    let solution = solve(&model, &lengths, &load, &model.robot().home_or_middle(), &Settings::default()).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.reason);
    assert!(imbalance(&model, &lengths, &load, &solution.pose) < 1e-10);
    assert!(solution.reason.unwrap().contains("is stretched by"));
}

/// The guess is up to 0.5 m and 17° beside the platform: straight down the energy, stiff cables end most of these searches early.
#[test]
fn stiff_suspended_robots_are_found_from_some_degrees_away() {
    for pattern in PATTERNS {
        let mut robots = RandomRobots::new(pattern, true, 32);
        let (mut found, cases) = (0, 40);
        for _ in 0..cases {
            let (model, pose, load) = robots.draw(|cable, _| stiffness(cable, 1e6 * LOAD));
            let lengths = model.cable_lengths(&pose).unwrap();
            let at_rest = solve(&model, &lengths, &load, &pose, &Settings::default()).unwrap();
            assert_eq!(at_rest.status, Status::Converged, "{pattern:?}: {:?}", at_rest.reason);
            let guess = at_rest.pose.displaced(&robots.twist(&model, 0.3, 0.3));
            let solution = solve(&model, &lengths, &load, &guess, &Settings::default()).unwrap();
            let error = distance(&solution.pose, &at_rest.pose, model.platform_radius());
            assert_eq!(solution.status, Status::Converged, "{pattern:?}: {:?}", solution.reason);
            found += usize::from(error < 1e-6);
        }
        // the others are stable too: where a platform hangs in two ways, a guess may be nearer to the other
        println!("{pattern:?}: {found} of {cases}");
        assert!(found >= cases - 2, "{pattern:?}: {found} of {cases}");
    }
}

/// Catenaries without stretch a thousandth longer than their chords, guesses some centimetres and degrees off.
#[test]
fn sagging_cables_that_do_not_stretch_come_to_rest() {
    const CASES: usize = 25;
    let mut robots = RandomRobots::new(MotionPattern::Spatial, true, 34);
    let mut not_found = Vec::new();
    for case in 0..CASES {
        let (model, pose, load) = robots.draw(|cable, _| {
            stiffness(cable, 1e6);
            cable.linear_density = Some(0.5);
        });
        let mut robot = model.robot().clone();
        robot.gravity = Some(Vector3::new(0.0, 0.0, -9.81));
        let lengths: Vec<f64> = model_of(&robot, "standard").cable_lengths(&pose).unwrap();
        let lengths: Vec<f64> = lengths.iter().map(|length| 1.001 * length).collect();
        let guess = pose.displaced(&robots.twist(&model, 0.05, 0.05));
        let sagging = model_of(&robot, "catenary");
        let solution = solve(&sagging, &lengths, &load, &guess, &Settings::default()).unwrap();
        if solution.status != Status::Converged {
            not_found.push((case, solution.status, solution.reason));
            continue;
        }
        // each cable held by its length: the same pulls, solved anew
        let wrench = (0..sagging.cable_count()).fold(load.wrench(&solution.pose), |sum, cable| {
            let input = cdpr_model::cable::CableInput::ControlledLength(lengths[cable]);
            let state = sagging.cable_state(cable, &solution.pose, input).unwrap();
            let pull = Vector3::from(state.pull);
            let moment = (solution.pose.rotation * sagging.robot().cables[cable].platform_anchor).cross(&pull);
            sum + Wrench::new(pull.x, pull.y, pull.z, moment.x, moment.y, moment.z)
        });
        // 1e-11 m at the stiffness of chords a thousandth shorter than their cables
        assert!(wrench.norm() < 1e-8 * LOAD, "case {case}: {wrench}");
    }
    // one search ends early and one where the platform would turn over; the status says so
    assert!(not_found.len() <= 2, "{not_found:?}");
}

fn model_of(robot: &Robot, composition: &str) -> Model {
    Model::new(robot.clone(), composition.parse::<Composition>().unwrap()).unwrap()
}

/// A platform on one vertical cable spins freely; a second one stops it where its slack ends, to one side only.
#[test]
fn a_platform_that_spins_on_one_cable_is_not_stable_where_another_ends_its_slack() {
    let mut rng = ChaCha8Rng::seed_from_u64(33);
    let mut ended_there = 0;
    for case in 0..60 {
        let mut robot = builtin("cablerobot-simulator-helicopter");
        robot.cables.truncate(2);
        let aside = Vector3::new(rng.random_range(1.0..4.0), rng.random_range(-4.0..4.0), rng.random_range(0.0..4.0));
        let rim = Vector3::new(0.5, 0.0, rng.random_range(-0.2..0.2));
        for (cable, a, b) in [(0, Vector3::new(0.0, 0.0, 5.0), Vector3::new(0.0, 0.0, 0.3)), (1, aside, rim)] {
            (robot.cables[cable].frame_anchor, robot.cables[cable].platform_anchor) = (a, b);
            stiffness(&mut robot.cables[cable], 1e5);
        }
        robot.home = None;
        let is_rigid = case % 2 == 0;
        let composition = if is_rigid { Composition::STANDARD } else { Composition::ELASTIC };
        let model = Model::new(robot, composition).unwrap();
        let load = Load::constant(Wrench::new(0.0, 0.0, -LOAD, 0.0, 0.0, 0.0));
        let spun = |angle: f64| Pose::from_xyz_angles(Vector3::zeros(), [0.0, 0.0, angle]);
        let to_aside = aside.y.atan2(aside.x);
        let (stops, starts) = (rng.random_range(0.3..1.5), rng.random_range(0.1..0.9));
        let mut lengths = model.cable_lengths(&spun(to_aside + stops)).unwrap();
        let guess = spun(to_aside + stops + starts);
        lengths[0] *= if is_rigid { 1.0 } else { 0.99 };
        let solution = solve(&model, &lengths, &load, &guess, &Settings::default()).unwrap();
        let pulls = solution.tensions[1] > 1e-6 * LOAD;
        ended_there += usize::from(!pulls);
        assert!(pulls || solution.status == Status::Singular, "case {case}: {solution:?}");
    }
    println!("{ended_there} of 60 end where the second cable is just taut");
    assert!(ended_there > 20, "{ended_there}");
}
