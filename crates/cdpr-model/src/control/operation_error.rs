//! Reasons that an operation has no lengths, no answer or no derivatives at a pose.

use thiserror::Error;

use super::input_error::InputError;
use super::status::Status;
use crate::cable::winch::GrooveError;
use crate::compensation::MapError;
use crate::equilibrium::distribution::{DistributionError, Reason};
use crate::model::WinchError;
use crate::statics::StaticsError;
use crate::tension::NotSmooth;

/// Reason that a control model sends no lengths for a pose, that a machine does not come to rest there, or that one of
/// them has no derivative.
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
    /// A winch without the motor angle for a length.
    #[error(transparent)]
    Winch(#[from] WinchError),
    /// A length outside the range of a drum's groove.
    #[error(transparent)]
    Groove(#[from] GrooveError),
    /// The machine does not come to rest.
    #[error("{}", .reason.as_deref().unwrap_or(.status.name()))]
    NoRest {
        /// Outcome of the search.
        status: Status,
        /// The reason in words, if known.
        reason: Option<String>,
    },
    /// A pose beyond the map of the control model.
    #[error(transparent)]
    Map(#[from] MapError),
    /// An error at one of many poses.
    #[error("pose {pose}: {reason}")]
    AtPose {
        /// Number of the pose, from 1.
        pose: usize,
        /// The error there.
        reason: Box<Self>,
    },
    /// A machine with one number changed, for differences, does not answer.
    #[error("{cause} deviating: {reason}")]
    Deviating {
        /// Name of the number.
        cause: String,
        /// The error of that machine.
        reason: Box<Self>,
    },
    /// The method for choosing tensions has no derivative at this pose.
    #[error("the tensions of the control model have no derivative: {0}")]
    NotSmooth(NotSmooth),
    /// A displacement of the machine meets no resistance.
    #[error("the stiffness of the machine is singular at the emerging pose")]
    Singular,
    /// Robots, tensions or a load for which no pose has an answer.
    #[error(transparent)]
    Input(#[from] InputError),
}
