//! One pose by forward kinematics, CableRobot Simulator (m = 8, n = 6), start 0.1 m and 3° off:
//! `cargo bench -p benches --bench forward_kinematics`.
//!
//! `newcomer` is the same problem as one writes it first: dynamic matrices, a singular value decomposition per step.

use std::hint::black_box;

use cdpr::equilibrium::forward_kinematics::{Settings, Solver, Status, solve};
use cdpr::geometry::{Pose, Twist};
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::{DVector, Vector3};
use cdpr::robot::Robot;
use criterion::Criterion;

fn models() -> [(&'static str, Model); 2] {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").expect("built in");
    let pulleys = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).expect("placed");
    [
        ("standard", Model::new(robot, Composition::STANDARD).expect("a model")),
        ("pulley", Model::new(pulleys, Composition::PULLEY).expect("a model")),
    ]
}

/// Gauss–Newton by the pseudoinverse until the step is below 1e-10.
fn newcomer(model: &Model, lengths: &[f64], guess: &Pose) -> Pose {
    let mut pose = *guess;
    for _ in 0..100 {
        let residuals =
            DVector::from_vec(model.cable_lengths(&pose).expect("lengths")) - DVector::from_row_slice(lengths);
        let jacobian = -model.structure_matrix(&pose).expect("a structure matrix").transpose();
        let step = jacobian.svd(true, true).solve(&-residuals, 1e-12).expect("both sides were computed");
        pose = pose.displaced(&Twist::from_column_slice(step.as_slice()));
        if step.norm() < 1e-10 {
            break;
        }
    }
    pose
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group("forward kinematics");
    let settings = Settings::default();
    for (name, model) in models() {
        let pose = Pose::from_xyz_angles(Vector3::new(0.3, -0.4, 1.6), [0.05, -0.02, 0.08]);
        let lengths = model.cable_lengths(&pose).expect("lengths");
        let along = Vector3::new(1.0, -1.0, 1.0).normalize();
        let turn = along * 3.0_f64.to_radians();
        let shift = 0.1 * along;
        let guess = pose.displaced(&Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z));
        let mut solver = Solver::new(&model, &settings).expect("valid settings");
        let solution = solver.solve(&lengths, &guess).expect("valid input");
        let error = (solution.pose.position - pose.position).norm();
        assert!(solution.status == Status::Converged && error < 1e-9, "{error:e} m off");
        assert!((newcomer(&model, &lengths, &guess).position - pose.position).norm() < 1e-9);

        group.bench_function(format!("{name}, solver reused"), |bencher| {
            bencher.iter(|| solver.solve(black_box(&lengths), black_box(&guess)).map(|solution| solution.iterations));
        });
        group.bench_function(format!("{name}, one call"), |bencher| {
            bencher.iter(|| solve(&model, black_box(&lengths), black_box(&guess), &settings));
        });
        group.bench_function(format!("{name}, newcomer"), |bencher| {
            bencher.iter(|| newcomer(&model, black_box(&lengths), black_box(&guess)));
        });
    }
    group.finish();
    criterion.final_summary();
}
