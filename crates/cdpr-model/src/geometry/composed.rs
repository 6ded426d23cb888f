//! Products and inverses of poses.

use super::Pose;

/// The pose `second`, given in the frame at `first`, as a pose in the world.
pub fn product(first: &Pose, second: &Pose) -> Pose {
    Pose { position: first.transform(&second.position), rotation: first.rotation * second.rotation }
}

/// The pose of the world in the frame at a pose.
pub fn inverse(pose: &Pose) -> Pose {
    let rotation = pose.rotation.inverse();
    Pose { position: -(rotation * pose.position), rotation }
}
