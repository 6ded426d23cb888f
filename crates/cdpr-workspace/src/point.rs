//! Positions along the axes of a robot.

/// Coordinates of a position along the translations of the robot (m): x, y, z, or the two of its plane and 0.
pub type Point = [f64; 3];
