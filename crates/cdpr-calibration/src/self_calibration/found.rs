//! Samples at poses that were found.

use crate::fit::InputError;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{InternalSamples, Samples};
use cdpr_model::model::Model;

/// Length as it is recorded at a pose (m).
pub(super) fn modelled_length(model: &Model, cable: usize, pose: &Pose) -> f64 {
    model.recorded_length(cable, model.path_or_nan(cable, pose).0.length)
}

/// Samples at poses that were found, lengths counted from nothing and as the model's winches have them.
pub(super) fn as_found(model: &Model, internal: &InternalSamples, poses: &[Pose]) -> Result<Samples, InputError> {
    let lengths = model.with_lengths(&internal.samples).map_err(InputError::Winch)?;
    let mut samples = Samples { poses: poses.to_vec(), ..lengths.into_owned() };
    if internal.are_changes {
        let origin: Vec<f64> =
            (0..model.cable_count()).map(|cable| modelled_length(model, cable, &Pose::identity())).collect();
        samples.lengths.iter_mut().zip(origin.iter().cycle()).for_each(|(length, origin)| *length += origin);
    }
    Ok(samples)
}

/// Samples as a model's winches and its calibration read them.
pub(super) fn read_by(
    model: &Model,
    are_changes: bool,
    internal: &InternalSamples,
) -> Result<InternalSamples, InputError> {
    let samples = model.with_lengths(&internal.samples).map_err(InputError::Winch)?.into_owned();
    Ok(InternalSamples { samples, are_changes, ..internal.clone() })
}
