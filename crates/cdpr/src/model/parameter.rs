//! Parameters that identification may free: their names, and where they live in the robot.

use std::fmt;
use std::str::FromStr;

use nalgebra::Matrix3;

use super::{Model, ParameterError};
use crate::cable::CableState;
use crate::cable::law::LawParameter;
use crate::geometry::Wrench;
use crate::robot::{Cable, ExternalWrench, Robot};
use crate::scalar::cross;

/// A kind of parameter: one group per cable, but for the wrench, which the platform has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum ParameterKind {
    /// Frame anchor a (world, m); entry point D of a pulley.
    FrameAnchor,
    /// Platform anchor b (platform frame, m).
    PlatformAnchor,
    /// q_recorded = length_scale · q_θ + length_offset (m).
    LengthOffset,
    /// See [`ParameterKind::LengthOffset`]; without unit.
    LengthScale,
    /// Pulley radius r_p (m).
    PulleyRadius,
    /// Radius of the winch's drum to the cable's centre line (m); data of motor angles tell it.
    DrumRadius,
    /// Controlled length at the drum's start angle (m); data of motor angles tell it. It shifts lengths as the length offset
    /// does: one of the two is free, never both.
    StartLength,
    /// Specific compliance 1/EA (1/N): its inverse, the stiffness, runs away where data say little (see the book).
    Compliance,
    /// Strained length between winch and outlet q_h (m).
    HiddenLength,
    /// f_recorded = tension_scale · f + tension_offset; without unit.
    TensionScale,
    /// See [`ParameterKind::TensionScale`] (N).
    TensionOffset,
    /// The constant external wrench in world axes, weight included (N, N·m).
    Wrench,
}

impl ParameterKind {
    /// Every kind, in the order of a parameter vector.
    pub const ALL: [Self; 12] = [
        Self::FrameAnchor,
        Self::PlatformAnchor,
        Self::LengthOffset,
        Self::LengthScale,
        Self::PulleyRadius,
        Self::DrumRadius,
        Self::StartLength,
        Self::Compliance,
        Self::HiddenLength,
        Self::TensionScale,
        Self::TensionOffset,
        Self::Wrench,
    ];

    /// The name used by `--free` and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::FrameAnchor => "frame-anchor",
            Self::PlatformAnchor => "platform-anchor",
            Self::LengthOffset => "length-offset",
            Self::LengthScale => "length-scale",
            Self::PulleyRadius => "pulley-radius",
            Self::DrumRadius => "drum-radius",
            Self::StartLength => "start-length",
            Self::Compliance => "compliance",
            Self::HiddenLength => "hidden-length",
            Self::TensionScale => "tension-scale",
            Self::TensionOffset => "tension-offset",
            Self::Wrench => "wrench",
        }
    }

    /// Unit of the value, empty for a ratio; a wrench is in N, its moments in N·m.
    pub fn unit(self) -> &'static str {
        match self {
            Self::LengthScale | Self::TensionScale => "",
            Self::Compliance => "1/N",
            Self::TensionOffset | Self::Wrench => "N",
            _ => "m",
        }
    }

    /// True for what only a model with elastic cables and recorded tensions can tell.
    pub fn needs_elasticity(self) -> bool {
        matches!(self, Self::Compliance | Self::HiddenLength | Self::TensionScale | Self::TensionOffset | Self::Wrench)
    }

    /// True for what only recorded motor angles can tell.
    pub fn needs_motor_angles(self) -> bool {
        matches!(self, Self::DrumRadius | Self::StartLength)
    }

    /// True for the anchors, which have a component along each axis of the pattern.
    pub fn is_anchor(self) -> bool {
        matches!(self, Self::FrameAnchor | Self::PlatformAnchor)
    }
}

impl FromStr for ParameterKind {
    type Err = ParameterError;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        if let Some(kind) = Self::ALL.into_iter().find(|kind| kind.name() == name) {
            return Ok(kind);
        }
        Err(ParameterError::UnknownName { name: name.to_owned() })
    }
}

impl fmt::Display for ParameterKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// One number that can be identified.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Parameter {
    /// Cable it belongs to, from 0; 0 for the wrench, which belongs to none.
    pub cable: usize,
    /// What it is.
    pub kind: ParameterKind,
    /// Component of an anchor along the pattern's axes, or of the wrench along its degrees of freedom, from 0; 0 for the
    /// rest.
    pub axis: usize,
}

impl Parameter {
    /// Name for people and files, e.g. `frame-anchor[1].x`.
    pub fn name(&self, robot: &Robot) -> String {
        let cable = self.cable + 1;
        match self.kind {
            ParameterKind::Wrench => {
                let translations = robot.motion_pattern.translations();
                match self.axis.checked_sub(translations) {
                    None => format!("wrench.force_{}", axis_name(robot, self.axis)),
                    Some(_) if robot.motion_pattern.is_planar() => "wrench.moment".to_owned(),
                    Some(axis) => format!("wrench.moment_{}", axis_name(robot, axis)),
                }
            }
            kind if kind.is_anchor() => format!("{kind}[{cable}].{}", axis_name(robot, self.axis)),
            kind => format!("{kind}[{cable}]"),
        }
    }

    /// Unit of the value, empty for a ratio.
    pub fn unit(&self, robot: &Robot) -> &'static str {
        let is_moment = self.kind == ParameterKind::Wrench && self.axis >= robot.motion_pattern.translations();
        if is_moment { "N·m" } else { self.kind.unit() }
    }

    /// Its value in a model's robot: what the file says, else the neutral value (scale 1, offset 0).
    pub fn value(&self, model: &Model) -> f64 {
        let cable = &model.robot().cables[self.cable];
        match self.kind {
            ParameterKind::FrameAnchor => model.axes()[self.axis].dot(&cable.frame_anchor),
            ParameterKind::PlatformAnchor => model.axes()[self.axis].dot(&cable.platform_anchor),
            ParameterKind::LengthOffset => cable.length_offset.unwrap_or(0.0),
            ParameterKind::LengthScale => cable.length_scale.unwrap_or(1.0),
            ParameterKind::PulleyRadius => cable.pulley_radius.unwrap_or(0.0),
            ParameterKind::DrumRadius => cable.drum_radius.unwrap_or(0.0),
            ParameterKind::StartLength => cable.drum_start_length.unwrap_or(0.0),
            ParameterKind::Compliance => specific_compliance(cable),
            ParameterKind::HiddenLength => cable.hidden_length.unwrap_or(0.0),
            ParameterKind::TensionScale => cable.tension_scale.unwrap_or(1.0),
            ParameterKind::TensionOffset => cable.tension_offset.unwrap_or(0.0),
            ParameterKind::Wrench => {
                let wrench = model.robot().external_wrench.as_ref().map_or_else(Wrench::zeros, |w| w.wrench);
                model.twist_basis()[self.axis].dot(&wrench)
            }
        }
    }

    /// Its value where the robot states one; `None` where [`Parameter::value`] is a neutral value.
    pub fn stated(&self, model: &Model) -> Option<f64> {
        let cable = &model.robot().cables[self.cable];
        let stated = match self.kind {
            ParameterKind::FrameAnchor | ParameterKind::PlatformAnchor => true,
            ParameterKind::LengthOffset => cable.length_offset.is_some(),
            ParameterKind::LengthScale => cable.length_scale.is_some(),
            ParameterKind::PulleyRadius => cable.pulley_radius.is_some(),
            ParameterKind::DrumRadius => cable.drum_radius.is_some(),
            ParameterKind::StartLength => cable.drum_start_length.is_some(),
            ParameterKind::Compliance => cable.axial_compliance.is_some() || cable.axial_stiffness.is_some(),
            ParameterKind::HiddenLength => cable.hidden_length.is_some(),
            ParameterKind::TensionScale => cable.tension_scale.is_some(),
            ParameterKind::TensionOffset => cable.tension_offset.is_some(),
            // a wrench without the weight is not the constant wrench that identification means
            ParameterKind::Wrench => {
                model.robot().external_wrench.as_ref().is_some_and(|wrench| wrench.includes_gravity)
            }
        };
        stated.then(|| self.value(model))
    }

    /// Writes a value into a robot with the axes of `model`.
    pub fn assign(&self, model: &Model, robot: &mut Robot, value: f64) {
        let cable = &mut robot.cables[self.cable];
        match self.kind {
            ParameterKind::FrameAnchor => {
                let axis = model.axes()[self.axis];
                cable.frame_anchor += axis * (value - axis.dot(&cable.frame_anchor));
            }
            ParameterKind::PlatformAnchor => {
                let axis = model.axes()[self.axis];
                cable.platform_anchor += axis * (value - axis.dot(&cable.platform_anchor));
            }
            ParameterKind::LengthOffset => cable.length_offset = Some(value),
            ParameterKind::LengthScale => cable.length_scale = Some(value),
            ParameterKind::PulleyRadius => cable.pulley_radius = Some(value),
            ParameterKind::DrumRadius => cable.drum_radius = Some(value),
            ParameterKind::StartLength => cable.drum_start_length = Some(value),
            ParameterKind::Compliance => (cable.axial_compliance, cable.axial_stiffness) = (Some(value), None),
            ParameterKind::HiddenLength => cable.hidden_length = Some(value),
            ParameterKind::TensionScale => cable.tension_scale = Some(value),
            ParameterKind::TensionOffset => cable.tension_offset = Some(value),
            ParameterKind::Wrench => {
                let direction = model.twist_basis()[self.axis];
                let external = robot.external_wrench.get_or_insert_with(|| ExternalWrench {
                    wrench: Wrench::zeros(),
                    includes_gravity: true,
                    note: Some("identified".to_owned()),
                });
                external.wrench += direction * (value - direction.dot(&external.wrench));
                external.includes_gravity = true;
            }
        }
    }

    /// Values it may take: radii, compliances and hidden lengths not below 0, scales and radii of drums positive.
    pub fn bounds(&self) -> (f64, f64) {
        match self.kind {
            ParameterKind::PulleyRadius | ParameterKind::Compliance | ParameterKind::HiddenLength => {
                (0.0, f64::INFINITY)
            }
            ParameterKind::LengthScale | ParameterKind::TensionScale | ParameterKind::DrumRadius => {
                (1e-3, f64::INFINITY)
            }
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        }
    }
}

/// 1/EA as the file states it (1/N); 0 where it states neither stiffness nor compliance.
pub(crate) fn specific_compliance(cable: &Cable) -> f64 {
    cable.axial_compliance.or_else(|| cable.axial_stiffness.map(|stiffness| 1.0 / stiffness)).unwrap_or(0.0)
}

/// Name of a pattern axis in the world: x, y or z.
pub(crate) fn axis_name(robot: &Robot, axis: usize) -> String {
    let names = if robot.motion_pattern.is_planar() { robot.plane.axes() } else { "xyz".to_owned() };
    names.chars().nth(axis).map(String::from).unwrap_or_default()
}

impl Model {
    /// Change of the wrench (world) and of the recorded length of a cable (0-based) in a state by one of its parameters, at fixed tension where
    /// it is given.
    #[inline]
    pub(crate) fn by_parameter(
        &self,
        (cable, state): (usize, &CableState),
        parameter: &Parameter,
        rotation: &Matrix3<f64>,
    ) -> (Wrench, f64) {
        let none = Wrench::zeros();
        let law = |kind: LawParameter| {
            let change = self.law(cable).by_parameter(state, kind);
            let (pull, length) = state.at_given(change.pull, change.controlled_length);
            (state.wrench_of(pull), length)
        };
        match parameter.kind {
            ParameterKind::FrameAnchor => {
                // moving the frame anchor is moving the platform anchor the other way
                let (pull, length) = state.by_anchor((-self.axes()[parameter.axis]).into());
                (state.wrench_of(pull), length)
            }
            ParameterKind::PlatformAnchor => {
                let axis: [f64; 3] = (rotation * self.axes()[parameter.axis]).into();
                let (pull, length) = state.by_anchor(axis);
                let [x, y, z] = cross(axis, state.pull);
                (state.wrench_of(pull) + Wrench::new(0.0, 0.0, 0.0, x, y, z), length)
            }
            ParameterKind::PulleyRadius => law(LawParameter::PulleyRadius),
            ParameterKind::Compliance => law(LawParameter::Compliance),
            ParameterKind::HiddenLength => law(LawParameter::HiddenLength),
            ParameterKind::LengthOffset => (none, 1.0),
            ParameterKind::LengthScale => (none, state.controlled_length),
            ParameterKind::TensionScale => {
                state.by_given_tension(-state.given_tension() / state.recording.tension_scale)
            }
            ParameterKind::TensionOffset => state.by_given_tension(-1.0 / state.recording.tension_scale),
            // they change what is recorded, not what is expected
            ParameterKind::DrumRadius | ParameterKind::StartLength => (none, 0.0),
            ParameterKind::Wrench => (none, 0.0),
        }
    }
}
