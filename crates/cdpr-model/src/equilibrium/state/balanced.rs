//! Balance of load and tensions at one pose.

use nalgebra::DMatrix;

use crate::equilibrium::closed_form::{ClosedFormTensions, OnePose};
use crate::geometry::Pose;
use crate::model::Model;
use crate::scalar::{LANES, dispatch_narrow};
use crate::tension::closed_form::{self, Solution, Solver};
use crate::tension::{InputError, Limits};

/// Memory of a balance of load and tensions.
#[derive(Clone, Debug)]
pub(super) struct Balanced {
    pub(super) structure_matrix: DMatrix<f64>,
    pub(super) solver: Solver,
    pub(super) found: Solution,
}

impl Balanced {
    pub(super) fn of(model: &Model) -> Self {
        let (n, m) = (model.dof(), model.cable_count());
        let found = Solution {
            tensions: vec![0.0; m],
            within_limits: false,
            wrench_residual: vec![0.0; n],
            balanced: false,
            rank: 0,
        };
        Self { structure_matrix: DMatrix::zeros(n, m), solver: Solver::new(m, n), found }
    }

    /// Solves with the products of rows in registers; false if orthogonal factors or singular values are needed.
    pub(super) fn in_registers(&mut self, model: &Model, pose: &Pose, wrench: [f64; 6], limits: &Limits) -> bool {
        let (n, m) = (model.dof(), model.cable_count());
        if !(n..=LANES).contains(&m) || limits.cable_count() != m {
            return false;
        }
        let mut middle = [0.0; LANES];
        middle.iter_mut().enumerate().take(m).for_each(|(cable, middle)| *middle = limits.middle(cable));
        let rotation = &pose.rotation_rows();
        let (cables, basis, position) = (&model.groups()[0], model.twist_basis(), pose.position.into());
        let kernel = OnePose { cables, basis, position, rotation, wrench, middle: &middle };
        let Some(ClosedFormTensions { tensions, residual, sizes }) = dispatch_narrow(kernel) else { return false };
        let found = &mut self.found;
        found.tensions.copy_from_slice(&tensions[..m]);
        found.wrench_residual.copy_from_slice(&residual[..n]);
        found.within_limits = limits.contain(&found.tensions, limits.tolerance());
        found.balanced =
            residual.iter().zip(&sizes).all(|(residual, size)| residual.abs() <= closed_form::ROUNDING * size);
        found.rank = n;
        true
    }

    /// Solves with orthogonal factors, or singular values.
    pub(super) fn by_factors(&mut self, wrench: &[f64], limits: &Limits) -> Result<(), InputError> {
        let answer = self.solver.solve(&self.structure_matrix, wrench, limits, None)?;
        let found = &mut self.found;
        found.tensions.copy_from_slice(&answer.tensions);
        found.wrench_residual.copy_from_slice(&answer.wrench_residual);
        (found.within_limits, found.balanced, found.rank) = (answer.within_limits, answer.balanced, answer.rank);
        Ok(())
    }
}
