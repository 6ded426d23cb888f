//! Growth and decay of damping, in units of the diagonal that it is added to.

use crate::scalar::Select;

/// Damping after a plain step that did not help: as much as changes a step by a thousandth, so that ten times more, tried
/// next, costs few trials until steps are shorter by half.
const AFTER_FAILURE: f64 = 1e-3;
/// Damping of equations without a solution: far above rounding (1e-16), too small to slow the directions that are determined.
pub const OF_SINGULAR: f64 = 1e-9;
/// Factor from one damping to the next, after failure upwards and after success downwards.
const FACTOR: f64 = 10.0;
/// Below this a step is Newton's to nine digits: no damping at all makes it exact.
const NONE_BELOW: f64 = 1e-9;
/// Above this a step moves less than rounding does.
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

/// Damping where the equations have no solution.
#[inline(always)]
pub(super) fn regularised<N: Select>(damping: N) -> N {
    (damping * damping.constant(FACTOR)).max(damping.constant(OF_SINGULAR))
}

/// Lanes in which damping slows directions that the equations determine.
#[inline(always)]
pub(super) fn is_felt<N: Select>(damping: N) -> N::Mask {
    damping.constant(OF_SINGULAR).is_less(damping)
}

/// Lanes in which more damping is no use.
#[inline(always)]
pub(super) fn is_exhausted<N: Select>(damping: N) -> N::Mask {
    damping.constant(MOST).is_less(damping)
}
