//! How chosen tensions follow the model, by any method of tension distribution.
//!
//! A method takes structure matrix and load to tensions; how these follow is told by [`Response`]. A deviation changes the
//! column of its cable and the load.

use nalgebra::{DMatrix, DVector};

use super::cable::CableState;
use super::cause::Cause;
use super::equilibrium::load_change;
use crate::geometry::{Pose, Wrench};
use crate::metamodel::study::TensionMethod;
use crate::model::Model;
use crate::statics::{Load, StaticsError, StraightCable};
use crate::tension::{Limits, NotSmooth, Response};

/// Chosen tensions of a model at a pose.
pub(super) struct Choice<'a> {
    model: &'a Model,
    pose: Pose,
    response: Response,
}

impl<'a> Choice<'a> {
    /// Tensions of straight cables that a method has chosen within limits, or why they do not follow changes.
    pub(super) fn by(
        method: TensionMethod,
        (model, pose): (&'a Model, &Pose),
        load: &Load,
        limits: &Limits,
        tensions: &[f64],
    ) -> Result<Result<Self, NotSmooth>, StaticsError> {
        let wrench = load.in_pattern(model, pose);
        let matrix = by_tensions(model, pose, tensions)?;
        let response = Response::of(method, &matrix, wrench.as_slice(), limits, tensions);
        Ok(response.map(|response| Self { model, pose: *pose, response }))
    }

    /// The balanced tensions nearest to a reference (N), whatever the limits; cables of any law where the tensions are their own
    /// reference.
    pub(super) fn nearest(
        model: &'a Model,
        pose: &Pose,
        tensions: &[f64],
        reference: &[f64],
    ) -> Result<Result<Self, NotSmooth>, StaticsError> {
        let matrix = by_tensions(model, pose, tensions)?;
        let response = Response::of_nearest(&matrix, tensions, reference);
        Ok(response.map(|response| Self { model, pose: *pose, response }))
    }

    /// Change of all tensions per unit of a deviation of the model (N).
    pub(super) fn by_cause(&self, cause: &Cause) -> DVector<f64> {
        let column = in_pattern(self.model, &self.column_change(cause));
        let wrench = in_pattern(self.model, &load_change(cause, self.model, &self.pose));
        self.response.change(cause.cable, column.as_slice(), wrench.as_slice())
    }

    /// Change of all tensions per newton of one cable's reference (N).
    pub(super) fn by_reference(&self, cable: usize) -> DVector<f64> {
        self.response.change_by_reference(cable)
    }

    /// Change of the cause's column of the structure matrix (world).
    fn column_change(&self, cause: &Cause) -> Wrench {
        let Some(parameter) = cause.parameter() else { return Wrench::zeros() };
        let (position, rows) = (self.pose.position.into(), self.pose.rotation_rows());
        let cable = StraightCable::at(self.model, cause.cable, position, &rows, 1.0);
        cable.by(&parameter, self.model, &self.pose.rotation_matrix()).0
    }
}

/// ∂(wrench)/∂f in the pattern's rows: the structure matrix of straight cables.
fn by_tensions(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<DMatrix<f64>, StaticsError> {
    let mut matrix = DMatrix::zeros(model.dof(), tensions.len());
    for (cable, &tension) in tensions.iter().enumerate() {
        let (wrench, _) = CableState::at_measured(model, cable, pose, tension)?.by_tension();
        matrix.set_column(cable, &in_pattern(model, &wrench));
    }
    Ok(matrix)
}

fn in_pattern(model: &Model, wrench: &Wrench) -> DVector<f64> {
    let basis = model.twist_basis();
    DVector::from_iterator(basis.len(), basis.iter().map(|twist| twist.dot(wrench)))
}
