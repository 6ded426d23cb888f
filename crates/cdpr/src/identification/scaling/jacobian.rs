//! Jacobian of a model at what was measured, with weights of its rows.

use nalgebra::DMatrix;

use crate::identification::blocks::Block;
use crate::identification::elastostatic::weighted_jacobian;
use crate::identification::fit::{InputError, RowWeights, explains_tensions};
use crate::identification::pose_lanes::PoseLanes;
use crate::identification::weights::Weights;
use crate::measurement::Samples;
use crate::model::Model;
use crate::robot::Parameter;

/// Rows of lengths, of elastic models with those of wrenches; parameters by cable.
pub(super) fn jacobian(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    weights: RowWeights,
) -> Result<DMatrix<f64>, InputError> {
    if explains_tensions(model) {
        return weighted_jacobian(model, samples, parameters, weights);
    }
    let poses = PoseLanes::new(samples);
    let even = Weights::even(weights.length.recip(), model.cable_count(), samples.len(), &poses);
    let mut matrix = DMatrix::zeros(samples.len() * model.cable_count(), parameters.len());
    for cable in 0..model.cable_count() {
        let places: Vec<usize> = (0..parameters.len()).filter(|&k| parameters[k].cable == cable).collect();
        let own = places.iter().map(|&k| parameters[k]).collect();
        let block = Block::new(model, cable, own, samples, &even);
        let (_, columns) = block.rows(&poses, &block.start, samples.len());
        for (&place, column) in places.iter().zip(&columns) {
            let first = cable * samples.len();
            column.iter().enumerate().for_each(|(sample, entry)| matrix[(first + sample, place)] = *entry);
        }
    }
    match matrix.iter().all(|entry| entry.is_finite()) {
        true => Ok(matrix),
        false => Err(InputError::NotFinite),
    }
}
