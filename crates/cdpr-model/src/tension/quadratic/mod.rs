//! The exact quadratic programme: min ‖f − f_ref‖² such that Aᵀ f + w = 0 and f_min ≤ f ≤ f_max.
//!
//! The unknowns are reduced to the null space of Aᵀ by orthogonal factors, and a dual active set finds the optimum in
//! finitely many steps, or a certificate that there is none: a direction y in which the load asks for more than the
//! cables can give within their limits. Any number of cables is possible, also fewer than degrees of freedom, and so
//! are structure matrices without full rank: the load must then lie in their range, to 1e-9 of load and tensions (rows
//! compared after division by their length).

mod active_set;
pub(super) mod balance;
pub(super) mod block;
mod bound;
pub(super) mod certificate;
mod fixed;
mod plane;
#[cfg(test)]
mod tests;
mod words;

use super::Limits;
use super::error::{InputError, check_sizes};
use active_set::ActiveSet;
use balance::Balance;
use bound::BoundEnd;
pub use certificate::Certificate;
use nalgebra::DMatrix;

/// Reason of a status without verdict.
pub(super) const UNDECIDED: &str =
    "rounding errors are too large for a verdict: anchors, load or limits differ by too many orders of magnitude";

/// Whether the limits can be kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// The tensions balance the load, keep their limits, and are the nearest to the reference that do.
    Feasible,
    /// No tensions balance the load and keep the limits, see [`Distribution::certificate`] and
    /// [`Distribution::reason`].
    Infeasible,
    /// Rounding or overflow prevented a verdict: matrices with entries at the ends of their range.
    Undecided,
}

/// Tensions, or the reason that there are none.
#[must_use = "check `status` before using the tensions"]
#[derive(Clone, Debug)]
pub struct Distribution {
    /// Whether the limits can be kept.
    pub status: Status,
    /// Tension per cable (N), within the limits. Not for use if infeasible: they balance as much of the load as
    /// possible and miss limits.
    pub tensions: Vec<f64>,
    /// Aᵀ f + w, one entry per row (N, N·m): rounding if feasible.
    pub wrench_residual: Vec<f64>,
    /// Number of limits that were added or exchanged.
    pub iterations: u32,
    certificate: Certificate,
}

impl Distribution {
    /// The proof of infeasibility, for checking by other means; `None` unless infeasible.
    pub fn certificate(&self) -> Option<&Certificate> {
        (self.status == Status::Infeasible).then_some(&self.certificate)
    }

    /// The reason that there are no tensions: the force that cables would have to give, and the one that their limits
    /// allow. `None` if feasible.
    pub fn reason(&self) -> Option<String> {
        match self.status {
            Status::Feasible => None,
            Status::Infeasible => Some(self.certificate.to_string()),
            Status::Undecided => Some(UNDECIDED.to_owned()),
        }
    }
}

/// A solver that keeps its memory and starts from the limits that were active last time.
///
/// The optimum is unique, so that the start changes the result by rounding only; after [`Solver::forget`] it is the
/// same to the last bit.
#[derive(Clone, Debug)]
pub struct Solver {
    dof: usize,
    balance: Balance,
    search: ActiveSet,
    distribution: Distribution,
}

/// Solves one distribution; see [`Solver`] for many.
pub fn solve(
    structure_matrix: &DMatrix<f64>,
    wrench: &[f64],
    limits: &Limits,
    reference: Option<&[f64]>,
) -> Result<Distribution, InputError> {
    let (dof, cable_count) = structure_matrix.shape();
    let mut solver = Solver::new(cable_count, dof);
    solver.solve(structure_matrix, wrench, limits, reference)?;
    Ok(solver.distribution)
}

impl Solver {
    /// A solver for this many cables and degrees of freedom; it claims all memory here.
    pub fn new(cable_count: usize, dof: usize) -> Self {
        Self {
            dof,
            balance: Balance::new(cable_count, dof),
            search: ActiveSet::new(cable_count),
            distribution: Distribution {
                status: Status::Undecided,
                tensions: vec![0.0; cable_count],
                wrench_residual: vec![0.0; dof],
                iterations: 0,
                certificate: Certificate::new(cable_count, dof),
            },
        }
    }

    /// Forgets the limits that were active last time: the next result does not depend on what was solved before.
    pub fn forget(&mut self) {
        self.search.forget();
    }

    /// Returns the tensions nearest to `reference` (N, by default the middle of the limits) that balance the wrench
    /// within limits.
    ///
    /// The wrench has one component per row of the structure matrix (N, N·m).
    pub fn solve(
        &mut self,
        structure_matrix: &DMatrix<f64>,
        wrench: &[f64],
        limits: &Limits,
        reference: Option<&[f64]>,
    ) -> Result<&Distribution, InputError> {
        self.check(structure_matrix, wrench, limits, reference)?;
        let unreachable = self.balance.solve(structure_matrix, wrench, &mut self.search.basis)?;
        let dimension = self.distribution.tensions.len() - self.balance.rank();
        let certificate = &mut self.distribution.certificate;
        self.distribution.status = match unreachable {
            Some(unreachable) => {
                self.search.begin(dimension, limits, reference);
                self.balance.write_contradiction(unreachable, &mut certificate.direction);
                Status::Infeasible
            }
            None => match self.search.search(dimension, limits, reference) {
                BoundEnd::Optimum => Status::Feasible,
                BoundEnd::TooLong => Status::Undecided,
                BoundEnd::Contradiction(bound) => {
                    let combination = self.search.write_contradiction(bound);
                    self.balance.write_combination(combination, &mut certificate.direction);
                    Status::Infeasible
                }
            },
        };
        self.conclude(structure_matrix, wrench, limits);
        Ok(&self.distribution)
    }

    fn check(
        &self,
        structure_matrix: &DMatrix<f64>,
        wrench: &[f64],
        limits: &Limits,
        reference: Option<&[f64]>,
    ) -> Result<(), InputError> {
        let (rows, columns) = structure_matrix.shape();
        let (expected_rows, expected_columns) = (self.dof, self.distribution.tensions.len());
        if (rows, columns) != (expected_rows, expected_columns) {
            return Err(InputError::MatrixShape { expected_rows, expected_columns, rows, columns });
        }
        if reference.is_some_and(|reference| !reference.iter().all(|tension| tension.is_finite())) {
            return Err(InputError::NotFinite { what: "reference" });
        }
        check_sizes(structure_matrix, wrench, limits, reference)
    }

    /// Writes tensions, residual and certificate at the end of the search; undecided if one of them has overflowed.
    fn conclude(&mut self, structure_matrix: &DMatrix<f64>, wrench: &[f64], limits: &Limits) {
        let Distribution { status, tensions, wrench_residual, iterations, certificate } = &mut self.distribution;
        *iterations = self.search.iterations;
        let cable_count = tensions.len();
        tensions.copy_from_slice(&self.search.point.as_flattened()[..cable_count]);
        if *status == Status::Feasible {
            for (cable, tension) in tensions.iter_mut().enumerate() {
                *tension = tension.clamp(limits.minimum()[cable], limits.maximum()[cable]);
            }
        }
        match self.dof {
            2 => write_residual::<2>(structure_matrix.as_slice(), wrench, tensions, wrench_residual),
            3 => write_residual::<3>(structure_matrix.as_slice(), wrench, tensions, wrench_residual),
            6 => write_residual::<6>(structure_matrix.as_slice(), wrench, tensions, wrench_residual),
            dof => {
                wrench_residual.copy_from_slice(wrench);
                for (column, tension) in structure_matrix.as_slice().chunks_exact(dof).zip(tensions.iter()) {
                    wrench_residual.iter_mut().zip(column).for_each(|(residual, entry)| *residual += entry * tension);
                }
            }
        }
        if *status == Status::Infeasible {
            let has_full_rank = self.balance.rank() == self.dof;
            certificate.complete(structure_matrix, wrench, limits, has_full_rank);
        }
        let are_finite = |numbers: &[f64]| numbers.iter().all(|number| number.is_finite());
        let is_sound = match status {
            Status::Feasible => are_finite(tensions) && are_finite(wrench_residual),
            Status::Infeasible => certificate.holds(),
            Status::Undecided => true,
        };
        if !is_sound {
            *status = Status::Undecided;
        }
    }
}

/// Writes Aᵀ f + w, for a number of rows known to the compiler.
fn write_residual<const N: usize>(structure_matrix: &[f64], wrench: &[f64], tensions: &[f64], residual: &mut [f64]) {
    let mut sum = [0.0; N];
    sum.copy_from_slice(wrench);
    for (column, tension) in structure_matrix.chunks_exact(N).zip(tensions) {
        for row in 0..N {
            sum[row] += column[row] * tension;
        }
    }
    residual.copy_from_slice(&sum);
}
