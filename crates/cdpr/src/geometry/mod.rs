//! Poses, twists, wrenches and motion patterns; nothing here knows of a robot.

mod composed;
mod pattern;
mod pose_batch;

pub use cdpr_core::geometry::{Pose, Twist, Wrench};
pub(crate) use composed::{inverse, product};
pub use pattern::{MotionPattern, PatternError, Plane};
pub use pose_batch::PoseBatch;
pub(crate) use pose_batch::{POSE_ROWS, in_lanes, rotation_rows, transpose};
