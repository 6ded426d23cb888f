//! A controller that drives a machine: the lengths that a control model sends for poses, and the pose and tensions that
//! emerge.
//!
//! [`Control`] is a control model with its method for choosing tensions and its map; [`Operation`] answers with the
//! pose and tensions that emerge on a machine, [`Driving`] from several threads. [`initial_tensions`] and
//! [`winch_offsets`] describe how the winches were set before, and [`initial_tension`] finds the tensions that suit a
//! path.

mod command;
mod controller;
mod driving;
pub mod error_statistics;
mod history;
mod initial;
pub mod initial_tension;
mod input_error;
mod machine;
mod map_effect;
mod operation;
mod operation_error;
mod outcome;
pub mod simulate;
mod status;
mod winches;
mod winding;

pub use command::{CommandedPose, Shortening};
pub use controller::{Control, TensionChoice, lengths_at};
pub use driving::Driving;
pub use error_statistics::{LengthErrorStatistics, PoseErrorStatistics, TensionErrorStatistics};
pub use history::{History, Reach};
pub use initial::Initial;
pub use input_error::InputError;
pub use map_effect::MapEffect;
pub use operation::{Arrival, Emerged, Operation, PathPoint};
pub use operation_error::OperationError;
pub use outcome::Outcome;
pub use status::Status;
pub use winches::{aim, initial_tensions, tension_model, tensions_set, winch_offsets};
pub use winding::{Winding, WindingGradient, with_motor_angles};
