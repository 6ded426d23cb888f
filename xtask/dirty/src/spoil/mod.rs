//! Functions that spoil a scene, one for each kind of dirt.

pub(crate) mod frames;
pub(crate) mod lengths;
pub(crate) mod rows;
pub(crate) mod setups;
pub(crate) mod units;
