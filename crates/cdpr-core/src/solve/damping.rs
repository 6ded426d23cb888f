//! Growth and decay of damping, in units of the diagonal to which it is added.

use crate::scalar::Select;

/// Damping after an undamped step that did not help: it changes a step by a thousandth, so that raising it tenfold,
/// trial by trial, needs few trials until steps are half as long.
const AFTER_FAILURE: f64 = 1e-3;
/// Damping of singular equations: far above rounding (1e-16), too small to slow the directions that are determined.
pub const OF_SINGULAR: f64 = 1e-9;
/// Factor between one damping and the next, up after failure and down after success.
const FACTOR: f64 = 10.0;
/// Damping below which a step is Newton's to nine digits; it is then set to 0, which makes the step exact.
const NONE_BELOW: f64 = 1e-9;
/// Damping above which a step is smaller than rounding.
const MOST: f64 = 1e12;

/// Damping after a step that helped.
#[inline(always)]
pub(super) fn lowered<N: Select>(damping: N) -> N {
    (damping * damping.constant(1.0 / FACTOR)).select(none_below(damping), damping.constant(0.0))
}

#[inline(always)]
fn none_below<N: Select>(damping: N) -> N::Mask {
    damping.without(damping.everywhere(true), damping.is_less(damping.constant(NONE_BELOW)))
}

/// Damping after a step that did not help.
#[inline(always)]
pub(super) fn raised<N: Select>(damping: N) -> N {
    (damping * damping.constant(FACTOR)).max(damping.constant(AFTER_FAILURE))
}

/// Damping after equations without a solution.
#[inline(always)]
pub(super) fn regularised<N: Select>(damping: N) -> N {
    (damping * damping.constant(FACTOR)).max(damping.constant(OF_SINGULAR))
}

/// Lanes in which damping slows directions that the equations determine.
#[inline(always)]
pub(super) fn is_felt<N: Select>(damping: N) -> N::Mask {
    damping.constant(OF_SINGULAR).is_less(damping)
}

/// Lanes in which more damping cannot help.
#[inline(always)]
pub(super) fn is_exhausted<N: Select>(damping: N) -> N::Mask {
    damping.constant(MOST).is_less(damping)
}
