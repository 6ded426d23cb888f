//! Inverse kinematics of the CableRobot Simulator (8 cables) over points and over pulleys, with directions and all derivatives:
//! `cargo bench -p benches --bench outlets`. Times are per pose: an eighth of them per cable.

use std::hint::black_box;

use cdpr::geometry::Pose;
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::Vector3;
use cdpr::robot::Robot;
use criterion::Criterion;

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group("inverse kinematics");
    let robot = Robot::builtin("cablerobot-simulator-helicopter").expect("built in");
    let pulleys = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).expect("placed");
    let poses: Vec<Pose> = (0..64)
        .map(|k| {
            let t = f64::from(k);
            let position = Vector3::new(t.sin(), (1.3 * t).cos(), 1.5 + 0.5 * (0.7 * t).sin());
            Pose::from_xyz_angles(position, [0.1 * (0.9 * t).sin(), 0.1 * t.cos(), 0.2 * (0.4 * t).sin()])
        })
        .collect();
    for (name, robot, composition) in
        [("points", robot, Composition::STANDARD), ("pulleys", pulleys, Composition::PULLEY)]
    {
        let model = Model::new(robot, composition).expect("a model");
        let mut next = poses.iter().cycle();
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let pose = next.next().expect("a cycle");
                for cable in 0..model.cable_count() {
                    black_box(model.path(cable, black_box(pose))).expect("a course");
                }
            });
        });
    }
    group.finish();
    criterion.final_summary();
}
