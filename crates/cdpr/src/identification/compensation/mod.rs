//! Compensation maps: smooth corrections of lengths over the workspace, where the best physical model leaves errors that repeat.
//!
//! Recorded lengths are modelled ones and a correction c(x) of the pose, the mean of a Gaussian process over the residuals. Lengths that were recorded at
//! a pose lead back to it, whatever the cables' elasticity does, so that a controller that sends φ(x) + c(x) comes to x. The map is judged on samples held out, and
//! ends where measurements end.

mod compensation_error;
mod field;
#[cfg(feature = "files")]
mod file;
mod judgement;
mod map;
mod pose_space;
#[cfg(test)]
mod tests;

pub use compensation_error::CompensationError;
#[cfg(feature = "files")]
pub use file::MapError;
pub use judgement::{Compensated, Judged, compensate, evaluate_compensated};
pub use map::Compensation;
