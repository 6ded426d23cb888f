//! What each effect costs in inverse kinematics, CableRobot Simulator (m = 8), one pose at a time, all cables:
//! `cargo bench -p benches --bench effects`. The last lines are the ratios to the standard model in the same run.
#![expect(clippy::print_stdout, reason = "a program that shows its figures")]

use std::hint::black_box;
use std::time::{Duration, Instant};

use cdpr::equilibrium::State;
use cdpr::geometry::Pose;
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::Vector3;
use cdpr::robot::{HysteresisTable, Pulley, Robot};

/// Everything that an effect asks for: pulleys, cables of 0.8 kg/m, stiffening and hysteresis.
fn machine() -> Robot {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").expect("built in");
    for cable in &mut robot.cables {
        cable.pulley = Some(Pulley::Whole { radius: 0.16, swivel_axis: Vector3::z().into() });
        (cable.linear_density, cable.finite_elements) = (Some(0.8), Some(10));
        cable.tension_of_strain = Some(vec![2e6, 2e8]);
        cable.hysteresis = Some(HysteresisTable {
            strain: vec![0.0, 0.005, 0.02],
            loading_N: vec![0.0, 1.2e4, 6e4],
            unloading_N: vec![0.0, 1.0e4, 6e4],
            loading_slope_N: None,
            unloading_slope_N: None,
            transition_strain: vec![4e-4],
            transition_share: None,
        });
    }
    robot
}

fn poses() -> Vec<Pose> {
    let at = |index: i32, rate: f64| (f64::from(index) * rate).sin();
    (0..200)
        .map(|i| {
            let position = Vector3::new(1.5 * at(i, 0.7), 1.5 * at(i, 1.1), 1.6 + 0.6 * at(i, 1.9));
            Pose::from_xyz_angles(position, [0.08 * at(i, 0.3), 0.08 * at(i, 0.9), 0.08 * at(i, 1.3)])
        })
        .collect()
}

/// Controlled lengths of all cables at all poses, summed.
fn sweep(model: &Model, poses: &[Pose]) -> f64 {
    let (mut state, tensions) = (State::at_home(model), vec![4000.0; model.cable_count()]);
    let length = |pose| match model.inverse(pose, &tensions, &mut state) {
        Ok(command) => command.cables.iter().map(|cable| cable.controlled_length).sum(),
        Err(_) => f64::NAN,
    };
    poses.iter().map(length).sum()
}

/// Shortest time per pose of many sweeps (ns): what the machine can, whatever else it does.
fn time(model: &Model, poses: &[Pose]) -> f64 {
    let mut best = Duration::MAX;
    for _ in 0..60 {
        let start = Instant::now();
        assert!(black_box(sweep(black_box(model), black_box(poses))).is_finite());
        best = best.min(start.elapsed());
    }
    best.as_nanos() as f64 / poses.len() as f64
}

fn main() {
    let (robot, poses) = (machine(), poses());
    let names = [
        "standard",
        "pulley",
        "elastic",
        "polynomial",
        "hysteresis",
        "elastic+catenary",
        "pulley+elastic+catenary",
        "elastic+finite-element",
    ];
    let mut base = f64::NAN;
    for name in names {
        let composition: Composition = name.parse().expect("a composition");
        let model = Model::new(robot.clone(), composition).expect("everything it needs");
        let time = time(&model, &poses);
        base = if name == "standard" { time } else { base };
        println!("{name:<26} {time:>8.0} ns per pose  {:>6.1} x standard", time / base);
    }
}
