//! Dykstra's alternating projections on the balanced tensions and on the limits (Boyle and Dykstra 1986).
//!
//! x ← P_balance(y), y ← P_limits(x + q), q ← x + q − y: with the correction q the points tend to the balanced tensions
//! within limits that are nearest to the reference, the optimum of the quadratic programme (without q, to some allowed
//! tensions). The projection on the balance is p + H Hᵀ y, the one on the limits clamps each tension.
//!
//! **Stop rule:** no tension of x misses its limits, and none differs from y, by more than 1e-9 of the largest limit;
//! or 10 000 rounds. If the allowed tensions are a thin set, there are rounds in which the tensions hardly change, so
//! that "no change" is no stop rule. **Where it fails:** the rounds needed grow without bound as the angle between
//! balance and limits closes, at the boundary of the feasible loads; the status is then `NotFound`. **Continuity:**
//! that of the optimum, to the stop rule. **Warm start:** none: another start would tend to another point.

use super::affine::Affine;
use super::distribute::{Chosen, Distribute, FoundTensions, Problem, Status, Task, Written};
use super::{InputError, Limits, nearest, quadratic};

/// Rounds before giving up.
const MAX_ROUNDS: u32 = 10_000;

/// Rounds before the quadratic programme decides whether there are allowed tensions.
const FIRST_ROUNDS: u32 = 200;

/// Distance from a limit, relative to the largest limit, below which a tension counts as on it: ten times that of other
/// methods.
pub(super) const ON_LIMIT: f64 = 1e-8;

/// The method: balanced tensions and the search on them.
#[derive(Clone, Debug)]
pub(super) struct Projections {
    balanced: Affine,
    search: Search,
}

impl Projections {
    pub(super) fn new(cable_count: usize, dof: usize) -> Self {
        Self { balanced: Affine::new(cable_count, dof), search: Search::new(cable_count) }
    }
}

impl Distribute for Projections {
    fn search(&mut self, task: &Task<'_>, found: &mut FoundTensions<'_>) -> Result<bool, InputError> {
        let Self { balanced, search } = self;
        let Problem { structure_matrix, wrench } = task.problem;
        if !balanced.load(structure_matrix, wrench)? {
            return Ok(false);
        }
        search.begin(balanced, task.reference, found.tensions);
        let is_found = search.run(FIRST_ROUNDS, balanced, found.limits, found.tensions);
        *found.iterations = search.rounds;
        Ok(is_found)
    }

    fn refine(
        &mut self,
        _task: &Task<'_>,
        _qp: &mut quadratic::Solver,
        found: &mut FoundTensions<'_>,
    ) -> Result<(), InputError> {
        if *found.status == Status::NotFound {
            let rounds = MAX_ROUNDS - FIRST_ROUNDS;
            let is_found = self.search.run(rounds, &self.balanced, found.limits, found.tensions);
            *found.status = if is_found { Status::Feasible } else { Status::NotFound };
            *found.iterations = self.search.rounds;
        }
        Ok(())
    }

    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        nearest::derivative(chosen, ON_LIMIT)
    }
}

/// State of the search: y (`cut`), q (`correction`) and the rounds so far; x are the tensions of the caller.
#[derive(Clone, Debug)]
struct Search {
    cut: Vec<f64>,
    correction: Vec<f64>,
    rounds: u32,
}

impl Search {
    fn new(cable_count: usize) -> Self {
        Self { cut: vec![0.0; cable_count], correction: vec![0.0; cable_count], rounds: 0 }
    }

    /// Starts at the balanced tensions nearest to the reference.
    fn begin(&mut self, balanced: &Affine, reference: &[f64], tensions: &mut [f64]) {
        balanced.nearest(reference, tensions);
        self.correction.fill(0.0);
        self.rounds = 0;
    }

    /// Runs up to this many further rounds; true once the tensions keep the limits.
    fn run(&mut self, rounds: u32, balanced: &Affine, limits: &Limits, tensions: &mut [f64]) -> bool {
        // ten times the rounding of limits
        let tolerance = 10.0 * limits.tolerance();
        for _ in 0..rounds {
            self.rounds += 1;
            let mut apart = 0.0_f64;
            for (cable, x) in tensions.iter().enumerate() {
                let wanted = x + self.correction[cable];
                self.cut[cable] = wanted.clamp(limits.minimum()[cable], limits.maximum()[cable]);
                self.correction[cable] = wanted - self.cut[cable];
                apart = apart.max((x - self.cut[cable]).abs());
            }
            if apart <= tolerance {
                return true;
            }
            balanced.nearest(&self.cut, tensions);
        }
        false
    }
}
