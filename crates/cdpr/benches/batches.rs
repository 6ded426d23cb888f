//! Batches over many poses against a loop over single poses, CableRobot Simulator (m = 8, n = 6):
//! `cargo bench -p cdpr --bench batches`.
//!
//! Prints CPU time per pose and its ratio to the loop in the same run: rounds take turns, the median counts.

use std::hint::black_box;
use std::time::Instant;

use cdpr::equilibrium::feasibility;
use cdpr::geometry::{Pose, PoseBatch, Wrench};
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::Vector3;
use cdpr::robot::Robot;
use cdpr::scalar::LaneTable;
use cdpr::statics::Load;
use cdpr::tension::{Limits, quadratic};

const ROUNDS: usize = 15;
const POSES: usize = 4096;

/// Median nanoseconds per pose of each candidate; they take turns.
fn medians(poses: usize, candidates: &mut [&mut dyn FnMut()]) -> Vec<f64> {
    let mut times = vec![Vec::new(); candidates.len()];
    for _ in 0..ROUNDS {
        for (candidate, times) in candidates.iter_mut().zip(&mut times) {
            let start = Instant::now();
            candidate();
            times.push(start.elapsed().as_secs_f64() * 1e9 / poses as f64);
        }
    }
    for times in &mut times {
        times.sort_by(f64::total_cmp);
    }
    times.iter().map(|times| times[ROUNDS / 2]).collect()
}

/// One line of the table: the batch, its goal, and how many times the loop takes.
#[expect(clippy::print_stdout, reason = "the table is what the bench is for")]
fn report(name: &str, goal: f64, poses: usize, batch: &mut dyn FnMut(), single: &mut dyn FnMut()) {
    let times = medians(poses, &mut [batch, single]);
    let (batch, single) = (times[0], times[1]);
    println!("{name:36} {batch:9.1} ns (goal {goal:6.1})   one by one {single:9.1} ns   ×{:.1}", single / batch);
}

fn poses() -> Vec<Pose> {
    let pose = |k: usize| {
        let t = k as f64;
        let position = Vector3::new(2.0 * t.sin(), 2.0 * (1.3 * t).cos(), 2.5 + 2.0 * (0.7 * t).sin());
        Pose::from_xyz_angles(position, [0.15 * (0.9 * t).sin(), 0.15 * t.cos(), 0.15 * (0.4 * t).sin()])
    };
    (0..POSES).map(pose).collect()
}

fn geometry(name: &str, model: &Model, goals: [f64; 2]) {
    let poses = poses();
    let batch: PoseBatch = poses.iter().collect();
    let (mut lengths, mut matrices) = (LaneTable::default(), LaneTable::default());
    let mut one_length = || {
        poses.iter().for_each(|pose| {
            black_box(model.cable_lengths(black_box(pose))).expect("courses");
        });
    };
    let mut all = || model.batch_cable_lengths(black_box(&batch), &mut lengths);
    report(&format!("cable lengths, {name}"), goals[0], POSES, &mut all, &mut one_length);
    let mut one_matrix = || {
        poses.iter().for_each(|pose| {
            black_box(model.structure_matrix(black_box(pose))).expect("courses");
        });
    };
    // as many as stay in the cache, which is how they are used
    let part: PoseBatch = poses[..64].iter().collect();
    let mut all = || {
        for _ in 0..POSES / 64 {
            model.batch_structure_matrices(black_box(&part), &mut matrices);
        }
    };
    report(&format!("structure matrix, {name}"), goals[1], POSES, &mut all, &mut one_matrix);
}

/// A grid of `side`³ positions with the home orientation.
fn grid(side: usize) -> Vec<Pose> {
    let at = |k: usize, least: f64, most: f64| least + (most - least) * k as f64 / (side - 1) as f64;
    let cells = (0..side).flat_map(move |i| (0..side).flat_map(move |j| (0..side).map(move |k| [i, j, k])));
    let position = |[i, j, k]: [usize; 3]| Vector3::new(at(i, -4.0, 4.0), at(j, -5.0, 5.0), at(k, 0.0, 5.5));
    cells.map(|cell| Pose { position: position(cell), ..Pose::identity() }).collect()
}

#[expect(clippy::print_stdout, reason = "the table is what the bench is for")]
fn feasible(model: &Model) {
    let load = Load::constant(Wrench::new(0.0, 0.0, -7500.0, 0.0, -600.0, 0.0));
    let limits = Limits::uniform(8, 1000.0, 9000.0).expect("in order");
    let poses = grid(50);
    let mut answers = vec![false; poses.len()];
    let mut exact = vec![false; poses.len()];
    let mut all = || feasibility::feasible(model, &load, &limits, black_box(&poses), &mut answers).expect("fits");
    let mut solver = quadratic::Solver::new(8, 6);
    let mut single = || {
        for (pose, answer) in poses.iter().zip(&mut exact) {
            let matrix = model.structure_matrix(pose).expect("courses");
            solver.forget();
            let found = solver.solve(&matrix, load.in_pattern(model, pose).as_slice(), &limits, None).expect("fits");
            *answer = found.status == quadratic::Status::Feasible;
        }
    };
    report("wrench-feasible, grid 50³", 200.0, poses.len(), &mut all, &mut single);
    assert_eq!(answers, exact);
    println!("{:36} {} of {}", "", answers.iter().filter(|answer| **answer).count(), answers.len());
}

fn main() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").expect("built in");
    let pulleys = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).expect("placed");
    let standard = Model::new(robot, Composition::STANDARD).expect("a model");
    let pulley = Model::new(pulleys, Composition::PULLEY).expect("a model");
    geometry("points", &standard, [22.0, 35.0]);
    geometry("pulleys", &pulley, [60.0, 80.0]);
    feasible(&standard);
}
