//! Deviations of parameters of a control model, of a machine and of its winch settings.

use std::fmt;

use cdpr_model::model::{Model, StretchEffect};
use cdpr_model::reading::{Keyword, keywords};
use cdpr_model::robot::{Parameter, ParameterKind, Robot};

/// Owner of a parameter: control model, machine or winches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// The control model, with the numbers in the controller's file.
    Control,
    /// The machine, with its real numbers.
    Machine,
    /// The winch settings at the initial pose.
    Winches,
}

keywords!(Side: Control = "control", Machine = "machine", Winches = "winches");

/// Kind of a deviation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// A number of a robot; stiffness as a relative change: 0.01 makes the cable 1 % stiffer.
    Parameter(ParameterKind),
    /// Winch offset (m).
    WinchOffset,
    /// Initial tension (N), brought into balance with the load by the smallest change of all tensions.
    InitialTension,
}

/// Numbers of a cable that may deviate; axes turn about two directions, including that of a drum's axis in which
/// lengths do not change.
const OF_CABLES: [ParameterKind; 13] = [
    ParameterKind::FrameAnchor,
    ParameterKind::PlatformAnchor,
    ParameterKind::PulleyRadius,
    ParameterKind::SwivelAxis,
    ParameterKind::LengthOffset,
    ParameterKind::LengthScale,
    ParameterKind::DrumRadius,
    ParameterKind::DrumPitch,
    ParameterKind::DrumAxis,
    ParameterKind::StartLength,
    ParameterKind::StartAngle,
    ParameterKind::AxialStiffness,
    ParameterKind::HiddenLength,
];

impl Kind {
    /// The name in results.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Parameter(kind) => kind.name(),
            Self::WinchOffset => "winch-offset",
            Self::InitialTension => "initial-tension",
        }
    }

    /// Unit of a deviation, `1` for a relative change.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Parameter(ParameterKind::LengthScale | ParameterKind::AxialStiffness) => "1",
            Self::Parameter(kind) => kind.unit(),
            Self::WinchOffset => "m",
            Self::InitialTension => "N",
        }
    }

    /// Step of the differences for a deviation without an analytic derivative: far above rounding, far below nonlinear
    /// effects.
    pub(crate) fn difference_step(self) -> f64 {
        match self.unit() {
            "m" | "1" => 1e-5,
            "rad" => 1e-4,
            _ => 1e-2,
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A number that may deviate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ParameterDeviation {
    /// Side of the deviation: control model, machine or winches.
    pub side: Side,
    /// Kind of the parameter.
    pub kind: Kind,
    /// Cable of the parameter, from 0; 0 for parameters of the platform.
    pub cable: usize,
    /// Component along the axes of the pattern (for moments about its rotations), from 0; 0 for scalars.
    pub axis: usize,
}

impl ParameterDeviation {
    /// Name for people and files, e.g. `machine frame-anchor[1].x`.
    pub fn name(&self, model: &Model) -> String {
        let side = self.side.name();
        match self.parameter() {
            Some(parameter) => format!("{side} {}", parameter.name(model.robot())),
            None => format!("{side} {}[{}]", self.kind, self.cable + 1),
        }
    }

    /// The robot's parameter that deviates; `None` for those of the winches.
    pub(crate) fn parameter(&self) -> Option<Parameter> {
        match self.kind {
            Kind::Parameter(kind) => Some(Parameter { cable: self.cable, kind, axis: self.axis }),
            Kind::WinchOffset | Kind::InitialTension => None,
        }
    }

    /// The parameter of a single cable by which the derivative is taken, and its change per unit of the deviation at a
    /// model's values: 1, except for stiffness, whose increase lowers the compliance.
    pub(super) fn cable_parameter(&self, model: &Model) -> Option<(Parameter, f64)> {
        let parameter = self.parameter().filter(|parameter| OF_CABLES.contains(&parameter.kind))?;
        Some(match parameter.kind {
            ParameterKind::AxialStiffness => {
                let compliance = Parameter { kind: ParameterKind::Compliance, ..parameter };
                (compliance, -compliance.value(model.robot()))
            }
            _ => (parameter, 1.0),
        })
    }

    /// Writes the deviation into a robot, with `model` the one without deviations; deviations of the winches have no
    /// effect.
    ///
    /// A parameter is clamped to its bounds: no radius below 0, no stiffness below a thousandth.
    pub fn deviate(&self, model: &Model, robot: &mut Robot, by: f64) {
        let Some(parameter) = self.parameter() else { return };
        let (least, largest) = parameter.bounds();
        let moved = |from: &Robot| (parameter.value(from) + by).clamp(least, largest);
        match parameter.kind {
            ParameterKind::AxialStiffness => {
                let compliance = Parameter { kind: ParameterKind::Compliance, ..parameter };
                compliance.set(robot, compliance.value(robot) / f64::max(1.0 + by, 1e-3));
            }
            // a platform with unknown mass or centre has none that could deviate
            ParameterKind::Mass | ParameterKind::CenterOfMass if parameter.get(robot).is_none() => {}
            _ => parameter.set(robot, moved(model.robot())),
        }
    }
}

/// Deviations possible on one side, ordered by cable, kind and axis; those of the load on the platform last.
pub(crate) fn causes_of(side: Side, model: &Model) -> Vec<ParameterDeviation> {
    let mut causes = Vec::new();
    let has_tensions = model.needs_tensions();
    for cable in 0..model.cable_count() {
        if side == Side::Winches {
            let of_winch = [(Kind::WinchOffset, true), (Kind::InitialTension, has_tensions)].into_iter();
            causes.extend(of_winch.filter(|(_, has)| *has).map(|(kind, _)| ParameterDeviation {
                side,
                kind,
                cable,
                axis: 0,
            }));
            continue;
        }
        for kind in OF_CABLES.into_iter().filter(|&kind| belongs(kind, model, cable)) {
            causes.extend(
                (0..kind.components(model.robot())).map(|axis| deviation(side, Parameter { cable, kind, axis })),
            );
        }
    }
    if side != Side::Winches && has_tensions {
        let of_platform = OF_PLATFORM.into_iter().filter(|&kind| acts(kind, model));
        let axes = |kind: ParameterKind| {
            (0..kind.components(model.robot())).map(move |axis| Parameter { cable: 0, kind, axis })
        };
        causes.extend(of_platform.flat_map(axes).map(|parameter| deviation(side, parameter)));
    }
    causes
}

fn deviation(side: Side, Parameter { cable, kind, axis }: Parameter) -> ParameterDeviation {
    ParameterDeviation { side, kind: Kind::Parameter(kind), cable, axis }
}

/// Numbers of the platform that may deviate.
const OF_PLATFORM: [ParameterKind; 4] =
    [ParameterKind::Force, ParameterKind::Moment, ParameterKind::Mass, ParameterKind::CenterOfMass];

/// True for a number of the platform that changes its load.
fn acts(kind: ParameterKind, model: &Model) -> bool {
    match kind {
        ParameterKind::Mass => weighs(model),
        ParameterKind::CenterOfMass => {
            let can_turn = model.dof() > model.axes().len();
            weighs(model) && can_turn && model.robot().platform.center_of_mass.is_some()
        }
        _ => true,
    }
}

/// True if the platform is a point.
fn is_point(model: &Model) -> bool {
    model.dof() == model.axes().len() && model.robot().cables.iter().all(|cable| cable.platform_anchor.norm() == 0.0)
}

/// True if the platform's weight is part of the load.
fn weighs(model: &Model) -> bool {
    let robot = model.robot();
    let is_included = robot.external_wrench.as_ref().is_some_and(|external| external.includes_gravity);
    !is_included && robot.platform.mass.is_some() && robot.gravity.is_some()
}

/// True for a number that a cable of the model has.
fn belongs(kind: ParameterKind, model: &Model, cable: usize) -> bool {
    let composition = model.composition();
    let of_robot = &model.robot().cables[cable];
    let is_spring = of_robot.spring_constant().is_some();
    match kind {
        // the anchors of a point platform cannot deviate
        ParameterKind::PlatformAnchor => !is_point(model),
        ParameterKind::PulleyRadius => composition.pulley,
        ParameterKind::SwivelAxis => composition.pulley && of_robot.pulley_swivel_axis().is_some(),
        ParameterKind::DrumRadius | ParameterKind::DrumPitch => composition.drum,
        ParameterKind::StartLength | ParameterKind::StartAngle => composition.drum,
        // with a guide that travels with the cable the axis has no effect
        ParameterKind::DrumAxis => composition.drum && of_robot.winch.guided != Some(true),
        ParameterKind::AxialStiffness => {
            let compliance = Parameter { cable, kind: ParameterKind::Compliance, axis: 0 }.value(model.robot());
            composition.stretch == StretchEffect::Linear && !is_spring && compliance > 0.0
        }
        ParameterKind::HiddenLength => composition.is_elastic() && !is_spring,
        _ => true,
    }
}
