//! Questions about workspaces that cannot be answered.

use thiserror::Error;

use super::wrench_set::{PayloadError, WrenchSetError};
use cdpr_model::cable::winch::DrumError;
use cdpr_model::statics::LoadError;
use cdpr_model::tension::{InputError, LimitsError};

/// A question that does not fit the robot, or is incomplete.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum WorkspaceError {
    /// No criterion was given.
    #[error("no criterion is given; name one, e.g. wrench-feasible")]
    NoCriterion,
    /// A criterion for straight cables was requested for sagging ones.
    #[error(
        "`{criterion}` asks for directions that do not depend on tensions, but the cables of the model sag; leave the effect out"
    )]
    SaggingCables {
        /// Name of the criterion, or of the question.
        criterion: &'static str,
    },
    /// The robot's file lacks a key that the criterion needs.
    #[error("the criterion `{criterion}` needs {key}, which the file of \"{robot}\" lacks; {cure}")]
    MissingKey {
        /// Name of the criterion.
        criterion: &'static str,
        /// Name of the robot.
        robot: String,
        /// The missing key, with its table.
        key: String,
        /// Advice to the user.
        cure: String,
    },
    /// A criterion of an effect that the model does not have.
    #[error("the criterion `{criterion}` needs a model with the effect `{effect}`: {cure}")]
    MissingEffect {
        /// Name of the criterion.
        criterion: &'static str,
        /// The effect.
        effect: &'static str,
        /// Reason, and advice to the user.
        cure: String,
    },
    /// A number that the criterion cannot use.
    #[error("the criterion `{criterion}` has {setting} = {value}; {wanted}")]
    Setting {
        /// Name of the criterion.
        criterion: &'static str,
        /// Name of the number.
        setting: &'static str,
        /// Value given.
        value: f64,
        /// Values allowed, in words.
        wanted: &'static str,
    },
    /// A number with which no capability can be sought.
    #[error("the {setting} is {value}; {wanted}")]
    Capability {
        /// Name of the number.
        setting: &'static str,
        /// Value given.
        value: f64,
        /// Values allowed, in words.
        wanted: &'static str,
    },
    /// A drum whose numbers make none.
    #[error("cable {cable}: {error}")]
    Drum {
        /// Number of the cable, from 1.
        cable: usize,
        /// Numbers that make no drum.
        error: DrumError,
    },
    /// The number of ends does not match the box.
    #[error("expected {expected} bounds, two per translation of the platform, found {found}")]
    BoundsCount {
        /// Number of ends needed: two for each dimension.
        expected: usize,
        /// Numbers given.
        found: usize,
    },
    /// Ends of a box that are not in order.
    #[error(
        "the bounds along axis {axis} run from {least} m to {largest} m; the first must be below the second, both finite"
    )]
    Bounds {
        /// Number of the axis, from 1.
        axis: usize,
        /// Lower end given (m).
        least: f64,
        /// Upper end given (m).
        largest: f64,
    },
    /// The size of cells is not finite and positive.
    #[error("the step is {step} m; cells need a finite size above zero")]
    Step {
        /// Step given (m).
        step: f64,
    },
    /// More cells than can be counted.
    #[error("a step of {step} m cuts {extent} m into more cells than can be judged; take a larger one")]
    StepTooFine {
        /// Step given (m).
        step: f64,
        /// A side of the box (m).
        extent: f64,
    },
    /// Orientations were requested for a platform that does not turn.
    #[error("the {archetype} workspace asks for orientations, but motion pattern {pattern} does not turn")]
    NoRotation {
        /// Word for the archetype.
        archetype: &'static str,
        /// Name of the motion pattern.
        pattern: &'static str,
    },
    /// The set of orientations is empty.
    #[error("the {archetype} workspace needs at least one orientation, none is given")]
    NoOrientation {
        /// Word for the archetype.
        archetype: &'static str,
    },
    /// Too few rays for a face, or more than memory allows.
    #[error("{rays} rays do not make a hull; between {least} and {most} do")]
    Rays {
        /// Rays given.
        rays: usize,
        /// Fewest.
        least: usize,
        /// Most.
        most: usize,
    },
    /// The tolerance is not finite and positive, so that bisection would not end, or not begin.
    #[error("the tolerance is {tolerance} m; it must be finite and above zero")]
    Tolerance {
        /// Tolerance given (m).
        tolerance: f64,
    },
    /// A centre outside the box.
    #[error("the center {center} lies outside the bounds; move it inside, or widen them")]
    CenterOutsideBounds {
        /// Its coordinates.
        center: String,
    },
    /// A centre at which the criterion fails.
    #[error(
        "the center {center} does not belong to the workspace, so that no ray leaves it there: {reason}; choose a pose at which the criteria hold"
    )]
    CenterOutside {
        /// Its coordinates.
        center: String,
        /// Reason for which it fails there.
        reason: String,
    },
    /// Limits of tension that are unknown, or leave no tensions.
    #[error(transparent)]
    Limits(#[from] LimitsError),
    /// A load that is unknown.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// Cables that have no wrench set.
    #[error(transparent)]
    WrenchSet(#[from] WrenchSetError),
    /// A payload that is unknown or invalid.
    #[error(transparent)]
    Payload(#[from] PayloadError),
    /// Limits or wrenches that do not fit the model.
    #[error(transparent)]
    Tension(#[from] InputError),
}
