//! Answer of a machine to one command.

use super::operation_error::OperationError;
use super::status::Status;
use crate::geometry::Pose;

/// Answer of a machine to one command.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The pose that emerges: the best one found if the status is not [`Status::Converged`], the commanded one if
    /// nothing was sent.
    pub pose: Pose,
    /// Lengths sent to the winches: the control model's with the offsets, in the units of its own encoders (m); empty
    /// if the control model has none.
    pub sent: Vec<f64>,
    /// Lengths that the encoders read when the platform is at rest (m): those sent, or, for a rigid machine with
    /// winches that take up slack, the actual ones. Offsets are part of the winch's zero and are not read.
    pub recorded: Vec<f64>,
    /// Tensions that emerge (N); `None` for a rigid machine that fits its lengths.
    pub tensions: Option<Vec<f64>>,
    /// Tensions that the control model commands, f_ref (N); `None` if its lengths do not depend on tensions, or if
    /// nothing was sent.
    pub commanded_tensions: Option<Vec<f64>>,
    /// Status of the answer.
    pub status: Status,
    /// The reason in words if the status is not [`Status::Converged`].
    pub reason: Option<String>,
}

impl Outcome {
    /// Emerging less commanded tensions (N); `None` if one of the models has none.
    pub fn tension_errors(&self) -> Option<Vec<f64>> {
        let both = self.tensions.as_ref().zip(self.commanded_tensions.as_ref());
        both.map(|(emerging, commanded)| emerging.iter().zip(commanded).map(|(f, wanted)| f - wanted).collect())
    }

    /// An error with the reason unless the machine has come to rest.
    pub fn at_rest(&self) -> Result<(), OperationError> {
        match self.status {
            Status::Converged => Ok(()),
            status => Err(OperationError::NoRest { status, reason: self.reason.clone() }),
        }
    }
}
