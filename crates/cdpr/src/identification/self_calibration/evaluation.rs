//! Errors of a model at the poses where a sample's measurements agree best.

use super::found::{as_found, modelled_length};
use super::question::{check_swivels, no_equation_left, sensing};
use super::vectors::Sensing;
use super::written::stacked;
use crate::identification::evaluation::Evaluation;
use crate::identification::fit::InputError;
use crate::identification::objective::Sensor;
use crate::measurement::{InternalSamples, Samples};
use crate::model::Model;

/// Errors of a model's lengths and swivel angles at the poses where its measurements agree best; known components of poses stay. There are no errors of poses.
///
/// Tensions count where the model is elastic, and where lengths, swivels and what is known of poses leave poses open.
pub fn evaluate_lengths(model: &Model, internal: &InternalSamples) -> Result<Evaluation, InputError> {
    let (robot, data) = (model.cable_count(), internal.samples.cable_count);
    if robot != data {
        return Err(InputError::CableCount { robot, data });
    }
    check_swivels(model, internal)?;
    let geometry =
        InternalSamples { samples: Samples { tensions: None, ..internal.samples.clone() }, ..internal.clone() };
    let by_geometry = sensing(model, &geometry, false);
    let is_determined =
        !model.needs_tensions() && by_geometry.vectors(model, &geometry, &[], &[]).equation_count().is_some();
    let (internal, sensing) = match is_determined || internal.samples.tensions.is_none() {
        true => (&geometry, by_geometry),
        false => (internal, sensing(model, internal, false)),
    };
    let mut vectors = sensing.vectors(model, internal, &[], &[]);
    if vectors.equation_count().is_none() {
        return Err(no_equation_left(model, &sensing));
    }
    let written = stacked(&mut vectors, model, &[])?;
    let swivel = match &sensing {
        Sensing::All(layout, weights) => layout
            .places(Sensor::Swivel, internal.samples.len())
            .map(|row| written.residuals[row] * weights.swivel)
            .collect(),
        _ => Vec::new(),
    };
    let length = match &sensing {
        Sensing::All(layout, weights) => layout
            .places(Sensor::Length, internal.samples.len())
            .map(|row| written.residuals[row] * weights.length)
            .collect(),
        Sensing::Lengths(_) => {
            let found = as_found(model, internal, &vectors.poses())?;
            let error =
                |(k, recorded): (usize, &f64)| modelled_length(model, k % robot, &found.poses[k / robot]) - recorded;
            found.lengths.iter().enumerate().map(error).collect()
        }
    };
    let count = internal.samples.len();
    Ok(Evaluation {
        position: vec![f64::NAN; count],
        position_vector: vec![[f64::NAN; 3]; count],
        rotation: vec![f64::NAN; count],
        length,
        swivel,
        cable_count: robot,
        ..Evaluation::default()
    })
}
