//! Eight numbers side by side in memory.

use super::LANES;

/// Eight numbers on a cache line of their own: no load or store straddles two.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub struct Line(pub [f64; LANES]);
