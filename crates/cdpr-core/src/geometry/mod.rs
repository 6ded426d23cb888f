//! Poses, twists and wrenches; independent of any robot.

mod angle_rates;
mod pose;

pub use pose::{POSE_ROWS, Pose};

/// Six numbers [v; ω] (m/s, rad/s) or a small displacement [δr; δφ] (m, rad): world axes, rotation acting from the
/// left.
pub type Twist = nalgebra::Vector6<f64>;

/// Force and moment about the platform origin, world axes (N, N·m); acts *on* the platform: Aᵀ f + w = 0.
pub type Wrench = nalgebra::Vector6<f64>;
