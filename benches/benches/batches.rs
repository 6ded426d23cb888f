//! Batches over many poses against a loop over single poses, CableRobot Simulator (m = 8, n = 6):
//! `cargo bench -p benches --bench batches`.
//!
//! Prints the time per pose beside the goal of a quiet machine, and how many times as long the loop takes in the same run. One
//! thread, the wall clock; candidates take turns in short rounds. The median of rounds is what the machine gave, their least
//! (`best`) what it gives with nothing else on it. The first line compares one thread with all of them, the last two the
//! grids of 50³ and 100³ poses, and an octree with the grid.

mod clock;

use std::hint::black_box;

use cdpr::equilibrium::{Solutions, closed_form, distribution, elastostatics, feasibility, forward_kinematics};
use cdpr::geometry::{Pose, PoseBatch, Twist, Wrench};
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::{UnitQuaternion, Vector3};
use cdpr::robot::Robot;
use cdpr::scalar::LaneTable;
use cdpr::statics::Load;
use cdpr::tension::{self, Limits, quadratic};
use cdpr::workspace::criterion::WrenchFeasible;
use cdpr::workspace::grid::{self, Grid};
use cdpr::workspace::{Archetype, Bounds, Region, octree};
use clock::{Time, times};

const ROUNDS: usize = 9;
/// Rounds of each batch, and how long one lasts at least (s): short enough that some are left alone on a busy machine.
const SHORT_ROUNDS: usize = 301;
const SHORT: f64 = 0.0005;
const POSES: usize = 4096;

/// One line of the table: the batch, its goal, and how many times the loop takes.
#[expect(clippy::print_stdout, reason = "the table is what the bench is for")]
fn report(name: &str, goal: f64, poses: usize, batch: &mut dyn FnMut(), single: &mut dyn FnMut()) {
    let rounds = (SHORT_ROUNDS * POSES / poses).max(ROUNDS);
    let times = times(poses, rounds, SHORT, &mut [batch, single]);
    let (batch, single) = (times[0], times[1]);
    println!(
        "{name:36} {:9.1} ns, best {:8.1} (goal {goal:6.1})   one by one {:9.1} ns, best {:8.1}   ×{:.1}, best ×{:.1}",
        batch.median,
        batch.best,
        single.median,
        single.best,
        single.median / batch.median,
        single.best / batch.best
    );
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
    let mut from_slice = PoseBatch::default();
    let mut all = || {
        from_slice.fill(black_box(&poses));
        model.batch_cable_lengths(&from_slice, &mut lengths);
    };
    report(&format!("… from a slice of poses, {name}"), goals[0], POSES, &mut all, &mut one_length);
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

/// Lengths of an array of poses, as other languages hold it, against the kernel on chunks that lie side by side already.
#[expect(clippy::print_stdout, reason = "the table is what the bench is for")]
fn rows(name: &str, model: &Model) {
    let poses = poses();
    let quaternions: Vec<[f64; 7]> = poses.iter().map(Pose::numbers).collect();
    let angles: Vec<[f64; 6]> = poses
        .iter()
        .map(|pose| {
            let ([x, y, z], [i, j, k]) = (pose.position.into(), pose.xyz_angles());
            [x, y, z, i, j, k]
        })
        .collect();
    let chunk: PoseBatch = poses[..512].iter().collect();
    let (mut table, mut filled) = (LaneTable::default(), PoseBatch::default());
    let mut lengths = vec![0.0; 8 * POSES];
    let mut more = lengths.clone();
    let mut kernel = || {
        for _ in 0..POSES / 512 {
            model.batch_cable_lengths(black_box(&chunk), &mut table);
        }
    };
    let mut of_rows = || model.lengths_of_rows(black_box(&quaternions[..]).into(), &mut lengths).expect("poses");
    let mut of_angles = || model.lengths_of_rows(black_box(&angles[..]).into(), &mut more).expect("poses");
    let mut fill = || {
        for rows in quaternions.chunks(512) {
            filled.fill_rows(black_box(rows)).expect("poses");
        }
    };
    let times = times(POSES, SHORT_ROUNDS, SHORT, &mut [&mut kernel, &mut of_rows, &mut of_angles, &mut fill]);
    println!(
        "lengths of rows, {name:20} kernel {:.1} ns; rows of quaternions {:.1} ns, ×{:.2}, best ×{:.2} (goal ×1.3); of angles \
         {:.1} ns, ×{:.2}; rows in alone {:.1} ns",
        times[0].median,
        times[1].median,
        times[1].median / times[0].median,
        times[1].best / times[0].best,
        times[2].median,
        times[2].median / times[0].median,
        times[3].median,
    );
}

/// Tensions by the exact method at many poses against one by one.
fn distributions(model: &Model) {
    let (load, limits) = load_and_limits();
    let poses = poses();
    let batch: PoseBatch = poses.iter().collect();
    let mut found = distribution::Distributions::default();
    let mut all = || {
        distribution::solve_batch(model, &load, &limits, tension::Method::Qp, black_box(&batch), &mut found)
            .expect("fits");
    };
    let mut single = distribution::Solver::new(model, &load, &limits);
    let mut one = || {
        poses.iter().for_each(|pose| drop(black_box(single.solve(black_box(pose))).expect("courses")));
    };
    report("exact tension distribution", 1000.0, POSES, &mut all, &mut one);
}

/// Guesses 0.1 m and 3° off.
fn guesses(poses: &[Pose]) -> PoseBatch {
    let along = Vector3::new(1.0, -1.0, 1.0).normalize();
    let (shift, turn) = (0.1 * along, 3.0_f64.to_radians() * along);
    let twist = Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z);
    poses.iter().map(|pose| pose.displaced(&twist)).collect::<Vec<_>>().iter().collect()
}

fn forward(name: &str, model: &Model, goal: f64) {
    let (poses, mut table) = (poses(), LaneTable::default());
    model.batch_cable_lengths(&poses.iter().collect(), &mut table);
    let guesses = guesses(&poses);
    let settings = forward_kinematics::Settings::default();
    let mut solver = forward_kinematics::Solver::new(model, &settings).expect("settings");
    let mut single = forward_kinematics::Solver::new(model, &settings).expect("settings");
    let mut solutions = Solutions::default();
    let mut all = || solver.solve_batch(black_box(&table), &guesses, &mut solutions).expect("lengths");
    let mut lengths = [0.0; 8];
    let mut one = || {
        for item in 0..POSES {
            table.read(item, &mut lengths);
            black_box(single.solve(&lengths, &guesses.get(item)).expect("lengths").iterations);
        }
    };
    report(&format!("forward kinematics, {name}"), goal, POSES, &mut all, &mut one);
}

fn elastic(name: &str, model: &Model, goal: f64) {
    let (poses, mut table) = (poses(), LaneTable::default());
    let load = Load::constant(Wrench::new(0.0, 0.0, -3000.0, 0.0, -100.0, 0.0));
    model.batch_cable_lengths(&poses.iter().collect(), &mut table);
    let mut lengths = [0.0; 8];
    for item in 0..POSES {
        table.read(item, &mut lengths);
        lengths.iter_mut().for_each(|length| *length -= 0.06);
        table.write(item, &lengths);
    }
    let guesses = guesses(&poses);
    let settings = elastostatics::Settings::default();
    let mut solver = elastostatics::Solver::new(model, &load, &settings).expect("settings");
    let mut single = elastostatics::Solver::new(model, &load, &settings).expect("settings");
    let mut solutions = Solutions::default();
    let mut all = || solver.solve_batch(black_box(&table), &guesses, &mut solutions).expect("lengths");
    let mut one = || {
        for item in 0..POSES {
            table.read(item, &mut lengths);
            black_box(single.solve(&lengths, &guesses.get(item)).expect("lengths").iterations);
        }
    };
    report(&format!("elastostatic forward, {name}"), goal, POSES, &mut all, &mut one);
}

fn load_and_limits() -> (Load, Limits) {
    let load = Load::constant(Wrench::new(0.0, 0.0, -7500.0, 0.0, -600.0, 0.0));
    (load, Limits::uniform(8, 1000.0, 9000.0).expect("in order"))
}

fn tensions(model: &Model) {
    let (load, limits) = load_and_limits();
    let poses = poses();
    let batch: PoseBatch = poses.iter().collect();
    let mut tensions = LaneTable::default();
    let mut all = || closed_form::solve_batch(model, &load, &limits, black_box(&batch), &mut tensions).expect("fits");
    let mut one = || {
        for pose in &poses {
            let matrix = model.structure_matrix(pose).expect("courses");
            let wrench = load.in_pattern(model, pose);
            drop(black_box(tension::closed_form::solve(&matrix, wrench.as_slice(), &limits)).expect("fits"));
        }
    };
    report("closed form with structure matrix", 75.0, POSES, &mut all, &mut one);
}

/// A grid of `side`³ positions with the home orientation.
fn grid(side: usize) -> Vec<Pose> {
    let at = |k: usize, least: f64, most: f64| least + (most - least) * k as f64 / (side - 1) as f64;
    let cells = (0..side).flat_map(move |i| (0..side).flat_map(move |j| (0..side).map(move |k| [i, j, k])));
    let position = |[i, j, k]: [usize; 3]| Vector3::new(at(i, -4.0, 4.0), at(j, -5.0, 5.0), at(k, 0.0, 5.5));
    cells.map(|cell| Pose { position: position(cell), ..Pose::identity() }).collect()
}

fn feasible(model: &Model) {
    let (load, limits) = load_and_limits();
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
    let fine = grid(100);
    let mut fine_answers = vec![false; fine.len()];
    let mut all_fine =
        || feasibility::feasible(model, &load, &limits, black_box(&fine), &mut fine_answers).expect("fits");
    let mut all = || feasibility::feasible(model, &load, &limits, black_box(&poses), &mut answers).expect("fits");
    growth(&times(1, ROUNDS, SHORT, &mut [&mut all, &mut all_fine]));
}

/// How the time of a grid grows with its points: eight times as many should not take more than 8.2 times as long.
#[expect(clippy::print_stdout, reason = "the table is what the bench is for")]
fn growth(times: &[Time]) {
    let [coarse, fine] = times else { return };
    println!(
        "grid 50³ {:.1} ms, best {:.1}; grid 100³ {:.1} ms, best {:.1}; ×{:.2}, best ×{:.2} (goal ×8.2)",
        coarse.median * 1e-6,
        coarse.best * 1e-6,
        fine.median * 1e-6,
        fine.best * 1e-6,
        fine.median / coarse.median,
        fine.best / coarse.best
    );
}

/// An octree against the grid of its smallest cells, 100 along the longest side of a box that reaches a quarter of its longest side
/// beyond that around the robot; one thread.
#[expect(clippy::print_stdout, reason = "the table is what the bench is for")]
fn refined(model: &Model) {
    let (load, limits) = load_and_limits();
    let criterion = WrenchFeasible::new(model, &load, &limits).expect("fits");
    let upright = Archetype::ConstantOrientation(UnitQuaternion::identity());
    let region = Region::new(model, &criterion, &upright).expect("an orientation");
    let around = Bounds::around(model).expect("a box");
    let further = 0.25 * (0..3).map(|axis| around.extent(axis)).fold(0.0, f64::max);
    let ends: Vec<f64> = around.ends().chunks(2).flat_map(|ends| [ends[0] - further, ends[1] + further]).collect();
    let bounds = Bounds::new(3, &ends).expect("a box");
    let longest = (0..3).map(|axis| bounds.extent(axis)).fold(0.0, f64::max);
    let cells = Grid::new(&bounds, longest / 100.0).expect("a grid");
    let settings = octree::Settings::new(longest / 100.0);
    let found = octree::solve(&region, &bounds, &settings).expect("cells");
    let mut tree = || {
        black_box(octree::solve(&region, &bounds, &settings)).expect("cells");
    };
    let mut all = || {
        black_box(grid::count(&region, &cells));
    };
    let times = times(1, ROUNDS, SHORT, &mut [&mut tree, &mut all]);
    let times: Vec<f64> = times.iter().map(|time| time.median * 1e-6).collect();
    println!(
        "octree {:.1} ms ({} points), grid {:.1} ms ({} points), ×{:.1} (goal ×10)",
        times[0],
        found.points,
        times[1],
        cells.points(),
        times[1] / times[0]
    );
}

/// The grid of 100³ by all threads against one, by the wall clock: the best of some runs each.
#[expect(clippy::print_stdout, reason = "the table is what the bench is for")]
fn threads(model: &Model) {
    let (load, limits) = load_and_limits();
    let poses = grid(100);
    let mut answers = vec![false; poses.len()];
    let mut best = [f64::INFINITY; 2];
    let all = std::thread::available_parallelism().map_or(1, usize::from);
    for _ in 0..ROUNDS {
        for (best, threads) in best.iter_mut().zip([1, all]) {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            let start = std::time::Instant::now();
            pool.install(|| feasibility::feasible(model, &load, &limits, &poses, &mut answers)).expect("fits");
            *best = best.min(start.elapsed().as_secs_f64() * 1e3);
        }
    }
    println!("grid 100³: one thread {:.1} ms, {all} threads {:.1} ms, ×{:.2}", best[0], best[1], best[0] / best[1]);
}

fn main() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").expect("built in");
    let pulleys = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).expect("placed");
    let standard = Model::new(robot, Composition::STANDARD).expect("a model");
    let pulley = Model::new(pulleys, Composition::PULLEY).expect("a model");
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").expect("built in");
    let elastic_model = Model::new(robot, Composition::ELASTIC).expect("a model");
    threads(&standard);
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().expect("the first pool");
    geometry("points", &standard, [22.0, 35.0]);
    geometry("pulleys", &pulley, [60.0, 80.0]);
    rows("points", &standard);
    rows("pulleys", &pulley);
    distributions(&standard);
    forward("points", &standard, 300.0);
    forward("pulleys", &pulley, 500.0);
    elastic("points", &elastic_model, 800.0);
    tensions(&standard);
    feasible(&standard);
    refined(&standard);
}
