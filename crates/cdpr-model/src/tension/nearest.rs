//! The nearest tensions to a reference within balance and limits: the optimum of the quadratic programme (`quadratic`).
//!
//! **Continuity:** the tensions follow load, matrix and limits continuously, with kinks at which a cable comes to a
//! limit or leaves it.
//! **Warm start:** the active limits of the last programme; the answer changes by rounding only.

use super::distribute::{Chosen, Distribute, ON_LIMIT, Written};
use super::response::optimum;

/// The method has no stage of its own: the solver's quadratic programme is its answer.
#[derive(Clone, Debug)]
pub(super) struct Nearest;

impl Distribute for Nearest {
    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        derivative(chosen, ON_LIMIT)
    }
}

/// Derivative of the nearest tensions to the middle of the limits; cables nearer to a limit than this fraction of the
/// largest limit stay on it.
pub(super) fn derivative(chosen: &Chosen<'_>, on_limit: f64) -> Written {
    optimum::nearest(chosen, chosen.between_limits(on_limit), &|cable| chosen.limits.middle(cable))
}
