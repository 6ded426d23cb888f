//! Random problems of tension distribution on known and made-up robots.
#![allow(dead_code, reason = "each test file uses its own part")]

use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{Cable, Robot, builtin};
use cdpr_model::tension::Limits;
use cdpr_model::tension::quadratic::{self, Status};
use nalgebra::{DMatrix, DVector, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::distribution::Problem;
use super::support::{self, builtin as robot, random_direction, random_pose, within_pattern};

/// All built-in robots (redundancy 0, 1 and 2), and made-up ones with redundancy 0 to 6.
pub(crate) fn models() -> Vec<Model> {
    let mut rng = ChaCha8Rng::seed_from_u64(41);
    let mut robots: Vec<Robot> = builtin::names().map(robot).collect();
    for redundancy in 0..=6 {
        robots.push(made_up(&robot("planar-example"), 2 + redundancy, &mut rng));
        robots.push(made_up(&robot("kntu-planar"), 3 + redundancy, &mut rng));
        robots.push(made_up(&support::simulator(), 6 + redundancy, &mut rng));
    }
    robots.into_iter().map(|robot| Model::new(robot, Composition::STANDARD).expect("a model")).collect()
}

/// Cables from anywhere on a sphere to anywhere on a platform, in the plane of the robot that lends its motion pattern.
fn made_up(pattern: &Robot, cable_count: usize, rng: &mut ChaCha8Rng) -> Robot {
    let home = pattern.home.expect("has a home pose").position;
    let planar = pattern.motion_pattern != support::simulator().motion_pattern;
    let flat = |v: Vector3<f64>| if planar { Vector3::new(v.x, v.y, 0.0) } else { v };
    let platform = if pattern.cables.iter().any(|cable| cable.platform_anchor.norm() > 0.0) { 0.5 } else { 0.0 };
    let cable = |_| Cable {
        frame_anchor: home + flat(8.0 * random_direction(rng)),
        platform_anchor: flat(platform * random_direction(rng)),
        ..pattern.cables[0].clone()
    };
    let cables = (0..cable_count).map(cable).collect();
    Robot { name: format!("made up with {cable_count} cables"), cables, travel: None, ..pattern.clone() }
}

/// A random pose, limits and a load that tensions within or beyond the limits balance.
pub(crate) fn random_problem(model: &Model, rng: &mut ChaCha8Rng) -> Problem {
    let matrix = random_matrix(model, rng);
    let limits = random_limits(model, rng);
    random_load(matrix, limits, rng)
}

/// The same with these limits.
pub(crate) fn random_problem_within(model: &Model, limits: Limits, rng: &mut ChaCha8Rng) -> Problem {
    random_load(random_matrix(model, rng), limits, rng)
}

fn random_matrix(model: &Model, rng: &mut ChaCha8Rng) -> DMatrix<f64> {
    let home: Pose = model.robot().home.expect("has a home pose");
    loop {
        let pose = within_pattern(model, &home, &random_pose(model.robot(), 0.2, rng));
        if let Ok(matrix) = model.structure_matrix(&pose) {
            return matrix;
        }
    }
}

fn random_load(matrix: DMatrix<f64>, limits: Limits, rng: &mut ChaCha8Rng) -> Problem {
    let reach = rng.random_range(0.0..4.0);
    let away = DVector::from_fn(limits.cable_count(), |cable, _| {
        0.5 * reach * rng.random_range(-1.0..1.0) * (limits.maximum()[cable] - limits.minimum()[cable])
    });
    let middle = DVector::from_fn(limits.cable_count(), |cable, _| limits.middle(cable));
    let problem = |part: f64| {
        let wrench = -(&matrix * (&middle + part * &away));
        Problem { matrix: matrix.clone(), wrench: wrench.as_slice().to_vec(), limits: limits.clone() }
    };
    if rng.random_ratio(9, 10) {
        return problem(1.0);
    }
    // one in ten is near the boundary, on either side
    let beyond = 10_f64.powf(rng.random_range(-5.0..-2.0)) * if rng.random() { 1.0 } else { -1.0 };
    problem(edge(&problem) * (1.0 + beyond))
}

/// Where the loads of this ray stop being feasible, to 1e-7.
fn edge(problem: &impl Fn(f64) -> Problem) -> f64 {
    let is_feasible = |part| {
        let Problem { matrix, wrench, limits } = problem(part);
        quadratic::solve(&matrix, &wrench, &limits, None).expect("fits").status == Status::Feasible
    };
    let (mut inside, mut outside) = (0.0, 10.0);
    while outside - inside > 1e-7 * outside {
        let middle = 0.5 * (inside + outside);
        *(if is_feasible(middle) { &mut inside } else { &mut outside }) = middle;
    }
    inside
}

/// The file's limits where it has some, or other ones for each cable.
fn random_limits(model: &Model, rng: &mut ChaCha8Rng) -> Limits {
    if let (true, Ok(limits)) = (rng.random(), Limits::of(model.robot(), None, None)) {
        return limits;
    }
    let size = 10_f64.powf(rng.random_range(1.0..5.0));
    let largest: Vec<f64> = (0..model.cable_count()).map(|_| size * rng.random_range(0.3..1.0)).collect();
    let least = largest.iter().map(|largest| largest * rng.random_range(0.0..0.5)).collect();
    Limits::new(least, largest).expect("in order")
}
