//! Derivatives of the winches: the length paid out per length sent and per deviation of the drums.

use nalgebra::DVector;

use super::cause::{Kind, ParameterDeviation, Side};
use cdpr_model::cable::winch::DrumLength;
use cdpr_model::control::OperationError;
use cdpr_model::control::{Winding, WindingGradient};
use cdpr_model::model::Model;
use cdpr_model::robot::ParameterKind;

/// The winches between a control model and a machine, at the lengths sent.
pub(super) struct Windings<'a> {
    control: &'a Model,
    machine: &'a Model,
    /// Gradients of the windings; `None` if neither side has drums, so that lengths are sent directly.
    gradients: Option<Vec<WindingGradient>>,
}

impl<'a> Windings<'a> {
    pub(super) fn at(control: &'a Model, machine: &'a Model, sent: &[f64]) -> Result<Self, OperationError> {
        let winding = Winding::new(control, machine)?;
        Ok(Self { control, machine, gradients: winding.gradients(sent)? })
    }

    /// Change of the lengths paid out, per change of the lengths sent (m).
    pub(super) fn paid_out(&self, sent: &DVector<f64>) -> DVector<f64> {
        match &self.gradients {
            None => sent.clone(),
            Some(gradients) => DVector::from_fn(sent.len(), |cable, _| sent[cable] * gradients[cable].by_sent),
        }
    }

    /// The inverse of [`Windings::paid_out`].
    pub(super) fn sent(&self, paid_out: &DVector<f64>) -> DVector<f64> {
        match &self.gradients {
            None => paid_out.clone(),
            Some(gradients) => DVector::from_fn(paid_out.len(), |cable, _| paid_out[cable] / gradients[cable].by_sent),
        }
    }

    /// Change of the length that the cause's cable pays out for the same length sent (m per unit).
    pub(super) fn by_cause(&self, cause: &ParameterDeviation) -> f64 {
        let Some(gradient) = self.gradients.as_ref().map(|gradients| &gradients[cause.cable]) else { return 0.0 };
        match cause.side {
            // a larger modelled length at the same angle is a smaller angle for the same length
            Side::Control => {
                let counted = match self.machine.robot().cables[cause.cable].winch.radius {
                    None => by_ideal(&gradient.machine, cause),
                    Some(_) => 0.0,
                };
                counted - gradient.by_sent * by_drum(&gradient.control, cause, self.control)
            }
            // a control model whose file has no drum uses the machine's
            Side::Machine => {
                let counted = match self.control.robot().cables[cause.cable].winch.radius {
                    None => by_ideal(&gradient.control, cause),
                    Some(_) => 0.0,
                };
                by_drum(&gradient.machine, cause, self.machine) - gradient.by_sent * counted
            }
            Side::Winches => 0.0,
        }
    }
}

/// Change of an ideal winch's length at a fixed angle.
fn by_ideal(drum: &DrumLength, cause: &ParameterDeviation) -> f64 {
    match cause.kind {
        Kind::Parameter(ParameterKind::DrumRadius) => drum.by_radius,
        Kind::Parameter(ParameterKind::StartLength) => drum.by_start_length,
        Kind::Parameter(ParameterKind::StartAngle) => -drum.by_angle,
        _ => 0.0,
    }
}

/// Change of a drum's length at a fixed angle.
fn by_drum(drum: &DrumLength, cause: &ParameterDeviation, model: &Model) -> f64 {
    let parameter = cause.parameter().filter(|_| model.composition().drum);
    parameter.map_or(0.0, |parameter| model.by_winch_parameter(drum, &parameter))
}
