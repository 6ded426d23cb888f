//! Cases without branches: a formula with cases chooses lane by lane, so that it gives the same bits at every width.

use super::Real;

/// A [`Real`] that can choose between two values lane by lane.
pub trait Select: Real {
    /// Set of lanes in which a statement holds.
    type Mask: Copy;

    /// Mask of the lanes with `self < other`; false where either is NaN.
    fn is_less(self, other: Self) -> Self::Mask;

    /// `self` where the mask holds, `otherwise` elsewhere.
    fn select(self, mask: Self::Mask, otherwise: Self) -> Self;

    /// True if the mask holds in any lane (the value of `self` does not matter, here and in the next three).
    fn any(self, mask: Self::Mask) -> bool;

    /// Lanes in which both hold.
    fn both(self, a: Self::Mask, b: Self::Mask) -> Self::Mask;

    /// Lanes in which at least one of them holds.
    fn either(self, a: Self::Mask, b: Self::Mask) -> Self::Mask;

    /// Lanes in which the first holds without the second.
    fn without(self, a: Self::Mask, b: Self::Mask) -> Self::Mask;

    /// Mask of all lanes, or of none.
    #[inline(always)]
    fn everywhere(self, holds: bool) -> Self::Mask {
        self.constant(if holds { 0.0 } else { 1.0 }).is_less(self.constant(0.5))
    }

    /// The number, or that of the first lane.
    fn first(self) -> f64;

    /// Absolute value.
    fn abs(self) -> Self;

    /// The smaller of both; `other` where either is NaN.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.select(self.is_less(other), other)
    }

    /// The larger of both; `other` where either is NaN.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.select(other.is_less(self), other)
    }
}

impl Select for f64 {
    type Mask = bool;

    #[inline]
    fn is_less(self, other: Self) -> bool {
        self < other
    }

    #[inline]
    fn select(self, mask: bool, otherwise: Self) -> Self {
        if mask { self } else { otherwise }
    }

    #[inline]
    fn any(self, mask: bool) -> bool {
        mask
    }

    #[inline]
    fn both(self, a: bool, b: bool) -> bool {
        a && b
    }

    #[inline]
    fn either(self, a: bool, b: bool) -> bool {
        a || b
    }

    #[inline]
    fn without(self, a: bool, b: bool) -> bool {
        a && !b
    }

    #[inline]
    fn first(self) -> f64 {
        self
    }

    #[inline]
    fn abs(self) -> Self {
        self.abs()
    }
}
