//! How the lengths that a control model sends follow its parameters.

use nalgebra::DVector;

use super::cause::ParameterDeviation;
use super::choice::Choice;
use crate::geometry::Pose;
use crate::metamodel::control::{Control, TensionChoice};
use crate::metamodel::input_error::InputError;
use crate::metamodel::operation_error::OperationError;
use crate::model::Model;
use crate::statics::{StaticsError, cable_state};

/// A control model with what its derivatives need.
pub(super) struct Command<'a> {
    control: Control<'a>,
    /// How tensions are chosen, where lengths depend on them.
    choice: Option<TensionChoice<'a>>,
}

impl<'a> Command<'a> {
    pub(super) fn new(control: Control<'a>) -> Result<Self, InputError> {
        Ok(Self { control, choice: control.tension_choice()? })
    }

    /// Changes of the lengths in the units of the control model's encoders (m) per unit of each cause, or why there are none.
    pub(super) fn by_causes(
        &mut self,
        pose: &Pose,
        causes: &[ParameterDeviation],
    ) -> Result<Vec<DVector<f64>>, OperationError> {
        let Control { model, tension_method } = self.control;
        let m = model.cable_count();
        let Some(TensionChoice { solver, load, limits }) = &mut self.choice else {
            return causes.iter().map(|cause| Ok(at_tensions(model, pose, &vec![0.0; m], cause)?)).collect();
        };
        let found = solver.solve(pose)?;
        if let Some(reason) = found.reason {
            return Err(OperationError::NoTensions(reason));
        }
        let choice = Choice::by(tension_method, (model, pose), load, limits, &found.tensions)?
            .map_err(OperationError::NotSmooth)?;
        let stretch = by_tensions(model, pose, &found.tensions)?;
        let one = |cause: &ParameterDeviation| {
            let fixed = at_tensions(model, pose, &found.tensions, cause)?;
            let chosen = choice.by_cause(cause)?;
            Ok(fixed + stretch.component_mul(&chosen))
        };
        causes.iter().map(one).collect()
    }
}

/// Change of the recorded lengths at fixed tensions (m).
pub(super) fn at_tensions(
    model: &Model,
    pose: &Pose,
    tensions: &[f64],
    cause: &ParameterDeviation,
) -> Result<DVector<f64>, StaticsError> {
    let mut change = DVector::zeros(model.cable_count());
    if let Some((parameter, unit)) = cause.cable_parameter(model) {
        let state = cable_state(model, pose, cause.cable, tensions[cause.cable])?;
        let (_, length) = model.by_parameter((cause.cable, &state), &parameter, &pose.rotation_matrix());
        change[cause.cable] = length * unit;
    }
    Ok(change)
}

/// Change of each recorded length per newton of the cable's tension (m/N).
pub(super) fn by_tensions(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<DVector<f64>, StaticsError> {
    let slope = |(cable, &tension)| Ok(cable_state(model, pose, cable, tension)?.by_given_tension(1.0).1);
    tensions.iter().enumerate().map(slope).collect::<Result<_, _>>().map(DVector::from_vec)
}
