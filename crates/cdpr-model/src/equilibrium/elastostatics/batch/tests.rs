//! Batches give the bits of single problems, on every unit.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::equilibrium::elastostatics::Settings;
use crate::geometry::{Twist, Wrench};
use crate::model::{Composition, Model, place_pulleys};
use crate::robot::{CableStiffness, Robot, builtin};
use crate::statics::Load;

/// Every built-in robot, with springs if its file has no stiffness, over points and over pulleys.
fn models() -> Vec<Model> {
    let mut models = Vec::new();
    for name in builtin::names() {
        let mut robot = Robot::builtin(name).unwrap();
        for cable in &mut robot.cables {
            cable.stiffness.get_or_insert(CableStiffness::Axial(4e5));
        }
        let pulleys = vec![(0.05, Vector3::z()); robot.cables.len()];
        let placed = place_pulleys(&robot, &pulleys, &robot.home_or_middle());
        models.extend(placed.ok().and_then(|robot| Model::new(robot, Composition::PULLEY_ELASTIC).ok()));
        models.push(Model::new(robot, Composition::ELASTIC).unwrap());
    }
    models
}

/// Controlled lengths at random poses, a little or far too short, sometimes too long, and guesses near and far.
fn problems(model: &Model, count: usize, seed: u64) -> (LaneTable, PoseBatch) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let home = model.robot().home_or_middle();
    let mut lengths = LaneTable::new(model.cable_count());
    let mut guesses = PoseBatch::default();
    while guesses.len() < count {
        let mut twist = |size: f64| -> Twist {
            model.twist_basis().iter().map(|direction| direction * (size * rng.random_range(-1.0..1.0))).sum()
        };
        let pose = home.displaced(&twist(0.2));
        let guess = pose.displaced(&twist([0.02, 0.05, 0.05, 0.4][guesses.len() % 4]));
        let Ok(mut exact) = model.cable_lengths(&pose) else { continue };
        let shorter = [0.99, 0.98, 0.995, 1.01][guesses.len() / 4 % 4];
        exact.iter_mut().for_each(|length| *length = (*length * shorter).max(0.05));
        lengths.resize(guesses.len() + 1);
        lengths.write(guesses.len(), &exact);
        guesses.push(&guess);
    }
    (lengths, guesses)
}

fn loads(model: &Model) -> [Load; 2] {
    let weight = Load::of(model.robot()).unwrap_or(Load::constant(Wrench::new(0.0, 0.0, -500.0, 0.0, 0.0, 0.0)));
    [weight, Load::constant(Wrench::new(10.0, -20.0, -700.0, 5.0, 20.0, -3.0))]
}

#[test]
fn a_batch_has_the_bits_of_single_problems_for_every_robot() {
    let settings = Settings { max_restarts: 1, ..Settings::default() };
    let mut converged = 0;
    for model in models() {
        let (lengths, guesses) = problems(&model, 20, 91);
        for load in loads(&model) {
            let mut batch = Solutions::default();
            Solver::new(&model, &load, &settings).unwrap().solve_batch(&lengths, &guesses, &mut batch).unwrap();
            let mut single = Solver::new(&model, &load, &settings).unwrap();
            let mut numbers = vec![0.0; model.cable_count()];
            for item in 0..guesses.len() {
                lengths.read(item, &mut numbers);
                let expected = single.solve(&numbers, &guesses.get(item)).unwrap();
                let what = format!("{}, {}, problem {item}", model.robot().name, model.composition());
                assert_eq!(batch.pose(item), expected.pose, "{what}");
                assert_eq!(batch.status(item), expected.status, "{what}");
                assert_eq!(batch.iterations(item), expected.iterations, "{what}");
                for (cable, tension) in expected.tensions.iter().enumerate() {
                    assert_eq!(batch.tension(cable, item).to_bits(), tension.to_bits(), "{what}");
                }
                converged += usize::from(expected.status == Status::Converged);
            }
        }
    }
    assert!(converged > 300, "{converged}");
}

/// Equilibria with slack cables take many more steps; a batch for taut cables does not search for them, in lanes or
/// not.
#[test]
fn asked_for_taut_cables_a_batch_ends_with_the_bars() {
    let settings = Settings { max_restarts: 0, ..Settings::default() };
    let (mut kept, mut left) = (0, 0);
    for model in models() {
        let (lengths, guesses) = problems(&model, 40, 93);
        let mut solver = Solver::new(&model, &loads(&model)[0], &settings).unwrap();
        let (mut all, mut taut) = (Solutions::default(), Solutions::default());
        solver.solve_batch(&lengths, &guesses, &mut all).unwrap();
        solver.solve_taut_batch(&lengths, &guesses, &mut taut).unwrap();
        let pulls = |item| (0..model.cable_count()).all(|cable| all.tension(cable, item) > 0.0);
        for item in 0..guesses.len() {
            let what = format!("{}, {}, problem {item}", model.robot().name, model.composition());
            if taut.status(item) == Status::Converged && pulls(item) {
                assert_eq!(taut.pose(item), all.pose(item), "{what}");
                kept += 1;
            } else if all.status(item) == Status::Converged && taut.status(item) == Status::NotConverged {
                assert!(!pulls(item), "{what}");
                assert!(taut.iterations(item) <= settings.max_iterations, "{what}");
                left += 1;
            }
        }
        // an ordinary batch afterwards solves all problems as before
        let mut again = Solutions::default();
        solver.solve_batch(&lengths, &guesses, &mut again).unwrap();
        assert_eq!(again, all);
    }
    assert!(kept > 300 && left > 100, "{kept} kept, {left} left");
}

#[test]
fn eight_descents_give_the_same_bits_on_every_unit_and_taut_cables_end_in_lanes() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let settings = Settings::default();
    let (lengths, guesses) = problems(&model, 160, 92);
    let (mut done, mut near) = (0, 0);
    for group in 0..lengths.groups() {
        let on = |unit| {
            let mut solutions = [Line::default(); TENSIONS + 8];
            let descents = Descents {
                model: &model,
                settings: &settings,
                load: LoadParts::of(&loads(&model)[1]),
                platform_radius: model.platform_radius(),
                lengths: lengths.group(group),
                guesses: guesses.table().group(group),
                solutions: &mut solutions,
            };
            (descents.run_on(unit), solutions)
        };
        let (endings, solutions) = on(Unit::Portable);
        for unit in Unit::available() {
            let (other, found) = on(unit);
            assert_eq!(other, endings, "{unit:?}");
            for lane in (0..LANES).filter(|&lane| endings[lane] == Ending::Solved) {
                let bits = |lines: &[Line; TENSIONS + 8]| lines.map(|line| line.0[lane].to_bits());
                assert_eq!(bits(&found), bits(&solutions), "{unit:?}");
            }
        }
        let is_near = |lane: &usize| lane % 4 < 3 && (group * LANES + lane) / 4 % 4 < 3;
        near += (0..LANES).filter(is_near).count();
        done += (0..LANES).filter(is_near).filter(|&lane| endings[lane] == Ending::Solved).count();
    }
    assert!(done as f64 > 0.9 * near as f64, "{done} of {near}");
}
