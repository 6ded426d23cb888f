//! Frames of a recording: the tracker's world in the frame of the robot, and the tracked marker on the platform.
//!
//! A tracker tells the pose M of a marker in its own world; the platform is at T = X M Y⁻¹, X the pose of that world in the robot's frame
//! and Y that of the marker on the platform. Both are found together with the parameters of the model: for frames at hand the
//! parameters are at their optimum, and Gauss–Newton steps of the frames account for how that optimum follows them (variable projection).
//! Directions that no row resists, since the anchors follow, are fixed by the least change of the file's anchors.

mod directions;
mod elimination;
mod estimate;
mod joint;
mod need;
mod poses;
mod rows;
mod search;
mod start;
mod uncertainty;

#[cfg(test)]
mod tests;

pub use estimate::{FrameEstimate, Gauge, RecordingFrames};
pub use joint::frame_warning;
pub(super) use joint::{fit, freed};
pub(crate) use need::frames_that_fit;
pub(crate) use start::start_by_positions;
