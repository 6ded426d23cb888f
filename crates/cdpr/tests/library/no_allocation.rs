//! Hot paths claim no memory: an allocator that counts, per thread.
#![expect(unsafe_code, reason = "an allocator can only be replaced by unsafe code; this one passes every call on")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use cdpr::calibration::fit::{self, optimal_parameters};
use cdpr::equilibrium::{self, State, closed_form, elastostatics, feasibility, forward_kinematics};
use cdpr::geometry::{Pose, PoseBatch, Twist, Wrench};
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::Vector3;
use cdpr::plant::events::CableBreak;
use cdpr::plant::{Command, Plant, Winches};
use cdpr::reading::Keyword;
use cdpr::robot::Robot;
use cdpr::scalar::LaneTable;
use cdpr::statics::Load;
use cdpr::tension::quadratic::{self, Status};
use cdpr::tension::{self, Limits, Method, Options, Reference};

use super::dense;

struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call goes to the system's allocator unchanged; counting touches a constant-initialised cell only.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Allocations of this thread while `work` runs.
fn allocations(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.get();
    work();
    ALLOCATIONS.get() - before
}

#[test]
fn a_reused_forward_kinematics_solver_allocates_nothing() {
    let (model, samples) = dense::problem();
    let settings = forward_kinematics::Settings::default();
    let mut solver = forward_kinematics::Solver::new(&model, &settings).unwrap();
    let twist = Twist::new(0.06, -0.06, 0.06, 0.03, 0.03, -0.03);
    let work = || {
        for (sample, pose) in samples.poses.iter().enumerate() {
            let solution = solver.solve(samples.lengths_of(sample), &pose.displaced(&twist)).unwrap();
            assert_eq!(solution.status, forward_kinematics::Status::Converged);
        }
    };
    assert_eq!(allocations(work), 0);
}

#[test]
fn a_reused_elastostatic_solver_allocates_nothing() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let (_, samples) = dense::problem();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let load = Load::constant(Wrench::new(0.0, 0.0, -5000.0, 0.0, 100.0, 0.0));
    let mut solver = elastostatics::Solver::new(&model, &load, &elastostatics::Settings::default()).unwrap();
    let lengths: Vec<Vec<f64>> = samples
        .poses
        .iter()
        .map(|pose| model.cable_lengths(pose).unwrap().iter().map(|length| length - 0.02).collect())
        .collect();
    let twist = Twist::new(0.06, -0.06, 0.06, 0.03, 0.03, -0.03);
    let work = || {
        for (lengths, pose) in lengths.iter().zip(&samples.poses) {
            let solution = solver.solve(lengths, &pose.displaced(&twist)).unwrap();
            assert_eq!(solution.status, elastostatics::Status::Converged);
        }
    };
    assert_eq!(allocations(work), 0);
}

/// Both doors, for every kind of cable, once the state has answered before; a robot whose load is unknown too.
#[test]
fn a_reused_state_allocates_nothing() {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    for cable in &mut robot.cables {
        cable.linear_density = Some(0.1);
        cable.tension_of_strain = Some(vec![2e6, 2e8]);
    }
    let unloaded = Robot { gravity: None, external_wrench: None, ..robot.clone() };
    assert!(Load::of(&unloaded).is_err());
    let (_, samples) = dense::problem();
    let cases = ["standard", "elastic", "polynomial", "elastic+catenary"].map(|words| (&robot, words));
    for (robot, words) in cases.into_iter().chain([(&unloaded, "standard")]) {
        let model = Model::new(robot.clone(), words.parse().unwrap()).unwrap();
        let load = Load::constant(Wrench::new(0.0, 0.0, -5000.0, 0.0, 100.0, 0.0));
        let load = model.needs_tensions().then_some(&load);
        let mut state = State::at_home(&model);
        let mut lengths = vec![0.0; 8];
        let mut answer = |pose: &Pose| {
            let command = model.inverse(pose, &[4000.0; 8], &mut state).unwrap();
            assert!(command.failures.is_empty());
            lengths.iter_mut().zip(&command.cables).for_each(|(length, cable)| *length = cable.controlled_length);
            let solution = model.forward(&lengths, load, Some(pose), &mut state).unwrap();
            assert_eq!(solution.status, equilibrium::Status::Converged, "{words}");
            state.settle_forward(&model);
        };
        let home = robot.home_or_middle();
        let pose =
            |sample: &Pose| Pose { position: home.position + sample.rotation * Vector3::new(0.1, 0.0, 0.0), ..home };
        answer(&home);
        let work = || samples.poses.iter().take(20).for_each(|sample| answer(&pose(sample)));
        assert_eq!(allocations(work), 0, "{words}");
    }
}

/// Lengths, structure matrix and tensions in closed form of one pose after the other, over points and over pulleys.
#[test]
fn single_poses_in_a_reused_state_allocate_nothing() {
    let (standard, samples) = dense::problem();
    let pulleys = vec![(0.161, Vector3::z()); 8];
    let robot = place_pulleys(standard.robot(), &pulleys, &standard.robot().home_or_middle()).unwrap();
    let over_pulleys = Model::new(robot, Composition::PULLEY).unwrap();
    let load = Load::constant(Wrench::new(0.0, 0.0, -5000.0, 0.0, 100.0, 0.0));
    let limits = Limits::uniform(8, 1000.0, 9000.0).unwrap();
    for model in [standard, over_pulleys] {
        let mut state = State::at_home(&model);
        let mut lengths = [0.0; 8];
        let mut answer = |pose: &Pose| {
            model.write_cable_lengths(pose, &mut lengths).unwrap();
            assert_eq!(model.structure_matrix_in(pose, &mut state).unwrap().ncols(), 8);
            let found = model.closed_form_tensions(pose, &load, &limits, &mut state).unwrap();
            assert!(found.balanced);
        };
        answer(&samples.poses[0]);
        assert_eq!(allocations(|| samples.poses.iter().for_each(&mut answer)), 0, "{}", model.composition());
    }
}

/// Feasible or not, cold or warm, and with a reference of its own.
#[test]
fn a_reused_quadratic_programme_allocates_nothing() {
    let (model, samples) = dense::problem();
    let limits = Limits::uniform(8, 1000.0, 9000.0).unwrap();
    let matrices: Vec<_> = samples.poses.iter().map(|pose| model.structure_matrix(pose).unwrap()).collect();
    let mut solver = quadratic::Solver::new(8, 6);
    let mut found = [0, 0];
    let work = || {
        for (case, matrix) in matrices.iter().enumerate() {
            for weight in [5e3, 4e4] {
                let wrench = [0.0, 0.0, -weight, 0.0, 100.0 * case as f64, 0.0];
                let reference = (case % 2 == 0).then_some([2000.0; 8]);
                let reference = reference.as_ref().map(|reference| reference.as_slice());
                match solver.solve(matrix, &wrench, &limits, reference).unwrap().status {
                    Status::Feasible => found[0] += 1,
                    _ => found[1] += 1,
                }
            }
            if case % 3 == 0 {
                solver.forget();
            }
        }
    };
    assert_eq!(allocations(work), 0);
    assert!(found[0] > 20 && found[1] > 20, "{found:?}");
}

/// Every method, feasible or not, near a reference and at a rate; the closed form by singular values apart.
#[test]
fn a_reused_solver_of_any_method_allocates_nothing() {
    let (model, samples) = dense::problem();
    let limits = Limits::uniform(8, 1000.0, 9000.0).unwrap();
    let matrices: Vec<_> = samples.poses.iter().map(|pose| model.structure_matrix(pose).unwrap()).collect();
    let lengths = [1.0, 1.0, 1.0, 0.8, 0.8, 0.8];
    for &method in Method::ALL {
        for p in [1.0, 2.0, 3.0].into_iter().filter(|p| method.least_p().is_none_or(|least| least <= *p)) {
            let mut solver = tension::Solver::new(method, 8, 6);
            let mut previous = [4000.0; 8];
            let mut found = [0, 0];
            let work = || {
                for (case, matrix) in matrices.iter().enumerate().take(30) {
                    for weight in [5e3, 4e4] {
                        let wrench = [0.0, 0.0, -weight, 0.0, 100.0 * case as f64, 0.0];
                        let before = previous;
                        let options = Options {
                            reference: Reference::Given(&[3000.0; 8]),
                            previous: Some(&before),
                            rates: (case % 3 == 0).then_some(&[5e4; 8]),
                            lengths: Some(&lengths),
                            p,
                            ..Options::default()
                        };
                        let answer = solver.solve(matrix, &wrench, &limits, &options).unwrap();
                        if answer.status == tension::Status::Feasible {
                            previous.copy_from_slice(&answer.tensions);
                            found[0] += 1;
                        } else {
                            found[1] += 1;
                        }
                    }
                }
            };
            assert_eq!(allocations(work), 0, "{method}, p = {p}");
            assert!(found[0] > 10 && found[1] > 10, "{method}: {found:?}");
        }
    }
}

/// The result is memory, but its amount depends neither on the steps taken nor on the number of samples.
#[test]
fn identification_allocates_for_its_result_and_not_for_its_steps() {
    let (model, samples) = dense::problem();
    let free = "frame-anchor,platform-anchor".parse().unwrap();
    let count = |max_iterations, samples: &_| {
        let settings = fit::Settings { max_iterations, ..fit::Settings::default() };
        let mut iterations = 0;
        let count =
            allocations(|| iterations = optimal_parameters(&model, samples, &free, &settings).unwrap().iterations);
        (count, iterations)
    };
    let half = samples.subset(&(0..45).collect::<Vec<_>>());
    let (one_step, _) = count(1, &samples);
    let (all_steps, iterations) = count(200, &samples);
    assert!(iterations > 2);
    assert_eq!(one_step, all_steps);
    assert_eq!(one_step, count(1, &half).0);
}

/// Sagging cables too: shapes, tangents and steps live in memory claimed before.
#[test]
fn a_reused_solver_of_sagging_cables_allocates_nothing() {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    robot.cables.iter_mut().for_each(|cable| cable.linear_density = Some(0.8));
    let model = Model::new(robot, "elastic+catenary".parse().unwrap()).unwrap();
    let load = Load::of(model.robot()).unwrap();
    let pose = model.robot().home_or_middle();
    let lengths = cdpr::statics::controlled_lengths(&model, &pose, &[4000.0; 8]).unwrap();
    let start = elastostatics::solve(&model, &lengths, &load, &pose, &elastostatics::Settings::default()).unwrap();
    let mut solver = elastostatics::Solver::new(&model, &load, &elastostatics::Settings::default()).unwrap();
    let guess = start.pose.displaced(&Twist::new(1e-3, -1e-3, 2e-3, 1e-3, 0.0, -1e-3));
    let work = || {
        for _ in 0..10 {
            let solution = solver.solve(&lengths, &guess).unwrap();
            assert_eq!((solution.status, solution.restarts), (elastostatics::Status::Converged, 0));
        }
    };
    assert_eq!(allocations(work), 0);
}

/// Batches small enough for one thread, asked a second time.
#[test]
fn a_repeated_batch_allocates_nothing() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let (_, samples) = dense::problem();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let load = Load::constant(Wrench::new(0.0, 0.0, -5000.0, 0.0, 100.0, 0.0));
    let limits = Limits::uniform(8, 1000.0, 9000.0).unwrap();
    let mut poses: PoseBatch = samples.poses.iter().collect();
    let (mut lengths, mut tables) = (LaneTable::default(), [LaneTable::default(), LaneTable::default()]);
    let mut kinematic = forward_kinematics::Solver::new(&model, &forward_kinematics::Settings::default()).unwrap();
    let mut elastic = elastostatics::Solver::new(&model, &load, &elastostatics::Settings::default()).unwrap();
    let mut verdicts = feasibility::Solver::new(&model, &load, &limits).unwrap();
    let (mut found, mut held) = (cdpr::equilibrium::Solutions::default(), cdpr::equilibrium::Solutions::default());
    let mut answers = vec![false; samples.poses.len()];
    let mut work = || {
        poses.fill(&samples.poses);
        model.batch_cable_lengths(&poses, &mut lengths);
        model.batch_structure_matrices(&poses, &mut tables[0]);
        closed_form::solve_batch(&model, &load, &limits, &poses, &mut tables[1]).unwrap();
        kinematic.solve_batch(&lengths, &poses, &mut found).unwrap();
        elastic.solve_batch(&lengths, &poses, &mut held).unwrap();
        verdicts.solve(&samples.poses, &mut answers).unwrap();
    };
    work();
    assert_eq!(allocations(work), 0);
}

/// Steps in time for every kind of cable, with dampers, drums and a broken cable.
#[test]
fn a_step_in_time_allocates_nothing() {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    robot.platform.center_of_mass = Some(Vector3::new(0.1, 0.0, 0.05));
    robot.platform.inertia = Some(cdpr::nalgebra::Matrix3::from_diagonal(&Vector3::new(117.0, 121.0, 62.5)));
    for cable in &mut robot.cables {
        cable.linear_density = Some(0.7);
        cable.tension_of_strain = Some(vec![1.5e6, 6e7]);
        cable.damping = Some(200.0);
        (cable.winch.radius, cable.winch.drum_inertia) = (Some(0.1525), Some(0.6));
    }
    let pose = robot.home_or_middle();
    let mut with_pulleys = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &pose).unwrap();
    for cable in &mut with_pulleys.cables {
        (cable.winch.coulomb_friction, cable.pulley_friction) = (Some(10.0), Some(0.03));
        (cable.winch.static_friction, cable.winch.stribeck_speed) = (Some(15.0), Some(0.3));
    }
    for (composition, winches) in [
        ("elastic", Winches::Ideal),
        ("elastic", Winches::Drums),
        ("pulley+elastic", Winches::Ideal),
        ("pulley+elastic", Winches::Drums),
        ("polynomial", Winches::Ideal),
        ("elastic+catenary", Winches::Ideal),
    ] {
        let composition: Composition = composition.parse().unwrap();
        let robot = if composition.pulley { &with_pulleys } else { &robot };
        let plant = Plant::new(Model::new(robot.clone(), composition).unwrap(), winches).unwrap();
        let tensions = [3678.0, 2169.0, 4250.0, 1708.0, 3985.0, 2394.0, 4715.0, 1684.0];
        let mut state = plant.at_rest(&pose, &tensions).unwrap();
        let mut told = plant.holding_torques(&state).unwrap();
        told.resize(8, 0.0);
        let lengths: Vec<f64> = state.cables.iter().map(|cable| cable.controlled_length - 0.001).collect();
        if composition.pulley {
            // cables go slack and taut
            state.set_twist(&Twist::new(0.5, -0.3, 0.2, 0.5, 0.8, -0.6));
        }
        let commands = match winches {
            Winches::Drums => Command::torques(&told),
            _ => Command::lengths(&lengths),
        };
        let work = || {
            for step in 0..20 {
                plant.step(&mut state, &commands, 1e-3).unwrap();
                if step == 10 {
                    plant.apply(&mut state, &CableBreak { cable: 1 });
                }
            }
        };
        assert_eq!(allocations(work), 0, "{composition}");
    }
}
