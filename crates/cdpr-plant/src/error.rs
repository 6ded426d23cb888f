//! Errors of machines that cannot move and of scenarios that cannot be run.

use thiserror::Error;

use cdpr_model::control;
use cdpr_model::geometry::PatternError;
use cdpr_model::model::{CompositionError, ModelError, WinchError};
use cdpr_model::robot::BodyError;
use cdpr_model::robot::stretch::registry::law_words;
use cdpr_model::statics::{LoadError, StaticsError};

/// Key of a scenario file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScenarioKey {
    /// Table, without brackets; nested tables are separated by points.
    pub table: &'static str,
    /// Position in a list of tables, from 0.
    pub index: Option<usize>,
    /// Key in the table; empty for the table itself.
    pub key: &'static str,
}

impl ScenarioKey {
    /// A key of a table.
    pub(crate) const fn of(table: &'static str, key: &'static str) -> Self {
        Self { table, index: None, key }
    }
}

/// Error in a machine or a scenario.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlantError {
    /// A value of the scenario that cannot be used.
    #[error("{message}")]
    Value {
        /// Key with the value.
        key: ScenarioKey,
        /// Error and remedy.
        message: String,
    },
    /// Components of a pose that do not fit the motion pattern.
    #[error("{reason}")]
    Components {
        /// Key with the components.
        key: ScenarioKey,
        /// Reason.
        reason: PatternError,
    },
    /// A composition that cannot be understood.
    #[error(transparent)]
    Composition(#[from] CompositionError),
    /// Effects whose keys the robot file lacks.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// Mass, centre of mass or inertia unknown.
    #[error(transparent)]
    Body(#[from] BodyError),
    /// The load on the platform is unknown.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// Cables that do not stretch: their tension does not follow from their length, so it cannot move a platform.
    #[error(
        "cable {cable} does not stretch in the model `{composition}`, so that its tension does not follow from its length; use a model with \
         {}, and give the cable a stiffness",
        law_words("or")
    )]
    RigidCable {
        /// Number of the cable, from 1.
        cable: usize,
        /// Effects of the model.
        composition: String,
    },
    /// A drum without radius or inertia.
    #[error(
        "winches = \"drums\" needs `{key}`, which cable {cable} (\"{name}\") does not have; add the key to its [[cable]] table or to \
         [cable_defaults], or use winches = \"ideal\""
    )]
    NoDrum {
        /// Missing key.
        key: &'static str,
        /// Number of the cable, from 1.
        cable: usize,
        /// Name of the cable.
        name: String,
    },
    /// A length that the drum cannot hold.
    #[error(transparent)]
    Winch(#[from] WinchError),
    /// The start is not an equilibrium of the cables.
    #[error("there is no equilibrium to start from: {0}")]
    Start(#[from] control::InputError),
    /// A cable that has no state at the start.
    #[error("there is no equilibrium to start from: {0}")]
    Cable(#[from] StaticsError),
    /// A controller whose period is not a positive time.
    #[error("the controller is to be asked every {period} s; a period is a time above 0 s")]
    Period {
        /// Period of the controller (s).
        period: f64,
    },
    /// The step is too large for the fastest motion of the machine.
    #[error(
        "a step of {step} s is too large: the fastest motion of this machine has {frequency:.1} Hz; use step_s = {largest:.1e} at most"
    )]
    StepTooLarge {
        /// Step asked for (s).
        step: f64,
        /// Largest sensible step (s).
        largest: f64,
        /// Fastest motion: natural frequency, or rate of decay over 2π (Hz).
        frequency: f64,
    },
}

/// Reason for which a controller has no command.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{reason}")]
pub struct ControlError {
    reason: String,
}

impl ControlError {
    /// An error with its reason in words.
    pub fn new(reason: impl Into<String>) -> Self {
        Self { reason: reason.into() }
    }
}

/// Errors that prevent the first step of a machine.
impl From<StepError> for PlantError {
    fn from(error: StepError) -> Self {
        match error {
            StepError::Cable(error) => Self::Cable(error),
            StepError::Winch(error) => Self::Winch(error),
            _ => Self::Value { key: ScenarioKey::of("start", ""), message: error.to_string() },
        }
    }
}

impl PlantError {
    /// Key in the scenario at which the error lies; `None` if there is none.
    pub fn key(&self) -> Option<ScenarioKey> {
        match self {
            Self::Value { key, .. } | Self::Components { key, .. } => Some(*key),
            Self::Composition(_) => Some(ScenarioKey::of("machine", "model")),
            Self::Start(_) => Some(ScenarioKey::of("start", "")),
            Self::StepTooLarge { .. } => Some(ScenarioKey::of("time", "step_s")),
            _ => None,
        }
    }
}

/// Reason for which a machine cannot take another step.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum StepError {
    /// A cable has no path, or no shape, at the pose that the platform reached.
    #[error(transparent)]
    Cable(#[from] StaticsError),
    /// A drum has run out of its groove.
    #[error(transparent)]
    Winch(#[from] WinchError),
    /// A winch that reels in more cable than there is.
    #[error(
        "cable {cable} has no length left: its winch would come to {length:.3} m; check signs and units of the commands, and torques against the load"
    )]
    NoLength {
        /// Number of the cable, from 1.
        cable: usize,
        /// Unstrained length that it would have (m).
        length: f64,
    },
    /// A platform that turns faster than steps can follow.
    #[error(
        "the platform turns by {turn:.3} rad within a step, and steps follow 1 rad at most: use a smaller step_s, or check moments, twist and inertia"
    )]
    Spin {
        /// Turn within a step (rad).
        turn: f64,
    },
    /// The motion overflowed.
    #[error(
        "the motion grew beyond all numbers: the step is too large for what the machine came to, or a load is not plausible"
    )]
    Overflow,
    /// No step of the integrator is small enough for the tolerance.
    #[error(
        "no step of the integrator keeps its error below {tolerance:e}: the machine is too stiff for it, or its forces jump; use a larger \
         tolerance, or integrator = \"symplectic\""
    )]
    Tolerance {
        /// Error that a step may have.
        tolerance: f64,
    },
    /// A command that the winch does not follow.
    #[error("cable {cable} is commanded {quantity}, and {takes}; {others}")]
    Command {
        /// Number of the cable, from 1.
        cable: usize,
        /// Quantity that is commanded.
        quantity: &'static str,
        /// Quantities that the machine's winches take.
        takes: &'static str,
        /// Kind of winches that follows the command.
        others: &'static str,
    },
    /// A command that is not a finite number.
    #[error("cable {cable} is commanded {number}; commands are finite numbers")]
    NotFinite {
        /// Number of the cable, from 1.
        cable: usize,
        /// Command.
        number: f64,
    },
    /// The controller has no command.
    #[error("the controller has no command: {0}")]
    Control(#[from] ControlError),
    /// The number of commands is not one per cable.
    #[error("{found} commands are given, the robot has {expected} cables: give one per cable")]
    Count {
        /// Cables of the robot.
        expected: usize,
        /// Commands given.
        found: usize,
    },
}
