//! Where a cable leaves the frame: a fixed point, or a pulley that swivels towards the platform.

pub mod point;
pub mod pulley;
