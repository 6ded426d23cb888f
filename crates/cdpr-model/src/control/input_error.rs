//! Studies that cannot be run.

use thiserror::Error;

use crate::cable::GeometryError;
use crate::equilibrium::{ForwardError, elastostatics};
use crate::geometry::PatternError;
use crate::model::{CompositionError, Model, ModelError, WinchError};
use crate::statics::{LoadError, StaticsError};
use crate::tension::{self, LimitsError};

/// Error in a pair of control model and machine, or in the setting of its winches.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum InputError {
    /// Control model and machine are different robots.
    #[error(
        "the control model has {control} cables and the pattern {control_pattern}, the machine {machine} cables and {machine_pattern}"
    )]
    DifferentRobots {
        /// Cables of the control model.
        control: usize,
        /// Its motion pattern.
        control_pattern: &'static str,
        /// Cables of the machine.
        machine: usize,
        /// Its motion pattern.
        machine_pattern: &'static str,
    },
    /// Not one offset or tension per cable.
    #[error("{key} has {found} entries; the robot has {expected} cables")]
    Count {
        /// Key of the study.
        key: &'static str,
        /// Cables of the robot.
        expected: usize,
        /// Entries given.
        found: usize,
    },
    /// A cable has no path at the initial pose.
    #[error("at the initial pose, {0}")]
    Initial(#[from] GeometryError),
    /// The initial tensions are not possible for the cables.
    #[error("at the initial pose, {0}")]
    InitialTensions(#[from] StaticsError),
    /// Offsets of elastic cables are requested without initial tensions.
    #[error(
        "the winch offsets of elastic cables depend on the initial tensions: add tensions_N or tension_method to [initial], or say offset = \"none\""
    )]
    NoTensions,
    /// No tensions balance the load at the initial pose.
    #[error("at the initial pose no tensions balance the load: {reason}; choose another pose or other tensions")]
    NotBalanced {
        /// Reason that the load is not balanced.
        reason: String,
    },
    /// The load on an elastic robot is unknown.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// An elastic machine whose forward problem cannot be posed.
    #[error("the machine cannot answer: {0}")]
    Machine(#[from] elastostatics::InputError),
    /// The tension limits are unknown or leave nothing to choose.
    #[error("{0}; in a study, [limits] gives tension_min_N and tension_max_N for all cables")]
    Limits(#[from] LimitsError),
    /// Numbers that no tension distribution can use.
    #[error("at the initial pose, {0}")]
    Distribution(#[from] tension::InputError),
    /// Motor angles outside the range of the winches of control model or machine.
    #[error(transparent)]
    Winch(#[from] WinchError),
    /// Motor angles are requested, but neither model has drums.
    #[error("neither control model nor machine has the effect `drum`, so there are no motor angles to record")]
    NoDrum,
    /// No requirement is stated, so that every pose would be reached.
    #[error("{}", no_requirement(*is_elastic))]
    NoRequirement {
        /// True if the machine has tensions to which limits apply.
        is_elastic: bool,
    },
    /// Errors of tensions are to be judged, but none are commanded, or none emerge.
    #[error(
        "[limits] tension_error_max_N compares emerging with commanded tensions, but {}: give {} an elastic model, or take the key out",
        if *commands { "none emerge from a rigid machine" } else { "the control model commands lengths alone" },
        if *commands { "[machine]" } else { "[control]" }
    )]
    NoCommandedTensions {
        /// True if the control model commands tensions, so that the machine has none.
        commands: bool,
    },
    /// A single initial tension is to vary, which the balance does not allow.
    #[error("initial tensions balance the load, so that none of them changes alone: vary winch-offset instead")]
    TensionsVaryTogether,
    /// A robot without the keys for its model, or a deviation that leaves no valid model.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A text that is no composition of effects.
    #[error(transparent)]
    Composition(#[from] CompositionError),
    /// An initial pose that does not fit the robot.
    #[error("[initial] pose: {0}")]
    InitialPose(#[from] PatternError),
    /// Tensions of a rigid machine are requested.
    #[error(
        "the machine's cables are rigid, so no tensions emerge: give [machine] an elastic model, e.g. model = \"elastic\""
    )]
    RigidMachine,
    /// More answers than the limit of memory.
    #[error("{robots} robots at {poses} poses are more than {limit} answers: draw fewer robots or command fewer poses")]
    TooManyRobots {
        /// Robots drawn.
        robots: usize,
        /// Poses commanded.
        poses: usize,
        /// Largest number of answers.
        limit: usize,
    },
    /// A map that the study names but that was not given.
    #[error("[control] compensation names the map {file}, which is not there to drive with: give it to the experiment")]
    NoMap {
        /// Its file.
        file: String,
    },
    /// A map for a task that cannot use one.
    #[error("[control] compensation: {question} cannot take a map: {reason}; take the key out")]
    Map {
        /// Name of the task.
        question: &'static str,
        /// Reason that it cannot use a map.
        reason: &'static str,
    },
    /// No poses to command.
    #[error("the study commands no poses: add [poses.grid], [poses.random] or [poses.file]")]
    NoPoses,
    /// `[poses] only` keeps none.
    #[error(
        "none of the {poses} poses of the study is wrench-feasible: the machine's cables balance the load at no pose of this region; move \
         [poses], or take `only` out"
    )]
    NoneFeasible {
        /// Poses of the study.
        poses: usize,
    },
}

impl From<ForwardError> for InputError {
    fn from(error: ForwardError) -> Self {
        match error {
            ForwardError::Load(error) => Self::Load(error),
            ForwardError::Input(error) => Self::Machine(error),
        }
    }
}

fn no_requirement(is_elastic: bool) -> &'static str {
    match is_elastic {
        true => {
            "nothing says when a pose is reached: add tension_min_N and tension_max_N, or position_error_max_m, to [limits]"
        }
        false => {
            "a rigid machine has no tensions to judge, and nothing else says when a pose is reached: add position_error_max_m to [limits], or give the machine an elastic model"
        }
    }
}

/// Refuses models of different cable counts or motion patterns.
pub(super) fn check_same_robot(control: &Model, machine: &Model) -> Result<(), InputError> {
    let pattern = |model: &Model| model.robot().motion_pattern.name();
    if control.cable_count() == machine.cable_count() && pattern(control) == pattern(machine) {
        return Ok(());
    }
    Err(InputError::DifferentRobots {
        control: control.cable_count(),
        control_pattern: pattern(control),
        machine: machine.cable_count(),
        machine_pattern: pattern(machine),
    })
}
