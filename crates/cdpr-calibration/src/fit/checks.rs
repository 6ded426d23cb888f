//! Questions that a fit asks of its model and samples before and after.

use super::input_error::InputError;
use super::settings::{Settings, prior_sigma};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, LengthShift, Model, RecordingParameter, ShiftCourse};
use cdpr_model::robot::Parameter;
use cdpr_model::solve::not_positive;

/// The free parameters, where model, samples and settings allow a fit of them.
pub(crate) fn checked_parameters(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &Settings,
) -> Result<Vec<Parameter>, InputError> {
    check_question(model, samples, settings)?;
    let parameters = free.parameters(model, &settings.hold)?;
    check_motor_angles(&parameters, samples)?;
    check_swivels(&parameters)?;
    check_rows(model, samples, &parameters, settings)?;
    Ok(parameters)
}

/// Refuses settings that mean nothing, and samples that are none of the model's.
pub(crate) fn check_question(model: &Model, samples: &Samples, settings: &Settings) -> Result<(), InputError> {
    let positive = [("tolerance", settings.tolerance), ("weak_direction_limit", settings.weak_direction_limit)];
    if let Some((name, value)) = not_positive(positive) {
        return Err(InputError::Setting { name, value });
    }
    if settings.row_weights.is_some() && (!model.needs_tensions() || settings.is_other_objective()) {
        let words = if model.needs_tensions() { "another objective" } else { "the lengths of rigid cables" };
        return Err(InputError::RowWeightCost { words: words.to_owned() });
    }
    if samples.is_empty() {
        return Err(InputError::NoSamples);
    }
    let (robot, data) = (model.cable_count(), samples.cable_count);
    if robot != data {
        return Err(InputError::CableCount { robot, data });
    }
    Ok(())
}

/// Refuses parameters of drums where no motor angles are recorded.
pub(crate) fn check_motor_angles(parameters: &[Parameter], samples: &Samples) -> Result<(), InputError> {
    let of_drum = parameters.iter().map(|parameter| parameter.kind).find(|kind| kind.needs_motor_angles());
    if let Some(kind) = of_drum.filter(|_| samples.motor_angles.is_none()) {
        return Err(InputError::NoMotorAngles { kind });
    }
    Ok(())
}

/// Refuses zeros of swivels, which do not change lengths.
fn check_swivels(parameters: &[Parameter]) -> Result<(), InputError> {
    let is_free = parameters.iter().any(|parameter| parameter.kind.needs_swivels());
    if is_free { Err(InputError::NoSwivelAngles) } else { Ok(()) }
}

/// Refuses more parameters than rows at measured poses.
fn check_rows(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
) -> Result<(), InputError> {
    let without_prior = |p: &&Parameter| prior_sigma(settings, p.kind).is_none();
    if model.needs_tensions() {
        let (rows, count) =
            (samples.len() * (model.dof() + model.cable_count()), parameters.iter().filter(without_prior).count());
        return match count > rows {
            true => Err(InputError::TooFewRows { parameters: count, rows, samples: samples.len() }),
            false => Ok(()),
        };
    }
    for cable in 0..model.cable_count() {
        let without_prior = |p: &&Parameter| p.cable == cable && prior_sigma(settings, p.kind).is_none();
        let count = parameters.iter().filter(without_prior).count();
        if count > samples.len() {
            return Err(InputError::TooFewSamples { cable: cable + 1, parameters: count, samples: samples.len() });
        }
    }
    Ok(())
}

/// Refuses parameters of the recording, which only squares of lengths tell.
pub(crate) fn check_recording(free: &FreeParameters, settings: &Settings) -> Result<(), InputError> {
    let is_freed =
        |parameter: &RecordingParameter| free.names_recording(*parameter) && !settings.hold.names_recording(*parameter);
    let freed = RecordingParameter::ALL.into_iter().find(is_freed).map(RecordingParameter::name);
    let shifted = || free.first_length_shift(&settings.hold).map(ShiftCourse::known_name);
    freed.or_else(shifted).map_or(Ok(()), |name| Err(InputError::RecordingCost { name }))
}

/// Refuses shifts of lengths that follow from motor angles by drums which are free themselves.
pub(super) fn check_shifts(parameters: &[Parameter], shifts: &[LengthShift]) -> Result<(), InputError> {
    let of_drum = parameters.iter().map(|parameter| parameter.kind).find(|kind| kind.needs_motor_angles());
    let shift = shifts.first().map(ToString::to_string).unwrap_or_default();
    of_drum.map_or(Ok(()), |kind| Err(InputError::ShiftOfAngles { shift, kind }))
}

/// Distance from a bound that is none, relative to the larger of bound and start value: steps to a bound end there to rounding.
const AT_BOUND: f64 = 1e-9;

/// True where a value lies on one of its bounds, to rounding.
pub(super) fn is_at_bound(value: f64, start: f64, bounds: (f64, f64)) -> bool {
    let (lower, upper) = bounds;
    let near = |bound: f64| bound.is_finite() && (value - bound).abs() <= AT_BOUND * bound.abs().max(start.abs());
    value <= lower || value >= upper || near(lower) || near(upper)
}
