//! The toolchain for cable-driven parallel robots: models, calibration and model selection.
//!
//! A platform hangs in m cables. Cable i runs from its frame anchor aᵢ (world) to its platform anchor bᵢ (platform frame);
//! at the pose x = (r, R) its length is qᵢ = ‖aᵢ − r − R bᵢ‖, and pulleys, elasticity or sag make it longer. A *control
//! model* computes these lengths for the winches. Which one is good enough, and at which parameters p? From measured poses
//! and recorded lengths this library finds the parameters of candidate models,
//!
//! min over p of Σ ((q(x, p) − q_recorded)/σ)²,
//!
//! tells what the data determine and how surely, and recommends the simplest candidate that predicts data it was not
//! fitted to as well as the best one does.
//!
//! ```
//! use cdpr::workspace::Workspace;
//! use cdpr::{Load, Model, Robot, State, Status};
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../cdpr-model/robots/");
//! let robot = Robot::from_file(format!("{folder}cablerobot-simulator-helicopter-elastostatic-calibrated.toml"))?;
//! let load = Load::of(&robot)?;
//! let model = Model::new(robot, "elastic".parse()?)?;
//! let mut state = State::at_home(&model);
//! let home = state.pose();
//!
//! let distribution = model.distribute(&home, &load)?; // tensions, or the reason for which there are none
//! let command = model.inverse(&home, &distribution.tensions, &mut state)?;
//! let lengths = command.controlled_lengths()?;
//! let answer = model.forward(&lengths, Some(&load), Some(&home), &mut state)?; // pose, tensions, status
//! assert_eq!(answer.status, Status::Converged);
//! assert!((answer.pose.position - home.position).norm() < 1e-9);
//! let volume = Workspace::of(&model, &load).wrench_feasible().volume()?; // m³, with a bound of its error
//! assert!(volume.error_bound < 0.1 * volume.size);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Data flow from left to right through the modules [`geometry`], [`robot`], [`measurement`], [`cable`], [`model`],
//! [`statics`], [`equilibrium`], [`workspace`], [`compensation`], [`control`], [`plant`], [`calibration`], [`study`]; [`scalar`] holds the number types and [`reading`] the error of every
//! file reader with the stable name of every error. Symbols and signs are in [`notation`]. SI units and radians everywhere.

#[doc(inline)]
pub use cdpr_model::equilibrium::distribution::Distribution;
#[doc(inline)]
pub use cdpr_model::equilibrium::{Solution, State, Status};
#[doc(inline)]
pub use cdpr_model::finding::{Finding, FindingKind, Severity};
#[doc(inline)]
pub use cdpr_model::geometry::{Pose, Twist, Wrench};
#[doc(inline)]
pub use cdpr_model::measurement::Samples;
#[doc(inline)]
pub use cdpr_model::model::{Composition, FreeParameters, Model};
#[doc(inline)]
pub use cdpr_model::notation;
#[doc(inline)]
pub use cdpr_model::reading::{FileError, ReadError};
#[doc(inline)]
pub use cdpr_model::robot::Robot;
#[doc(inline)]
pub use cdpr_model::statics::Load;
#[doc(inline)]
pub use cdpr_model::tension::Limits;
#[doc(inline)]
pub use cdpr_study::Experiment;
pub use error::{Error, Place};
pub use nalgebra;

mod error;

pub mod geometry {
    //! Poses, twists and wrenches, and the motions that a robot's cables can make.

    #[doc(inline)]
    pub use cdpr_model::geometry::{
        MotionPattern, PatternError, Plane, Pose, PoseBatch, PoseRowError, PoseRows, Twist, Wrench,
    };
}

pub mod scalar {
    //! Numbers that one formula serves: `f64`, eight lanes at once, dual numbers.

    #[doc(inline)]
    pub use cdpr_model::scalar::{
        Kernel, LANES, LaneTable, Lanes, Line, Real, Select, Unit, dispatch, dispatch_narrow, dispatch_on,
    };
}

pub mod reading {
    //! Errors of files, with place and remedy, and the stable code of every error.

    #[doc(inline)]
    pub use cdpr_model::reading::{ErrorCode, FileError, Keyword, ReadError};
}

pub mod robot {
    //! The robot as data, its file, and every number of it by name.

    #[doc(inline)]
    pub use cdpr_model::robot::{
        Axis, Body, Cable, CableStiffness, CableWinch, DrumSide, ExternalWrench, HysteresisTable, Obstacle, Parameter,
        ParameterKind, Platform, Pulley, Robot, StiffnessBasis, TravelBox, WrapSide,
    };

    #[cfg(feature = "files")]
    pub mod builtin {
        //! Robots that come with the library.

        #[doc(inline)]
        pub use cdpr_model::robot::builtin::{find, names};
    }

    #[cfg(feature = "files")]
    pub mod caspr {
        //! Robots of CASPR's files.

        #[doc(inline)]
        pub use cdpr_model::robot::caspr::{Files, Import, Options, import};
    }
}

pub mod measurement {
    //! Measured poses with lengths, tensions and further sensors: samples, their file, how they are split.

    #[doc(inline)]
    pub use cdpr_model::measurement::{
        DataError, InternalSamples, Samples, SensorSigmas, Sidecar, Split, SplitError, StaticSamples,
    };
    #[cfg(feature = "files")]
    #[doc(inline)]
    pub use cdpr_model::measurement::{Reading, ReadingOptions, poses_from_csv};
}

pub mod cable;

pub mod model {
    //! A robot with chosen effects: lengths, structure matrix, derivatives.

    #[doc(inline)]
    pub use cdpr_model::model::{
        Cables, Composition, CompositionError, FreeParameters, Model, ModelError, ParameterError, PlacePulleysError,
        SpanEffect, StretchEffect, Supported, WinchError, place_pulleys,
    };
}

pub mod statics {
    //! Balance, load and stiffness.

    #[doc(inline)]
    pub use cdpr_model::statics::{
        Load, LoadError, Stability, StaticsError, Stiffness, TensionSplit, balanced_wrench, cable_state,
        check_tensions, controlled_lengths, section_wrench, split, wrench_residual,
    };
}

pub mod tension {
    //! Tension distribution.

    #[doc(inline)]
    pub use cdpr_model::tension::{
        Answer, InputError, Intervals, Limits, LimitsError, Method, NotSmooth, Options, Reference, Response, Solver,
        Status, intervals, solve,
    };

    pub mod closed_form {
        //! The nearest tensions to the middle of the limits that balance the load (eq. 3.41).

        #[doc(inline)]
        pub use cdpr_model::tension::closed_form::{Solver, solve};
    }

    pub mod quadratic {
        //! The nearest tensions within the limits.

        #[doc(inline)]
        pub use cdpr_model::tension::quadratic::{Solver, Status, solve};
    }
}

pub mod equilibrium;

pub mod compensation {
    //! Maps that correct a model's lengths over the workspace; [`calibration::compensation`](crate::calibration::compensation) makes them.

    #[doc(inline)]
    pub use cdpr_model::compensation::{Beyond, Compensation, Correction, MapError};
}

pub mod control {
    //! A control model that sends lengths for poses, and what emerges from a machine under it.

    #[doc(inline)]
    pub use cdpr_model::control::{
        CommandedPose, Control, Driving, History, Initial, InputError, LengthErrorStatistics, Operation,
        OperationError, Outcome, PoseErrorStatistics, Reach, Shortening, Status, TensionErrorStatistics,
        initial_tensions, winch_offsets,
    };

    pub mod initial_tension {
        //! Initial tensions that suit a path, an area or a volume (eq. 3.42).

        #[doc(inline)]
        pub use cdpr_model::control::initial_tension::{Fit, Optimum, Task, fit, optimum};
    }

    pub mod simulate {
        //! Virtual measurements.

        #[doc(inline)]
        pub use cdpr_model::control::simulate::{Simulation, simulate};
    }
}

pub mod workspace;

pub mod plant {
    //! The machine in time.

    #[doc(inline)]
    pub use cdpr_plant::{
        Between, Command, ControlError, Controller, Energy, Event, Happening, Inertia, Linearization, Measured, Mode,
        Plant, PlantError, PlantState, RunEnd, Scenario, Sensors, Setpoint, Simulation, StepError, Summary, Violation,
        Winches,
    };

    pub mod events {
        //! Events that happen to a machine.

        #[doc(inline)]
        pub use cdpr_plant::events::{CableBreak, FrictionChange, LoadChange, Slip, WinchStop, WrenchChange};
    }

    pub mod sensors {
        //! Sensors of a moving machine.

        #[doc(inline)]
        pub use cdpr_plant::sensors::SensorLog;
    }
}

pub mod calibration;

pub mod study;

/// Questions that outlive the call in which they are posed own what they ask about, and any thread may answer them.
#[cfg(test)]
mod tests {
    fn is_owned<T: Clone + Send + Sync + 'static>() {}
    fn is_owned_once<T: Send + Sync + 'static>() {}

    #[test]
    fn long_lived_questions_own_their_models() {
        is_owned::<crate::Model>();
        is_owned::<crate::control::Control>();
        is_owned::<crate::control::Operation>();
        is_owned::<crate::control::Driving>();
        is_owned::<crate::equilibrium::distribution::Solver>();
        is_owned::<crate::workspace::Workspace>();
        is_owned_once::<crate::study::reachable::Reachable>();
        #[cfg(feature = "files")]
        is_owned_once::<crate::study::sweep::PreparedSweep>();
    }
}
