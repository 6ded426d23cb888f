//! Batches give the bits of single problems, on every unit.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::super::Settings;
use super::*;
use crate::geometry::{Pose, Twist};
use crate::model::{Composition, place_pulleys};
use crate::robot::{Robot, builtin};

/// Lengths at random poses, some of them with errors of millimetres or of decimetres, and guesses near and far.
fn problems(model: &Model, count: usize, seed: u64) -> (LaneTable, PoseBatch) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let home = model.robot().home_or_middle();
    let mut lengths = LaneTable::new(model.cable_count());
    let mut guesses = PoseBatch::default();
    while guesses.len() < count {
        let mut twist = |size: f64| -> Twist {
            model.twist_basis().iter().map(|direction| direction * (size * rng.random_range(-1.0..1.0))).sum()
        };
        let pose = home.displaced(&twist(0.3));
        let guess = pose.displaced(&twist([0.03, 0.1, 0.1, 1.0][guesses.len() % 4]));
        let Ok(mut exact) = model.cable_lengths(&pose) else { continue };
        let error = [0.0, 1e-3, 0.0, 0.3][guesses.len() / 4 % 4];
        exact.iter_mut().for_each(|length| *length = (*length + error * rng.random_range(-1.0..1.0)).max(0.1));
        lengths.resize(guesses.len() + 1);
        lengths.write(guesses.len(), &exact);
        guesses.push(&guess);
    }
    (lengths, guesses)
}

fn models() -> Vec<Model> {
    let mut models = Vec::new();
    for name in builtin::names() {
        let robot = Robot::builtin(name).unwrap();
        let pulleys = vec![(0.05, Vector3::z()); robot.cables.len()];
        let placed = place_pulleys(&robot, &pulleys, &robot.home_or_middle());
        models.extend(placed.ok().and_then(|robot| Model::new(robot, Composition::PULLEY).ok()));
        models.push(Model::new(robot, Composition::STANDARD).unwrap());
    }
    models
}

#[test]
fn a_batch_has_the_bits_of_single_problems_for_every_robot() {
    // fewer starts for speed: the choice of starts is the single solver's
    let settings = Settings { max_restarts: 2, ..Settings::default() };
    let mut converged = 0;
    for model in models() {
        let (lengths, guesses) = problems(&model, 52, 81);
        let mut batch = Solutions::default();
        Solver::new(&model, &settings).unwrap().solve_batch(&lengths, &guesses, &mut batch).unwrap();
        let mut single = Solver::new(&model, &settings).unwrap();
        let mut numbers = vec![0.0; model.cable_count()];
        for item in 0..guesses.len() {
            lengths.read(item, &mut numbers);
            let expected = single.solve(&numbers, &guesses.get(item)).unwrap();
            let name = &model.robot().name;
            assert_eq!(batch.pose(item), expected.pose, "{name}, problem {item}");
            assert_eq!(batch.status(item), expected.status, "{name}, problem {item}");
            assert_eq!(batch.residual_rms(item).to_bits(), expected.residual_rms.to_bits(), "{name}, problem {item}");
            assert_eq!(batch.iterations(item), expected.iterations, "{name}, problem {item}");
            converged += usize::from(expected.status == Status::Converged);
        }
    }
    assert!(converged > 500, "{converged}");
}

#[test]
fn eight_descents_give_the_same_bits_on_every_unit_and_nearly_all_end_in_lanes() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let settings = Settings::default();
    let (lengths, guesses) = problems(&model, 160, 82);
    let (mut done, mut near) = (0, 0);
    for group in 0..lengths.groups() {
        let on = |unit| {
            let mut solutions = [Line::default(); TENSIONS];
            let descents = Descents {
                model: &model,
                settings: &settings,
                platform_radius: model.platform_radius(),
                lengths: lengths.group(group),
                guesses: guesses.table().group(group),
                solutions: &mut solutions,
            };
            (descents.run_on(unit), solutions)
        };
        let (is_done, solutions) = on(Unit::Portable);
        for unit in Unit::available() {
            let (other, found) = on(unit);
            assert_eq!(other, is_done, "{unit:?}");
            for lane in (0..LANES).filter(|&lane| is_done[lane]) {
                let bits = |lines: &[Line; TENSIONS]| lines.map(|line| line.0[lane].to_bits());
                assert_eq!(bits(&found), bits(&solutions), "{unit:?}");
            }
        }
        // guesses 0.1 m off with lengths that fit to a millimetre
        let is_near = |lane: &usize| lane % 4 < 3 && (group * LANES + lane) / 4 % 4 < 3;
        near += (0..LANES).filter(is_near).count();
        done += (0..LANES).filter(is_near).filter(|&lane| is_done[lane]).count();
    }
    assert!(done as f64 > 0.95 * near as f64, "{done} of {near}");
}

#[test]
fn what_the_single_problem_refuses_is_refused() {
    let model = Model::new(Robot::builtin("cogiro").unwrap(), Composition::STANDARD).unwrap();
    let (mut lengths, mut guesses) = problems(&model, 9, 83);
    let mut solver = Solver::new(&model, &Settings::default()).unwrap();
    let mut solutions = Solutions::default();
    lengths.write(8, &[1.0, 1.0, f64::NAN, 1.0, 1.0, 1.0, 1.0, 1.0]);
    let refused = solver.solve_batch(&lengths, &guesses, &mut solutions);
    assert!(matches!(refused, Err(InputError::Length { cable: 3, .. })), "{refused:?}");
    lengths.write(8, &[9.0; 8]);
    guesses.push(&Pose::identity());
    let refused = solver.solve_batch(&lengths, &guesses, &mut solutions);
    assert_eq!(refused, Err(InputError::GuessCount { expected: 9, found: 10 }));
    let refused = solver.solve_batch(&LaneTable::new(3), &guesses, &mut solutions);
    assert_eq!(refused, Err(InputError::LengthCount { expected: 8, found: 3 }));
}
