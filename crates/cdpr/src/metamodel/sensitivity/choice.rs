//! How chosen tensions follow the model: the derivative of the nearest tensions that balance the load.
//!
//! Tensions nearest to a reference t, min ½‖f − t‖² with Aᵀ f + w = 0, keep f − t − A λ = 0 for every cable that is not on a limit.
//! Differentiated: df − A dλ = dt + dA λ and Aᵀ df = −dAᵀ f − dw; a cable on its limit stays there.

use std::ops::AddAssign;

use nalgebra::{DMatrix, DVector};

use super::cable::CableState;
use super::cause::Cause;
use super::equilibrium::load_change;
use crate::geometry::{Pose, Wrench};
use crate::model::Model;
use crate::statics::{StaticsError, StraightCable};
use crate::tension::Limits;

/// Tensions this near to a limit, relative to the largest limit, are on it.
const ON_LIMIT: f64 = 1e-9;

/// Chosen tensions of a model at a pose.
pub(super) struct Choice<'a> {
    model: &'a Model,
    pose: Pose,
    tensions: Vec<f64>,
    /// Cables that are on no limit.
    free: Vec<usize>,
    /// λ (N).
    multipliers: DVector<f64>,
    /// Inverse of \[I, −A; Aᵀ, 0\] of the free cables.
    inverse: DMatrix<f64>,
}

impl<'a> Choice<'a> {
    /// Straight cables with the tensions nearest to a reference, within limits if there are any; `None` where the cables that are
    /// on no limit cannot balance a small change of the load.
    pub(super) fn nearest(
        model: &'a Model,
        pose: &Pose,
        tensions: &[f64],
        reference: &[f64],
        limits: Option<&Limits>,
    ) -> Result<Option<Self>, StaticsError> {
        let matrix = model.structure_matrix(pose)?;
        let Some(mut choice) = Self::of(model, pose, tensions, &matrix, limits) else { return Ok(None) };
        // the multipliers are those of the same programme at its solution
        let mut right = DVector::zeros(choice.inverse.nrows());
        for (row, &cable) in choice.free.iter().enumerate() {
            right[row] = reference[cable];
            let pull = matrix.column(cable) * tensions[cable];
            right.rows_mut(choice.free.len(), model.dof()).add_assign(&pull);
        }
        let solution = &choice.inverse * right;
        choice.multipliers.copy_from(&solution.rows(choice.free.len(), model.dof()));
        Ok(Some(choice))
    }

    /// Cables of any law with tensions that are their own reference.
    pub(super) fn as_they_are(model: &'a Model, pose: &Pose, tensions: &[f64]) -> Result<Option<Self>, StaticsError> {
        let mut matrix = DMatrix::zeros(model.dof(), tensions.len());
        for (cable, &tension) in tensions.iter().enumerate() {
            let (wrench, _) = CableState::at_measured(model, cable, pose, tension)?.by_tension();
            model.twist_basis().iter().enumerate().for_each(|(row, twist)| matrix[(row, cable)] = twist.dot(&wrench));
        }
        Ok(Self::of(model, pose, tensions, &matrix, None))
    }

    fn of(
        model: &'a Model,
        pose: &Pose,
        tensions: &[f64],
        matrix: &DMatrix<f64>,
        limits: Option<&Limits>,
    ) -> Option<Self> {
        let is_free = |cable: &usize| {
            limits.is_none_or(|limits| {
                let nearest = |limit: &[f64]| (tensions[*cable] - limit[*cable]).abs();
                let largest = limits.maximum().iter().fold(0.0, |largest: f64, limit| largest.max(limit.abs()));
                nearest(limits.minimum()).min(nearest(limits.maximum())) > ON_LIMIT * largest
            })
        };
        let free: Vec<usize> = (0..tensions.len()).filter(is_free).collect();
        let (count, n) = (free.len(), model.dof());
        let mut system = DMatrix::identity(count + n, count + n);
        system.view_mut((count, count), (n, n)).fill(0.0);
        for (row, &cable) in free.iter().enumerate() {
            for axis in 0..n {
                system[(row, count + axis)] = -matrix[(axis, cable)];
                system[(count + axis, row)] = matrix[(axis, cable)];
            }
        }
        let inverse = system.try_inverse().filter(|inverse| inverse.amax() < 1e9)?;
        let multipliers = DVector::zeros(n);
        Some(Self { model, pose: *pose, tensions: tensions.to_vec(), free, multipliers, inverse })
    }

    /// Change of all tensions per unit of a deviation of the model (N).
    pub(super) fn by_cause(&self, cause: &Cause) -> DVector<f64> {
        let count = self.free.len();
        let mut right = DVector::zeros(self.inverse.nrows());
        let column = self.column_change(cause);
        let change = column * self.tensions[cause.cable] + load_change(cause, self.model, &self.pose);
        for (axis, twist) in self.model.twist_basis().iter().enumerate() {
            right[count + axis] = -twist.dot(&change);
            if let Some(row) = self.free.iter().position(|&cable| cable == cause.cable) {
                right[row] += twist.dot(&column) * self.multipliers[axis];
            }
        }
        self.solve(&right)
    }

    /// Change of all tensions per newton of one cable's reference (N).
    pub(super) fn by_reference(&self, cable: usize) -> DVector<f64> {
        let mut right = DVector::zeros(self.inverse.nrows());
        if let Some(row) = self.free.iter().position(|&free| free == cable) {
            right[row] = 1.0;
        }
        self.solve(&right)
    }

    /// Change of the cause's column of the structure matrix (world).
    fn column_change(&self, cause: &Cause) -> Wrench {
        let Some(parameter) = cause.parameter() else { return Wrench::zeros() };
        let (position, rows) = (self.pose.position.into(), self.pose.rotation_rows());
        let cable = StraightCable::at(self.model, cause.cable, position, &rows, 1.0);
        cable.by(&parameter, self.model, &self.pose.rotation_matrix()).0
    }

    fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let solution = &self.inverse * right;
        let mut change = DVector::zeros(self.tensions.len());
        self.free.iter().enumerate().for_each(|(row, &cable)| change[cable] = solution[row]);
        change
    }
}
