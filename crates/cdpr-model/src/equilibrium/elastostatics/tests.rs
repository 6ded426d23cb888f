//! Properties of the descent on every machine.

use super::descent::{EquilibriumDescent, EquilibriumEnd, Tensions};
use super::*;
use crate::geometry::Wrench;
use crate::model::{Composition, Model};
use crate::robot::Robot;
use crate::scalar::{Unit, dispatch_on};

fn bits(end: &EquilibriumEnd, tensions: &Tensions) -> Vec<u64> {
    let pose = end.pose.position.iter().chain(end.pose.rotation.coords.iter());
    let numbers = pose.chain(&end.residual).chain(end.stiffness.as_flattened()).chain(tensions.accepted.as_flattened());
    numbers.map(|x| x.to_bits()).chain([u64::from(end.iterations)]).collect()
}

/// The narrow dispatch depends on the machine; results must not.
#[test]
fn the_descent_gives_the_same_bits_on_every_unit() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let pose = robot.home_or_middle();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let lengths = model.cable_lengths(&pose).unwrap();
    let springs = [Springs {
        rest_length: std::array::from_fn(|lane| lengths[lane] - 0.02 + 2e-3 * (lane as f64).sin()),
        stiffness: [2e5; LANES],
    }];
    let load = Load::constant(Wrench::new(0.0, 0.0, -500.0, 50.0, -20.0, 30.0));
    let settings = Settings::default();
    let problem = Problem {
        model: &model,
        settings: &settings,
        load: LoadParts::of(&load),
        full_load: &load,
        has_moment: true,
        springs: &springs,
        floor: 0.0,
        stiffness_scale: 1.6e6,
        mean_length: 9.0,
        platform_radius: model.platform_radius(),
        only_taut: false,
    };
    let start = Pose::from_xyz_angles(pose.position.add_scalar(0.06), [0.04, -0.05, 0.03]);
    let on = |unit| {
        let mut tensions = Tensions::new(1);
        let search = EquilibriumDescent::<6> { problem: &problem, start: &start, tensions: &mut tensions };
        let end = dispatch_on(unit, search).unwrap();
        bits(&end, &tensions)
    };
    for unit in Unit::available() {
        assert_eq!(on(unit), on(Unit::Portable), "{unit:?}");
    }
}
