//! Maps that cannot be read or used.

use thiserror::Error;

use crate::reading::ReadError;
use crate::statics::StaticsError;

/// Map that cannot be read, or used for a model or at a pose.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum MapError {
    /// A file that cannot be read as a map.
    #[error(transparent)]
    Read(#[from] Box<ReadError>),
    /// All samples at one pose.
    #[error("all samples are at one pose: a map over the workspace needs poses spread over it")]
    OnePose,
    /// Another robot or composition than that for which the map was made.
    #[error(
        "the map was made for {robot}, model {model}: its lengths differ by up to {difference_m} m from those of this model"
    )]
    OtherModel {
        /// Robot of the map.
        robot: String,
        /// Model of the map.
        model: String,
        /// Largest difference of a length at the map's centre (m); NaN if the two have different numbers of cables.
        difference_m: f64,
    },
    /// Pose beyond the samples of the map.
    #[error("the pose lies beyond the samples that the map was made of ({reason}): it says nothing there")]
    Outside {
        /// Reason, with the coordinate farthest out.
        reason: String,
    },
    /// A model without lengths at the map's centre.
    #[error(transparent)]
    Statics(#[from] StaticsError),
}

impl From<ReadError> for MapError {
    fn from(error: ReadError) -> Self {
        Self::Read(Box::new(error))
    }
}
