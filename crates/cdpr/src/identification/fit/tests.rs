//! What the block solver promises on every machine.

use nalgebra::Vector3;

use super::checked_parameters;
use crate::geometry::Pose;
use crate::identification::blocks::{Accumulate, Block};
use crate::identification::fit::Settings;
use crate::identification::pose_lanes::PoseLanes;
use crate::identification::weights::length_weights;
use crate::measurement::{Samples, SensorSigmas};
use crate::model::{Composition, Model, place_pulleys};
use crate::robot::Robot;
use crate::scalar::{Unit, dispatch_on};

/// Thirteen poses, so that the last group is padded; lengths of the model itself plus millimetres.
fn samples(model: &Model) -> Samples {
    let home = model.robot().home_or_middle();
    let pose = |index: u32| {
        let t = f64::from(index);
        let shift = Vector3::new(t.sin(), (1.7 * t).cos(), 0.5 * (2.3 * t).sin());
        Pose::from_xyz_angles(home.position + shift, [0.1 * t.cos(), 0.1 * (1.3 * t).sin(), 0.2 * (0.7 * t).sin()])
    };
    let poses: Vec<Pose> = (0..13).map(pose).collect();
    let lengths = poses.iter().flat_map(|pose| model.cable_lengths(pose).unwrap());
    let lengths = lengths.enumerate().map(|(index, length)| length + 1e-3 * (index as f64).sin()).collect();
    let sigmas =
        SensorSigmas { length: Some(1e-3), position: Some(2e-4), rotation: Some(1e-4), ..SensorSigmas::default() };
    Samples { poses, lengths, cable_count: model.cable_count(), sigmas, ..Samples::default() }
}

#[test]
fn normal_equations_have_the_same_bits_on_every_unit() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let pulleys = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).unwrap();
    for (model, free) in [
        (Model::new(robot, Composition::STANDARD).unwrap(), "frame-anchor,platform-anchor,length-offset,length-scale"),
        (Model::new(pulleys, Composition::PULLEY).unwrap(), "frame-anchor,platform-anchor,length-offset,pulley-radius"),
    ] {
        let samples = samples(&model);
        let poses = PoseLanes::new(&samples);
        let weights = length_weights(&model, &samples, &poses).unwrap();
        let parameters = checked_parameters(&model, &samples, &free.parse().unwrap(), &Settings::default()).unwrap();
        for cable in 0..8 {
            let own = parameters.iter().filter(|parameter| parameter.cable == cable).copied().collect();
            let block = Block::new(&model, cable, own, &samples, &weights);
            let on = |unit| {
                let kernel = Accumulate::<8> { block: &block, poses: &poses, values: &block.start, recordings: None };
                let equations = dispatch_on(unit, kernel).unwrap();
                let numbers = equations.matrix.as_flattened().iter().chain(&equations.gradient);
                numbers.chain([&equations.cost]).map(|x| x.to_bits()).collect::<Vec<_>>()
            };
            for unit in Unit::available() {
                assert_eq!(on(unit), on(Unit::Portable), "{unit:?}");
            }
        }
    }
}
