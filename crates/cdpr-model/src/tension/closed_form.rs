//! The closed form: tensions nearest to the middle of their limits, whether or not they keep them.

use nalgebra::{DMatrix, DVector};

use super::Limits;
use super::affine::{Affine, add_scaled};
use super::distribute::{Chosen, Distribute, FoundTensions, Problem, Task, Written};
use super::error::{InputError, check_shape, check_sizes};
use super::limits::can_be_calculated_with;
use super::response::optimum;
use crate::scalar::decomposition::svd;

/// Fraction of the terms of a row of the balance below which its residual is rounding.
pub(crate) const ROUNDING: f64 = 1e-9;

/// Tensions in closed form, with their residual and whether they keep the limits.
#[must_use = "check `within_limits` before using the tensions"]
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Tension per cable (N); it may be negative or above its limit.
    pub tensions: Vec<f64>,
    /// True if every tension keeps its limits.
    pub within_limits: bool,
    /// Aᵀ f + w (N, N·m): zero to rounding unless the structure matrix has lost rank.
    pub wrench_residual: Vec<f64>,
    /// True if the tensions balance the load to rounding.
    pub balanced: bool,
    /// Rank of the structure matrix.
    pub rank: usize,
}

impl Solution {
    /// The reason that the tensions are not for use: cables beyond their limits, or a load that stays unbalanced.
    /// `None` if they may be used.
    pub fn reason(&self, limits: &Limits) -> Option<String> {
        let mut reasons = limits.missed(&self.tensions);
        if !self.balanced {
            let residual: Vec<String> = self.wrench_residual.iter().map(|residual| format!("{residual:.3}")).collect();
            reasons.push(format!(
                "the cables leave [{}] of the load unbalanced: the structure matrix has rank {} of {}",
                residual.join(", "),
                self.rank,
                self.wrench_residual.len()
            ));
        }
        (!reasons.is_empty()).then(|| reasons.join("; "))
    }
}

/// A solver that keeps its memory but no start: every result depends on its own problem alone.
///
/// The tensions are a continuous function of load, matrix and limits wherever the matrix has full rank.
#[derive(Clone, Debug)]
pub struct Solver {
    balanced: Affine,
    reference: Vec<f64>,
    /// Sum of the terms' amounts per row, to which rounding is relative.
    sizes: Vec<f64>,
    solution: Solution,
}

/// f = f_m − A⁺ᵀ (w + Aᵀ f_m) with f_m = ½ (f_min + f_max) (Miermeister 2021, eq. 3.41).
///
/// Of all tensions that balance the load these are the nearest to f_m. If the cables cannot balance it, the residual is
/// the least possible one, with each row divided by the length of the structure matrix's row. See [`Solver`] for many
/// problems.
pub fn solve(structure_matrix: &DMatrix<f64>, wrench: &[f64], limits: &Limits) -> Result<Solution, InputError> {
    let (dof, cable_count) = structure_matrix.shape();
    let mut solver = Solver::new(cable_count, dof);
    solver.solve(structure_matrix, wrench, limits, None)?;
    Ok(solver.solution)
}

impl Solver {
    /// A solver for this many cables and degrees of freedom. It claims all memory here, except that for lost rank.
    pub fn new(cable_count: usize, dof: usize) -> Self {
        Self {
            balanced: Affine::new(cable_count, dof),
            reference: vec![0.0; cable_count],
            sizes: vec![0.0; dof],
            solution: Solution {
                tensions: vec![0.0; cable_count],
                within_limits: false,
                wrench_residual: vec![0.0; dof],
                balanced: false,
                rank: 0,
            },
        }
    }

    /// As [`solve`], but near to the reference (N per cable) if one is given, instead of the middle of the limits.
    pub fn solve(
        &mut self,
        structure_matrix: &DMatrix<f64>,
        wrench: &[f64],
        limits: &Limits,
        reference: Option<&[f64]>,
    ) -> Result<&Solution, InputError> {
        check_shape(structure_matrix, self.solution.wrench_residual.len(), self.solution.tensions.len())?;
        check_sizes(structure_matrix, wrench, limits, reference)?;
        match reference {
            Some(reference) if !reference.iter().all(|&tension| can_be_calculated_with(tension)) => {
                return Err(InputError::NotFinite { what: "reference" });
            }
            Some(reference) => self.reference.copy_from_slice(reference),
            None => self.reference.iter_mut().enumerate().for_each(|(cable, place)| *place = limits.middle(cable)),
        }
        let found = &mut self.solution;
        // orthogonal factors if the rank is certain, otherwise singular values
        if self.balanced.load(structure_matrix, wrench)? && self.balanced.rank_is_certain() {
            self.balanced.nearest(&self.reference, &mut found.tensions);
            found.rank = wrench.len();
        } else {
            found.rank = by_singular_values(structure_matrix, wrench, &self.reference, &mut found.tensions)?;
        }
        write_residual(structure_matrix, wrench, &found.tensions, &mut found.wrench_residual);
        found.within_limits = limits.contain(&found.tensions, limits.tolerance());
        self.solution.balanced = self.is_zero_to_rounding(structure_matrix, wrench);
        Ok(&self.solution)
    }

    /// True if every row of Aᵀ f + w is rounding of its terms.
    fn is_zero_to_rounding(&mut self, structure_matrix: &DMatrix<f64>, wrench: &[f64]) -> bool {
        let sizes = &mut self.sizes;
        sizes.iter_mut().zip(wrench).for_each(|(size, w)| *size = w.abs());
        let columns = structure_matrix.as_slice().chunks_exact(wrench.len().max(1));
        for (column, tension) in columns.zip(&self.solution.tensions) {
            sizes.iter_mut().zip(column).for_each(|(size, entry)| *size += (entry * tension).abs());
        }
        self.solution.wrench_residual.iter().zip(sizes).all(|(residual, size)| residual.abs() <= ROUNDING * *size)
    }
}

impl Distribute for Solver {
    fn search(&mut self, task: &Task<'_>, found: &mut FoundTensions<'_>) -> Result<bool, InputError> {
        let Problem { structure_matrix, wrench } = task.problem;
        let solution = self.solve(structure_matrix, wrench, found.limits, Some(task.reference))?;
        found.tensions.copy_from_slice(&solution.tensions);
        Ok(solution.balanced && solution.within_limits)
    }

    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        // no limit holds a cable
        optimum::nearest(chosen, (0..chosen.tensions.len()).collect(), &|cable| chosen.limits.middle(cable))
    }
}

/// Writes Aᵀ f + w (N, N·m).
pub(super) fn write_residual(structure_matrix: &DMatrix<f64>, wrench: &[f64], tensions: &[f64], residual: &mut [f64]) {
    residual.copy_from_slice(wrench);
    for (column, tension) in structure_matrix.as_slice().chunks_exact(wrench.len().max(1)).zip(tensions) {
        add_scaled(residual, *tension, column);
    }
}

/// Writes the tensions with the least residual that are nearest to the reference; returns the rank.
fn by_singular_values(
    structure_matrix: &DMatrix<f64>,
    wrench: &[f64],
    reference: &[f64],
    tensions: &mut [f64],
) -> Result<usize, InputError> {
    let middle = DVector::from_column_slice(reference);
    let mut rows = structure_matrix.clone();
    let mut unbalanced = structure_matrix * &middle + DVector::from_column_slice(wrench);
    if !unbalanced.norm_squared().is_finite() {
        return Err(InputError::NotFinite { what: "wrench" });
    }
    // rows of length 1: forces and moments have different units, and the rank should not depend on them
    let largest = rows.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
    for (mut row, residual) in rows.row_iter_mut().zip(unbalanced.iter_mut()) {
        let length = row.norm();
        if length > LOST * largest {
            row /= length;
            *residual /= length;
        }
    }
    let (correction, rank) = minimum_norm(rows, &unbalanced);
    tensions.copy_from_slice((middle - correction).as_slice());
    Ok(rank)
}

/// Fraction of the largest row or singular value below which one counts as zero.
const LOST: f64 = 1e-12;

/// Shortest x with the least ‖rows x − right‖, and the rank of the rows.
fn minimum_norm(rows: DMatrix<f64>, right: &DVector<f64>) -> (DVector<f64>, usize) {
    let cables = rows.ncols();
    // rows whose products overflow count as zero
    let Some(decomposition) = svd(rows, true, true) else { return (DVector::zeros(cables), 0) };
    let values = &decomposition.singular_values;
    let least = LOST * values.max();
    let rank = values.iter().filter(|&&value| value > least).count();
    let solution = decomposition.solve(right, least).unwrap_or_else(|_| DVector::zeros(cables));
    (solution, rank)
}
