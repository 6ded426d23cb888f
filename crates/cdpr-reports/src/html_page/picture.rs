//! Robots, poses and points as pages draw them.

use cdpr_model::cable::winch::Winch;
use cdpr_model::geometry::Pose;
use cdpr_model::robot::{Cable, Robot};
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

use super::{digits, plain};
use crate::answers::axis_names;

/// Digits of coordinates and of quaternions.
const COORDINATE_DIGITS: usize = 7;
const QUATERNION_DIGITS: usize = 9;

/// Robot as it stands.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Robot")]
pub(crate) struct RobotPicture {
    name: String,
    /// Names of the axes of positions: two in a plane, three in space.
    axes: Vec<String>,
    /// False for a point.
    turns: bool,
    /// Null for a spatial robot.
    plane: Option<PlanePicture>,
    cables: Vec<CablePicture>,
}

/// World directions of a planar robot's axes.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Plane")]
struct PlanePicture {
    first: [f64; 3],
    second: [f64; 3],
}

/// Cable between frame and platform.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Cable")]
struct CablePicture {
    name: String,
    frame_anchor_m: [f64; 3],
    platform_anchor_m: [f64; 3],
    /// Null where the limits are unknown.
    #[serde(rename = "tension_min_N")]
    tension_min: Option<f64>,
    /// Null where the limits are unknown.
    #[serde(rename = "tension_max_N")]
    tension_max: Option<f64>,
    /// Null where the file states no whole pulley.
    pulley: Option<PulleyPicture>,
    /// Null where the file does not state where the drum stands.
    drum: Option<DrumPicture>,
}

/// Pulley with radius and axis.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Pulley")]
struct PulleyPicture {
    radius_m: f64,
    swivel_axis: [f64; 3],
}

/// Drum: the ends of its groove on the axis, and the way of the cable to its first pulley at the start angle.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Drum")]
struct DrumPicture {
    radius_m: f64,
    from_m: [f64; 3],
    to_m: [f64; 3],
    /// Null behind a guide.
    way_m: Option<[[f64; 3]; 2]>,
}

/// Pose of the platform.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Pose")]
pub(crate) struct PosePicture {
    position_m: [f64; 3],
    quaternion_xyzw: [f64; 4],
}

impl RobotPicture {
    /// Picture of a robot with least and largest tension of each cable (N); without limits where they are unknown.
    pub(crate) fn of(robot: &Robot, limits: &[(f64, f64)]) -> Self {
        let cable = |(index, cable)| CablePicture::of(cable, limits.get(index).copied());
        Self {
            name: plain(&robot.name),
            axes: axis_names(robot),
            turns: robot.motion_pattern.has_rotation(),
            plane: robot.motion_pattern.is_planar().then(|| PlanePicture {
                first: robot.plane.first_axis().into(),
                second: robot.plane.second_axis().into(),
            }),
            cables: robot.cables.iter().enumerate().map(cable).collect(),
        }
    }
}

impl CablePicture {
    fn of(cable: &Cable, limits: Option<(f64, f64)>) -> Self {
        let pulley = cable.pulley_radius().zip(cable.pulley_swivel_axis());
        Self {
            name: plain(&cable.name),
            frame_anchor_m: vector(&cable.frame_anchor, COORDINATE_DIGITS),
            platform_anchor_m: vector(&cable.platform_anchor, COORDINATE_DIGITS),
            tension_min: limits.map(|(least, _)| least),
            tension_max: limits.map(|(_, largest)| largest),
            pulley: pulley.map(|(radius, axis)| PulleyPicture {
                radius_m: digits(radius, COORDINATE_DIGITS),
                swivel_axis: vector(&axis, COORDINATE_DIGITS),
            }),
            drum: DrumPicture::of(cable),
        }
    }
}

/// Length of a groove that the file leaves open, in radii of its drum.
const OPEN_GROOVE: f64 = 3.0;

impl DrumPicture {
    fn of(cable: &Cable) -> Option<Self> {
        let winch = &cable.winch;
        let (radius, position, axis) = (winch.radius?, winch.position?, *winch.axis?);
        let length = winch.groove.and_then(|groove| groove.ends).map_or(OPEN_GROOVE * radius, |ends| ends.length);
        let drum = Winch::of(cable).and_then(Result::ok);
        let leaves = drum.and_then(|winch| winch.drum.departure(winch.drum.parameters().start_angle).ok().flatten());
        let first_pulley = winch.first_pulley.unwrap_or(cable.frame_anchor);
        let point = |point: &Vector3<f64>| vector(point, COORDINATE_DIGITS);
        Some(Self {
            radius_m: digits(radius, COORDINATE_DIGITS),
            from_m: point(&position),
            to_m: point(&(position + axis * length)),
            way_m: leaves.map(|leaves| [point(&leaves.contact), point(&first_pulley)]),
        })
    }
}

impl PosePicture {
    pub(crate) fn of(pose: &Pose) -> Self {
        Self {
            position_m: vector(&pose.position, COORDINATE_DIGITS),
            quaternion_xyzw: quaternion(pose, QUATERNION_DIGITS),
        }
    }
}

/// Components of a point or direction, to so many digits.
pub(crate) fn vector(point: &Vector3<f64>, count: usize) -> [f64; 3] {
    <[f64; 3]>::from(*point).map(|component| digits(component, count))
}

/// Rotation of a pose as x, y, z, w, to so many digits.
pub(crate) fn quaternion(pose: &Pose, count: usize) -> [f64; 4] {
    <[f64; 4]>::from(pose.rotation.coords).map(|part| digits(part, count))
}
