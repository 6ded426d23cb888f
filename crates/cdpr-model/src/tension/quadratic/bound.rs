//! Active limits of a search, and the ways in which it ends.

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

    /// Amount by which a tension misses the limit (N); below zero if it keeps it.
    #[inline]
    pub(super) fn missed(self, tension: f64, limits: &Limits) -> f64 {
        self.sign * (self.limit(limits) - tension)
    }
}

/// Outcome of the search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum BoundEnd {
    /// The optimum was found.
    Optimum,
    /// This limit contradicts the active ones, with the combination in `weights`.
    Contradiction(Bound),
    /// So many or so large steps that rounding or overflow must be the reason.
    TooLong,
}
