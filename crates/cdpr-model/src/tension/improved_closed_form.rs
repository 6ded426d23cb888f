//! The improved closed form (Pott 2014): the cable that misses its limit most is put on it, and the others are balanced
//! anew.
//!
//! Start: the closed form (eq. 3.41), the point f of f + H λ nearest to the reference. While a cable misses a limit,
//! the one that misses it by most newtons is fixed at that limit, its pull counts as load, and the closed form of the
//! others follows: the nearest point of the remaining solutions. Each turn uses up one degree of redundancy.
//!
//! **Where it fails.** No cable is ever released. With a redundancy of 2 or more a fixed cable may have to leave its
//! limit again, and even with a redundancy of 1 the cable that misses by most newtons is not always the one to fix: the
//! method then ends without tensions though there are some. **Continuity:** continuous as long as the order of fixing
//! does not change; it may jump when it does. **Warm start:** none, every result depends on its own problem alone.

use super::affine::Affine;
use super::distribute::{Chosen, Distribute, FoundTensions, ON_LIMIT, Problem, Task, Written};
use super::{InputError, Limits, nearest};

/// Memory for the solutions of the balance.
#[derive(Clone, Debug)]
pub(super) struct ImprovedClosedForm {
    balanced: Affine,
}

impl ImprovedClosedForm {
    pub(super) fn new(cable_count: usize, dof: usize) -> Self {
        Self { balanced: Affine::new(cable_count, dof) }
    }
}

impl Distribute for ImprovedClosedForm {
    fn search(&mut self, task: &Task<'_>, found: &mut FoundTensions<'_>) -> Result<bool, InputError> {
        let Problem { structure_matrix, wrench } = task.problem;
        Ok(self.balanced.load(structure_matrix, wrench)?
            && search(&mut self.balanced, found.limits, task.reference, found.tensions))
    }

    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        nearest::derivative(chosen, ON_LIMIT)
    }
}

/// Writes the tensions; true if they keep the limits. `balanced` holds the solutions of the balance and is used up.
pub(super) fn search(balanced: &mut Affine, limits: &Limits, reference: &[f64], tensions: &mut [f64]) -> bool {
    balanced.nearest(reference, tensions);
    while let Some((cable, limit)) = limits.most_missed(tensions) {
        if !balanced.fix(cable, limit, tensions) {
            return false;
        }
    }
    true
}
