//! Derivatives of the lengths that a control model sends, by its parameters.

use nalgebra::DVector;

use super::cause::ParameterDeviation;
use super::choice::Choice;
use cdpr_model::control::InputError;
use cdpr_model::control::OperationError;
use cdpr_model::control::{Control, TensionChoice};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::{StaticsError, cable_state};

/// A control model with the data for its derivatives.
pub(super) struct Command {
    control: Control,
    /// Choice of tensions; `None` if lengths do not depend on tensions.
    choice: Option<TensionChoice>,
}

/// Changes of a command at a pose, per unit of each cause.
pub(super) struct Commanded {
    /// Changes of the tensions (N).
    pub(super) tension_changes: Vec<DVector<f64>>,
    /// Changes of the lengths in the units of the control model's encoders (m), at fixed memories of its cables.
    pub(super) lengths: Vec<DVector<f64>>,
}

impl Command {
    pub(super) fn new(control: Control) -> Result<Self, InputError> {
        let choice = control.tension_choice()?;
        Ok(Self { control, choice })
    }

    /// Tensions at a pose (N), or the reason for which there are none; zeros if lengths do not depend on tensions.
    pub(super) fn tensions(&mut self, pose: &Pose) -> Result<Vec<f64>, OperationError> {
        let Some(TensionChoice { solver, .. }) = &mut self.choice else {
            return Ok(vec![0.0; self.control.model.cable_count()]);
        };
        let found = solver.solve(pose)?;
        match found.reason {
            Some(reason) => Err(OperationError::NoTensions(reason)),
            None => Ok(found.tensions),
        }
    }

    /// Changes of the command at a pose with each cause, or the reason for which there are none; `model` is the control
    /// model with the present memories of its cables.
    pub(super) fn by_causes(
        &mut self,
        model: &Model,
        pose: &Pose,
        causes: &[ParameterDeviation],
    ) -> Result<Commanded, OperationError> {
        let tensions = self.tensions(pose)?;
        let Some(TensionChoice { load, limits, .. }) = &self.choice else {
            let unchanged = vec![DVector::zeros(model.cable_count()); causes.len()];
            let lengths = causes.iter().map(|cause| at_tensions(model, pose, &tensions, cause));
            return Ok(Commanded { lengths: lengths.collect::<Result<_, _>>()?, tension_changes: unchanged });
        };
        let Control { model: choosing, tension_method, .. } = &self.control;
        let choice =
            Choice::by(*tension_method, choosing, pose, load, limits, &tensions)?.map_err(OperationError::NotSmooth)?;
        let stretch = by_tensions(model, pose, &tensions)?;
        let mut commanded = Commanded { tension_changes: Vec::new(), lengths: Vec::new() };
        for cause in causes {
            let fixed = at_tensions(model, pose, &tensions, cause)?;
            let chosen = choice.by_cause(cause)?;
            commanded.lengths.push(fixed + stretch.component_mul(&chosen));
            commanded.tension_changes.push(chosen);
        }
        Ok(commanded)
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
        let (_, length) = model.by_parameter(cause.cable, &state, &parameter, &pose.rotation_matrix());
        change[cause.cable] = length * unit;
    }
    Ok(change)
}

/// Change of each recorded length per newton of the cable's tension (m/N).
pub(super) fn by_tensions(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<DVector<f64>, StaticsError> {
    let slope = |(cable, &tension)| Ok(cable_state(model, pose, cable, tension)?.by_given_tension(1.0).1);
    tensions.iter().enumerate().map(slope).collect::<Result<_, _>>().map(DVector::from_vec)
}
