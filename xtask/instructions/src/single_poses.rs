//! Single poses: a cable in each lane; and what needs no lanes.

use std::hint::black_box;

use cdpr::equilibrium::{elastostatics, forward_kinematics};
use cdpr::geometry::Pose;
use cdpr::model::Composition;
use cdpr::nalgebra::{DMatrix, DVector};
use cdpr::robot::{Robot, builtin};
use cdpr::statics::{Load, controlled_lengths};
use cdpr::tension::{Limits, closed_form, quadratic};

use crate::counting;
use crate::robots::{ELASTIC, POSES, RIGID, beside, model, pose, poses, spread, with_pulleys};

pub(crate) fn count() {
    inverse_kinematics();
    forward();
    tensions();
    // without the published errors, which the file had not when it was first counted: counts compare code, not files
    let (head, rest) =
        builtin::find(RIGID).and_then(|text| text.split_once("\n# errors that the source")).expect("built in");
    let text = format!("{head}{}", &rest[rest.find("\n[platform]").expect("a platform")..]);
    counting::count("robot file, read", &mut || usize::from(Robot::from_toml(black_box(&text), "robot.toml").is_ok()));
}

fn inverse_kinematics() {
    let (standard, pulley, elastic) =
        (model(RIGID, Composition::STANDARD), with_pulleys(), model(ELASTIC, Composition::ELASTIC));
    let poses = poses();
    for (name, model) in [("inverse kinematics, standard", &standard), ("inverse kinematics, pulley", &pulley)] {
        counting::count(name, &mut || poses.iter().filter(|pose| model.cable_lengths(black_box(pose)).is_ok()).count());
    }
    let tensions = [3000.0; 8];
    counting::count("inverse kinematics, elastic", &mut || {
        poses.iter().filter(|pose| controlled_lengths(&elastic, black_box(pose), &tensions).is_ok()).count()
    });
    counting::count("structure matrix", &mut || {
        poses.iter().filter(|pose| standard.structure_matrix(black_box(pose)).is_ok()).count()
    });
}

fn forward() {
    let (standard, elastic) = (model(RIGID, Composition::STANDARD), model(ELASTIC, Composition::ELASTIC));
    let problem = |pose: &Pose| (standard.cable_lengths(pose).expect("lengths"), beside(pose));
    let problems: Vec<_> = poses().iter().map(problem).collect();
    let settings = forward_kinematics::Settings::default();
    let mut solver = forward_kinematics::Solver::new(&standard, &settings).expect("valid settings");
    counting::count("forward kinematics, standard", &mut || {
        let mut converges = |(lengths, guess): &(Vec<f64>, Pose)| {
            solver.solve(black_box(lengths), guess).expect("valid input").status
                == forward_kinematics::Status::Converged
        };
        problems.iter().filter(|problem| converges(problem)).count()
    });
    let load = Load::of(elastic.robot()).expect("a load");
    let settings = elastostatics::Settings::default();
    let mut solver = elastostatics::Solver::new(&elastic, &load, &settings).expect("valid settings");
    counting::count("forward problem, elastic", &mut || {
        let mut converges = |(lengths, guess): &(Vec<f64>, Pose)| {
            let shorter: [f64; 8] = std::array::from_fn(|cable| lengths[cable] - 0.03);
            solver.solve(black_box(&shorter), guess).expect("valid input").status == elastostatics::Status::Converged
        };
        problems.iter().filter(|problem| converges(problem)).count()
    });
}

/// Structure matrices, and wrenches that tensions drawn from this part of the limits' range balance.
fn tension_problems(parts: [f64; 2], limits: &Limits, wanted: quadratic::Status) -> Vec<(DMatrix<f64>, Vec<f64>)> {
    let standard = model(RIGID, Composition::STANDARD);
    let problem = |step: u32| {
        let matrix = standard.structure_matrix(&pose(step)).expect("courses");
        let part = |cable| parts[0] + (parts[1] - parts[0]) * spread(step + 1, 11 + cable as u32);
        let wrench = -(&matrix * DVector::from_fn(8, |cable, _| 1000.0 + 8000.0 * part(cable)));
        (matrix, wrench.as_slice().to_vec())
    };
    let is_wanted = |(matrix, wrench): &(DMatrix<f64>, Vec<f64>)| {
        quadratic::solve(matrix, wrench, limits, None).expect("fits").status == wanted
    };
    (0..).map(problem).filter(is_wanted).take(POSES as usize).collect()
}

fn tensions() {
    let limits = Limits::uniform(8, 1000.0, 9000.0).expect("in order");
    let feasible = tension_problems([0.0, 1.0], &limits, quadratic::Status::Feasible);
    let infeasible = tension_problems([-0.5, 1.5], &limits, quadratic::Status::Infeasible);
    let mut solver = closed_form::Solver::new(8, 6);
    counting::count("tensions, closed form", &mut || {
        let mut solves =
            |(matrix, wrench): &(_, Vec<f64>)| solver.solve(black_box(matrix), wrench, &limits, None).is_ok();
        feasible.iter().filter(|problem| solves(problem)).count()
    });
    let mut solver = quadratic::Solver::new(8, 6);
    for (name, problems) in
        [("tensions, quadratic, feasible", feasible), ("tensions, quadratic, infeasible", infeasible)]
    {
        counting::count(name, &mut || {
            let mut solves = |(matrix, wrench): &(_, Vec<f64>)| {
                solver.forget();
                solver.solve(black_box(matrix), wrench, &limits, None).is_ok()
            };
            problems.iter().filter(|problem| solves(problem)).count()
        });
    }
}
