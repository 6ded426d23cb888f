//! Bodies that a cable could touch: obstacles in the world, and the body of the platform.

use nalgebra::Vector3;

/// Body in the world that cables must not touch.
#[derive(Clone, Debug, PartialEq)]
pub struct Obstacle {
    /// Name of the obstacle.
    pub name: String,
    /// Shape and position (world, m).
    pub shape: ObstacleShape,
}

/// The shape of an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObstacleShape {
    /// A box along the world's axes; for a planar robot its extent along the normal has no effect.
    Box {
        /// Lower corner (world, m).
        min: Vector3<f64>,
        /// Upper corner (world, m).
        max: Vector3<f64>,
    },
    /// A round bar, such as a strut of the frame.
    Strut {
        /// One end (world, m).
        from: Vector3<f64>,
        /// The other end (world, m).
        to: Vector3<f64>,
        /// Half its diameter (m).
        radius: f64,
    },
}
