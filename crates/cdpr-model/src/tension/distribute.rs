//! Interface of a method of tension distribution: its search, its memory, its derivative.
//!
//! A problem goes through three stages ([`super::Solver`]): the method's own search; if that finds no tensions, the
//! exact verdict of the quadratic programme; then, if the method chooses among allowed tensions or gives tensions for
//! an infeasible problem, its refinement.

use std::fmt;

use super::{InputError, Limits, Options, quadratic};
use nalgebra::{DMatrix, DVector};

/// Tensions this near to a limit, relative to the largest limit, are on it.
pub(super) const ON_LIMIT: f64 = 1e-9;

/// Whether tensions balance the load within the limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// The tensions balance the load and keep their limits.
    Feasible,
    /// No tensions do: proved, see [`super::Answer::certificate`] and [`super::Answer::reason`].
    Infeasible,
    /// Some tensions do, but the method, which is no exact search, did not find them.
    NotFound,
    /// Rounding or overflow prevented a verdict: matrices with entries at the ends of their range.
    Undecided,
}

/// Reason that tensions are not feasible.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cause {
    /// The certificate if infeasible; no particular reason otherwise.
    Certificate,
    /// A cable (from 0) whose previous tension (N) is so far beyond its limits that one step does not reach them.
    OutOfReach { cable: usize, previous: f64, reach: f64, least: f64, largest: f64 },
    /// Allowed tensions whose set has this many dimensions, and more faces than can be added up.
    TooManyFaces { dimension: usize },
}

/// The balance to be kept: Aᵀ f + w = 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Problem<'a> {
    pub(super) structure_matrix: &'a DMatrix<f64>,
    pub(super) wrench: &'a [f64],
}

/// One problem, as a method sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Task<'a> {
    pub(super) problem: Problem<'a>,
    pub(super) options: &'a Options<'a>,
    /// Tensions to stay near to, one per cable (N).
    pub(super) reference: &'a [f64],
}

/// Mutable parts of the answer that a method writes.
#[derive(Debug)]
pub(super) struct FoundTensions<'a> {
    /// The given limits, narrowed by the rates.
    pub(super) limits: &'a Limits,
    pub(super) tensions: &'a mut [f64],
    pub(super) status: &'a mut Status,
    pub(super) cause: &'a mut Cause,
    pub(super) iterations: &'a mut u32,
}

impl FoundTensions<'_> {
    /// Stores the steps of a search; `None` marks the answer as not found.
    pub(super) fn settle(&mut self, steps: Option<u32>) {
        match steps {
            Some(steps) => *self.iterations = steps,
            None => *self.status = Status::NotFound,
        }
    }
}

/// A method with its memory from one problem to the next. Its functions claim no memory, except where a closed form
/// meets lost rank.
pub(super) trait Distribute: CloneBoxed + fmt::Debug + Send + Sync {
    /// Forgets the last problem.
    fn forget(&mut self) {}

    /// Searches before the exact programme runs; returns true if it found tensions within balance and limits, so that
    /// the programme is not needed.
    fn search(&mut self, _task: &Task<'_>, _found: &mut FoundTensions<'_>) -> Result<bool, InputError> {
        Ok(false)
    }

    /// Chooses tensions after the exact programme: `found` has its status and, for an exact method, its tensions.
    fn refine(
        &mut self,
        _task: &Task<'_>,
        _qp: &mut quadratic::Solver,
        _found: &mut FoundTensions<'_>,
    ) -> Result<(), InputError> {
        Ok(())
    }

    /// Derivative of chosen tensions in closed form; `None` if the method has none, which is then differentiated by
    /// central differences.
    fn derivative(&self, _chosen: &Chosen<'_>) -> Written {
        Ok(None)
    }
}

/// Copies a method as a trait object.
pub(super) trait CloneBoxed {
    fn clone_boxed(&self) -> Box<dyn Distribute>;
}

impl<T: Distribute + Clone + 'static> CloneBoxed for T {
    fn clone_boxed(&self) -> Box<dyn Distribute> {
        Box::new(self.clone())
    }
}

impl Clone for Box<dyn Distribute> {
    fn clone(&self) -> Self {
        (**self).clone_boxed()
    }
}

/// Tensions that a method has chosen, with the reference in the middle of the limits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chosen<'a> {
    pub(super) problem: Problem<'a>,
    pub(super) limits: &'a Limits,
    pub(super) tensions: &'a [f64],
}

impl Chosen<'_> {
    /// Cables on no limit: further from both than a fraction of the largest limit by amount.
    pub(super) fn between_limits(&self, fraction: f64) -> Vec<usize> {
        between(self.limits, self.tensions, fraction)
    }
}

/// Cables further from both limits than a fraction of the largest limit by amount.
pub(super) fn between(limits: &Limits, tensions: &[f64], fraction: f64) -> Vec<usize> {
    let largest = limits.minimum().iter().chain(limits.maximum()).fold(0.0, |most: f64, limit| most.max(limit.abs()));
    let is_free = |cable: &usize| {
        let to = |limit: &[f64]| (tensions[*cable] - limit[*cable]).abs();
        to(limits.minimum()).min(to(limits.maximum())) > fraction * largest
    };
    (0..tensions.len()).filter(is_free).collect()
}

/// Derivative of the chosen tensions.
pub(super) trait Derivative: fmt::Debug + Send + Sync {
    /// Change of all tensions (N) when one cable's column of the structure matrix and the wrench change by these
    /// amounts (one entry per row of the matrix).
    fn change(&self, cable: usize, column: &[f64], wrench: &[f64]) -> DVector<f64>;

    /// Change of all tensions (N) per newton of one cable's reference; zero for a method without a reference.
    fn change_by_reference(&self, cable: usize) -> DVector<f64>;
}

/// A derivative in closed form; `None` if the method has none.
pub(super) type Written = Result<Option<Box<dyn Derivative>>, NoDerivative>;

/// Reason that the chosen tensions have no derivative.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum NoDerivative {
    /// The cables between their limits cannot balance a small change.
    Pinned,
    /// The set of allowed tensions is too thin for a derivative.
    Thin,
    /// The method refuses the problem.
    Input(InputError),
}

impl From<InputError> for NoDerivative {
    fn from(error: InputError) -> Self {
        Self::Input(error)
    }
}
