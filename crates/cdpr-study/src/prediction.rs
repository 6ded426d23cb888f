//! Accuracy with which the model of an experiment's `[prediction]` predicts poses and tensions.

use thiserror::Error;

use crate::Experiment;
use cdpr_calibration::evaluation::{Evaluation, EvaluationError, evaluate};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::InputError;

/// Reason for which a model cannot predict poses and tensions.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PredictionError {
    /// Control model and machine that make no record.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A model without a forward problem, or with other cables than the records.
    #[error(transparent)]
    Evaluation(#[from] EvaluationError),
}

impl Experiment {
    /// Errors with which the model of `[prediction]` predicts, from the lengths sent, the outcome at these poses, for
    /// sensors without noise; `None` without this model.
    pub fn predict(&self, poses: &[CommandedPose]) -> Result<Option<Evaluation>, PredictionError> {
        let Some(model) = &self.prediction else { return Ok(None) };
        let recorded = self.record_exactly(poses)?;
        Ok(Some(evaluate(model, &recorded.samples)?))
    }
}
