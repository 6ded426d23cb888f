//! The derivative of a method that has none in closed form: central differences of its tensions.
//!
//! Entries of the structure matrix, load and reference are moved one by one, and the method solves the problem on both
//! sides. It has to find tensions there, so that tensions at the edge of the feasible loads have no such derivative.

use nalgebra::{DMatrix, DVector};

use crate::tension::distribute::{Chosen, Derivative, NoDerivative, Status};
use crate::tension::{Method, Options, Reference, Solver};

/// Step of an entry of the structure matrix, and of load and reference as a fraction of the largest limit. Rounding of
/// the solves, 1e-10 of the largest limit, stays below 1e-5 of a derivative.
const STEP: f64 = 1e-5;

/// Derivatives by every number of a problem (N per unit).
#[derive(Clone, Debug)]
pub(super) struct Differences {
    /// By the entries of the structure matrix, column by column.
    by_entry: Vec<DVector<f64>>,
    by_wrench: Vec<DVector<f64>>,
    by_reference: Vec<DVector<f64>>,
}

impl Differences {
    pub(super) fn of(method: Method, chosen: &Chosen<'_>) -> Result<Self, NoDerivative> {
        let (matrix, limits) = (chosen.problem.structure_matrix, chosen.limits);
        let (dof, cable_count) = matrix.shape();
        let middle: Vec<f64> = (0..cable_count).map(|cable| limits.middle(cable)).collect();
        let mut point = Point { matrix: matrix.clone(), wrench: chosen.problem.wrench.to_vec(), reference: middle };
        let mut solver = Solver::new(method, cable_count, dof);
        let mut solve = |point: &Point| -> Result<DVector<f64>, NoDerivative> {
            solver.forget();
            let options = Options { reference: Reference::Given(&point.reference), ..Options::default() };
            let answer = solver.solve(&point.matrix, &point.wrench, limits, &options)?;
            match answer.status {
                Status::Feasible => Ok(DVector::from_column_slice(&answer.tensions)),
                _ => Err(NoDerivative::Thin),
            }
        };
        let newtons = STEP * limits.minimum().iter().chain(limits.maximum()).fold(0.0_f64, |most, f| most.max(f.abs()));
        let mut slopes = |count: usize, step: f64, number: fn(&mut Point, usize) -> &mut f64| {
            let slope = |index: usize| -> Result<DVector<f64>, NoDerivative> {
                let here = *number(&mut point, index);
                *number(&mut point, index) = here + step;
                let ahead = solve(&point)?;
                *number(&mut point, index) = here - step;
                let behind = solve(&point)?;
                *number(&mut point, index) = here;
                Ok((ahead - behind) / (2.0 * step))
            };
            (0..count).map(slope).collect::<Result<Vec<_>, _>>()
        };
        Ok(Self {
            by_entry: slopes(dof * cable_count, STEP, |point, index| &mut point.matrix.as_mut_slice()[index])?,
            by_wrench: slopes(dof, newtons, |point, index| &mut point.wrench[index])?,
            by_reference: slopes(cable_count, newtons, |point, index| &mut point.reference[index])?,
        })
    }
}

/// A problem near the one that was solved.
struct Point {
    matrix: DMatrix<f64>,
    wrench: Vec<f64>,
    reference: Vec<f64>,
}

impl Derivative for Differences {
    fn change(&self, cable: usize, column: &[f64], wrench: &[f64]) -> DVector<f64> {
        let mut change = DVector::zeros(self.by_reference.len());
        let of_column = self.by_entry[cable * column.len()..].iter().zip(column);
        for (slope, by) in of_column.chain(self.by_wrench.iter().zip(wrench)) {
            change.axpy(*by, slope, 1.0);
        }
        change
    }

    fn change_by_reference(&self, cable: usize) -> DVector<f64> {
        self.by_reference[cable].clone()
    }
}
