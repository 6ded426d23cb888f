//! Tensions that balance a load within limits, for cables of any effects.
//!
//! The pull of a straight cable is its tension times a direction that the pose alone determines: one quadratic
//! programme is enough. The directions of sagging cables depend on their tensions, so that the exact programme is
//! solved repeatedly for the wrench linearized at the last tensions, W(f) ≈ W(f_k) + ∂W/∂f (f − f_k), until they no
//! longer change. Then the tensions balance the load exactly.

mod batch;

use std::fmt;

use nalgebra::DMatrix;
use thiserror::Error;

pub use self::batch::{Distributions, solve_batch};
use crate::cable::CableStateError;
use crate::geometry::Pose;
use crate::model::Model;
use crate::statics::{Load, StaticsError, cable_state};
use crate::tension::{self, InputError, Limits, LimitsError, Options};

/// Distributions allowed before the search gives up.
const MAX_ITERATIONS: u32 = 50;
/// Change of tensions, as a fraction of the largest, below which they have settled: Newton's method has doubled its
/// digits before, and the shapes of taut cables that do not stretch are known no better.
const SETTLED: f64 = 1e-10;

/// Tensions, with the reason if they do not balance the load.
#[must_use = "check `reason` before using the tensions"]
#[derive(Clone, Debug, PartialEq)]
pub struct Distribution {
    /// Tension per cable at the point where the robot measures it (N); within the limits unless there is a reason.
    pub tensions: Vec<f64>,
    /// Reason that these tensions do not balance the load; `None` if they do.
    pub reason: Option<Reason>,
    /// Number of programmes solved.
    pub iterations: u32,
}

/// Reason that no tensions were found.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// Limits and load exclude each other, in words.
    Infeasible(String),
    /// The fixed point was not reached, in words.
    NotConverged(String),
}

impl Reason {
    /// The status in results: `infeasible` or `not-converged`.
    pub fn status(&self) -> &'static str {
        match self {
            Self::Infeasible(_) => "infeasible",
            Self::NotConverged(_) => "not-converged",
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Infeasible(words) | Self::NotConverged(words) => formatter.write_str(words),
        }
    }
}

/// Input for which there is no distribution.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DistributionError {
    /// A cable without a path at the pose.
    #[error(transparent)]
    Statics(#[from] StaticsError),
    /// Limits that do not fit the model.
    #[error(transparent)]
    Tension(#[from] InputError),
    /// A robot with a file that states no limits.
    #[error(transparent)]
    Limits(#[from] LimitsError),
}

impl Model {
    /// Tensions that balance a load at a pose, the nearest to the middle of the limits that the robot's file states.
    ///
    /// [`solve`] takes other limits, [`Solver`] many poses and other methods.
    pub fn distribute(&self, pose: &Pose, load: &Load) -> Result<Distribution, DistributionError> {
        solve(self, pose, load, &Limits::of(self.robot(), None, None)?)
    }
}

/// A solver for many poses of one model.
#[derive(Clone, Debug)]
pub struct Solver {
    model: Model,
    load: Load,
    limits: Limits,
    chooser: tension::Solver,
}

impl Solver {
    /// A solver for this model, load and limits.
    pub fn new(model: &Model, load: &Load, limits: &Limits) -> Self {
        Self::by(tension::Method::Qp, model, load, limits)
    }

    /// A solver that chooses tensions by the given method.
    pub(crate) fn by(method: tension::Method, model: &Model, load: &Load, limits: &Limits) -> Self {
        let chooser = tension::Solver::new(method, model.cable_count(), model.dof());
        Self { model: model.clone(), load: *load, limits: limits.clone(), chooser }
    }

    /// Returns the tensions that keep the limits and balance the load at a pose, chosen by the solver's method: by
    /// default those nearest to the middle of the limits.
    pub fn solve(&mut self, pose: &Pose) -> Result<Distribution, DistributionError> {
        let wrench = self.load.in_pattern(&self.model, pose);
        let (chooser, limits) = (&mut self.chooser, &self.limits);
        let mut found = (Vec::new(), None);
        let balance = balance(&self.model, pose, wrench.as_slice(), &mut |matrix, wrench| {
            // the answer at a pose must not depend on earlier poses
            chooser.forget();
            let answer = chooser.solve(matrix, wrench, limits, &Options::default())?;
            found = (answer.tensions.clone(), answer.reason());
            Ok(found.1.is_none().then(|| found.0.clone()))
        })?;
        let (tensions, infeasible) = found;
        let reason = infeasible.map(Reason::Infeasible).or(balance.reason);
        Ok(Distribution { tensions, reason, iterations: balance.iterations })
    }
}

/// Solves one distribution; see [`Solver`] for many.
pub fn solve(model: &Model, pose: &Pose, load: &Load, limits: &Limits) -> Result<Distribution, DistributionError> {
    Solver::new(model, load, limits).solve(pose)
}

/// The balance of tensions and load at a pose, linear in the tensions: matrix · f + wrench = 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Balance {
    /// The structure matrix of straight cables; for sagging ones ∂W/∂f at the tensions on which the method settled, n ×
    /// m.
    pub matrix: DMatrix<f64>,
    /// The load in the pattern's n rows, plus the part of the wrench of sagging cables that is not matrix · f (N, N·m).
    pub wrench: Vec<f64>,
    /// Number of calls of the method.
    pub iterations: u32,
    /// Reason that the method did not settle; `None` if it did, or if it found no tensions and has a reason of its own.
    pub reason: Option<Reason>,
}

/// Estimated effort of a distribution at a pose: `straight` for straight cables, 1e4 for sagging ones, which are solved
/// repeatedly with their shapes.
pub fn effort(model: &Model, straight: f64) -> f64 {
    if model.cables().has_fixed_directions() { straight } else { 1e4 }
}

/// Any method of tension distribution: from matrix and wrench to tensions, `None` if it finds none.
pub type Method<'a> = dyn FnMut(&DMatrix<f64>, &[f64]) -> Result<Option<Vec<f64>>, InputError> + 'a;

/// The linear balance at the tensions that a method chooses for this same balance, for a load in the pattern's rows.
///
/// Straight cables need no iteration.
pub fn balance(
    model: &Model,
    pose: &Pose,
    wrench: &[f64],
    method: &mut Method<'_>,
) -> Result<Balance, DistributionError> {
    let matrix = model.structure_matrix(pose).map_err(StaticsError::from)?;
    let mut balance = Balance { matrix, wrench: wrench.to_vec(), iterations: 1, reason: None };
    let Some(mut tensions) = method(&balance.matrix, &balance.wrench)? else { return Ok(balance) };
    if model.cables().has_fixed_directions() {
        return Ok(balance);
    }
    let mut change = f64::INFINITY;
    while balance.iterations < MAX_ITERATIONS {
        match linearized(model, pose, wrench, &tensions) {
            Ok((matrix, wrench)) => (balance.matrix, balance.wrench) = (matrix, wrench),
            Err(StaticsError::CableState { cable, reason: reason @ CableStateError::TensionTooLow { .. } }) => {
                balance.reason = Some(Reason::Infeasible(format!("cable {cable}: {reason}")));
                return Ok(balance);
            }
            Err(error) => return Err(error.into()),
        }
        balance.iterations += 1;
        let Some(next) = method(&balance.matrix, &balance.wrench)? else { return Ok(balance) };
        let largest = next.iter().fold(0.0, |most, tension| f64::max(most, tension.abs()));
        change = next.iter().zip(&tensions).fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()));
        tensions = next;
        if change <= SETTLED * largest {
            return Ok(balance);
        }
    }
    balance.reason = Some(Reason::NotConverged(format!(
        "the directions of the sagging cables and their tensions do not settle: after {MAX_ITERATIONS} distributions the \
         tensions still change by {change:.3e} N"
    )));
    Ok(balance)
}

/// ∂W/∂f in the pattern's rows (n × m), and load plus W(f) − ∂W/∂f f (N, N·m).
fn linearized(
    model: &Model,
    pose: &Pose,
    wrench: &[f64],
    tensions: &[f64],
) -> Result<(DMatrix<f64>, Vec<f64>), StaticsError> {
    let basis = model.twist_basis();
    let mut matrix = DMatrix::zeros(basis.len(), tensions.len());
    let mut remaining = wrench.to_vec();
    for (cable, &tension) in tensions.iter().enumerate() {
        let state = cable_state(model, pose, cable, tension)?;
        let (whole, by_tension) = (state.wrench(), state.wrench_by_tension());
        for (row, twist) in basis.iter().enumerate() {
            let slope = twist.dot(&by_tension);
            matrix[(row, cable)] = slope;
            remaining[row] += twist.dot(&whole) - slope * tension;
        }
    }
    Ok((matrix, remaining))
}
