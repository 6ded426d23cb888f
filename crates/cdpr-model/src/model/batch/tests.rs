//! Batches have the bits of single poses, on every unit.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::geometry::{Pose, Twist};
use crate::model::{Composition, place_pulleys};
use crate::robot::{Robot, builtin};

/// Every built-in robot with point outlets, and with pulleys if it has some or can be given some.
fn models() -> Vec<Model> {
    let mut models = Vec::new();
    for name in builtin::names() {
        let robot = Robot::builtin(name).unwrap();
        let pulleys = vec![(0.05, Vector3::z()); robot.cables.len()];
        let placed = place_pulleys(&robot, &pulleys, &robot.home_or_middle());
        models.extend(Model::new(robot.clone(), Composition::PULLEY));
        models.extend(placed.ok().and_then(|robot| Model::new(robot, Composition::PULLEY).ok()));
        models.push(Model::new(robot, Composition::STANDARD).unwrap());
    }
    models
}

/// Random poses around the home pose, and poses at which cables have no path.
fn poses(model: &Model, count: usize) -> Vec<Pose> {
    let home = model.robot().home_or_middle();
    let mut rng = ChaCha8Rng::seed_from_u64(61);
    let mut poses: Vec<Pose> = (0..count)
        .map(|_| {
            let twist: Twist =
                model.twist_basis().iter().map(|direction| direction * rng.random_range(-1.5..1.5)).sum();
            home.displaced(&twist)
        })
        .collect();
    for (place, cable) in model.robot().cables.iter().enumerate() {
        let onto = cable.frame_anchor - home.rotation * cable.platform_anchor;
        let axis = cable.pulley_swivel_axis().unwrap_or_else(Vector3::z);
        poses[7 * place + 3].position = onto;
        poses[7 * place + 3].rotation = home.rotation;
        poses[7 * place + 4].position = onto - axis * 2.0;
        poses[7 * place + 4].rotation = home.rotation;
    }
    poses[1].position.x = f64::NAN;
    poses[2].position.y = 1e300;
    poses
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

#[test]
fn lengths_and_matrices_have_the_bits_of_single_poses_on_every_unit() {
    let mut without_path = 0;
    for model in models() {
        let poses = poses(&model, 203);
        let batch: PoseBatch = poses.iter().collect();
        let n = model.dof();
        for unit in Unit::available() {
            let (mut lengths, mut matrices) = (LaneTable::default(), LaneTable::default());
            lengths.reshape(model.cable_count(), batch.len());
            matrices.reshape(n * model.cable_count(), batch.len());
            Lengths { model: &model, poses: &batch, first: 0, lines: lengths.lines_mut() }.run_on(unit);
            StructureMatrices { model: &model, poses: &batch, first: 0, lines: matrices.lines_mut() }.run_on(unit);
            for (item, pose) in poses.iter().enumerate() {
                for cable in 0..model.cable_count() {
                    let path = model.path(cable, pose);
                    let length = path.as_ref().map_or(f64::NAN, |(path, _)| path.length);
                    without_path += usize::from(path.is_err());
                    let name = &model.robot().name;
                    assert!(same(lengths.get(cable, item), length), "{name}, {unit:?}: cable {cable}, pose {item}");
                    let column = model.structure_column(cable, pose);
                    for (row, twist) in model.twist_basis().iter().enumerate() {
                        let entry = column.as_ref().map_or(f64::NAN, |column| twist.dot(column));
                        let found = matrices.get(cable * n + row, item);
                        assert!(same(found, entry), "{name}, {unit:?}: cable {cable}, pose {item}: {found} {entry}");
                    }
                }
            }
        }
    }
    assert!(without_path > 1000, "{without_path}");
}

#[test]
fn an_empty_batch_has_no_answers() {
    let model = Model::new(Robot::builtin("cogiro").unwrap(), Composition::STANDARD).unwrap();
    let mut table = LaneTable::new(3);
    model.batch_cable_lengths(&PoseBatch::default(), &mut table);
    assert!(table.is_empty());
    model.batch_structure_matrices(&PoseBatch::default(), &mut table);
    assert!(table.is_empty());
}

/// Enough poses for several parts: results must not depend on the part that a thread was given.
#[test]
fn large_batches_have_the_bits_of_small_ones() {
    let model = Model::new(Robot::builtin("cogiro").unwrap(), Composition::STANDARD).unwrap();
    let few = poses(&model, 1001);
    let many: Vec<Pose> = few.iter().cycle().take(10_010).copied().collect();
    let (mut small, mut large) = (LaneTable::default(), LaneTable::default());
    model.batch_cable_lengths(&few.iter().collect(), &mut small);
    model.batch_cable_lengths(&many.iter().collect(), &mut large);
    for item in 0..many.len() {
        assert!((0..8).all(|cable| same(large.get(cable, item), small.get(cable, item % few.len()))), "{item}");
    }
}
