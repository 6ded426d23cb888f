//! Questions that no plan answers.

use thiserror::Error;

use crate::fit::InputError;
use cdpr_model::control;
use cdpr_model::equilibrium::distribution::DistributionError;
use cdpr_model::model::ParameterError;
use cdpr_model::statics::LoadError;

/// Wish that no plan can keep.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlanError {
    /// No pose is asked for.
    #[error("0 poses are to be planned: ask for 1 at least")]
    NoCount,
    /// More poses than candidates.
    #[error(
        "{count} poses are to be chosen of {candidates} candidates, each once: give more candidates, ask for fewer poses, or let poses repeat"
    )]
    TooMany {
        /// Poses asked for.
        count: usize,
        /// Candidates there are.
        candidates: usize,
    },
    /// No parameter is free.
    #[error("no parameter is free, so that there is nothing to measure for")]
    NothingFree,
    /// No pose that could be measured.
    #[error("none of the {poses} candidate poses can be measured, the first because {reason}")]
    NoCandidate {
        /// Poses that were asked.
        poses: usize,
        /// Why the first cannot be measured.
        reason: String,
    },
    /// More levels than the null space has directions for.
    #[error(
        "{levels} levels of tension are asked for at every pose; with {redundancy} more cables than degrees of freedom there are 1 to {most}: the \
         middle, and two along every direction of the null space"
    )]
    Levels {
        /// Levels asked for.
        levels: usize,
        /// m − n.
        redundancy: usize,
        /// Most levels.
        most: usize,
    },
    /// Levels of tension for a model that knows none.
    #[error(
        "levels of tension are asked for, but the model has rigid cables whose lengths no tension changes: one level is enough"
    )]
    LevelsOfRigid,
    /// Tension tests of a model that knows no tensions.
    #[error(
        "tension tests are asked for, but the model has rigid cables that no test tells of: plan for an elastic model"
    )]
    TestsOfRigid,
    /// Levels of tension of sagging cables.
    #[error(
        "levels of tension are asked for, but sagging cables have no null space that is the same for all tensions: one level only"
    )]
    LevelsOfSagging,
    /// Priors beside rows of unit weight.
    #[error(
        "priors count beside the accuracies of the sensors, and none is stated: state those of lengths and poses, or leave the priors out"
    )]
    PriorsWithoutAccuracies,
    /// Parameters that need what a plan does not know.
    #[error("`{name}` is free, but a plan of poses tells nothing of it: it depends on {on}")]
    Unplannable {
        /// Kind of the parameters.
        name: &'static str,
        /// Cause of its changes.
        on: &'static str,
    },
    /// Parameters that the model lacks.
    #[error(transparent)]
    Parameters(#[from] ParameterError),
    /// Rows that do not exist.
    #[error(transparent)]
    Rows(#[from] InputError),
    /// A load that is not stated.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// Limits that are missing.
    #[error(transparent)]
    Tensions(#[from] DistributionError),
    /// A machine that cannot be driven.
    #[error(transparent)]
    Machine(#[from] control::InputError),
}
