//! Compensation maps: smooth corrections of a control model's lengths over the workspace.
//!
//! Recorded lengths are modelled ones and a correction c(x) of the pose, the mean of a Gaussian process over residuals. Lengths that were recorded at
//! a pose lead back to it, whatever the cables' elasticity does, so that a controller that sends φ(x) + c(x) comes to x. The map
//! acts as a whole among its samples and fades to zero over a margin around them. [`cdpr_calibration::compensation`] makes maps and judges them; whoever commands lengths asks here.

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
