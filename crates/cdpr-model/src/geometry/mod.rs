//! Poses, twists, wrenches and motion patterns, without reference to a robot.

mod composed;
mod nearest_rotation;
mod pattern;
mod pose_batch;
mod pose_rows;

pub use cdpr_core::geometry::{Pose, Twist, Wrench};
pub use composed::{inverse, product};
pub use nearest_rotation::nearest_rotation;
pub use pattern::{MotionPattern, PatternError, Plane};
pub use pose_batch::PoseBatch;
pub use pose_batch::{POSE_ROWS, in_lanes, rotation_rows, transpose};
pub use pose_rows::{PoseRowError, PoseRows};
