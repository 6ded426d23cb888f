//! Names and numbers of a pose in measurement files.

use crate::geometry::{MotionPattern, Pose};
use crate::robot::Robot;

/// Names of the columns of a robot's positions in a unit; for a planar robot those of the axes of its plane.
pub fn position_columns(robot: &Robot, unit: &str) -> Vec<String> {
    let axes = if robot.motion_pattern.is_planar() { robot.plane.axes() } else { "xyz".to_owned() };
    axes.chars().map(|axis| format!("{axis}_{unit}")).collect()
}

/// Names of the columns of a pattern's orientations; empty for a point platform.
pub fn turn_columns(pattern: MotionPattern) -> &'static [&'static str] {
    match pattern {
        MotionPattern::Planar => &["angle_rad"],
        MotionPattern::Spatial => &["qx", "qy", "qz", "qw"],
        _ => &[],
    }
}

/// Names of the columns of a robot's poses (m; unit quaternion or rad).
pub fn pose_columns(robot: &Robot) -> Vec<String> {
    let turns = turn_columns(robot.motion_pattern).iter().map(|name| (*name).to_owned());
    position_columns(robot, "m").into_iter().chain(turns).collect()
}

/// Numbers of a pose in the order of [`pose_columns`].
pub fn pose_numbers(robot: &Robot, pose: &Pose) -> Vec<f64> {
    match robot.motion_pattern {
        MotionPattern::Spatial => pose.position.iter().chain(pose.rotation.coords.iter()).copied().collect(),
        pattern => pattern.pose_to_components(robot.plane, pose),
    }
}

/// Numbers of an orientation in the order of [`turn_columns`].
pub fn turn_numbers(robot: &Robot, pose: &Pose) -> Vec<f64> {
    pose_numbers(robot, pose).split_off(robot.motion_pattern.translations())
}
