//! Optimal parameters of one model from measured poses and recorded lengths.

mod answer;
mod cautions;
mod checks;
mod descent;
mod frames;
mod frozen;
mod input_error;
mod optimum;
mod profile;
mod robust;
mod settings;
#[cfg(test)]
mod tests;
pub(super) mod warnings;

use crate::progress::Progress;
use crate::progress::unobserved;
pub use answer::{Estimate, Fit, Status};
use checks::is_at_bound;
pub(super) use checks::length_residuals;
pub(super) use checks::{check_motor_angles, check_question, checked_parameters, explains_tensions};
pub use frames::{FrameEstimate, Gauge, RecordingFrames, frame_warning};
pub(super) use frames::{RowBlock, Wrenches, frames_that_fit};
pub(super) use frozen::FrozenLengths;
pub use input_error::InputError;
pub(super) use profile::Course;
pub use profile::{Profile, ProfilePoint, profiles};
pub(super) use settings::{ASSUMED_NOISE, ASSUMED_TENSION_SHARE, prior_sigma};
pub use settings::{Prior, RowWeights, Settings};

use super::clock;
use super::elastostatic;
use super::identifiability::{Analysis, KinematicState as State, analyse};
use super::likelihood::FittedRows;
use super::loss::{Loss, RobustLoss};
use super::noise::Noise;
use super::stopping::{StoppedBy, StoppingRule};
use super::weights::Weights;
use super::{objective, outliers};
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
    let samples = &*model.with_lengths(samples)?;
    if settings.is_other_objective() {
        objective::check_recording(free, settings)?;
        let mut fit = objective::fit(model, samples, &parameters, settings, progress)?;
        fit.tell_nominal_values(model);
        return Ok(fit);
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
    let mut fit = if explains_tensions(model) {
        let optimum = elastostatic::find(model, samples, &parameters, settings, progress)?;
        elastostatic::report(samples, &parameters, optimum, settings)
    } else {
        let (optimum, weights) = optimum::find(model, samples, &parameters, settings, progress)?;
        report(model, samples, &parameters, &weights, optimum, settings)?
    };
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
    if settings.is_other_objective() {
        let optimum = objective::optimum(model, samples, parameters, settings, &unobserved)?;
        return Ok(OptimalParameters {
            converged: optimum.end().converged(),
            iterations: optimum.end().iterations,
            history: optimum.end().trail.costs.clone(),
            parameters: parameters.to_vec(),
            model: optimum.into_calibrated(),
        });
    }
    if explains_tensions(model) {
        let optimum = elastostatic::find(model, samples, parameters, settings, &unobserved)?;
        return Ok(OptimalParameters {
            model: optimum.calibrated().clone(),
            converged: optimum.converged(),
            iterations: optimum.iterations(),
            history: optimum.trail().costs.clone(),
            parameters: parameters.to_vec(),
        });
    }
    let (optimum, _) = optimum::find(model, samples, parameters, settings, &unobserved)?;
    Ok(OptimalParameters {
        model: optimum.calibrated(model)?,
        parameters: parameters.to_vec(),
        converged: optimum.stopped().converged(),
        iterations: optimum.iterations(),
        history: optimum.trail().costs,
    })
}

/// Cost of the optimum from the values of a model, data and priors together; `None` if there is no fit.
pub(super) fn least_cost(model: &Model, samples: &Samples, free: &FreeParameters, settings: &Settings) -> Option<f64> {
    let settings = Settings { starts: 1, ..settings.clone() };
    optimal_parameters(model, samples, free, &settings).ok()?.history.last().copied()
}

fn report(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    weights: &Weights,
    optimum: optimum::Optimum,
    settings: &Settings,
) -> Result<Fit, InputError> {
    let calibrated = optimum.calibrated(model)?;
    let noise = Noise::of(&optimum.misfit(samples, settings), &optimum.norms, weights.absolute);
    let values: Vec<_> = optimum.ends.iter().map(|end| end.values).collect();
    let state = State { model: &calibrated, samples, poses: &optimum.poses, blocks: &optimum.blocks, values: &values };
    let (analysis, series) = analyse(&state, &optimum.norms, &noise, settings);
    let estimates: Vec<Estimate> = parameters
        .iter()
        .zip(&analysis.sigmas)
        .map(|(parameter, &sigma)| estimate(*parameter, parameter.value(model.robot()), &calibrated, sigma, settings))
        .collect();
    let (status, reason) = verdict(&analysis, &estimates, &optimum.stopped());
    let recorded = calibrated.with_lengths(samples)?;
    let outliers = outliers::named(&optimum.norms, samples, |sample| length_residuals(&calibrated, &recorded, sample));
    let loss = used(optimum.norms.loss);
    let mut warnings = analysis.warnings.clone();
    warnings.extend(warnings::suspicious_units(model, samples));
    let noise_factor = weights.noise * noise.factor;
    let row_weights =
        optimum.blocks.iter().map(|block| weights.of_cable(block.cable)[..samples.len()].to_vec()).collect();
    warnings.extend(warnings::of_fit(weights, noise_factor, &estimates));
    let trail = optimum.trail();
    Ok(Fit {
        model: calibrated,
        status,
        reason,
        stopped_by: optimum.stopped(),
        iterations: optimum.iterations(),
        history: trail.costs.clone(),
        trail,
        parameters: estimates,
        analysis,
        noise_factor,
        loss,
        loss_threshold: weights.noise * threshold(optimum.norms.loss),
        starts: optimum.starts,
        clock_offset: None,
        frames: None,
        certificate: None,
        samples: samples.len(),
        outlier_warning: outliers::warning(&outliers, samples.len(), loss),
        outliers,
        warnings,
        rows: Some(FittedRows {
            series,
            weights: row_weights,
            noise: weights.noise,
            norms: optimum.norms,
            absolute: weights.absolute,
            with_wrenches: false,
        }),
    })
}

/// The loss of an optimum.
pub(super) fn used(loss: Option<RobustLoss>) -> Loss {
    loss.map_or(Loss::Squared, |loss| loss.tail.loss())
}

/// C of the loss; infinite for least squares.
pub(super) fn threshold(loss: Option<RobustLoss>) -> f64 {
    loss.map_or(f64::INFINITY, |loss| loss.threshold)
}

pub(super) fn estimate(
    parameter: Parameter,
    start: f64,
    calibrated: &Model,
    sigma: Option<f64>,
    settings: &Settings,
) -> Estimate {
    let value = parameter.value(calibrated.robot());
    Estimate {
        name: parameter.name(calibrated.robot()),
        unit: parameter.unit(calibrated.robot()),
        nominal: None,
        start,
        value,
        sigma,
        change: value - start,
        prior_sigma: prior_sigma(settings, parameter.kind),
        at_bound: is_at_bound(value, start, parameter.bounds()),
        parameter,
    }
}

pub(super) fn verdict(analysis: &Analysis, estimates: &[Estimate], stopped: &StoppedBy) -> (Status, String) {
    let count = estimates.len();
    if !stopped.converged() {
        let reason = match stopped.rule {
            StoppingRule::IterationLimit => {
                format!("{stopped} was reached before the parameters settled")
            }
            _ => format!("the parameters did not settle: {stopped}"),
        };
        let weak = match analysis.weak_directions.len() {
            0 => String::new(),
            _ => format!("; the data hold them weakly along: {}", analysis.weak_directions.join("; ")),
        };
        return (Status::NotConverged, reason + &weak);
    }
    if count == 0 {
        return (Status::Converged, "nothing was free".to_owned());
    }
    let at_bounds = cautions::at_bounds(estimates).map_or_else(String::new, |words| format!("; {words}"));
    let directions = analysis.weak_directions.join("; ");
    if analysis.rank < count && analysis.undetermined > 0 {
        let rank = analysis.rank;
        let reason =
            format!("the data determine {rank} of {count} parameters{at_bounds}; not determined: {directions}");
        return (Status::NotIdentifiable, reason);
    }
    let reason = match analysis.weak_directions.len() {
        0 => format!("all {count} parameters are determined{at_bounds}"),
        _ => format!("all {count} parameters are determined{at_bounds}, but weakly along: {directions}"),
    };
    (Status::Converged, reason)
}
