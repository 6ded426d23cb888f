//! A robot with chosen effects: lengths, directions, structure matrix, and their derivatives by pose and by parameter.

mod batch;
mod composition;
mod error;
mod free_parameters;
mod kinematics;
mod laws;
mod length_shifts;
mod parameter;
mod parameter_names;
mod placement;
mod single_pose;
mod supported;
#[cfg(test)]
mod tests;
mod winches;
mod winching;

pub(crate) use cdpr_core::structure::{CableGroup, in_pattern};
pub use composition::{Cables, Composition, CompositionError, SpanEffect, StretchEffect};
pub use error::ModelError;
pub use free_parameters::{FreeParameters, identified_kind, missing_effect};
pub use kinematics::Model;
pub use length_shifts::{LengthShift, ShiftCourse};
pub use parameter_names::{ParameterError, RecordingParameter};
pub use placement::{PlacePulleysError, place_pulleys};
pub use supported::Supported;
pub use winching::WinchError;
