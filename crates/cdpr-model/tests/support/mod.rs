//! Robots, poses and virtual measurements for the tests.
#![allow(dead_code, reason = "each test file uses its own part")]

use cdpr_model::control::CommandedPose;
use cdpr_model::control::simulate::simulate;
use cdpr_model::control::{Control, InputError, Operation, Outcome};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model, place_pulleys};
use cdpr_model::robot::{DrumSide, Robot};
use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Sensor noise of the demo: standard deviations per axis.
pub(crate) const NOISE: SensorSigmas = SensorSigmas {
    position: Some(0.001155),
    rotation: Some(0.00101),
    length: Some(0.0002),
    tension: Some(50.0),
    swivel: None,
    length_scale: None,
    balance_force: None,
    balance_moment: None,
};

pub(crate) fn builtin(name: &str) -> Robot {
    Robot::builtin(name).unwrap_or_else(|| panic!("{name} is built in"))
}

/// The nominal CableRobot Simulator (eq. 6.1).
pub(crate) fn simulator() -> Robot {
    builtin("cablerobot-simulator-helicopter")
}

/// Outcome of each pose that a control model commands to a machine.
pub(crate) fn operate(
    control: impl Into<Control>,
    machine: &Model,
    offsets: &[f64],
    poses: &[CommandedPose],
) -> Result<Vec<Outcome>, InputError> {
    let mut operation = Operation::new(control, machine, offsets)?;
    Ok(poses.iter().map(|command| operation.answer(command)).collect())
}

/// Pulleys with +z axes whose contact points at the home pose are the published anchors.
pub(crate) fn with_pulleys(robot: &Robot, default_radius: f64) -> Robot {
    let pulleys: Vec<_> =
        robot.cables.iter().map(|cable| (cable.pulley_radius().unwrap_or(default_radius), Vector3::z())).collect();
    place_pulleys(robot, &pulleys, &robot.home.expect("has a home pose")).expect("pulleys fit")
}

/// The robot with a winch two metres below every frame anchor, its drum along an edge of the frame, geared 10 : 1.
pub(crate) fn with_drums(robot: &Robot) -> Robot {
    let mut robot = robot.clone();
    for (index, cable) in robot.cables.iter_mut().enumerate() {
        let is_even = index % 2 == 0;
        cable.winch.radius = Some(0.1);
        cable.winch.set_pitch(0.008);
        cable.winch.axis = Some(if is_even { Vector3::x() } else { -Vector3::y() }.into());
        cable.winch.position = Some(cable.frame_anchor + Vector3::new(-0.1, 0.05, -2.0));
        cable.winch.side = Some(if is_even { DrumSide::Left } else { DrumSide::Right });
        (cable.winch.start_length, cable.winch.gear_ratio) = (Some(4.0), Some(10.0));
    }
    robot
}

pub(crate) fn random_direction(rng: &mut ChaCha8Rng) -> Vector3<f64> {
    loop {
        let v = Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0));
        if v.norm() > 0.1 && v.norm() < 1.0 {
            return v.normalize();
        }
    }
}

/// Uniform in the robot's travel box (1 m around home where the file has none), each angle within ± `angle` (rad).
pub(crate) fn random_pose(robot: &Robot, angle: f64, rng: &mut ChaCha8Rng) -> Pose {
    let home = robot.home.expect("has a home pose");
    let (min, max) = match &robot.travel {
        Some(travel) => (travel.min, travel.max),
        None => (home.position.add_scalar(-1.0), home.position.add_scalar(1.0)),
    };
    let position = Vector3::from_fn(|k, _| min[k] + (max[k] - min[k]) * rng.random::<f64>());
    let home = home.rotation;
    let turn = Pose::from_xyz_angles(position, [0, 1, 2].map(|_| angle * rng.random_range(-1.0..=1.0)));
    Pose { position, rotation: turn.rotation * home }
}

/// The pose that differs from `base` as much as the model's motion pattern can follow towards `pose`.
pub(crate) fn within_pattern(model: &Model, base: &Pose, pose: &Pose) -> Pose {
    let away = base.displacement_to(pose);
    let twist: Twist = model.twist_basis().iter().map(|direction| direction * direction.dot(&away)).sum();
    base.displaced(&twist)
}

/// `shift` metres and `turn` radians away, in random directions.
pub(crate) fn displaced(pose: &Pose, shift: f64, turn: f64, rng: &mut ChaCha8Rng) -> Pose {
    let (v, omega) = (random_direction(rng) * shift, random_direction(rng) * turn);
    pose.displaced(&Twist::new(v.x, v.y, v.z, omega.x, omega.y, omega.z))
}

pub(crate) fn random_poses(robot: &Robot, count: usize, angle: f64, seed: u64) -> Vec<CommandedPose> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..count).map(|_| CommandedPose::at(random_pose(robot, angle, &mut rng))).collect()
}

/// What a machine records at random poses with orientations within ± `angle` (rad).
pub(crate) fn measured(machine: &Robot, composition: Composition, count: usize, angle: f64, seed: u64) -> Samples {
    let model = Model::new(machine.clone(), composition).expect("is a model");
    let poses = random_poses(machine, count, angle, seed);
    simulate(&model, &model, &vec![0.0; model.cable_count()], &poses, &NOISE, seed)
        .expect("machine and control model fit")
        .samples
}
