//! Every vector unit of the machine gives the same bits, in the library as users get it: `cargo xtask test` compiles the library's own tests
//! for the portable unit alone.
//!
//! One test: a limit holds for the whole process.
#![allow(clippy::unwrap_used, reason = "tests fail by panic")]

use cdpr::calibration::Loss;
use cdpr::calibration::fit::{self, optimal_parameters};
use cdpr::equilibrium::{Solutions, closed_form, elastostatics, feasibility, forward_kinematics};
use cdpr::geometry::{Pose, PoseBatch, Twist, Wrench};
use cdpr::measurement::Samples;
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::Vector3;
use cdpr::robot::{CableStiffness, Robot, builtin};
use cdpr::scalar::{LaneTable, Unit};
use cdpr::statics::Load;
use cdpr::tension::{Limits, quadratic};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A model and problems at random poses: not a whole number of eights.
struct Problems {
    model: Model,
    load: Load,
    poses: Vec<Pose>,
    guesses: PoseBatch,
    lengths: LaneTable,
}

impl Problems {
    /// Lengths a little too short or wrong, guesses near and far.
    fn of(model: Model, count: usize) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(17);
        let load = Load::of(model.robot()).unwrap_or(Load::constant(Wrench::new(0.0, 0.0, -500.0, 0.0, 0.0, 0.0)));
        let home = model.robot().home_or_middle();
        let mut problems = Self {
            load,
            poses: Vec::new(),
            guesses: PoseBatch::default(),
            lengths: LaneTable::new(model.cable_count()),
            model,
        };
        while problems.poses.len() < count {
            let mut twist = |size: f64| -> Twist {
                problems
                    .model
                    .twist_basis()
                    .iter()
                    .map(|direction| direction * (size * rng.random_range(-1.0..1.0)))
                    .sum()
            };
            let item = problems.poses.len();
            let pose = home.displaced(&twist(0.3));
            let guess = pose.displaced(&twist([0.03, 0.1, 0.1, 0.5][item % 4]));
            let Ok(mut lengths) = problems.model.cable_lengths(&pose) else { continue };
            let part = [0.0, 1e-3, 5e-3, 2e-2][item / 4 % 4];
            lengths.iter_mut().for_each(|length| *length *= 1.0 - part * rng.random_range(0.0..1.0));
            problems.lengths.resize(item + 1);
            problems.lengths.write(item, &lengths);
            problems.poses.push(pose);
            problems.guesses.push(&guess);
        }
        problems
    }

    fn numbers(&self, item: usize) -> Vec<f64> {
        let mut numbers = vec![0.0; self.model.cable_count()];
        self.lengths.read(item, &mut numbers);
        numbers
    }
}

/// Every built-in robot over points and over pulleys, rigid and (with a stiffness where its file has none) elastic.
fn problems(count: usize) -> Vec<Problems> {
    let mut all = Vec::new();
    for name in builtin::names() {
        let mut robot = Robot::builtin(name).unwrap();
        for cable in &mut robot.cables {
            cable.stiffness.get_or_insert(CableStiffness::Axial(4e5));
        }
        let pulleys = vec![(0.05, Vector3::z()); robot.cables.len()];
        let placed = place_pulleys(&robot, &pulleys, &robot.home_or_middle());
        let over_pulleys = [Composition::PULLEY, Composition::PULLEY_ELASTIC];
        let over_points = [Composition::STANDARD, Composition::ELASTIC];
        let robots = placed.ok().map(|placed| (placed, over_pulleys)).into_iter().chain([(robot, over_points)]);
        for (robot, compositions) in robots {
            all.extend(compositions.into_iter().filter_map(|composition| Model::new(robot.clone(), composition).ok()));
        }
    }
    all.into_iter().map(|model| Problems::of(model, count)).collect()
}

/// Numbers that one kind of work gave.
#[derive(Debug, Default, PartialEq)]
struct Bits(Vec<u64>);

impl Bits {
    fn add(&mut self, numbers: impl IntoIterator<Item = f64>) {
        // the sign and payload of a NaN depend on the instruction
        self.0.extend(numbers.into_iter().map(|x| if x.is_nan() { u64::MAX } else { x.to_bits() }));
    }

    fn add_pose(&mut self, pose: &Pose) {
        self.add(pose.position.iter().chain(pose.rotation.coords.iter()).copied());
    }
}

fn inverse(problems: &Problems) -> Bits {
    let (model, mut bits) = (&problems.model, Bits::default());
    let batch: PoseBatch = problems.poses.iter().collect();
    let mut table = LaneTable::default();
    model.batch_cable_lengths(&batch, &mut table);
    let mut numbers = vec![0.0; model.cable_count()];
    for item in 0..batch.len() {
        table.read(item, &mut numbers);
        bits.add(numbers.iter().copied());
    }
    model.batch_structure_matrices(&batch, &mut table);
    let mut numbers = vec![0.0; model.dof() * model.cable_count()];
    for (item, pose) in problems.poses.iter().enumerate() {
        table.read(item, &mut numbers);
        bits.add(numbers.iter().copied());
        if let Ok(matrix) = model.structure_matrix(pose) {
            bits.add(matrix.iter().copied());
        }
    }
    bits
}

fn forward(problems: &Problems) -> Bits {
    let mut bits = Bits::default();
    let settings = forward_kinematics::Settings { max_restarts: 1, ..forward_kinematics::Settings::default() };
    let mut solver = forward_kinematics::Solver::new(&problems.model, &settings).unwrap();
    let mut batch = Solutions::default();
    solver.solve_batch(&problems.lengths, &problems.guesses, &mut batch).unwrap();
    for item in 0..batch.len() {
        bits.add_pose(&batch.pose(item));
        bits.add([batch.residual_rms(item), f64::from(batch.iterations(item))]);
        let single = solver.solve(&problems.numbers(item), &problems.guesses.get(item)).unwrap();
        bits.add_pose(&single.pose);
    }
    bits
}

fn elastic(problems: &Problems) -> Bits {
    let mut bits = Bits::default();
    let settings = elastostatics::Settings { max_restarts: 1, ..elastostatics::Settings::default() };
    let mut solver = elastostatics::Solver::new(&problems.model, &problems.load, &settings).unwrap();
    let mut batch = Solutions::default();
    solver.solve_batch(&problems.lengths, &problems.guesses, &mut batch).unwrap();
    for item in 0..batch.len() {
        bits.add_pose(&batch.pose(item));
        bits.add((0..problems.model.cable_count()).map(|cable| batch.tension(cable, item)));
        let single = solver.solve(&problems.numbers(item), &problems.guesses.get(item)).unwrap();
        bits.add_pose(&single.pose);
    }
    bits
}

/// In closed form for a whole batch, feasible or not in lanes, and the programme of single poses.
fn tensions(problems: &Problems) -> Bits {
    let (model, load, mut bits) = (&problems.model, &problems.load, Bits::default());
    let cables = model.cable_count();
    let limits = Limits::uniform(cables, 100.0, 9000.0).unwrap();
    let mut answers = vec![false; problems.poses.len()];
    feasibility::feasible(model, load, &limits, &problems.poses, &mut answers).unwrap();
    bits.add(answers.into_iter().map(|answer| f64::from(u8::from(answer))));
    if cables < model.dof() {
        return bits;
    }
    let mut batch = LaneTable::default();
    if closed_form::solve_batch(model, load, &limits, &problems.poses.iter().collect(), &mut batch).is_ok() {
        for item in 0..problems.poses.len() {
            bits.add((0..cables).map(|cable| batch.get(cable, item)));
        }
    }
    let mut programme = quadratic::Solver::new(cables, model.dof());
    for pose in &problems.poses {
        let Ok(matrix) = model.structure_matrix(pose) else { continue };
        programme.forget();
        let answer = programme.solve(&matrix, load.in_pattern(model, pose).as_slice(), &limits, None).unwrap();
        bits.add(answer.tensions.iter().copied());
    }
    bits
}

/// Anchors and offsets of a rigid robot from its lengths.
fn identified(problems: &Problems) -> Bits {
    let mut bits = Bits::default();
    let lengths = (0..problems.poses.len()).flat_map(|item| problems.numbers(item)).collect();
    let samples = Samples {
        poses: problems.poses.clone(),
        lengths,
        cable_count: problems.model.cable_count(),
        ..Samples::default()
    };
    let settings = fit::Settings { max_iterations: 20, loss: Loss::Squared, ..fit::Settings::default() };
    for free in ["length-offset", "frame-anchor", "frame-anchor,platform-anchor,length-offset"] {
        if let Ok(optimum) = optimal_parameters(&problems.model, &samples, &free.parse().unwrap(), &settings) {
            bits.add(optimum.history);
            for cable in &optimum.model.robot().cables {
                bits.add(cable.frame_anchor.iter().chain(&cable.platform_anchor).copied().chain(cable.length_offset));
            }
        }
    }
    bits
}

fn all_bits(problems: &[Problems]) -> Vec<(String, Bits)> {
    let mut all = Vec::new();
    for problem in problems {
        let mut add = |work: &str, bits: Bits| {
            all.push((format!("{work} of {}, {}", problem.model.robot().name, problem.model.composition()), bits));
        };
        add("lengths and structure matrices", inverse(problem));
        if problem.model.composition().is_elastic() {
            add("equilibria", elastic(problem));
        } else {
            add("poses", forward(problem));
            add("tensions", tensions(problem));
            add("parameters", identified(problem));
        }
    }
    all
}

#[test]
fn every_unit_gives_the_bits_of_the_portable_one() {
    let problems = problems(45);
    let units: Vec<Unit> = Unit::available().collect();
    Unit::limit(Unit::Portable);
    let expected = all_bits(&problems);
    let count: usize = expected.iter().map(|(_, bits)| bits.0.len()).sum();
    assert!(expected.len() > 50 && count > 50_000, "{} kinds of work, {count} numbers", expected.len());
    for unit in units {
        Unit::limit(unit);
        assert_eq!(Unit::widest(), unit);
        for ((what, bits), (_, expected)) in all_bits(&problems).into_iter().zip(&expected) {
            assert!(bits == *expected, "{what}: {unit:?} gives other bits than the portable unit");
        }
    }
}
