//! Poses in frames of poses.

use super::Pose;

/// The pose that is `second` in the frame at `first`.
pub fn product(first: &Pose, second: &Pose) -> Pose {
    Pose { position: first.transform(&second.position), rotation: first.rotation * second.rotation }
}

/// The world in the frame at a pose.
pub fn inverse(pose: &Pose) -> Pose {
    let rotation = pose.rotation.inverse();
    Pose { position: -(rotation * pose.position), rotation }
}
