//! Maps that cannot be made.

use thiserror::Error;

use crate::EvaluationError;
use cdpr_model::compensation::MapError;
use cdpr_model::measurement::SplitError;
use cdpr_model::model::WinchError;

/// Map that cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CompensationError {
    /// Samples that are too few to tell a smooth error from noise.
    #[error(
        "a smooth error is told from noise by {least} samples or more whose lengths the model knows, there are {samples}"
    )]
    TooFewSamples {
        /// Samples with an error of every length.
        samples: usize,
        /// Least number.
        least: usize,
    },
    /// Samples that cannot be held out.
    #[error(transparent)]
    Split(#[from] SplitError),
    /// Samples that the model cannot be evaluated on.
    #[error(transparent)]
    Evaluation(#[from] EvaluationError),
    /// A map that cannot be made.
    #[error(transparent)]
    Map(#[from] MapError),
    /// Motor angles that the robot's winches cannot have.
    #[error(transparent)]
    Winch(#[from] WinchError),
}
