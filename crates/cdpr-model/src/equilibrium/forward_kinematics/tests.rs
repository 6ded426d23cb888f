//! Properties of the descent on every machine.

use nalgebra::Vector3;

use super::descent::{PoseDescent, PoseEnd, Problem, Residuals};
use super::*;
use crate::model::{Composition, place_pulleys};
use crate::robot::Robot;
use crate::scalar::{Unit, dispatch_on};

fn bits(end: &PoseEnd, residuals: &Residuals) -> Vec<u64> {
    let pose = end.pose.position.iter().chain(end.pose.rotation.coords.iter());
    let numbers = pose.chain([&end.rms, &end.pivot_ratio]).chain(residuals.accepted.as_flattened());
    numbers.map(|x| x.to_bits()).chain([u64::from(end.iterations)]).collect()
}

/// The narrow dispatch depends on the machine; results must not.
#[test]
fn the_descent_gives_the_same_bits_on_every_unit() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let pose = robot.home_or_middle();
    let pulleys = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &pose).unwrap();
    for model in [Model::new(robot, Composition::STANDARD).unwrap(), Model::new(pulleys, Composition::PULLEY).unwrap()]
    {
        let lengths = model.cable_lengths(&pose).unwrap();
        let guess = Pose::from_xyz_angles(pose.position + Vector3::new(0.1, -0.05, 0.08), [0.04, -0.05, 0.03]);
        let targets = [std::array::from_fn(|lane| lengths[lane] + 1e-3 * (lane as f64).sin())];
        let settings = Settings::default();
        let platform_radius = model.platform_radius();
        let problem =
            Problem { model: &model, settings: &settings, targets: &targets, mean_length: 9.0, platform_radius };
        let on = |unit| {
            let mut residuals = Residuals { accepted: vec![[0.0; LANES]], trial: vec![[0.0; LANES]] };
            let search = PoseDescent::<6> { problem: &problem, start: &guess, residuals: &mut residuals };
            let end = dispatch_on(unit, search).unwrap();
            bits(&end, &residuals)
        };
        for unit in Unit::available() {
            assert_eq!(on(unit), on(Unit::Portable), "{unit:?}");
        }
    }
}
