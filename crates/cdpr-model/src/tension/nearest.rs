//! The nearest tensions to a reference within balance and limits: the answer of the quadratic programme itself (`quadratic`).
//!
//! **Continuity:** the tensions follow load, matrix and limits continuously, with kinks where a cable comes to a limit or leaves it.
//! **Warm start:** the active limits of the last programme; the answer changes by rounding only.

use super::distribute::{Chosen, Distribute, ON_LIMIT, Written};
use super::response::optimum;

/// Every stage of it is the exact verdict.
#[derive(Clone, Debug)]
pub(super) struct Nearest;

impl Distribute for Nearest {
    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        derivative(chosen, ON_LIMIT)
    }
}

/// Derivative of the nearest tensions to the middle of the limits; cables nearer to a limit than a fraction of the largest stay on it.
pub(super) fn derivative(chosen: &Chosen<'_>, on_limit: f64) -> Written {
    optimum::nearest(chosen, chosen.between_limits(on_limit), &|cable| chosen.limits.middle(cable))
}
