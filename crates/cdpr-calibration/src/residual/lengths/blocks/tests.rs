//! Columns behind those of the kernels against differences of the residuals.

use nalgebra::Vector3;

use super::Block;
use crate::residual::lengths::pose_lanes::PoseLanes;
use crate::residual::lengths::weights::length_weights;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, FreeParameters, Model};
use cdpr_model::robot::{Parameter, ParameterKind, Robot, WrapSide};

/// A robot with tilted pulleys and a fleeting drum at every cable, all axes turned; planar ones with pulleys that do not swivel.
fn robot(name: &str) -> Robot {
    let mut robot = Robot::builtin(name).unwrap();
    let is_planar = robot.motion_pattern.is_planar();
    for cable in &mut robot.cables {
        let is_left = cable.frame_anchor.x < 0.0;
        let axis = if is_planar { Vector3::y() } else { Vector3::new(0.1, -0.2, 0.9).normalize() };
        cable.set_pulley_swivel_axis(axis);
        cable.set_pulley_radius(0.12);
        cable.pulley_wrap_side = is_planar.then_some(if is_left { WrapSide::Right } else { WrapSide::Left });
        cable.winch.radius = Some(0.1);
        cable.winch.set_pitch(0.012);
        cable.winch.axis = Some(Vector3::new(0.9, 0.1, -0.2).normalize().into());
        cable.winch.position = Some(cable.frame_anchor + Vector3::new(0.1, 0.3, -2.0));
        (cable.winch.start_length, cable.winch.start_angle) = (Some(3.0), Some(0.4));
        cable.length_scale = Some(1.02);
    }
    for cable in 0..robot.cables.len() {
        for kind in [ParameterKind::DrumAxis, ParameterKind::SwivelAxis] {
            for axis in 0..kind.components(&robot) {
                Parameter { cable, kind, axis }.set(&mut robot, 0.1 - 0.25 * axis as f64);
            }
        }
    }
    robot
}

/// Motor angles of the model itself at some poses about home.
fn samples(model: &Model) -> Samples {
    let home = model.robot().home_or_middle();
    let (first, second) = (model.axes()[0], model.axes()[1]);
    let pose =
        |t: f64| Pose { position: home.position + first * (0.4 * t.sin()) + second * (0.5 * (1.7 * t).cos()), ..home };
    let poses: Vec<Pose> = (0..11).map(|index| pose(f64::from(index))).collect();
    let angles = poses.iter().flat_map(|pose| {
        let lengths = model.cable_lengths(pose).unwrap();
        (0..model.cable_count()).map(move |cable| model.motor_angle(cable, lengths[cable]).unwrap()).collect::<Vec<_>>()
    });
    let angles: Vec<f64> = angles.collect();
    let sigmas = SensorSigmas { length: Some(1e-3), ..SensorSigmas::default() };
    let empty = Samples { cable_count: model.cable_count(), sigmas, ..Samples::default() };
    let recorded = Samples { poses, motor_angles: Some(angles), ..empty };
    model.with_lengths(&recorded).unwrap().into_owned()
}

#[test]
fn columns_are_the_derivatives_of_the_residuals() {
    for name in ["cablerobot-simulator-helicopter", "planar-example"] {
        let model = Model::new(robot(name), Composition { drum: true, ..Composition::PULLEY }).unwrap();
        let samples = samples(&model);
        let poses = PoseLanes::new(&samples);
        let weights = length_weights(&model, &samples, &poses).unwrap();
        use ParameterKind::{DrumAxis, DrumPitch, FrameAnchor, StartAngle, SwivelAxis};
        let free = FreeParameters::of(&[FrameAnchor, DrumPitch, DrumAxis, StartAngle, SwivelAxis]);
        let parameters = free.parameters(&model, &FreeParameters::default()).unwrap();
        for cable in 0..model.cable_count() {
            let own: Vec<Parameter> = parameters.iter().filter(|parameter| parameter.cable == cable).copied().collect();
            let block = Block::new(&model, cable, own.clone(), &samples, &weights);
            let count = samples.len();
            let (residuals, columns) = block.rows(&poses, &block.start, count);
            assert!(residuals.iter().all(|residual| residual.abs() < 1e-9), "{name}: the model's own samples");
            for (k, parameter) in own.iter().enumerate() {
                // steps of 1e-5 with weights of 1000: truncation 1e-7 times third derivatives, rounding 1e-7
                let at = |step: f64| {
                    let mut change = vec![0.0; own.len()];
                    change[k] = step;
                    block.rows(&poses, &block.moved(&block.start, &change), count).0
                };
                let (ahead, behind) = (at(1e-5), at(-1e-5));
                for sample in 0..count {
                    let slope = (ahead[sample] - behind[sample]) / 2e-5;
                    let (found, name) = (columns[k][sample], parameter.name(model.robot()));
                    assert!((found - slope).abs() < 1e-6 * (1e3 + slope.abs()), "{name}: {found} {slope}");
                }
            }
        }
    }
}
