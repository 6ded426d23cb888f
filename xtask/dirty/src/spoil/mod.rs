//! What spoils a scene: a function for each kind, by what it touches.

pub(crate) mod frames;
pub(crate) mod lengths;
pub(crate) mod rows;
pub(crate) mod setups;
pub(crate) mod units;
