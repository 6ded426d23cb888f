//! What may deviate on a control model, on a machine and on how its winches were set.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::geometry::Wrench;
use crate::model::{Model, Parameter, ParameterKind, StretchEffect, axis_name, specific_compliance};
use crate::robot::{ExternalWrench, Robot};

/// Whose parameter it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// The control model's, in the controller's file.
    Control,
    /// The machine's, in the hall.
    Machine,
    /// How the winches were set at the initial pose.
    Winches,
}

/// A kind of what may deviate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Kind {
    /// Frame anchor (world), per axis (m).
    FrameAnchor,
    /// Platform anchor (platform frame), per axis (m).
    PlatformAnchor,
    /// Pulley radius (m).
    PulleyRadius,
    /// Offset of the recorded lengths (m).
    LengthOffset,
    /// Scale of the recorded lengths (1).
    LengthScale,
    /// Radius of the winch's drum (m).
    DrumRadius,
    /// Controlled length at the drum's start angle (m).
    StartLength,
    /// Axial stiffness EA, relative: 0.01 makes the cable 1 % stiffer (1).
    AxialStiffness,
    /// Strained length between winch and outlet (m).
    HiddenLength,
    /// A further constant force on the platform (world), per axis of the pattern (N).
    Force,
    /// A further constant moment on the platform, per turn of the pattern (N·m).
    Moment,
    /// Mass of the platform (kg).
    Mass,
    /// Centre of mass (platform frame), per axis (m).
    CenterOfMass,
    /// Winch offset (m).
    WinchOffset,
    /// Initial tension, brought into balance with the load by the smallest change of all (N).
    InitialTension,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 15] = [
        Self::FrameAnchor,
        Self::PlatformAnchor,
        Self::PulleyRadius,
        Self::LengthOffset,
        Self::LengthScale,
        Self::DrumRadius,
        Self::StartLength,
        Self::AxialStiffness,
        Self::HiddenLength,
        Self::Force,
        Self::Moment,
        Self::Mass,
        Self::CenterOfMass,
        Self::WinchOffset,
        Self::InitialTension,
    ];

    /// The name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::FrameAnchor => "frame-anchor",
            Self::PlatformAnchor => "platform-anchor",
            Self::PulleyRadius => "pulley-radius",
            Self::LengthOffset => "length-offset",
            Self::LengthScale => "length-scale",
            Self::DrumRadius => "drum-radius",
            Self::StartLength => "start-length",
            Self::AxialStiffness => "axial-stiffness",
            Self::HiddenLength => "hidden-length",
            Self::Force => "force",
            Self::Moment => "moment",
            Self::Mass => "mass",
            Self::CenterOfMass => "center-of-mass",
            Self::WinchOffset => "winch-offset",
            Self::InitialTension => "initial-tension",
        }
    }

    /// Unit of a deviation, `1` for a share.
    pub fn unit(self) -> &'static str {
        match self {
            Self::LengthScale | Self::AxialStiffness => "1",
            Self::Force | Self::InitialTension => "N",
            Self::Moment => "N·m",
            Self::Mass => "kg",
            _ => "m",
        }
    }

    /// Deviation by which an exact model is moved to and fro where it has no analytic derivative: far above rounding, far below
    /// what bends.
    pub(in crate::metamodel) fn difference_step(self) -> f64 {
        match self.unit() {
            "m" => 1e-5,
            "1" => 1e-5,
            _ => 1e-2,
        }
    }

    /// The parameter of identification behind it.
    fn parameter_kind(self) -> Option<ParameterKind> {
        Some(match self {
            Self::FrameAnchor => ParameterKind::FrameAnchor,
            Self::PlatformAnchor => ParameterKind::PlatformAnchor,
            Self::PulleyRadius => ParameterKind::PulleyRadius,
            Self::LengthOffset => ParameterKind::LengthOffset,
            Self::LengthScale => ParameterKind::LengthScale,
            Self::DrumRadius => ParameterKind::DrumRadius,
            Self::StartLength => ParameterKind::StartLength,
            Self::AxialStiffness => ParameterKind::Compliance,
            Self::HiddenLength => ParameterKind::HiddenLength,
            _ => return None,
        })
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Side {
    /// The name in studies and results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Control => "control",
            Self::Machine => "machine",
            Self::Winches => "winches",
        }
    }
}

/// One number that may deviate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Cause {
    /// Whose.
    pub side: Side,
    /// What.
    pub kind: Kind,
    /// Cable it belongs to, from 0; 0 for what the platform has.
    pub cable: usize,
    /// Component along the axes of the pattern (turns for moments), from 0; 0 for what has none.
    pub axis: usize,
}

impl Cause {
    /// Name for people and files, e.g. `machine frame-anchor[1].x`.
    pub fn name(&self, model: &Model) -> String {
        let robot = model.robot();
        let (side, kind, cable) = (self.side.name(), self.kind, self.cable + 1);
        match kind {
            Kind::FrameAnchor | Kind::PlatformAnchor => {
                format!("{side} {kind}[{cable}].{}", axis_name(robot, self.axis))
            }
            Kind::Moment if robot.motion_pattern.is_planar() => format!("{side} {kind}"),
            Kind::Force | Kind::Moment | Kind::CenterOfMass => {
                format!("{side} {kind}.{}", axis_name(robot, self.axis))
            }
            Kind::Mass => format!("{side} {kind}"),
            _ => format!("{side} {kind}[{cable}]"),
        }
    }

    /// The parameter of the model behind it; `None` for what is none of a single cable.
    pub(super) fn parameter(&self) -> Option<Parameter> {
        let kind = self.kind.parameter_kind()?;
        Some(Parameter { cable: self.cable, kind, axis: self.axis })
    }

    /// Change of the parameter per unit of deviation, at a model's values: 1 but for the stiffness, whose compliance falls.
    pub(super) fn parameter_change(&self, model: &Model) -> f64 {
        match self.kind {
            Kind::AxialStiffness => -specific_compliance(&model.robot().cables[self.cable]),
            _ => 1.0,
        }
    }

    /// The twist whose wrench component it is.
    pub(super) fn wrench_axis(&self, model: &Model) -> usize {
        match self.kind {
            Kind::Moment => model.axes().len() + self.axis,
            _ => self.axis,
        }
    }

    /// Writes the deviation into a robot, `model` being the one without deviations; what the winches have is no robot's.
    ///
    /// A parameter stays within what it may be: no radius below 0, no stiffness below a thousandth.
    pub fn deviate(&self, model: &Model, robot: &mut Robot, by: f64) {
        match self.kind {
            Kind::AxialStiffness => {
                let cable = &mut robot.cables[self.cable];
                let compliance = specific_compliance(cable) / f64::max(1.0 + by, 1e-3);
                (cable.axial_compliance, cable.axial_stiffness) = (Some(compliance), None);
            }
            Kind::Force | Kind::Moment => {
                let external = robot.external_wrench.get_or_insert_with(|| ExternalWrench {
                    wrench: Wrench::zeros(),
                    includes_gravity: false,
                    note: None,
                });
                external.wrench += model.twist_basis()[self.wrench_axis(model)] * by;
            }
            Kind::Mass => {
                if let Some(mass) = &mut robot.platform.mass {
                    *mass = f64::max(*mass + by, 0.0);
                }
            }
            Kind::CenterOfMass => {
                if let Some(center) = &mut robot.platform.center_of_mass {
                    *center += model.axes()[self.axis] * by;
                }
            }
            _ => {
                if let Some(parameter) = self.parameter() {
                    let (least, largest) = parameter.bounds();
                    parameter.assign(model, robot, (parameter.value(model) + by).clamp(least, largest));
                }
            }
        }
    }
}

/// All that may deviate on one side, ordered by cable, kind and axis; what acts on the platform last.
pub fn causes_of(side: Side, model: &Model) -> Vec<Cause> {
    let mut causes = Vec::new();
    let has_tensions = model.needs_tensions();
    for cable in 0..model.cable_count() {
        for kind in Kind::ALL.into_iter().filter(|&kind| belongs((side, kind), model, cable, has_tensions)) {
            let count = if matches!(kind, Kind::FrameAnchor | Kind::PlatformAnchor) { model.axes().len() } else { 1 };
            // a point platform has no anchors to measure
            let is_point = kind == Kind::PlatformAnchor && is_point(model);
            causes.extend((0..if is_point { 0 } else { count }).map(|axis| Cause { side, kind, cable, axis }));
        }
    }
    if side != Side::Winches && has_tensions {
        let of = |kind: Kind, count: usize| (0..count).map(move |axis| Cause { side, kind, cable: 0, axis });
        let (axes, turns) = (model.axes().len(), model.dof() - model.axes().len());
        causes.extend(of(Kind::Force, axes).chain(of(Kind::Moment, turns)));
        if weighs(model) {
            causes.extend(of(Kind::Mass, 1));
            let has_center = turns > 0 && model.robot().platform.center_of_mass.is_some();
            causes.extend(of(Kind::CenterOfMass, if has_center { axes } else { 0 }));
        }
    }
    causes
}

/// True for a platform that is a point.
fn is_point(model: &Model) -> bool {
    model.dof() == model.axes().len() && model.robot().cables.iter().all(|cable| cable.platform_anchor.norm() == 0.0)
}

/// True where the platform's weight is part of the load.
fn weighs(model: &Model) -> bool {
    let robot = model.robot();
    let is_included = robot.external_wrench.as_ref().is_some_and(|external| external.includes_gravity);
    !is_included && robot.platform.mass.is_some() && robot.gravity.is_some()
}

/// What a cable of a model has.
fn belongs((side, kind): (Side, Kind), model: &Model, cable: usize, has_tensions: bool) -> bool {
    let composition = model.composition();
    let data = &model.robot().cables[cable];
    if side == Side::Winches {
        return kind == Kind::WinchOffset || (kind == Kind::InitialTension && has_tensions);
    }
    let is_spring = data.spring_constant.is_some();
    match kind {
        Kind::FrameAnchor | Kind::PlatformAnchor | Kind::LengthOffset | Kind::LengthScale => true,
        Kind::PulleyRadius => composition.pulley,
        Kind::DrumRadius | Kind::StartLength => composition.drum,
        Kind::AxialStiffness => {
            composition.stretch == StretchEffect::Linear && !is_spring && specific_compliance(data) > 0.0
        }
        Kind::HiddenLength => composition.is_elastic() && !is_spring,
        _ => false,
    }
}
