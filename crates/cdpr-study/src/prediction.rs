//! How well the model of an experiment's `[prediction]` tells what emerges.

use thiserror::Error;

use crate::Experiment;
use cdpr_calibration::evaluation::{Evaluation, EvaluationError, evaluate};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::InputError;

/// Mistake that keeps a model from predicting what emerges.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PredictionError {
    /// Control model and machine that record nothing.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A model that has no forward problem, or other cables than the records.
    #[error(transparent)]
    Evaluation(#[from] EvaluationError),
}

impl Experiment {
    /// Errors with which the model of `[prediction]` tells from the lengths that were sent what emerges at these poses, sensors without
    /// noise; `None` without such a model.
    pub fn predict(&self, poses: &[CommandedPose]) -> Result<Option<Evaluation>, PredictionError> {
        let Some(model) = &self.prediction else { return Ok(None) };
        let recorded = self.record_exactly(poses)?;
        Ok(Some(evaluate(model, &recorded.samples)?))
    }
}
