//! Quantities of an effect that cannot be told.

use thiserror::Error;

use cdpr_model::equilibrium::distribution::{DistributionError, Reason};
use cdpr_model::equilibrium::{ForwardError, NoSolution};
use cdpr_model::model::WinchError;
use cdpr_model::statics::{LoadError, StaticsError};

/// Reason for which a quantity of a [`Contribution`](super::Contribution) cannot be told.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum EffectError {
    /// An unknown load.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// Cables that have no state at the pose.
    #[error(transparent)]
    Statics(#[from] StaticsError),
    /// Numbers from which no tensions can be chosen.
    #[error(transparent)]
    Distribution(#[from] DistributionError),
    /// No tensions balance the load within the limits.
    #[error("{0}")]
    Unbalanced(Reason),
    /// Lengths that belong to tensions, of which none are given.
    #[error("the tensions are unknown")]
    UnknownTensions,
    /// A winch that cannot be turned so far.
    #[error(transparent)]
    Winch(#[from] WinchError),
    /// Lengths with which no forward problem can be posed.
    #[error(transparent)]
    Forward(#[from] ForwardError),
    /// Lengths that lead to no pose.
    #[error(transparent)]
    NoSolution(#[from] NoSolution),
    /// Lengths that lead elsewhere.
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
