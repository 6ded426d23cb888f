//! Rows of a model at what was measured, with weights of their own.

use nalgebra::{DMatrix, DVector};

use super::blocks::Block;
use super::elastostatic::weighted_rows;
use super::fit::{InputError, RowWeights, explains_tensions};
use super::pose_lanes::PoseLanes;
use super::weights::Weights;
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
        let ((residuals, jacobian), kinds) = match explains_tensions(model) {
            true => (weighted_rows(model, samples, parameters, weights)?, kinds_of_balance(model)),
            false => (even_length_rows(model, samples, parameters, weights), vec![RowKind::Length]),
        };
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

/// Wrench rows in the degrees of freedom of the pattern, then the cables.
fn kinds_of_balance(model: &Model) -> Vec<RowKind> {
    let is_force = |twist: &cdpr_model::geometry::Twist| twist.fixed_rows::<3>(3).norm() == 0.0;
    let of_wrench = |twist| if is_force(twist) { RowKind::Force } else { RowKind::Moment };
    let wrenches = model.twist_basis().iter().map(of_wrench);
    wrenches.chain(std::iter::repeat_n(RowKind::Length, model.cable_count())).collect()
}

/// Lengths cable by cable, all with one weight.
fn even_length_rows(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    weights: RowWeights,
) -> (DVector<f64>, DMatrix<f64>) {
    let poses = PoseLanes::new(samples);
    let even = Weights::even(weights.length.recip(), model.cable_count(), samples.len(), &poses);
    length_rows(model, samples, parameters, &poses, &even)
}

/// Lengths cable by cable, with a weight of its own for each.
pub(super) fn length_rows(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    poses: &PoseLanes,
    weights: &Weights,
) -> (DVector<f64>, DMatrix<f64>) {
    let mut jacobian = DMatrix::zeros(samples.len() * model.cable_count(), parameters.len());
    let mut residuals = DVector::zeros(jacobian.nrows());
    for cable in 0..model.cable_count() {
        let places: Vec<usize> = (0..parameters.len()).filter(|&k| parameters[k].cable == cable).collect();
        let own = places.iter().map(|&k| parameters[k]).collect();
        let block = Block::new(model, cable, own, samples, weights);
        let (own_residuals, columns) = block.rows(poses, &block.start, samples.len());
        let first = cable * samples.len();
        residuals.rows_mut(first, samples.len()).copy_from_slice(&own_residuals);
        for (&place, column) in places.iter().zip(&columns) {
            jacobian.view_mut((first, place), (samples.len(), 1)).copy_from_slice(column);
        }
    }
    (residuals, jacobian)
}
