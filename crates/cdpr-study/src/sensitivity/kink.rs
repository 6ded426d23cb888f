//! Points of a path from which no derivative continues.

use std::fmt;

use super::cause::Side;
use cdpr_model::control::OperationError;
use cdpr_model::control::Status;
use cdpr_model::reading::Keyword;

/// Reason for which no derivative continues along a path of cables with memory.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Kink {
    /// The motion of a cable ends within rounding of a point where a part of its hysteresis begins to slide or to hold,
    /// and deviations lead to either side.
    Branch {
        /// Side of the cable.
        side: Side,
        /// The cable, from 0.
        cable: usize,
    },
    /// A cable is within rounding between taut and slack.
    Slack {
        /// Side of the cable.
        side: Side,
        /// The cable, from 0.
        cable: usize,
    },
    /// The machine does not come to rest at a step of the path.
    NoRest(Status),
    /// Cables with weight and memory: their law needs the memory at more tensions than that at the outlet.
    Sagging,
    /// A step of the path has no derivative.
    Step(Box<OperationError>),
}

impl From<OperationError> for Kink {
    fn from(error: OperationError) -> Self {
        Self::Step(Box::new(error))
    }
}

impl fmt::Display for Kink {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Branch { side, cable } => {
                write!(f, "cable {} ({}) comes to rest where its hysteresis changes branch", cable + 1, side.name())
            }
            Self::Slack { side, cable } => write!(f, "cable {} ({}) is between taut and slack", cable + 1, side.name()),
            Self::NoRest(status) => write!(f, "a step of the way there has no equilibrium ({})", status.name()),
            Self::Sagging => f.write_str("cables that sag remember at more tensions than one"),
            Self::Step(error) => write!(f, "{error}"),
        }
    }
}
