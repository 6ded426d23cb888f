//! A robot as data: geometry, cables, limits and where the numbers come from.

mod axis;
pub mod builtin;
mod cable_defaults;
mod cable_reading;
pub mod caspr;
mod checks;
mod description;
mod file;
mod home_reading;
mod parameter;
mod parts;
mod reader;
mod reading;
pub(crate) mod stretch;
mod surroundings;
mod surroundings_reading;
mod winch;
mod winch_reading;
mod writing;

pub use axis::Axis;
pub use cdpr_core::cable::elasticity::StiffnessBasis;
pub use description::{
    Cable, ExternalWrench, Platform, ReferenceCheck, Robot, Source, TensionPlace, TravelBox, WrapSide,
};
pub(crate) use parameter::{Head, axis_name};
pub use parameter::{Parameter, ParameterKind};
pub use parts::{CableStiffness, Pulley};
pub(crate) use stretch::rising_range;
pub use stretch::{HysteresisTable, StretchError, TRANSITION_LIMIT};
pub use surroundings::{Obstacle, ObstacleShape};
pub use winch::{CableWinch, DrumSide, Groove, GrooveEnds};

/// JSON Schema of the robot file, for editors and for other programs.
pub fn schema() -> schemars::Schema {
    schemars::schema_for!(file::RobotFile)
}
