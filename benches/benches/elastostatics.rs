//! One pose and its tensions by the elastostatic forward problem, CableRobot Simulator (m = 8, n = 6), start 0.1 m and 3° off:
//! `cargo bench -p benches --bench elastostatics`.
//!
//! `newcomer` is the same problem as one writes it first: the stiffness matrices of `statics` and a dense solve per step.
//! It is given a good problem: no cable goes slack on the way, nothing is checked at the end.

use std::hint::black_box;

use cdpr::equilibrium::elastostatics::{Settings, Solver, Status, solve};
use cdpr::geometry::{Pose, Twist};
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::Vector3;
use cdpr::robot::Robot;
use cdpr::statics::{Load, Stiffness, wrench_residual};
use criterion::Criterion;

fn models() -> [(&'static str, Model); 2] {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").expect("built in");
    let pulleys = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).expect("placed");
    [
        ("elastic", Model::new(robot, Composition::ELASTIC).expect("a model")),
        ("pulley+elastic", Model::new(pulleys, Composition::PULLEY_ELASTIC).expect("a model")),
    ]
}

/// Newton steps with cables that cannot push, until the step is below 1e-10.
fn newcomer(model: &Model, lengths: &[f64], load: &Load, guess: &Pose) -> Pose {
    let mut pose = *guess;
    for _ in 0..100 {
        let tensions: Vec<f64> = (0..model.cable_count())
            .map(|cable| {
                let length = model.path(cable, &pose).expect("a course").0.length;
                model.elasticity(cable).tension(length, lengths[cable]).value.max(1e-3)
            })
            .collect();
        let residual = wrench_residual(model, &pose, &tensions, load).expect("tensions");
        let stiffness = Stiffness::at(model, &pose, &tensions, load).expect("elastic cables").system;
        let step = stiffness.lu().solve(&residual).expect("regular");
        pose = pose.displaced(&Twist::from_column_slice(step.as_slice()));
        if step.norm() < 1e-10 {
            break;
        }
    }
    pose
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group("elastostatic forward problem");
    let settings = Settings::default();
    let load = Load::of(&Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").expect("built in"));
    let load = load.expect("a load");
    for (name, model) in models() {
        let pose = Pose::from_xyz_angles(Vector3::new(0.3, -0.4, 1.6), [0.05, -0.02, 0.08]);
        let lengths: Vec<f64> = model.cable_lengths(&pose).expect("lengths").iter().map(|q| q - 0.03).collect();
        let pose = solve(&model, &lengths, &load, &pose, &settings).expect("valid input").pose;
        let along = Vector3::new(1.0, -1.0, 1.0).normalize();
        let turn = along * 3.0_f64.to_radians();
        let shift = 0.1 * along;
        let guess = pose.displaced(&Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z));
        let mut solver = Solver::new(&model, &load, &settings).expect("valid settings");
        let solution = solver.solve(&lengths, &guess).expect("valid input");
        let error = (solution.pose.position - pose.position).norm();
        assert!(solution.status == Status::Converged && error < 1e-9, "{error:e} m off");
        assert!((newcomer(&model, &lengths, &load, &guess).position - pose.position).norm() < 1e-8);

        group.bench_function(format!("{name}, solver reused"), |bencher| {
            bencher.iter(|| solver.solve(black_box(&lengths), black_box(&guess)).map(|solution| solution.iterations));
        });
        group.bench_function(format!("{name}, one call"), |bencher| {
            bencher.iter(|| solve(&model, black_box(&lengths), &load, black_box(&guess), &settings));
        });
        group.bench_function(format!("{name}, newcomer"), |bencher| {
            bencher.iter(|| newcomer(&model, black_box(&lengths), &load, black_box(&guess)));
        });
    }
    group.finish();
    criterion.final_summary();
}
