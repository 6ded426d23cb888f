//! Limits that a search holds, and how it ends.

use crate::tension::Limits;

/// A limit: the least tension (`sign` 1) or the largest (`sign` −1) of a cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bound {
    pub(super) cable: usize,
    pub(super) sign: f64,
}

impl Bound {
    #[inline]
    pub(super) fn limit(self, limits: &Limits) -> f64 {
        if self.sign > 0.0 { limits.minimum()[self.cable] } else { limits.maximum()[self.cable] }
    }

    /// By how much a tension breaks the limit; below zero where it keeps it (N).
    #[inline]
    pub(super) fn missed(self, tension: f64, limits: &Limits) -> f64 {
        self.sign * (self.limit(limits) - tension)
    }
}

/// How the search ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum BoundEnd {
    /// The optimum.
    Optimum,
    /// This limit contradicts active ones; the weights of the latter are in `weights`.
    Contradiction(Bound),
    /// So many steps, or so large ones, that rounding or overflow must be at work.
    TooLong,
}
