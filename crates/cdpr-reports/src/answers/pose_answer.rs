//! Poses and vectors in the components of a motion pattern.

use cdpr_model::geometry::{MotionPattern, Pose, Twist};
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

/// A pose as the contract writes it.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
#[schemars(rename = "PoseAnswer")]
pub struct PoseAnswer {
    /// Position (m): three components, or the two of a planar robot.
    position_m: Vec<f64>,
    /// Angles of R = Rx Ry Rz (rad), of a spatial platform.
    #[serde(skip_serializing_if = "Option::is_none")]
    rotation_rad: Option<[f64; 3]>,
    /// The same as a quaternion.
    #[serde(skip_serializing_if = "Option::is_none")]
    quaternion_xyzw: Option<[f64; 4]>,
    /// Angle from the first to the second axis (rad), of a planar platform.
    #[serde(skip_serializing_if = "Option::is_none")]
    angle_rad: Option<f64>,
    /// The components with their names, for people.
    #[serde(skip)]
    words: String,
}

impl PoseAnswer {
    /// Pose in the components of the robot's files.
    pub fn new(robot: &Robot, pose: &Pose) -> Self {
        let components =
            robot.motion_pattern.pose_to_components(robot.plane, pose).into_iter().map(without_sign_of_zero);
        let components: Vec<f64> = components.collect();
        let translations = robot.motion_pattern.translations();
        let spatial = robot.motion_pattern == MotionPattern::Spatial;
        let quaternion = pose.rotation.coords;
        Self {
            position_m: components[..translations].to_vec(),
            rotation_rad: spatial.then(|| pose.xyz_angles().map(without_sign_of_zero)),
            quaternion_xyzw: spatial.then(|| [quaternion.x, quaternion.y, quaternion.z, quaternion.w]),
            angle_rad: (robot.motion_pattern == MotionPattern::Planar).then(|| components[translations]),
            words: words(robot, &components),
        }
    }

    /// The components with names and units.
    pub fn words(&self) -> &str {
        &self.words
    }
}

/// Translation and rotation of a twist or its rate, in the directions of a model's motion.
pub(super) fn rates(model: &Model, twist: &Twist) -> (Vec<f64>, Option<AngularRate>) {
    let pattern = model.robot().motion_pattern;
    let all: Vec<f64> = model.twist_basis().iter().map(|basis| basis.dot(twist) + 0.0).collect();
    let (translation, turning) = all.split_at(pattern.translations());
    let turning = match pattern {
        MotionPattern::Planar => Some(AngularRate::Planar(turning[0])),
        MotionPattern::Spatial => Some(AngularRate::Spatial([turning[0], turning[1], turning[2]])),
        _ => None,
    };
    (translation.to_vec(), turning)
}

/// Components about the world's axes, or of a planar robot about the normal of its plane.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum AngularRate {
    Planar(f64),
    Spatial([f64; 3]),
}

impl AngularRate {
    /// One number, or three.
    pub(super) fn components(&self) -> &[f64] {
        match self {
            Self::Planar(angle) => std::slice::from_ref(angle),
            Self::Spatial(vector) => vector,
        }
    }
}

/// A robot with its model, as answers and figures name it.
pub fn title(model: &Model) -> String {
    format!("{} ({})", model.robot().name, model.composition())
}

/// Names of the axes that a robot's vectors have.
pub fn axis_names(robot: &Robot) -> Vec<String> {
    let names = if robot.motion_pattern.is_planar() { robot.plane.axes() } else { "xyz".to_owned() };
    names.chars().map(String::from).collect()
}

/// Names of the degrees of freedom: displacements along the axes, then turns about them, of a planar robot the one in its plane.
pub fn degrees_of_freedom(robot: &Robot) -> Vec<String> {
    let axes = axis_names(robot);
    let turns = match robot.motion_pattern {
        MotionPattern::Planar => vec!["turn".to_owned()],
        MotionPattern::Spatial => axes.iter().map(|axis| format!("turn {axis}")).collect(),
        _ => Vec::new(),
    };
    [axes, turns].concat()
}

/// A world vector in the components of the robot's files.
pub fn components(robot: &Robot, vector: &Vector3<f64>) -> Vec<f64> {
    let components = match robot.motion_pattern.is_planar() {
        true => robot.plane.components(vector).to_vec(),
        false => vector.as_slice().to_vec(),
    };
    components.into_iter().map(without_sign_of_zero).collect()
}

/// −0 as 0: the sign of zero says nothing and puzzles readers.
fn without_sign_of_zero(number: f64) -> f64 {
    number + 0.0
}

fn words(robot: &Robot, components: &[f64]) -> String {
    let axes = axis_names(robot);
    let (position, angles) = components.split_at(axes.len());
    let mut parts: Vec<String> = axes.iter().zip(position).map(|(axis, x)| format!("{axis} {x:.6} m")).collect();
    let angle_names = if angles.len() == 1 { vec!["angle"] } else { vec!["rx", "ry", "rz"] };
    let in_degrees = |(name, angle): (&str, &f64)| format!("{name} {angle:.6} rad ({:.3}°)", angle.to_degrees());
    parts.extend(angle_names.into_iter().zip(angles).map(in_degrees));
    parts.join(", ")
}
