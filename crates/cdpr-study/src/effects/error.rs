//! Errors of quantities of an effect that cannot be computed.

use thiserror::Error;

use cdpr_model::equilibrium::distribution::{DistributionError, Reason};
use cdpr_model::equilibrium::{ForwardError, NoSolution};
use cdpr_model::model::WinchError;
use cdpr_model::statics::{LoadError, StaticsError};

/// Reason for which a quantity of a [`Contribution`](super::Contribution) cannot be computed.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum EffectError {
    /// An unknown load.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// Cables that have no state at the pose.
    #[error(transparent)]
    Statics(#[from] StaticsError),
    /// Input from which no tensions can be chosen.
    #[error(transparent)]
    Distribution(#[from] DistributionError),
    /// No tensions balance the load within the limits.
    #[error("{0}")]
    Unbalanced(Reason),
    /// Lengths depend on tensions, and none are given.
    #[error("the tensions are unknown")]
    UnknownTensions,
    /// A winch that cannot reach the length.
    #[error(transparent)]
    Winch(#[from] WinchError),
    /// Lengths that do not suit the forward problem.
    #[error(transparent)]
    Forward(#[from] ForwardError),
    /// Lengths for which the forward problem found no pose.
    #[error(transparent)]
    NoSolution(#[from] NoSolution),
    /// Lengths that lead to a distant pose.
    #[error("the lengths of this pose, or the changed ones, let the platform rest nowhere near it")]
    NotNear,
    /// A stiffness that is singular.
    #[error("the platform can move without resistance, so that its displacement is not determined")]
    Singular,
    /// A robot without a home pose.
    #[error("the file has no home pose at which winch offsets would be set")]
    NoHome,
    /// Tensions that are missing at the home pose.
    #[error("at the home pose: {0}")]
    AtHome(Box<Self>),
}
