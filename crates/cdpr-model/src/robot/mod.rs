//! A robot as data: geometry, cables, limits and the sources of the numbers.

mod assumption;
#[cfg(feature = "files")]
mod assumption_reading;
mod axis;
mod body;
#[cfg(feature = "files")]
pub mod builtin;
#[cfg(feature = "files")]
mod cable_defaults;
#[cfg(feature = "files")]
mod cable_reading;
#[cfg(feature = "files")]
pub mod caspr;
mod checks;
mod description;
mod doubts;
#[cfg(feature = "files")]
mod file;
#[cfg(feature = "files")]
mod home_reading;
mod identified;
mod parameter;
mod parts;
#[cfg(feature = "files")]
mod reader;
#[cfg(feature = "files")]
mod reading;
mod source;
pub mod stretch;
mod surroundings;
#[cfg(feature = "files")]
mod surroundings_reading;
mod tracked;
mod winch;
#[cfg(feature = "files")]
mod winch_reading;
#[cfg(feature = "files")]
mod writing;

pub use assumption::Assumption;
pub use axis::Axis;
pub use body::{Body, BodyError};
pub use cdpr_core::cable::elasticity::StiffnessBasis;
pub use description::{
    Cable, Calibration, ExternalWrench, Platform, ReferenceCheck, Robot, TensionPlace, TravelBox, WrapSide,
};
pub use parameter::{Head, axis_name};
pub use parameter::{Parameter, ParameterKind};
pub use parts::{CableStiffness, Pulley};
pub use source::{PublishedErrors, Source};
pub use stretch::registry::{LAWS, Law, LawNumber, StretchEffect, StretchNumber};
pub use stretch::{HysteresisTable, StretchError, TRANSITION_LIMIT};
pub use surroundings::{Obstacle, ObstacleShape};
pub use tracked::{Component, Frame, TrackedFrames};
pub use winch::{CableWinch, DrumSide, Groove, GrooveEnds};

#[cfg(feature = "files")]
/// JSON Schema of the robot file, for editors and for other programs.
pub fn schema() -> schemars::Schema {
    schemars::schema_for!(file::RobotFile)
}
