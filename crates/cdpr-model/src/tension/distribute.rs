//! Interface of a method of tension distribution: its search, its memory, its derivative.
//!
//! A problem goes through three stages ([`super::Solver`]): the method's own search; where that finds nothing, the exact verdict of the
//! quadratic programme; then, where the method chooses among allowed tensions or has an answer without any, its refinement.

use std::fmt;

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::{InputError, Limits, Options, quadratic};

/// Tensions this near to a limit, relative to the largest limit, are on it.
pub(super) const ON_LIMIT: f64 = 1e-9;

/// Whether tensions balance the load within the limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Status {
    /// The tensions balance the load and keep their limits.
    Feasible,
    /// No tensions do: proved, see [`super::Answer::certificate`] and [`super::Answer::reason`].
    Infeasible,
    /// Some tensions do, but the method, which is no exact search, did not find them.
    NotFound,
    /// Rounding or overflow kept the search from a verdict: matrices with entries at the ends of their range.
    Undecided,
}

/// Origin of a reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cause {
    /// The certificate, or nothing.
    Certificate,
    /// A cable (from 0) whose previous tension (N) is so far beyond its limits that one step does not reach them.
    OutOfReach { cable: usize, previous: f64, reach: f64, least: f64, largest: f64 },
    /// Allowed tensions of so many dimensions that the faces of their set cannot be added up.
    TooManyFaces { dimension: usize },
}

/// The balance that is asked for: Aᵀ f + w = 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Problem<'a> {
    pub(super) structure_matrix: &'a DMatrix<f64>,
    pub(super) wrench: &'a [f64],
}

/// Question to a method.
#[derive(Clone, Copy, Debug)]
pub(super) struct Task<'a> {
    pub(super) problem: Problem<'a>,
    pub(super) options: &'a Options<'a>,
    /// Tensions to stay near to, one per cable (N).
    pub(super) reference: &'a [f64],
}

/// Answer of a method, to be written.
#[derive(Debug)]
pub(super) struct FoundTensions<'a> {
    /// The limits in force.
    pub(super) limits: &'a Limits,
    pub(super) tensions: &'a mut [f64],
    pub(super) status: &'a mut Status,
    pub(super) cause: &'a mut Cause,
    pub(super) iterations: &'a mut u32,
}

impl FoundTensions<'_> {
    /// Steps of a search, or `None` of one that did not settle.
    pub(super) fn settle(&mut self, steps: Option<u32>) {
        match steps {
            Some(steps) => *self.iterations = steps,
            None => *self.status = Status::NotFound,
        }
    }
}

/// A method with its memory from one problem to the next. No stage claims memory, but where a closed form meets lost rank.
pub(super) trait Distribute: CloneBoxed + fmt::Debug + Send + Sync {
    /// Forgets the last problem.
    fn forget(&mut self) {}

    /// Searches before the exact verdict is asked for; true if it found tensions within balance and limits, so that none is needed.
    fn search(&mut self, _task: &Task<'_>, _found: &mut FoundTensions<'_>) -> Result<bool, InputError> {
        Ok(false)
    }

    /// Chooses after the exact verdict, which `found` has as its status; of an exact method it has the tensions of the programme, too.
    fn refine(
        &mut self,
        _task: &Task<'_>,
        _qp: &mut quadratic::Solver,
        _found: &mut FoundTensions<'_>,
    ) -> Result<(), InputError> {
        Ok(())
    }

    /// Derivative of chosen tensions in closed form; `None` of a method without, which is differentiated by differences.
    fn derivative(&self, _chosen: &Chosen<'_>) -> Written {
        Ok(None)
    }
}

/// A copy of a method whose type is not known.
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

/// Tensions that a method has chosen, the reference in the middle of the limits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chosen<'a> {
    pub(super) problem: Problem<'a>,
    pub(super) limits: &'a Limits,
    pub(super) tensions: &'a [f64],
}

impl Chosen<'_> {
    /// Cables that are on no limit: further from both than a fraction of the largest limit.
    pub(super) fn between_limits(&self, fraction: f64) -> Vec<usize> {
        between(self.limits, self.tensions, fraction)
    }
}

/// Cables that are on no limit.
pub(super) fn between(limits: &Limits, tensions: &[f64], fraction: f64) -> Vec<usize> {
    let largest = limits.minimum().iter().chain(limits.maximum()).fold(0.0, |most: f64, limit| most.max(limit.abs()));
    let is_free = |cable: &usize| {
        let to = |limit: &[f64]| (tensions[*cable] - limit[*cable]).abs();
        to(limits.minimum()).min(to(limits.maximum())) > fraction * largest
    };
    (0..tensions.len()).filter(is_free).collect()
}

/// Derivative of a method's answer.
pub(super) trait Derivative: fmt::Debug + Send + Sync {
    /// Change of all tensions (N) when the column of one cable in the structure matrix and the wrench change so (rows of the matrix).
    fn change(&self, cable: usize, column: &[f64], wrench: &[f64]) -> DVector<f64>;

    /// Change of all tensions (N) per newton of one cable's reference; zero for a method that is near to none.
    fn change_by_reference(&self, cable: usize) -> DVector<f64>;
}

/// A derivative in closed form, where the method has one.
pub(super) type Written = Result<Option<Box<dyn Derivative>>, NoDerivative>;

/// Tensions that no derivative leads away from.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum NoDerivative {
    /// The cables between their limits cannot balance a small change.
    Pinned,
    /// The allowed tensions leave the method nothing to choose.
    Thin,
    /// A problem that the method refuses.
    Input(InputError),
}

impl From<InputError> for NoDerivative {
    fn from(error: InputError) -> Self {
        Self::Input(error)
    }
}
