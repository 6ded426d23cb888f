//! Poses of an operation that have no lengths, no answer or no derivatives.

use thiserror::Error;

use super::input_error::InputError;
use super::status::Status;
use crate::cable::winch::GrooveError;
use crate::compensation::MapError;
use crate::equilibrium::distribution::{DistributionError, Reason};
use crate::model::WinchError;
use crate::statics::StaticsError;
use crate::tension::NotSmooth;

/// Reason for which a control model sends nothing for a pose, a machine does not come to rest there, or neither can be differentiated.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OperationError {
    /// Cables that have no state at the pose.
    #[error(transparent)]
    Statics(#[from] StaticsError),
    /// Numbers from which no tensions can be chosen.
    #[error(transparent)]
    Distribution(#[from] DistributionError),
    /// No tensions balance the load within the limits.
    #[error("the control model finds no tensions: {0}")]
    NoTensions(Reason),
    /// A winch that cannot be turned so far.
    #[error(transparent)]
    Winch(#[from] WinchError),
    /// A drum whose groove ends.
    #[error(transparent)]
    Groove(#[from] GrooveError),
    /// The machine does not come to rest.
    #[error("{}", .reason.as_deref().unwrap_or(.status.name()))]
    NoRest {
        /// End of the search.
        status: Status,
        /// The reason in words, where one is known.
        reason: Option<String>,
    },
    /// A pose that the map of the control model does not know.
    #[error(transparent)]
    Map(#[from] MapError),
    /// One of many poses.
    #[error("pose {pose}: {reason}")]
    AtPose {
        /// Its number, from 1.
        pose: usize,
        /// Its reason.
        reason: Box<Self>,
    },
    /// A machine with one number changed, of which differences are taken, does not answer.
    #[error("{cause} deviating: {reason}")]
    Deviating {
        /// Name of the number.
        cause: String,
        /// Its reason.
        reason: Box<Self>,
    },
    /// Tensions that are chosen in a way without a derivative at this pose.
    #[error("the tensions of the control model have no derivative: {0}")]
    NotSmooth(NotSmooth),
    /// A displacement of the machine meets no resistance.
    #[error("the stiffness of the machine is singular at the emerging pose")]
    Singular,
    /// Robots, tensions or a load with which no pose can be answered.
    #[error(transparent)]
    Input(#[from] InputError),
}
