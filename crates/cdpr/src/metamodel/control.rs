//! A control model as a controller uses it: lengths for poses.

use super::input_error::InputError;
use crate::geometry::Pose;
use crate::model::Model;
use crate::statics;

/// A control model that commands a machine.
pub(super) struct Controller<'a> {
    model: &'a Model,
}

impl<'a> Controller<'a> {
    pub(super) fn new(model: &'a Model) -> Result<Self, InputError> {
        if model.composition().elastic {
            return Err(InputError::ElasticControl);
        }
        Ok(Self { model })
    }

    /// Lengths for a pose in the units of the model's encoders (m), or why there are none.
    pub(super) fn lengths(&mut self, pose: &Pose) -> Result<Vec<f64>, String> {
        let lengths = self.model.cable_lengths(pose).map_err(|reason| reason.to_string())?;
        Ok(recorded(self.model, &lengths))
    }
}

/// Lengths with which a model's cables have these tensions at a pose, in the units of its encoders (m).
pub(super) fn lengths_at(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<Vec<f64>, statics::StaticsError> {
    Ok(recorded(model, &statics::controlled_lengths(model, pose, tensions)?))
}

fn recorded(model: &Model, controlled: &[f64]) -> Vec<f64> {
    controlled.iter().enumerate().map(|(cable, &length)| model.recorded_length(cable, length)).collect()
}
