//! Optimal parameters of one model from measured poses and recorded lengths.

pub(crate) mod answer;
mod cautions;
mod checks;
mod frames;
mod input_error;
mod largest_changes;
mod profile;
mod report;
mod settings;
mod shifts;
#[cfg(test)]
mod tests;
pub(super) mod warnings;

use crate::progress::Progress;
use crate::progress::unobserved;
pub use answer::{Estimate, Fit, Status};
use checks::check_shifts;
pub(super) use checks::{check_motor_angles, check_question, check_recording, checked_parameters};
pub use frames::{FrameEstimate, Gauge, RecordingFrames, frame_warning};
pub(super) use frames::{frames_that_fit, start_by_positions};
pub use input_error::InputError;
pub(super) use profile::Course;
pub use profile::{Profile, ProfilePoint, profiles};
pub(super) use report::report;
pub(super) use settings::{ASSUMED_NOISE, ASSUMED_TENSION_SHARE, prior_sigma};
pub use settings::{Prior, RowWeights, Settings, TaskBox};
pub use shifts::ShiftEstimate;

use super::clock;
use super::problem::Problem;
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, Model, RecordingParameter};
use cdpr_model::robot::Parameter;
pub use cdpr_model::solve::Minimizer;

/// Fits the free parameters of a model to samples.
///
/// Minimises Σ (ρ/σ)² + Σ ((p − p_start)/σ_prior)², ρ the modelled minus the recorded length (eq. 4.8), cable by cable,
/// within the parameters' bounds; under a robust [`Loss`] the cables' squares of a sample count together. Without free parameters it only tells how well the model fits.
pub fn fit(model: &Model, samples: &Samples, free: &FreeParameters, settings: &Settings) -> Result<Fit, InputError> {
    fit_observed(model, samples, free, settings, &unobserved)
}

/// As [`fit`]; `progress` is called after each descent: [`descent_count`] times.
pub fn fit_observed(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &Settings,
    progress: &Progress<'_>,
) -> Result<Fit, InputError> {
    let parameters = checked_parameters(model, samples, free, settings)?;
    if settings.is_other_objective() {
        check_recording(free, settings)?;
    }
    let samples = &*model.with_lengths(samples)?;
    let shifted = free.length_shifts(&settings.hold, model.cable_count())?;
    if !shifted.is_empty() {
        check_shifts(&parameters, &shifted)?;
        let plain = |samples: &Samples, free: &FreeParameters| fit_observed(model, samples, free, settings, progress);
        return shifts::fit(samples, free, &shifted, settings, &plain);
    }
    if !frames::freed(free, &settings.hold).is_empty() {
        let plain = |samples: &Samples, free: &FreeParameters| fit_observed(model, samples, free, settings, progress);
        return frames::fit(model, samples, free, settings, &plain);
    }
    let clock = RecordingParameter::ClockOffset;
    if free.names_recording(clock) && !settings.hold.names_recording(clock) {
        let free = free.without_recording(&[clock]);
        let cost = |samples: &Samples| least_cost(model, samples, &free, settings);
        let found =
            clock::best_offset(model, samples, parameters.len(), 0.0, &cost).ok_or(InputError::NoClockOffset)?;
        let (within, kept) = clock::synchronised_within(samples, found.seconds);
        let mut fit = fit_observed(model, &within, &free, settings, progress)?;
        fit.renumber_outliers(&kept);
        return Ok(Fit { clock_offset: Some(found), ..fit });
    }
    let mut problem = Problem::new(model, samples, &parameters, settings)?;
    let optimum = problem.minimize(progress)?;
    let mut suspicious: Vec<String> = problem.missing_words().into_iter().collect();
    suspicious.extend(warnings::suspicious_units(model, samples));
    let mut fit = report(&mut *problem.residual, &problem.unknowns, optimum, samples, suspicious)?;
    fit.tell_nominal_values(model);
    Ok(fit)
}

/// Descents of one fit: its starts.
pub fn descent_count(settings: &Settings) -> usize {
    settings.starts.max(1) as usize
}

/// The optimum of a fit alone.
#[must_use = "check `converged` before using the parameters"]
#[derive(Clone, Debug)]
pub struct OptimalParameters {
    /// The calibrated model.
    pub model: Model,
    /// The free parameters, ordered by cable.
    pub parameters: Vec<Parameter>,
    /// False when the iteration limit was reached.
    pub converged: bool,
    /// Steps of the cable that needed most.
    pub iterations: u32,
    /// Weighted sum of squared residuals and priors after each step, all cables together.
    pub history: Vec<f64>,
}

/// Finds what [`fit`] finds without asking how well the data determine it: a small part of the time.
pub fn optimal_parameters(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &Settings,
) -> Result<OptimalParameters, InputError> {
    let parameters = checked_parameters(model, samples, free, settings)?;
    optimum_of(model, samples, &parameters, settings)
}

/// The same for a list of parameters.
pub(super) fn optimum_of(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
) -> Result<OptimalParameters, InputError> {
    let samples = &*model.with_lengths(samples)?;
    let mut problem = Problem::new(model, samples, parameters, settings)?;
    let end = problem.minimize(&unobserved)?.end;
    Ok(OptimalParameters {
        model: problem.model_at(&end.values)?,
        parameters: parameters.to_vec(),
        converged: end.converged(),
        iterations: end.iterations,
        history: end.trail.costs,
    })
}

/// Cost of the optimum from the values of a model, data and priors together; `None` if there is no fit.
pub(super) fn least_cost(model: &Model, samples: &Samples, free: &FreeParameters, settings: &Settings) -> Option<f64> {
    let settings = Settings { starts: 1, ..settings.clone() };
    optimal_parameters(model, samples, free, &settings).ok()?.history.last().copied()
}
