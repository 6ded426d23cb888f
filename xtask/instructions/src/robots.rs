//! Robots and poses of the counted work.

use cdpr::geometry::{Pose, Twist};
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::Vector3;
use cdpr::robot::Robot;

pub(crate) const POSES: u32 = 64;
pub(crate) const ELASTIC: &str = "cablerobot-simulator-helicopter-elastostatic-calibrated";
pub(crate) const RIGID: &str = "cablerobot-simulator-helicopter";

/// A number in [0, 1) for each step and axis, evenly spread (R. Kronecker's sequence).
pub(crate) fn spread(step: u32, axis: u32) -> f64 {
    (f64::from(step) * f64::from(2 + 3 * axis).sqrt()).fract()
}

pub(crate) fn pose(step: u32) -> Pose {
    let part = |axis| 2.0 * spread(step + 1, axis) - 1.0;
    let position = Vector3::new(1.5 * part(0), 1.5 * part(1), 1.6 + 0.4 * part(2));
    Pose::from_xyz_angles(position, [0.15 * part(4), 0.15 * part(5), 0.15 * part(7)])
}

pub(crate) fn poses() -> Vec<Pose> {
    (0..POSES).map(pose).collect()
}

/// 0.1 m and 3° beside a pose.
pub(crate) fn beside(pose: &Pose) -> Pose {
    let along = Vector3::new(1.0, -1.0, 1.0).normalize();
    let (shift, turn) = (0.1 * along, 3.0_f64.to_radians() * along);
    pose.displaced(&Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z))
}

pub(crate) fn model(robot: &str, composition: Composition) -> Model {
    Model::new(builtin(robot), composition).expect("a model")
}

pub(crate) fn with_pulleys() -> Model {
    Model::new(on_pulleys(), Composition::PULLEY).expect("a model")
}

pub(crate) fn builtin(robot: &str) -> Robot {
    Robot::builtin(robot).expect("built in")
}

pub(crate) fn on_pulleys() -> Robot {
    let robot = builtin(RIGID);
    place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).expect("placed")
}

/// A machine of this model whose frame anchors are up to 5 mm elsewhere.
pub(crate) fn moved(nominal: &Model) -> Model {
    let mut robot = nominal.robot().clone();
    for (index, cable) in (0..).zip(&mut robot.cables) {
        cable.frame_anchor += Vector3::from_fn(|axis, _| 0.01 * spread(index + 1, axis as u32) - 0.005);
    }
    Model::new(robot, nominal.composition()).expect("a model")
}
