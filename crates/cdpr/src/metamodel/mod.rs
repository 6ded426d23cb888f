//! A control model on a machine: what emerges when one model's lengths drive another.

pub mod accuracy;
pub mod advice;
pub mod branches;
mod control;
pub mod difference;
mod driving;
pub mod effects;
pub mod errors;
mod experiment;
pub mod field;
pub mod initial_tension;
mod input_error;
mod machine;
mod map_effect;
mod operation;
mod operation_error;
mod outcome;
mod poorer;
pub mod reachable;
pub mod sensitivity;
pub mod simulate;
mod status;
pub mod study;
#[cfg(feature = "files")]
pub mod sweep;
pub mod tolerance;
mod winches;
mod winding;

pub use control::Control;
pub use driving::Driving;
pub use experiment::{Experiment, ExperimentError, Robots};
pub use input_error::InputError;
pub use map_effect::MapEffect;
pub use operation::Operation;
pub use operation_error::OperationError;
pub use outcome::Outcome;
pub use poorer::missing_effects;
pub use status::Status;
pub use study::Study;
pub use winches::{initial_tensions, winch_offsets};
pub use winding::with_motor_angles;
