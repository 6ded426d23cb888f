//! Batches: a pose in each lane, on the widest vector unit.

use std::hint::black_box;

use cdpr::equilibrium::{Solutions, closed_form, elastostatics, feasibility, forward_kinematics};
use cdpr::geometry::{Pose, PoseBatch};
use cdpr::model::{Composition, Model};
use cdpr::scalar::LaneTable;
use cdpr::statics::Load;
use cdpr::tension::Limits;

use crate::counting;
use crate::robots::{ELASTIC, RIGID, beside, model, pose, with_pulleys};

/// Two groups of eight: counting by steps takes tens of microseconds an instruction.
const POSES: u32 = 16;

pub(crate) fn count() {
    let (standard, pulley) = (model(RIGID, Composition::STANDARD), with_pulleys());
    geometry("standard", &standard);
    geometry("pulley", &pulley);
    forward("standard", &standard);
    forward("pulley", &pulley);
    equilibria();
    tensions(&standard);
}

fn poses() -> Vec<Pose> {
    (0..POSES).map(pose).collect()
}

/// Numbers of a table that are numbers.
fn finite(table: &LaneTable) -> usize {
    (0..table.rows()).map(|row| table.row(row).filter(|number| number.is_finite()).count()).sum()
}

fn geometry(name: &str, model: &Model) {
    let batch: PoseBatch = poses().iter().collect();
    let mut table = LaneTable::default();
    counting::count(&format!("batch, lengths, {name}"), &mut || {
        model.batch_cable_lengths(black_box(&batch), &mut table);
        table.len()
    });
    assert_eq!(finite(&table), 8 * POSES as usize, "lengths, {name}");
    counting::count(&format!("batch, structure matrices, {name}"), &mut || {
        model.batch_structure_matrices(black_box(&batch), &mut table);
        table.len()
    });
    assert_eq!(finite(&table), 48 * POSES as usize, "structure matrices, {name}");
}

/// Lengths of all poses, so much shorter (m), and guesses beside the poses.
fn problems(model: &Model, shorter: f64) -> (LaneTable, PoseBatch) {
    let poses = poses();
    let mut table = LaneTable::default();
    model.batch_cable_lengths(&poses.iter().collect(), &mut table);
    let mut lengths = [0.0; 8];
    for item in 0..table.len() {
        table.read(item, &mut lengths);
        table.write(item, &lengths.map(|length| length - shorter));
    }
    (table, poses.iter().map(beside).collect::<Vec<_>>().iter().collect())
}

fn forward(name: &str, model: &Model) {
    let (lengths, guesses) = problems(model, 0.0);
    let settings = forward_kinematics::Settings::default();
    let mut solver = forward_kinematics::Solver::new(model, &settings).expect("valid settings");
    let mut solutions = Solutions::default();
    counting::count(&format!("batch, forward kinematics, {name}"), &mut || {
        solver.solve_batch(black_box(&lengths), &guesses, &mut solutions).expect("valid input");
        (0..solutions.len()).filter(|&item| solutions.residual_rms(item) < 1e-9).count()
    });
}

fn equilibria() {
    let elastic = model(ELASTIC, Composition::ELASTIC);
    let load = Load::of(elastic.robot()).expect("a load");
    let (lengths, guesses) = problems(&elastic, 0.03);
    let settings = elastostatics::Settings::default();
    let mut solver = elastostatics::Solver::new(&elastic, &load, &settings).expect("valid settings");
    let mut solutions = Solutions::default();
    counting::count("batch, forward problem, elastic", &mut || {
        solver.solve_batch(black_box(&lengths), &guesses, &mut solutions).expect("valid input");
        (0..solutions.len()).filter(|&item| solutions.tension(0, item) > 0.0).count()
    });
}

fn tensions(standard: &Model) {
    let (load, limits) = (Load::of(standard.robot()).expect("a load"), Limits::uniform(8, 1000.0, 9000.0));
    let limits = limits.expect("in order");
    let poses = poses();
    let batch: PoseBatch = poses.iter().collect();
    let mut table = LaneTable::default();
    counting::count("batch, tensions, closed form", &mut || {
        closed_form::solve_batch(standard, &load, &limits, black_box(&batch), &mut table).expect("fits");
        table.len()
    });
    let mut answers = vec![false; poses.len()];
    counting::count("batch, wrench-feasible", &mut || {
        feasibility::feasible(standard, &load, &limits, black_box(&poses), &mut answers).expect("fits");
        answers.iter().filter(|answer| **answer).count()
    });
}
