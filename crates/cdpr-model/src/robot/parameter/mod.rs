//! Parameters: one type for every number of a robot, with its value, name, unit and bounds.
//!
//! Robot files, `--free` lists, sensitivities, tolerances and sweeps refer to the same numbers; each of them is a
//! [`Parameter`].

mod cable_numbers;
mod kind;
mod naming;
mod range;
#[cfg(test)]
mod tests;

use nalgebra::Vector3;

use super::{Axis, CableStiffness, Component, ExternalWrench, Frame, Robot, TrackedFrames};
use crate::geometry::Wrench;
use cable_numbers::{of_cable, set_of_cable};
pub use kind::ParameterKind;
pub use naming::{Head, axis_name};
pub(crate) use range::{Owner, Range};

/// Largest turn of an axis (rad): a larger deviation from the drawing means that the drawing is wrong.
const LARGEST_TURN: f64 = 0.5;

/// One number of a robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Parameter {
    /// Its cable, from 0; 0 for a number of the platform, which belongs to no cable.
    pub cable: usize,
    /// Kind.
    pub kind: ParameterKind,
    /// Component, from 0: of a vector along the pattern's axes (rotations for moments), of the wrench along its degrees
    /// of freedom, or of an axis' turn; 0 for other numbers.
    pub axis: usize,
}

impl ParameterKind {
    /// Number of components of this kind for a robot.
    pub fn components(self, robot: &Robot) -> usize {
        let (dof, translations) = (robot.dof(), robot.motion_pattern.translations());
        match self {
            Self::FrameAnchor | Self::PlatformAnchor | Self::Force | Self::CenterOfMass | Self::Gravity => translations,
            Self::Moment => dof - translations,
            Self::Wrench => dof,
            Self::TrackerFrame | Self::MarkerFrame => robot.frame_components(),
            Self::DrumAxis => 2,
            Self::SwivelAxis => {
                if robot.motion_pattern.is_planar() {
                    1
                } else {
                    2
                }
            }
            _ => 1,
        }
    }
}

impl Parameter {
    /// Value that the robot states; `None` if it states none.
    ///
    /// Stiffness and compliance are one number: if the robot states one of them, both have a value.
    pub fn get(&self, robot: &Robot) -> Option<f64> {
        use ParameterKind as Kind;
        let external = robot.external_wrench.as_ref();
        match self.kind {
            Kind::Mass => robot.platform.mass,
            Kind::PlatformDamping => robot.platform.damping,
            Kind::RotationalDamping => robot.platform.rotational_damping,
            Kind::CenterOfMass => robot.platform.center_of_mass.map(|center| component(robot, &center, self.axis)),
            Kind::Gravity => robot.gravity.map(|gravity| component(robot, &gravity, self.axis)),
            Kind::Force | Kind::Moment => external.map(|external| self.of_wrench(robot, &external.wrench)),
            // identification means the constant wrench with the weight, not one without it
            Kind::Wrench => external
                .filter(|external| external.includes_gravity)
                .map(|external| self.of_wrench(robot, &external.wrench)),
            Kind::FrameAnchor => Some(component(robot, &robot.cables[self.cable].frame_anchor, self.axis)),
            Kind::PlatformAnchor => Some(component(robot, &robot.cables[self.cable].platform_anchor, self.axis)),
            Kind::TrackerFrame | Kind::MarkerFrame => {
                let (frame, component) = (self.frame_of(robot.tracked?), robot.frame_component(self.axis)?);
                Some(match component {
                    Component::Shift(axis) => axis.dot(&frame.position),
                    Component::Turn(axis) => axis.dot(&frame.turn),
                })
            }
            Kind::DrumAxis | Kind::SwivelAxis => {
                self.axis_of(robot).map(|axis| axis.turn_about(&self.turn_direction(robot, &axis)))
            }
            kind => of_cable(kind, &robot.cables[self.cable]),
        }
    }

    /// Value that the robot states, otherwise the neutral one (scale 1, offset 0).
    pub fn value(&self, robot: &Robot) -> f64 {
        match (self.kind, &robot.external_wrench) {
            (ParameterKind::Wrench, Some(external)) => self.of_wrench(robot, &external.wrench),
            _ => self.get(robot).unwrap_or(self.kind.neutral()),
        }
    }

    /// Writes a value into a robot. Nothing else changes, except that stiffness, compliance and spring constant replace
    /// each other, and that a wrench then includes the weight. Values for a groove length without a pitch, a layer
    /// height without a groove length, or the turn of a missing axis have no effect.
    pub fn set(&self, robot: &mut Robot, value: f64) {
        use ParameterKind as Kind;
        let index = axis_index(robot, self.axis);
        match self.kind {
            Kind::Mass => robot.platform.mass = Some(value),
            Kind::PlatformDamping => robot.platform.damping = Some(value),
            Kind::RotationalDamping => robot.platform.rotational_damping = Some(value),
            Kind::CenterOfMass => robot.platform.center_of_mass.get_or_insert_default()[index] = value,
            Kind::Gravity => robot.gravity.get_or_insert_default()[index] = value,
            Kind::Force | Kind::Moment | Kind::Wrench => self.set_wrench(robot, value),
            Kind::FrameAnchor => robot.cables[self.cable].frame_anchor[index] = value,
            Kind::PlatformAnchor => robot.cables[self.cable].platform_anchor[index] = value,
            Kind::DrumAxis | Kind::SwivelAxis => self.set_turn(robot, value),
            Kind::TrackerFrame | Kind::MarkerFrame => self.set_frame(robot, value),
            kind => set_of_cable(kind, &mut robot.cables[self.cable], value),
        }
    }

    /// Parameters of a kind that identification has for a cable (0-based): all components, but for the drum's axis only
    /// the turn that tilts it more towards its first pulley, since lengths depend on no other turn of it.
    pub(crate) fn identified(kind: ParameterKind, robot: &Robot, cable: usize) -> Vec<Self> {
        let all = (0..kind.components(robot)).map(|axis| Self { cable, kind, axis });
        let Some(towards) = robot.cables[cable].way_to_first_pulley() else {
            return all.collect();
        };
        let lean = |parameter: &Self| {
            let turned = parameter.turned_axis(robot);
            turned.map_or(0.0, |(axis, about)| axis.by_turn_about(&about).dot(&towards).abs())
        };
        match kind {
            ParameterKind::DrumAxis => all.reduce(|a, b| if lean(&b) > lean(&a) { b } else { a }).into_iter().collect(),
            _ => all.collect(),
        }
    }

    /// Axis to which a turn belongs.
    fn axis_of(&self, robot: &Robot) -> Option<Axis> {
        let cable = &robot.cables[self.cable];
        match self.kind {
            ParameterKind::DrumAxis => cable.winch.axis,
            ParameterKind::SwivelAxis => cable.swivel_axis(),
            _ => None,
        }
    }

    /// The frame to which a component belongs.
    fn frame_of(&self, frames: TrackedFrames) -> Frame {
        if self.kind == ParameterKind::TrackerFrame { frames.tracker } else { frames.marker }
    }

    fn set_frame(&self, robot: &mut Robot, value: f64) {
        let Some(component) = robot.frame_component(self.axis) else { return };
        let frames = robot.tracked.get_or_insert_default();
        let frame = if self.kind == ParameterKind::TrackerFrame { &mut frames.tracker } else { &mut frames.marker };
        let (vector, axis) = match component {
            Component::Shift(axis) => (&mut frame.position, axis),
            Component::Turn(axis) => (&mut frame.turn, axis),
        };
        *vector += axis * (value - axis.dot(vector));
    }

    /// Direction about which an axis turns.
    fn turn_direction(&self, robot: &Robot, axis: &Axis) -> Vector3<f64> {
        match self.kind {
            ParameterKind::SwivelAxis if robot.motion_pattern.is_planar() => robot.plane.normal(),
            _ => axis.directions()[self.axis],
        }
    }

    fn set_turn(&self, robot: &mut Robot, value: f64) {
        let Some(mut axis) = self.axis_of(robot) else { return };
        axis.set_turn_about(&self.turn_direction(robot, &axis), value);
        let cable = &mut robot.cables[self.cable];
        match self.kind {
            ParameterKind::DrumAxis => cable.winch.axis = Some(axis),
            _ => cable.turn_swivel_axis(axis),
        }
    }

    /// Axis that the parameter turns, and the direction about which it does; `None` if it turns no axis of the robot.
    pub fn turned_axis(&self, robot: &Robot) -> Option<(Axis, Vector3<f64>)> {
        let axis = self.axis_of(robot)?;
        Some((axis, self.turn_direction(robot, &axis)))
    }

    /// [`Parameter::set`] if the reader of robot files would accept the value for any other numbers of the robot.
    /// `None` for a value out of range, for a vector or table that the robot does not state, and if other numbers
    /// decide, as for least and largest values.
    #[cfg(feature = "files")]
    pub fn set_alone(&self, robot: &mut Robot, value: f64) -> Option<()> {
        let is_alone = match self.kind {
            _ if !self.kind.range().contains(value) => false,
            ParameterKind::AxialStiffness | ParameterKind::Compliance | ParameterKind::SpringConstant => {
                let stated = robot.cables[self.cable].stiffness.map(|stiffness| match stiffness {
                    CableStiffness::Axial(_) => ParameterKind::AxialStiffness,
                    CableStiffness::Compliance(_) => ParameterKind::Compliance,
                    CableStiffness::Spring(_) => ParameterKind::SpringConstant,
                });
                stated.is_none_or(|stated| stated == self.kind)
            }
            ParameterKind::CenterOfMass | ParameterKind::Gravity | ParameterKind::Force | ParameterKind::Moment => {
                self.get(robot).is_some()
            }
            // a cable states all numbers of a law or none
            ParameterKind::Stretch(_) => self.get(robot).is_some(),
            // the first pulley must lie outside the drum
            ParameterKind::FrameAnchor => robot.cables[self.cable].winch.position.is_none(),
            ParameterKind::TensionMin | ParameterKind::TensionMax | ParameterKind::LengthMin => false,
            ParameterKind::LengthMax | ParameterKind::WrapMin | ParameterKind::WrapMax => false,
            ParameterKind::DrumRadius | ParameterKind::DrumPitch | ParameterKind::SpoolBuildUp => false,
            ParameterKind::GrooveLength | ParameterKind::LayerHeight => false,
            // a motor moves the cable by the drum's radius
            ParameterKind::MotorSpeedMax => robot.cables[self.cable].winch.radius.is_some(),
            // static friction of a drum must not be below sliding friction, and a pulley turns by its radius
            ParameterKind::CoulombFriction => robot.cables[self.cable].winch.static_friction.is_none(),
            ParameterKind::StaticFriction | ParameterKind::StribeckSpeed | ParameterKind::PulleyInertia => false,
            ParameterKind::PulleyRadius => robot.cables[self.cable].pulley_inertia.is_none(),
            ParameterKind::DrumAxis | ParameterKind::SwivelAxis => false,
            _ => true,
        };
        if !is_alone {
            return None;
        }
        self.set(robot, value);
        // cables from one point cannot hold a platform
        let first = robot.cables.first().map(|cable| cable.frame_anchor);
        let is_apart = robot.cables.len() < 2 || robot.cables.iter().any(|cable| Some(cable.frame_anchor) != first);
        is_apart.then_some(())
    }

    /// Values that searches may try: radii, compliances and hidden lengths not below 0; scales, radii of drums and
    /// numbers of laws positive; turns of axes up to half a radian about each direction.
    pub fn bounds(&self) -> (f64, f64) {
        match self.kind.range() {
            _ if self.kind.is_turn() => (-LARGEST_TURN, LARGEST_TURN),
            // strains are small
            _ if matches!(self.kind, ParameterKind::Stretch(_)) => (1e-9, f64::INFINITY),
            Range::NotNegative => (0.0, f64::INFINITY),
            Range::Positive => (1e-3, f64::INFINITY),
            Range::Real | Range::NotZero => (f64::NEG_INFINITY, f64::INFINITY),
        }
    }

    /// Unit of the value, empty for a ratio.
    pub fn unit(&self, robot: &Robot) -> &'static str {
        match self.kind {
            kind if self.axis < robot.motion_pattern.translations() => kind.unit(),
            ParameterKind::Wrench => "N·m",
            kind if kind.is_of_recording() => "rad",
            kind => kind.unit(),
        }
    }

    /// Degree of freedom along which a force, a moment or the wrench acts.
    pub fn degree_of_freedom(&self, robot: &Robot) -> usize {
        match self.kind {
            ParameterKind::Moment => robot.motion_pattern.translations() + self.axis,
            _ => self.axis,
        }
    }

    fn of_wrench(&self, robot: &Robot, wrench: &Wrench) -> f64 {
        let (row, sign) = wrench_row(robot, self.degree_of_freedom(robot));
        sign * wrench[row] + 0.0
    }

    fn set_wrench(&self, robot: &mut Robot, value: f64) {
        let (row, sign) = wrench_row(robot, self.degree_of_freedom(robot));
        let is_whole = self.kind == ParameterKind::Wrench;
        let external = robot.external_wrench.get_or_insert_with(|| ExternalWrench {
            wrench: Wrench::zeros(),
            includes_gravity: is_whole,
            note: is_whole.then(|| "identified".to_owned()),
        });
        external.wrench[row] = sign * value;
        external.includes_gravity |= is_whole;
    }
}

/// World coordinate of an axis of the pattern, from 0.
fn axis_index(robot: &Robot, axis: usize) -> usize {
    match robot.motion_pattern.is_planar() {
        true => robot.plane.indices().get(axis).copied().unwrap_or_default(),
        false => axis,
    }
}

/// Component of a vector along an axis of the pattern; zero is never negative.
fn component(robot: &Robot, vector: &Vector3<f64>, axis: usize) -> f64 {
    vector[axis_index(robot, axis)] + 0.0
}

/// Row of a wrench for a degree of freedom, and its sign: the plane's normal may be a negative axis.
fn wrench_row(robot: &Robot, degree_of_freedom: usize) -> (usize, f64) {
    let translations = robot.motion_pattern.translations();
    match degree_of_freedom.checked_sub(translations) {
        None => (axis_index(robot, degree_of_freedom), 1.0),
        Some(_) if robot.motion_pattern.is_planar() => {
            let normal = robot.plane.normal();
            (3 + normal.iamax(), normal.sum())
        }
        Some(axis) => (3 + axis, 1.0),
    }
}
