//! Compensation maps: smooth corrections of a control model's lengths over the workspace.
//!
//! Recorded lengths are the modelled ones plus a correction c(x) of the pose, the mean of a Gaussian process over
//! residuals. Lengths recorded at a pose lead back to it, for any elasticity of the cables, so that a controller that
//! sends φ(x) + c(x) comes to x. The map acts fully among its samples and fades to zero over a margin around them.
//! `cdpr_calibration::compensation` makes maps and judges them; controllers use them here.

mod correction;
#[cfg(test)]
mod edges;
mod fade;
mod field;
#[cfg(feature = "files")]
mod file;
mod map;
mod map_error;
mod pose_space;

pub use correction::{Beyond, Correction};
pub use map::{Compensation, MapFacts};
pub use map_error::MapError;
pub use pose_space::Extent;
