//! The description of a robot, in SI units and spatial vectors for any motion pattern.

use std::collections::BTreeMap;

use cdpr_core::cable::elasticity::StiffnessBasis;
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use super::{
    Assumption, Axis, CableStiffness, CableWinch, Component, HysteresisTable, Obstacle, Pulley, Source, TrackedFrames,
};
use crate::geometry::{MotionPattern, Plane, Pose, Wrench};

/// A cable robot as its file describes it. A number that the file does not state is `None`: unknown, never zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Robot {
    /// Short name, without spaces.
    pub name: String,
    /// One line of description.
    pub title: Option<String>,
    /// Degrees of freedom of the platform.
    pub motion_pattern: MotionPattern,
    /// Type in the file's own words, e.g. `spatial-suspended`.
    pub kind: Option<String>,
    /// World plane of a planar robot; xy for a spatial pattern.
    pub plane: Plane,
    /// Gravity (world, m/s²).
    pub gravity: Option<Vector3<f64>>,
    /// Remarks, one paragraph each.
    pub notes: Vec<String>,
    /// Source of the numbers.
    pub source: Option<Source>,
    /// Numbers that were neither published nor measured.
    pub assumptions: Vec<Assumption>,
    /// Mass properties.
    pub platform: Platform,
    /// A pose inside the workspace to start from.
    pub home: Option<Pose>,
    /// External wrench on the platform, besides the cables.
    pub external_wrench: Option<ExternalWrench>,
    /// Box of platform positions for plotting and sampling; not a proven workspace.
    pub travel: Option<TravelBox>,
    /// Obstacles in the way of cables (world).
    pub obstacles: Vec<Obstacle>,
    /// The cables, in the order of every per-cable list.
    pub cables: Vec<Cable>,
    /// Published numbers that the robot reproduces.
    pub reference_checks: Vec<ReferenceCheck>,
    /// Calibration that the numbers come from.
    pub calibration: Option<Calibration>,
    /// Frames of the recording that a calibration found them with; no part of the robot file.
    pub tracked: Option<TrackedFrames>,
}

impl Robot {
    /// Direction of a component of a frame in this robot's space: along its axes, then about them; in a plane about its normal. `None` beyond them.
    pub fn frame_component(&self, index: usize) -> Option<Component> {
        Component::of(self.motion_pattern, self.plane, index)
    }

    /// Number of components of a frame in this robot's space.
    pub fn frame_components(&self) -> usize {
        if self.motion_pattern.is_planar() { 3 } else { 6 }
    }
}

/// Calibration that a robot's numbers come from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Calibration {
    /// Status of its answer: `converged`, `converged-with-caution`, `recommended`, `recommended-with-caution`;
    /// `not-trusted`, `not-converged`, `not-identifiable` or `not-predictive` if no robot should be driven by these
    /// numbers.
    pub status: String,
}

/// Mass properties of the platform.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Platform {
    /// Mass (kg).
    pub mass: Option<f64>,
    /// Centre of mass (platform frame, m).
    pub center_of_mass: Option<Vector3<f64>>,
    /// Inertia about the centre of mass (platform axes, kg·m²).
    pub inertia: Option<Matrix3<f64>>,
    /// Damping of its velocity, D_lin: force −D_lin v at the platform origin (N·s/m).
    pub damping: Option<f64>,
    /// Damping of its angular velocity, D_rot: moment −D_rot ω (N·m·s/rad).
    pub rotational_damping: Option<f64>,
    /// Corners of the body, which is their convex hull (platform frame, m).
    pub hull: Option<Vec<Vector3<f64>>>,
}

/// A constant wrench on the platform.
#[derive(Clone, Debug, PartialEq)]
pub struct ExternalWrench {
    /// Force and moment about the platform origin (world axes; N, N·m).
    pub wrench: Wrench,
    /// True when the weight is part of it and must not be added again.
    pub includes_gravity: bool,
    /// Origin of the wrench.
    pub note: Option<String>,
}

/// An axis-parallel box of platform positions.
#[derive(Clone, Debug, PartialEq)]
pub struct TravelBox {
    /// Lower corner (world, m).
    pub min: Vector3<f64>,
    /// Upper corner (world, m).
    pub max: Vector3<f64>,
    /// Origin of the box.
    pub note: Option<String>,
}

/// One cable, from its frame anchor to its platform anchor.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cable {
    /// Name, not always unique (see [`Robot::warnings`]): cables are identified by their order.
    pub name: String,
    /// Frame anchor a (world, m); with the effect `pulley` the point D where the cable enters the swivelling pulley.
    pub frame_anchor: Vector3<f64>,
    /// Platform anchor b (platform frame, m).
    pub platform_anchor: Vector3<f64>,
    /// Pulley at the frame.
    pub pulley: Option<Pulley>,
    /// Side of a pulley that does not swivel (planar robots); `None` if it swivels.
    pub pulley_wrap_side: Option<WrapSide>,
    /// Least wrap angle on the pulley (rad).
    pub pulley_wrap_min: Option<f64>,
    /// Largest wrap angle on the pulley (rad).
    pub pulley_wrap_max: Option<f64>,
    /// Diameter of the cable (m).
    pub diameter: Option<f64>,
    /// Least geometric length q allowed (m).
    pub length_min: Option<f64>,
    /// Largest geometric length q allowed (m).
    pub length_max: Option<f64>,
    /// Largest speed of the cable that is allowed (m/s); see also [`CableWinch::motor_speed_max`].
    pub speed_max: Option<f64>,
    /// Least tension allowed (N).
    pub tension_min: Option<f64>,
    /// Largest tension allowed (N).
    pub tension_max: Option<f64>,
    /// Stiffness, by E·A or as a constant spring.
    pub stiffness: Option<CableStiffness>,
    /// Length by which the specific stiffness is divided.
    pub stiffness_by: Option<StiffnessBasis>,
    /// Strained length between winch and outlet that is not part of the geometry (m).
    pub hidden_length: Option<f64>,
    /// Further compliance in series (m/N).
    pub series_compliance: Option<f64>,
    /// Coefficients c₁, c₂, … of the polynomial tension f = Σ cₖ εᵏ of the strain (N).
    pub tension_of_strain: Option<Vec<f64>>,
    /// Loading and unloading branch of the tension against strain.
    pub hysteresis: Option<HysteresisTable>,
    /// Numbers of laws of stretch that are plain keys, by these keys (see [`LAWS`](super::LAWS)).
    pub law_numbers: BTreeMap<&'static str, f64>,
    /// Damping per rate of elongation (N·s/m).
    pub damping: Option<f64>,
    /// Damping time η, damping over stiffness (s); adds to `damping`.
    pub damping_time: Option<f64>,
    /// Friction coefficient μ of the pulley, its bearing included.
    pub pulley_friction: Option<f64>,
    /// Inertia of the pulley about its axis (kg·m²).
    pub pulley_inertia: Option<f64>,
    /// Winch, as far as the file states it.
    pub winch: CableWinch,
    /// q_recorded = length_scale · q_θ + length_offset; 1 when unknown.
    pub length_scale: Option<f64>,
    /// See `length_scale` (m); 0 when unknown.
    pub length_offset: Option<f64>,
    /// f_recorded = tension_scale · f + tension_offset; 1 when unknown.
    pub tension_scale: Option<f64>,
    /// See `tension_scale` (N); 0 when unknown.
    pub tension_offset: Option<f64>,
    /// Recorded swivel angle of the pulley less the angle itself (rad); 0 when unknown.
    pub swivel_offset: Option<f64>,
    /// Place at which recorded and given tensions act; the outlet when unknown. Matters with sag.
    pub tension_at: Option<TensionPlace>,
    /// Mass per length of the unstrained cable (kg/m).
    pub linear_density: Option<f64>,
    /// Elements of the effect `finite-element`; 10 when unknown.
    pub finite_elements: Option<usize>,
}

/// Side of the cable on which a pulley stands that does not swivel: of a cable that runs along `pulley_swivel_axis`, seen with
/// the first axis of the plane turning counterclockwise to the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum WrapSide {
    /// The cable turns left around it.
    Left,
    /// The cable turns right around it.
    Right,
}

/// At which end of its free part a cable's tension is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum TensionPlace {
    /// At the frame, as load cells of winches measure it.
    Outlet,
    /// At the platform anchor.
    Platform,
}

/// A published number with the pose and load it belongs to, as the file states it (numbers in the file's components).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct ReferenceCheck {
    /// Quantity compared, in words.
    pub what: String,
    /// Platform position (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position_m: Option<Vec<f64>>,
    /// External force (N).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force_N: Option<Vec<f64>>,
    /// External moment (N·m).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment_Nm: Option<Vec<f64>>,
    /// Tensions applied (N).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tension_N: Option<Vec<f64>>,
    /// Least tension allowed (N).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tension_min_N: Option<f64>,
    /// Largest tension allowed (N).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tension_max_N: Option<f64>,
    /// Tensions published (N).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected_tension_N: Option<Vec<f64>>,
    /// Wrench published (N, N·m).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected_wrench: Option<Vec<f64>>,
    /// Wrench of the upper cables published (N, N·m).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected_upper_wrench: Option<Vec<f64>>,
    /// Wrench of the lower cables published (N, N·m).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected_lower_wrench: Option<Vec<f64>>,
    /// Winch offsets published (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected_offset_m: Option<Vec<f64>>,
    /// Allowed deviation in the unit of the number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Allowed deviation of tensions (N).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance_N: Option<f64>,
    /// Equation or figure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
}

impl Cable {
    /// Pulley radius r_p (m), with or without an axis.
    pub fn pulley_radius(&self) -> Option<f64> {
        match self.pulley? {
            Pulley::Whole { radius, .. } | Pulley::Radius(radius) => Some(radius),
            Pulley::SwivelAxis(_) => None,
        }
    }

    /// Unit vector along the pulley's swivel axis (world), with or without a radius.
    pub fn pulley_swivel_axis(&self) -> Option<Vector3<f64>> {
        self.swivel_axis().map(|axis| *axis)
    }

    /// [`Cable::pulley_swivel_axis`] with the turn from the given direction.
    pub fn swivel_axis(&self) -> Option<Axis> {
        match self.pulley? {
            Pulley::Whole { swivel_axis, .. } | Pulley::SwivelAxis(swivel_axis) => Some(swivel_axis),
            Pulley::Radius(_) => None,
        }
    }

    /// Sets the radius of the pulley (m); its axis does not change.
    pub fn set_pulley_radius(&mut self, radius: f64) {
        self.pulley = Pulley::of(Some(radius), self.swivel_axis());
    }

    /// Sets the swivel axis of the pulley (unit, world); its radius does not change.
    pub fn set_pulley_swivel_axis(&mut self, swivel_axis: Vector3<f64>) {
        self.turn_swivel_axis(swivel_axis.into());
    }

    pub(crate) fn turn_swivel_axis(&mut self, swivel_axis: Axis) {
        self.pulley = Pulley::of(self.pulley_radius(), Some(swivel_axis));
    }

    /// Vector from the drum's position to the first pulley (world, m).
    pub(crate) fn way_to_first_pulley(&self) -> Option<Vector3<f64>> {
        Some(self.winch.first_pulley.unwrap_or(self.frame_anchor) - self.winch.position?)
    }

    /// Specific stiffness E·A (N), if it is stated as a stiffness.
    pub fn axial_stiffness(&self) -> Option<f64> {
        match self.stiffness? {
            CableStiffness::Axial(stiffness) => Some(stiffness),
            CableStiffness::Compliance(_) | CableStiffness::Spring(_) => None,
        }
    }

    /// Specific compliance 1/(E·A) (1/N), if it is stated as a compliance.
    pub fn axial_compliance(&self) -> Option<f64> {
        match self.stiffness? {
            CableStiffness::Compliance(compliance) => Some(compliance),
            CableStiffness::Axial(_) | CableStiffness::Spring(_) => None,
        }
    }

    /// Specific compliance 1/(E·A) (1/N), stated in either form; `None` for a constant spring.
    pub fn specific_compliance(&self) -> Option<f64> {
        match self.stiffness? {
            CableStiffness::Axial(stiffness) => Some(1.0 / stiffness),
            CableStiffness::Compliance(compliance) => Some(compliance),
            CableStiffness::Spring(_) => None,
        }
    }

    /// Spring constant (N/m), for a stiffness that does not depend on the length.
    pub fn spring_constant(&self) -> Option<f64> {
        match self.stiffness? {
            CableStiffness::Spring(constant) => Some(constant),
            CableStiffness::Axial(_) | CableStiffness::Compliance(_) => None,
        }
    }
}

impl Robot {
    /// Number of cables m.
    pub fn cable_count(&self) -> usize {
        self.cables.len()
    }

    /// Number of degrees of freedom n.
    pub fn dof(&self) -> usize {
        self.motion_pattern.dof()
    }

    /// x_A of a pulley that does not swivel, from D to its centre (unit, world); `None` if it swivels, or without an
    /// axis.
    pub fn pulley_side(&self, cable: &Cable) -> Option<Vector3<f64>> {
        let side = cable.pulley_wrap_side?;
        Some(self.side_of(&cable.pulley_swivel_axis()?, side))
    }

    /// The side of a direction in the plane (unit, world).
    pub(crate) fn side_of(&self, direction: &Vector3<f64>, side: WrapSide) -> Vector3<f64> {
        let left = self.plane.normal().cross(direction);
        match side {
            WrapSide::Left => left,
            WrapSide::Right => -left,
        }
    }

    /// Diagonal of the box of the frame anchors (m): the size of the robot.
    pub fn anchor_diagonal(&self) -> f64 {
        let [low, high] = self.anchor_box();
        (high - low).norm()
    }

    /// Lower and upper corner of the box around the frame anchors (m); the origin for a robot without cables.
    pub(crate) fn anchor_box(&self) -> [Vector3<f64>; 2] {
        let anchors = || self.cables.iter().map(|cable| cable.frame_anchor);
        let first = anchors().next().unwrap_or_default();
        anchors().fold([first, first], |[low, high], anchor| [low.inf(&anchor), high.sup(&anchor)])
    }

    /// The home pose, or the mean of the frame anchors with an unrotated platform if the file states none.
    pub fn home_or_middle(&self) -> Pose {
        self.home.unwrap_or_else(|| {
            let sum: Vector3<f64> = self.cables.iter().map(|cable| cable.frame_anchor).sum();
            Pose { position: sum / self.cables.len().max(1) as f64, ..Pose::identity() }
        })
    }
}
