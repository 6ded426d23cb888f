//! Where a cable leaves the frame.

pub mod bent;
pub mod point;
pub mod pulley;
