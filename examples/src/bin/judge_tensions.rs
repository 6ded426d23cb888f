//! Tensions for other programs to judge (`cargo xtask judge`): exact quadratic programmes with our answers and times as JSON.
//!
//! `judge_tensions FILE` writes them; without a file they are computed and counted only.

use std::hint::black_box;
use std::time::Instant;

use cdpr::geometry::{Pose, Wrench};
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::{DMatrix, Vector3};
use cdpr::robot::Robot;
use cdpr::statics::Load;
use cdpr::tension::Limits;
use cdpr::tension::quadratic::{Solver, Status};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

type Failure = Box<dyn std::error::Error>;

const POSES: usize = 400;
/// (N)
const LIMITS: [f64; 2] = [1000.0, 9000.0];

fn main() -> Result<(), Failure> {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").ok_or("the robot is not built in")?;
    let model = Model::new(robot, Composition::STANDARD)?;
    let load = Load::constant(Wrench::new(0.0, 0.0, -7500.0, 0.0, -600.0, 0.0));
    let limits = Limits::uniform(8, LIMITS[0], LIMITS[1])?;
    let mut rng = ChaCha8Rng::seed_from_u64(6);
    let mut problems = Vec::new();
    for _ in 0..POSES {
        let mut vector = |size: f64| Vector3::from_fn(|_, _| size * rng.random_range(-1.0..1.0));
        let position = Vector3::new(0.0, 0.0, 2.5) + vector(2.0);
        let pose = Pose::from_xyz_angles(position, vector(0.17).into());
        problems.push((model.structure_matrix(&pose)?, load.in_pattern(&model, &pose)));
    }
    let mut solver = Solver::new(8, 6);
    let mut cases: Vec<Value> = Vec::new();
    for (matrix, wrench) in &problems {
        solver.forget();
        let found = solver.solve(matrix, wrench.as_slice(), &limits, None)?;
        let tensions = (found.status == Status::Feasible).then(|| found.tensions.clone());
        let rows: Vec<Vec<f64>> = matrix.row_iter().map(|row| row.iter().copied().collect()).collect();
        let time = nanoseconds(&mut solver, matrix, wrench.as_slice(), &limits)?;
        cases.push(json!({ "matrix": rows, "wrench": wrench.as_slice(), "tensions": tensions, "nanoseconds": time }));
    }
    if let Some(file) = std::env::args_os().nth(1) {
        std::fs::write(file, json!({ "limits": LIMITS, "cases": cases }).to_string())?;
    }
    Ok(())
}

/// Time of one cold solution, the least of some rounds: what other work on the machine takes is not counted.
fn nanoseconds(solver: &mut Solver, matrix: &DMatrix<f64>, wrench: &[f64], limits: &Limits) -> Result<f64, Failure> {
    const REPETITIONS: u32 = 20;
    let mut least = f64::INFINITY;
    for _ in 0..20 {
        let start = Instant::now();
        for _ in 0..REPETITIONS {
            solver.forget();
            black_box(solver.solve(black_box(matrix), wrench, limits, None)?.status);
        }
        least = least.min(start.elapsed().as_secs_f64() * 1e9 / f64::from(REPETITIONS));
    }
    Ok(least)
}
