//! Maps that cannot be made or used.

use thiserror::Error;

use crate::identification::EvaluationError;
use crate::measurement::SplitError;
use crate::model::WinchError;
use crate::statics::StaticsError;

/// Map that cannot be made, or used for a model.
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
    /// All samples at one pose.
    #[error("all samples are at one pose: a map over the workspace needs poses spread over it")]
    OnePose,
    /// Another robot or composition than the map was made for.
    #[error(
        "the map was made for {robot}, model {model}: its lengths differ by up to {difference_m} m from those of this model"
    )]
    OtherModel {
        /// Robot of the map.
        robot: String,
        /// Model of the map.
        model: String,
        /// Largest difference of a length at the map's centre (m); NaN where the two have not as many cables.
        difference_m: f64,
    },
    /// Pose beyond the samples of the map.
    #[error("the pose lies beyond the samples that the map was made of ({reason}): it says nothing there")]
    Outside {
        /// Reason.
        reason: String,
    },
    /// Samples that cannot be held out.
    #[error(transparent)]
    Split(#[from] SplitError),
    /// Samples that the model cannot be evaluated on.
    #[error(transparent)]
    Evaluation(#[from] EvaluationError),
    /// A model without lengths at the map's centre.
    #[error(transparent)]
    Statics(#[from] StaticsError),
    /// Motor angles that the robot's winches cannot have.
    #[error(transparent)]
    Winch(#[from] WinchError),
}
