//! Derivatives of a model by its robot's parameters, and the effects that make a parameter identifiable.

use nalgebra::Matrix3;

use super::Model;
use crate::cable::CableState;
use crate::cable::law::LawParameter;
use crate::geometry::Wrench;
use crate::robot::{Parameter, ParameterKind};
use crate::scalar::cross;

impl ParameterKind {
    /// True for parameters that only a model with elastic cables and recorded tensions can identify.
    pub(crate) fn needs_elasticity(self) -> bool {
        let is_of_law = matches!(self, Self::Compliance | Self::HiddenLength | Self::LinearDensity | Self::Stretch(_));
        is_of_law || matches!(self, Self::TensionScale | Self::TensionOffset) || self.is_of_load()
    }

    /// True for parameters of an ideal winch, which models without drums have too.
    pub fn is_of_ideal_winch(self) -> bool {
        matches!(self, Self::DrumRadius | Self::SpoolBuildUp | Self::StartLength)
    }

    /// True for parameters that only recorded swivel angles can identify.
    pub fn needs_swivels(self) -> bool {
        self == Self::SwivelOffset
    }

    /// True for parameters that only recorded motor angles can identify.
    pub fn needs_motor_angles(self) -> bool {
        matches!(self, Self::DrumPitch | Self::DrumAxis | Self::StartAngle) || self.is_of_ideal_winch()
    }
}

/// The parameter of the cable's law for a parameter of the robot; `None` for anchors, calibration, drums and the
/// platform.
fn law_parameter(parameter: &Parameter, model: &Model) -> Option<LawParameter> {
    let robot = model.robot();
    match parameter.kind {
        ParameterKind::SwivelAxis => {
            let (axis, about) = parameter.turned_axis(robot)?;
            Some(LawParameter::PulleyTurn(axis.rotation_by_turn_about(&about).into()))
        }
        ParameterKind::PulleyRadius => Some(LawParameter::PulleyRadius),
        ParameterKind::Compliance => Some(LawParameter::Compliance),
        ParameterKind::HiddenLength => Some(LawParameter::HiddenLength),
        ParameterKind::LinearDensity => robot.gravity.map(|gravity| LawParameter::Weight(gravity.into())),
        ParameterKind::Stretch(number) => {
            (model.composition().stretch == number.law().effect).then(|| LawParameter::Stretch(number.place()))
        }
        _ => None,
    }
}

impl Model {
    /// The model with other values of some parameters; `None` if they are invalid.
    pub fn with_parameters(&self, parameters: &[Parameter], values: &[f64]) -> Option<Self> {
        let mut robot = self.robot().clone();
        for (parameter, &value) in parameters.iter().zip(values) {
            parameter.set(&mut robot, value);
        }
        robot.forget_assumptions(parameters.iter().copied());
        Self::new(robot, self.composition()).ok()
    }

    /// Change of the wrench (world) and of the recorded length of a cable (0-based) in a state by one of its
    /// parameters, at fixed tension if the tension is given.
    #[inline]
    pub fn by_parameter(
        &self,
        cable: usize,
        state: &CableState,
        parameter: &Parameter,
        rotation: &Matrix3<f64>,
    ) -> (Wrench, f64) {
        let none = Wrench::zeros();
        let law = |kind: LawParameter| {
            let change = self.law(cable).by_parameter(state, kind);
            let (pull, length) = state.at_given(change.pull, change.controlled_length);
            (state.wrench_of(pull), length)
        };
        if let Some(of_law) = law_parameter(parameter, self) {
            return law(of_law);
        }
        match parameter.kind {
            ParameterKind::FrameAnchor => {
                // moving the frame anchor equals moving the platform anchor the other way
                let (pull, length) = state.by_anchor((-self.axes()[parameter.axis]).into());
                (state.wrench_of(pull), length)
            }
            ParameterKind::PlatformAnchor => {
                let axis: [f64; 3] = (rotation * self.axes()[parameter.axis]).into();
                let (pull, length) = state.by_anchor(axis);
                let [x, y, z] = cross(axis, state.pull);
                (state.wrench_of(pull) + Wrench::new(0.0, 0.0, 0.0, x, y, z), length)
            }
            ParameterKind::LengthOffset => (none, 1.0),
            ParameterKind::LengthScale => (none, state.controlled_length),
            ParameterKind::TensionScale => {
                state.by_given_tension(-state.given_tension() / state.recording.tension_scale)
            }
            ParameterKind::TensionOffset => state.by_given_tension(-1.0 / state.recording.tension_scale),
            // drums change the recorded length, not the predicted one; the platform's numbers belong to the load
            _ => (none, 0.0),
        }
    }
}
