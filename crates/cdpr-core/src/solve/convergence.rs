//! The convergence test of all searches.

use crate::scalar::Select;

/// Fraction of the tolerance below which a step is the last, at any contraction of the steps before it.
const NEGLIGIBLE: f64 = 1e-3;

/// Total length of the steps that follow one of this size if they go on shrinking at this rate.
#[inline(always)]
pub(super) fn left<N: Select>(size: N, contraction: N) -> N {
    size * contraction / (size.constant(1.0) - contraction)
}

/// Lanes in which this step is the last: the remaining ones, if they go on shrinking at this rate, add up to less than
/// the tolerance.
///
/// Σ size·contractionᵏ (k ≥ 1) = size·contraction/(1 − contraction); a rate above a half is no sign of convergence. The
/// test reads the step, not the residual, since the residual stays large for lengths that contradict each other.
#[inline(always)]
pub(super) fn settles<N: Select>(size: N, contraction: N, tolerance: N) -> N::Mask {
    let shrinks = contraction.is_less(size.constant(0.5));
    let remaining = (tolerance * (size.constant(1.0) - contraction)).is_less(size * contraction);
    let is_negligible = size.is_less(size.constant(NEGLIGIBLE) * tolerance);
    size.either(size.without(shrinks, remaining), is_negligible)
}
