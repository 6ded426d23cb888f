//! Rows of a model at what was measured, with weights of their own.

use nalgebra::{DMatrix, DVector};

use super::fit::{InputError, RowWeights, Settings};
use super::problem::Problem;
use super::residual::Given;
use super::residual::entries::{RowNoise, length_rows};
use super::residual::rows::Rows;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Residuals of lengths, of elastic models with those of wrenches, and their derivatives by parameters.
pub(super) struct PlainRows {
    pub(super) residuals: DVector<f64>,
    pub(super) jacobian: DMatrix<f64>,
    /// Kinds of the rows that repeat from sample to sample.
    kinds: Vec<RowKind>,
    weights: RowWeights,
}

/// Quantity of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RowKind {
    /// A cable's length (m).
    Length,
    /// Forces in balance (N).
    Force,
    /// Moments in balance (N·m).
    Moment,
}

impl PlainRows {
    /// Rows of a model with its parameters by cable.
    pub(super) fn of(
        model: &Model,
        samples: &Samples,
        parameters: &[Parameter],
        weights: RowWeights,
    ) -> Result<Self, InputError> {
        let settings = Settings::default();
        let given = Given { model, samples, parameters, settings: &settings };
        let rows = length_rows(&given, RowNoise::Even(weights))?;
        let Rows { residuals, jacobian, .. } = Problem::of(rows, samples, parameters, &settings)?.rows()?;
        let kinds = kinds_of(model);
        match residuals.iter().chain(jacobian.iter()).all(|entry| entry.is_finite()) {
            true => Ok(Self { residuals, jacobian, kinds, weights }),
            false => Err(InputError::NotFinite),
        }
    }

    /// Root mean square of the residuals of a kind, in its unit; `None` without any.
    pub(super) fn rms(&self, kind: RowKind) -> Option<f64> {
        let of_kind = self.residuals.iter().zip(self.kinds.iter().cycle()).filter(|(_, own)| **own == kind);
        let (count, sum) =
            of_kind.fold((0_usize, 0.0), |(count, sum), (residual, _)| (count + 1, sum + residual * residual));
        let weight = if kind == RowKind::Length { self.weights.length } else { self.weights.wrench };
        (count > 0).then(|| (sum / count as f64).sqrt() / weight)
    }
}

/// Of elastic models wrench rows in the degrees of freedom of the pattern, then the cables.
fn kinds_of(model: &Model) -> Vec<RowKind> {
    let is_force = |twist: &cdpr_model::geometry::Twist| twist.fixed_rows::<3>(3).norm() == 0.0;
    let of_wrench = |twist| if is_force(twist) { RowKind::Force } else { RowKind::Moment };
    let wrenches = model.twist_basis().iter().filter(|_| model.needs_tensions()).map(of_wrench);
    wrenches.chain(std::iter::repeat_n(RowKind::Length, model.cable_count())).collect()
}
