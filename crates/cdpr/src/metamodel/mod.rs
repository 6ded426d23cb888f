//! A control model on a machine: what emerges when one model's lengths drive another.

pub mod accuracy;
pub mod advice;
pub mod branches;
mod control;
mod driving;
pub mod effects;
pub mod errors;
mod experiment;
pub mod field;
pub mod initial_tension;
mod input_error;
mod machine;
mod operate;
mod operation_error;
mod poorer;
pub mod reachable;
pub mod sensitivity;
pub mod simulate;
pub mod study;
pub mod sweep;
pub mod tolerance;
mod winches;
mod winding;

pub use control::Control;
pub use driving::Driving;
pub use experiment::{Experiment, ExperimentError, Robots};
pub use input_error::InputError;
pub use operate::{Operation, Outcome, Status, operate};
pub use operation_error::OperationError;
pub use poorer::{missing_effects, remark_on_poorer};
pub use study::Study;
pub use winches::{initial_tensions, winch_offsets};
pub use winding::with_motor_angles;
