//! Questions about workspaces that cannot be answered.

use thiserror::Error;

use super::wrench_set::{PayloadError, WrenchSetError};
use crate::statics::LoadError;
use crate::tension::{InputError, LimitsError};

/// A question that does not fit the robot, or that is none.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum WorkspaceError {
    /// Nothing to judge by.
    #[error("no criterion is given; name one, e.g. wrench-feasible")]
    NoCriterion,
    /// A criterion for straight cables asked of sagging ones.
    #[error(
        "the criterion `{criterion}` asks for directions that do not depend on tensions, but the cables of the model sag; leave the effect out"
    )]
    SaggingCables {
        /// Name of the criterion.
        criterion: &'static str,
    },
    /// The robot's file does not say what the criterion needs.
    #[error("the criterion `{criterion}` needs {key}, which the file of \"{robot}\" lacks; {cure}")]
    MissingKey {
        /// Name of the criterion.
        criterion: &'static str,
        /// Name of the robot.
        robot: String,
        /// The key that is missing, with its table.
        key: String,
        /// How to mend it.
        cure: String,
    },
    /// A number of a criterion that it cannot use.
    #[error("the criterion `{criterion}` has {setting} = {value}; {wanted}")]
    Setting {
        /// Name of the criterion.
        criterion: &'static str,
        /// Name of the number.
        setting: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        wanted: &'static str,
    },
    /// Limits of tension that are unknown or leave none.
    #[error(transparent)]
    Limits(#[from] LimitsError),
    /// A load that is unknown.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// Cables without a wrench set.
    #[error(transparent)]
    WrenchSet(#[from] WrenchSetError),
    /// A payload that is unknown or none.
    #[error(transparent)]
    Payload(#[from] PayloadError),
    /// Limits or wrenches that do not fit the model.
    #[error(transparent)]
    Tension(#[from] InputError),
}
