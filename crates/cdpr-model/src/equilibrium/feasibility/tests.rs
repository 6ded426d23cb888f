//! Verdicts in lanes equal those of the single pose, on every unit.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::equilibrium::distribution;
use crate::geometry::{Twist, Wrench};
use crate::model::Composition;
use crate::robot::{Robot, builtin};
use crate::scalar::Unit;

/// Poses from the middle of the workspace to far beyond it, some of them without a path.
fn poses(model: &Model, count: usize, rng: &mut ChaCha8Rng) -> Vec<Pose> {
    let home = model.robot().home_or_middle();
    let mut poses: Vec<Pose> = (0..count)
        .map(|_| {
            let reach = rng.random_range(0.0..4.0);
            let twist: Twist = (model.twist_basis().iter().enumerate())
                .map(|(k, direction)| {
                    let turn = if k < model.axes().len() { 1.0 } else { 0.2 };
                    direction * (turn * reach * rng.random_range(-1.0..1.0))
                })
                .sum();
            home.displaced(&twist)
        })
        .collect();
    let cable = &model.robot().cables[0];
    poses[5].position = cable.frame_anchor - poses[5].rotation * cable.platform_anchor;
    poses[6].position.x = f64::INFINITY;
    poses
}

/// The file's load and limits, or others that are feasible at some poses.
fn problem(model: &Model) -> (Load, Limits) {
    let weight = Wrench::new(0.0, 0.0, -500.0, 0.0, 20.0, 0.0);
    let load = Load::of(model.robot()).unwrap_or(Load::constant(weight));
    let limits = Limits::of(model.robot(), None, None);
    (load, limits.unwrap_or_else(|_| Limits::uniform(model.cable_count(), 50.0, 2000.0).unwrap()))
}

#[test]
fn every_unit_decides_as_the_exact_programme_for_every_robot() {
    let mut rng = ChaCha8Rng::seed_from_u64(71);
    let mut counts = [0; 3];
    for name in builtin::names() {
        let model = Model::new(Robot::builtin(name).unwrap(), Composition::STANDARD).unwrap();
        let (load, limits) = problem(&model);
        let poses = poses(&model, 1003, &mut rng);
        let mut answers = vec![false; poses.len()];
        let mut solver = Solver::new(&model, &load, &limits).unwrap();
        solver.solve(&poses, &mut answers).unwrap();
        counts[2] += solver.single_poses;
        for (pose, &answer) in poses.iter().zip(&answers) {
            let matrix = model.structure_matrix(pose);
            let expected = matrix.is_ok_and(|matrix| {
                let wrench = load.in_pattern(&model, pose);
                let found = quadratic::solve(&matrix, wrench.as_slice(), &limits, None).unwrap();
                found.status == Status::Feasible
            });
            assert_eq!(answer, expected, "{name}: {pose:?}");
            counts[usize::from(answer)] += 1;
        }
        if model.cable_count() > LANES || model.cable_count() < model.dof() {
            continue;
        }
        for (index, poses) in poses.chunks(CHUNK).enumerate() {
            let on = |unit| {
                let mut verdicts = [Verdict::Doubt; CHUNK];
                Chunk { solver: &solver, poses, verdicts: &mut verdicts }.run_on(unit);
                verdicts
            };
            for unit in Unit::available() {
                assert_eq!(on(unit), on(Unit::Portable), "{name}: chunk {index} on {unit:?}");
            }
        }
    }
    assert!(counts[0] > 3000 && counts[1] > 3000, "{counts:?}");
}

#[test]
fn lanes_decide_nearly_all_poses_of_a_robot_with_eight_cables() {
    let model = Model::new(Robot::builtin("cablerobot-simulator-helicopter").unwrap(), Composition::STANDARD).unwrap();
    let (load, limits) = problem(&model);
    let poses = poses(&model, 2000, &mut ChaCha8Rng::seed_from_u64(72));
    let mut solver = Solver::new(&model, &load, &limits).unwrap();
    solver.solve(&poses, &mut vec![false; poses.len()]).unwrap();
    assert!(solver.single_poses < 20, "{} of {} poses one by one", solver.single_poses, poses.len());
}

/// Between a feasible and an infeasible pose, down to poses that differ only by rounding.
#[test]
fn verdicts_agree_across_the_boundary() {
    let model = Model::new(Robot::builtin("cablerobot-simulator-helicopter").unwrap(), Composition::STANDARD).unwrap();
    let (load, limits) = problem(&model);
    let mut rng = ChaCha8Rng::seed_from_u64(73);
    let one = |pose: &Pose| {
        let mut answer = [false];
        feasible(&model, &load, &limits, std::slice::from_ref(pose), &mut answer).unwrap();
        let single = distribution::solve(&model, pose, &load, &limits).unwrap();
        assert_eq!(answer[0], single.reason.is_none(), "{pose:?}");
        answer[0]
    };
    let inside = model.robot().home_or_middle();
    assert!(one(&inside));
    for _ in 0..50 {
        let away = Twist::from_fn(|_, _| rng.random_range(-1.0..1.0)).normalize();
        let (mut near, mut far) = (0.0, 20.0);
        for _ in 0..60 {
            let middle = 0.5 * (near + far);
            *(if one(&inside.displaced(&(away * middle))) { &mut near } else { &mut far }) = middle;
        }
    }
}

#[test]
fn sagging_cables_are_asked_one_by_one() {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    robot.cables.iter_mut().for_each(|cable| cable.linear_density = Some(0.8));
    let model = Model::new(robot, "elastic+catenary".parse().unwrap()).unwrap();
    let (load, limits) = problem(&model);
    let poses = poses(&model, 40, &mut ChaCha8Rng::seed_from_u64(74));
    let mut answers = vec![false; poses.len()];
    feasible(&model, &load, &limits, &poses, &mut answers).unwrap();
    for (pose, answer) in poses.iter().zip(answers) {
        let found = distribution::solve(&model, pose, &load, &limits);
        assert_eq!(answer, found.is_ok_and(|found| found.reason.is_none()));
    }
}

#[test]
fn sizes_that_do_not_fit_are_refused() {
    let model = Model::new(Robot::builtin("cogiro").unwrap(), Composition::STANDARD).unwrap();
    let (load, limits) = problem(&model);
    let few = Limits::uniform(3, 0.0, 1.0).unwrap();
    let refused = feasible(&model, &load, &few, &[], &mut []);
    assert_eq!(refused, Err(InputError::LimitCount { expected: 8, found: 3 }));
    let refused = feasible(&model, &load, &limits, &[Pose::identity()], &mut []);
    assert_eq!(refused, Err(InputError::AnswerCount { expected: 1, found: 0 }));
}
