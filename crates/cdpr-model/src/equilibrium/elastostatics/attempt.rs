//! Result of the search from one start.

use super::descent::{EquilibriumEnd, Stop};
use super::problem::Problem;
use crate::statics::Stability;

/// Result of the search from one start.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attempt {
    pub(super) end: EquilibriumEnd,
    /// Smallest eigenvalue of the stiffness (N/m).
    pub(super) stability: f64,
    /// Largest excess of a rigid cable over its controlled length (m).
    pub(super) excess: f64,
    /// Residual wrench that counts as balance (N).
    pub(super) undecided: f64,
    /// True if the bars are in balance, one of them pushes, and only taut cables are sought.
    pub(super) pushes: bool,
}

impl Attempt {
    /// True for a stable equilibrium.
    pub(super) fn is_good(&self, problem: &Problem<'_>) -> bool {
        self.is_equilibrium(problem)
            && Stability::of(self.stability, problem.indifferent_stiffness()) == Stability::Stable
    }

    /// True if forces balance and rigid cables have their lengths.
    pub(super) fn is_equilibrium(&self, problem: &Problem<'_>) -> bool {
        self.end.stop == Stop::Stationary
            && !self.pushes
            && self.excess <= problem.settings.length_tolerance
            && problem.wrench_size(&self.end.residual) <= self.undecided
    }

    /// True if this attempt is better: equilibria before others, then by stability or by the residual.
    pub(super) fn is_better(&self, other: &Self, problem: &Problem<'_>) -> bool {
        match (self.is_equilibrium(problem), other.is_equilibrium(problem)) {
            (true, true) => self.stability > other.stability,
            (true, false) => true,
            (false, true) => false,
            (false, false) => {
                let left = |attempt: &Self| (attempt.excess, problem.wrench_size(&attempt.end.residual));
                left(self) < left(other) || left(other).1.is_nan()
            }
        }
    }
}
