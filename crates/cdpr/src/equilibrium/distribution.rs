//! Tensions that balance a load within limits, for cables of any effects.
//!
//! The pull of a straight cable is its tension times a direction that the pose alone determines: one quadratic programme
//! answers. The directions of sagging cables follow their tensions, so the exact programme is solved again and again for
//! the wrench linearized at the last tensions, W(f) ≈ W(f_k) + ∂W/∂f (f − f_k), until they no longer change. Where that ends,
//! the tensions balance the load exactly.

use nalgebra::DMatrix;
use thiserror::Error;

use crate::cable::law::HoldError;
use crate::geometry::Pose;
use crate::model::Model;
use crate::statics::{Load, StaticsError, held};
use crate::tension::{InputError, Limits, quadratic};

/// Programmes solved before giving up.
const MAX_ITERATIONS: u32 = 50;
/// Tensions that change by less than this share of the largest limit are settled: Newton has doubled its digits before, and the
/// shapes of taut cables that do not stretch are known no better.
const SETTLED: f64 = 1e-10;

/// Tensions, or why there are none.
#[must_use = "check `reason` before using the tensions"]
#[derive(Clone, Debug, PartialEq)]
pub struct Distribution {
    /// Tension per cable where the robot measures it (N); within the limits unless there is a reason.
    pub tensions: Vec<f64>,
    /// Why these are no tensions for the load.
    pub reason: Option<Reason>,
    /// Programmes solved.
    pub iterations: u32,
}

/// Why no tensions were found.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// Limits and load exclude each other, in words.
    Infeasible(String),
    /// The fixed point was not reached, in words.
    NotConverged(String),
}

impl Reason {
    /// The words.
    pub fn words(&self) -> &str {
        match self {
            Self::Infeasible(words) | Self::NotConverged(words) => words,
        }
    }
}

/// Input for which the question has no meaning.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DistributionError {
    /// A cable without a course at the pose.
    #[error(transparent)]
    Statics(#[from] StaticsError),
    /// Limits that do not fit the model.
    #[error(transparent)]
    Tension(#[from] InputError),
}

/// A solver for many poses of one model.
#[derive(Clone, Debug)]
pub struct Solver<'a> {
    model: &'a Model,
    load: Load,
    limits: Limits,
    programme: quadratic::Solver,
}

impl<'a> Solver<'a> {
    /// A solver for this model, load and limits.
    pub fn new(model: &'a Model, load: &Load, limits: &Limits) -> Self {
        let programme = quadratic::Solver::new(model.cable_count(), model.dof());
        Self { model, load: *load, limits: limits.clone(), programme }
    }

    /// The tensions nearest to the middle of the limits that keep them and balance the load at a pose.
    pub fn solve(&mut self, pose: &Pose) -> Result<Distribution, DistributionError> {
        let structure_matrix = self.model.structure_matrix(pose).map_err(StaticsError::from)?;
        let wrench = self.load.in_pattern(self.model, pose);
        let first = self.programme(&structure_matrix, wrench.as_slice())?;
        if first.reason.is_some() || !self.model.composition().is_sagging() {
            return Ok(first);
        }
        self.iterate(pose, wrench.as_slice(), first.tensions)
    }

    fn programme(&mut self, matrix: &DMatrix<f64>, wrench: &[f64]) -> Result<Distribution, DistributionError> {
        // a pose is answered to the same bits whatever was asked before
        self.programme.forget();
        let found = self.programme.solve(matrix, wrench, &self.limits, None)?;
        let reason = found.reason().map(Reason::Infeasible);
        Ok(Distribution { tensions: found.tensions.clone(), reason, iterations: 1 })
    }

    fn iterate(
        &mut self,
        pose: &Pose,
        wrench: &[f64],
        mut tensions: Vec<f64>,
    ) -> Result<Distribution, DistributionError> {
        let largest = self.limits.maximum().iter().fold(0.0_f64, |a, b| a.max(*b));
        let mut change = f64::INFINITY;
        for iteration in 1..=MAX_ITERATIONS {
            let (matrix, rest) = match self.linearized(pose, wrench, &tensions) {
                Ok(linearized) => linearized,
                Err(StaticsError::Hold { cable, reason: reason @ HoldError::TensionTooLow { .. } }) => {
                    let reason = Reason::Infeasible(format!("cable {cable}: {reason}"));
                    return Ok(Distribution { tensions, reason: Some(reason), iterations: iteration });
                }
                Err(error) => return Err(error.into()),
            };
            let found = self.programme(&matrix, &rest)?;
            if found.reason.is_some() {
                return Ok(Distribution { iterations: iteration, ..found });
            }
            change = found.tensions.iter().zip(&tensions).fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()));
            tensions = found.tensions;
            if change <= SETTLED * largest {
                return Ok(Distribution { tensions, reason: None, iterations: iteration });
            }
        }
        let words = format!(
            "the directions of the sagging cables and their tensions do not settle: after {MAX_ITERATIONS} programmes the \
             tensions still change by {change:.3e} N"
        );
        Ok(Distribution { tensions, reason: Some(Reason::NotConverged(words)), iterations: MAX_ITERATIONS })
    }

    /// ∂W/∂f in the pattern's rows, and load plus W(f) − ∂W/∂f f.
    fn linearized(
        &self,
        pose: &Pose,
        wrench: &[f64],
        tensions: &[f64],
    ) -> Result<(DMatrix<f64>, Vec<f64>), StaticsError> {
        let basis = self.model.twist_basis();
        let mut matrix = DMatrix::zeros(basis.len(), tensions.len());
        let mut rest = wrench.to_vec();
        for (cable, &tension) in tensions.iter().enumerate() {
            let held = held(self.model, pose, cable, tension)?;
            let (whole, by_tension) = (held.wrench(), held.wrench_by_tension());
            for (row, twist) in basis.iter().enumerate() {
                let slope = twist.dot(&by_tension);
                matrix[(row, cable)] = slope;
                rest[row] += twist.dot(&whole) - slope * tension;
            }
        }
        Ok((matrix, rest))
    }
}

/// One distribution; see [`Solver`] for many.
pub fn solve(model: &Model, pose: &Pose, load: &Load, limits: &Limits) -> Result<Distribution, DistributionError> {
    Solver::new(model, load, limits).solve(pose)
}
