//! Optimal parameters of one model from measured poses and recorded lengths.

mod cautions;
mod descent;
mod input_error;
mod optimum;
#[cfg(test)]
mod tests;
pub(super) mod warnings;

use std::str::FromStr;

pub use input_error::InputError;
use serde::Serialize;

use super::elastostatic;
use super::identifiability::{Analysis, Correlation, analyse};
use super::starts::Basin;
use super::weights::Weights;
use crate::measurement::Samples;
use crate::model::{FreeParameters, Model, identified_kind};
use crate::robot::{Parameter, ParameterKind};
pub use crate::solve::Minimizer;

/// Assumptions and stop rules of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Parameters that stay at their value although `free` names them.
    pub hold: FreeParameters,
    /// Ridges towards the start value.
    pub priors: Vec<Prior>,
    /// Stop once the parameters are this near to the optimum, judged by the last steps (m; scales times the mean length).
    pub tolerance: f64,
    /// Way to the optimum.
    pub minimizer: Minimizer,
    /// Steps allowed for each cable.
    pub max_iterations: u32,
    /// A direction in parameter space with a larger standard deviation is reported as weak (m).
    pub weak_direction_limit: f64,
    /// Starts: the file's values and others, anchors up to 0.5 m away and compliances up to 10/3 times larger or smaller.
    pub starts: u32,
    /// Seed of the other starts.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            hold: FreeParameters::default(),
            priors: Vec::new(),
            tolerance: 1e-10,
            minimizer: Minimizer::default(),
            max_iterations: 200,
            weak_direction_limit: 0.1,
            starts: 1,
            seed: 0,
        }
    }
}

/// A ridge: parameters of this kind are normally distributed around their start values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prior {
    /// The kind of parameter.
    pub kind: ParameterKind,
    /// Standard deviation, in the parameter's unit.
    pub sigma: f64,
}

impl FromStr for Prior {
    type Err = InputError;

    /// Reads `platform-anchor=0.02`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let syntax = || InputError::PriorSyntax { text: text.to_owned() };
        let (name, value) = text.split_once('=').ok_or_else(syntax)?;
        let sigma: f64 = value.trim().parse().map_err(|_| syntax())?;
        if !(sigma > 0.0 && sigma.is_finite()) {
            return Err(syntax());
        }
        Ok(Self { kind: identified_kind(name.trim())?, sigma })
    }
}

/// Why the fit ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Status {
    /// The optimum is found and every parameter is determined.
    Converged,
    /// The data leave directions in parameter space open; the parameters are one of many optima.
    NotIdentifiable,
    /// The iteration limit was reached.
    NotConverged,
    /// The optimum is a model without a forward problem: more cables than degrees of freedom ended rigid.
    NotPredictive,
}

/// One identified parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Name, e.g. `frame-anchor[1].x`.
    pub name: String,
    /// Unit; empty for a ratio.
    pub unit: &'static str,
    /// Value of the robot as given; `None` where its file states none, so that the start is a neutral value or a guess.
    pub nominal: Option<f64>,
    /// Value before the fit.
    pub start: f64,
    /// Optimal value.
    pub value: f64,
    /// Standard deviation; `None` when the data do not determine it.
    pub sigma: Option<f64>,
    /// Value minus start.
    pub change: f64,
    /// Standard deviation of the prior, if there is one.
    pub prior_sigma: Option<f64>,
    /// True when the value lies on a bound, to rounding and the tolerance of the fit.
    pub at_bound: bool,
    /// Which parameter it is.
    #[serde(skip)]
    pub parameter: Parameter,
}

/// Outcome of a fit; `model` carries the best parameters found whatever the status.
#[must_use = "check `status` before using the parameters"]
#[derive(Clone, Debug)]
pub struct Fit {
    /// The calibrated model.
    pub model: Model,
    /// Why the fit ended.
    pub status: Status,
    /// The status in words, with numbers.
    pub reason: String,
    /// Steps of the cable that needed most.
    pub iterations: u32,
    /// Weighted sum of squared residuals and priors after each step, all cables together.
    pub history: Vec<f64>,
    /// The free parameters, ordered by cable.
    pub parameters: Vec<Estimate>,
    /// Rank, singular values, weak directions, correlations.
    pub analysis: Analysis,
    /// Noise that residuals and priors tell, in units of the stated accuracies, or of the assumed ones where none is stated
    /// (1 mm for lengths, 1 % of the mean for tensions): √((data + prior cost)/(rows + priors − parameters)) at that noise.
    /// Near 1 when model and sensors agree with the data; standard deviations of parameters grow with it when it exceeds 1 or
    /// no accuracy is stated. NaN where there are as many parameters as rows and priors.
    pub noise_factor: f64,
    /// The optima that the starts led to, best first. Cables of a kinematic model are identified apart, each from its own best
    /// start: the best optimum may then be one that no start led all cables to.
    pub basins: Vec<Basin>,
    /// Warnings in words: doubts about noise, bounds and rank.
    pub warnings: Vec<String>,
}

impl Fit {
    /// Correlations above the limit, for reports.
    pub fn correlations(&self) -> &[Correlation] {
        &self.analysis.correlations
    }
}

/// Noise assumed for a length when no sensor accuracy is known, until the residuals tell (m).
pub(super) const ASSUMED_NOISE: f64 = 1e-3;

/// Share of the mean tension assumed as the force sensors' noise where none is stated.
pub(super) const ASSUMED_TENSION_SHARE: f64 = 0.01;

/// Fits the free parameters of a model to samples.
///
/// Minimises Σ (ρ/σ)² + Σ ((p − p_start)/σ_prior)², ρ the modelled minus the recorded length (eq. 4.8), cable by cable,
/// within the parameters' bounds. Without free parameters it only tells how well the model fits.
pub fn fit(model: &Model, samples: &Samples, free: &FreeParameters, settings: &Settings) -> Result<Fit, InputError> {
    fit_observed(model, samples, free, settings, &|| ())
}

/// As [`fit`]; `progress` is called after each descent: [`descent_count`] times.
pub fn fit_observed(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &Settings,
    progress: &dyn Fn(),
) -> Result<Fit, InputError> {
    let parameters = checked_parameters(model, samples, free, settings)?;
    let samples = &*model.with_lengths(samples)?;
    let mut fit = if explains_tensions(model) {
        let optimum = elastostatic::find(model, samples, &parameters, settings, progress)?;
        elastostatic::report(samples, &parameters, optimum, settings)
    } else {
        let (optimum, weights) = optimum::find(model, samples, &parameters, settings, progress)?;
        report(model, samples, &parameters, &weights, optimum, settings)?
    };
    // the starts are those of a robot that may have been completed, with a wrench for instance
    fit.parameters.iter_mut().for_each(|estimate| estimate.nominal = estimate.parameter.get(model.robot()));
    Ok(fit)
}

/// True where poses, lengths and tensions are explained together, by cables in equilibrium; lengths of straight, rigid cables are explained
/// without tensions, cable by cable.
fn explains_tensions(model: &Model) -> bool {
    model.needs_tensions()
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
    let samples = &*model.with_lengths(samples)?;
    if explains_tensions(model) {
        let optimum = elastostatic::find(model, samples, &parameters, settings, &|| ())?;
        return Ok(OptimalParameters {
            model: optimum.calibrated().clone(),
            converged: optimum.converged(),
            iterations: optimum.iterations(),
            history: optimum.history().to_vec(),
            parameters,
        });
    }
    let (optimum, _) = optimum::find(model, samples, &parameters, settings, &|| ())?;
    Ok(OptimalParameters {
        model: optimum.calibrated(model)?,
        parameters,
        converged: optimum.converged(),
        iterations: optimum.iterations(),
        history: optimum.history(),
    })
}

fn checked_parameters(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &Settings,
) -> Result<Vec<Parameter>, InputError> {
    for (name, value) in [("tolerance", settings.tolerance), ("weak_direction_limit", settings.weak_direction_limit)] {
        if !(value > 0.0 && value.is_finite()) {
            return Err(InputError::Setting { name, value });
        }
    }
    if samples.is_empty() {
        return Err(InputError::NoSamples);
    }
    let (robot, data) = (model.cable_count(), samples.cable_count);
    if robot != data {
        return Err(InputError::CableCount { robot, data });
    }
    let parameters = free.parameters(model, &settings.hold)?;
    let of_drum = parameters.iter().map(|parameter| parameter.kind).find(|kind| kind.needs_motor_angles());
    if let Some(kind) = of_drum.filter(|_| samples.motor_angles.is_none()) {
        return Err(InputError::NoMotorAngles { kind });
    }
    let without_prior = |p: &&Parameter| prior_sigma(settings, p.kind).is_none();
    if explains_tensions(model) {
        let (rows, count) =
            (samples.len() * (model.dof() + model.cable_count()), parameters.iter().filter(without_prior).count());
        return match count > rows {
            true => Err(InputError::TooFewRows { parameters: count, rows, samples: samples.len() }),
            false => Ok(parameters),
        };
    }
    for cable in 0..model.cable_count() {
        let without_prior = |p: &&Parameter| p.cable == cable && prior_sigma(settings, p.kind).is_none();
        let count = parameters.iter().filter(without_prior).count();
        if count > samples.len() {
            return Err(InputError::TooFewSamples { cable: cable + 1, parameters: count, samples: samples.len() });
        }
    }
    Ok(parameters)
}

pub(super) fn prior_sigma(settings: &Settings, kind: ParameterKind) -> Option<f64> {
    settings.priors.iter().rev().find(|prior| prior.kind == kind).map(|prior| prior.sigma)
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
    let misfit = optimum.misfit(samples, settings).factor();
    let inflation = inflation(misfit, weights.absolute);
    let values: Vec<_> = optimum.ends.iter().map(|end| end.values).collect();
    let analysis = analyse(&calibrated, samples, &optimum.poses, &optimum.blocks, &values, inflation, settings);
    let estimates: Vec<Estimate> = parameters
        .iter()
        .zip(&analysis.sigmas)
        .map(|(parameter, &sigma)| estimate(model, &calibrated, *parameter, sigma, settings))
        .collect();
    let (status, reason) = verdict(&analysis, &estimates, optimum.converged(), settings);
    let mut warnings = analysis.warnings.clone();
    warnings.extend(warnings::suspicious_units(model, samples));
    let noise_factor = weights.noise * misfit;
    warnings.extend(warnings::of_fit(weights, noise_factor, &estimates));
    Ok(Fit {
        model: calibrated,
        status,
        reason,
        iterations: optimum.iterations(),
        history: optimum.history(),
        parameters: estimates,
        analysis,
        noise_factor,
        basins: optimum.basins,
        warnings,
    })
}

/// Factor of the standard deviations that the weights give: residuals that are smaller than stated accuracies are luck.
pub(super) fn inflation(misfit: f64, absolute: bool) -> f64 {
    match misfit.is_finite() {
        true if absolute => misfit.max(1.0),
        true => misfit,
        // nothing is left over to tell
        false => 1.0,
    }
}

pub(super) fn estimate(
    model: &Model,
    calibrated: &Model,
    parameter: Parameter,
    sigma: Option<f64>,
    settings: &Settings,
) -> Estimate {
    let (start, value) = (parameter.value(model.robot()), parameter.value(calibrated.robot()));
    Estimate {
        name: parameter.name(model.robot()),
        unit: parameter.unit(model.robot()),
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

/// Distance from a bound that is none, relative to the larger of bound and start value: steps to a bound end there to rounding.
const AT_BOUND: f64 = 1e-9;

fn is_at_bound(value: f64, start: f64, (lower, upper): (f64, f64)) -> bool {
    let near = |bound: f64| bound.is_finite() && (value - bound).abs() <= AT_BOUND * bound.abs().max(start.abs());
    value <= lower || value >= upper || near(lower) || near(upper)
}

pub(super) fn verdict(
    analysis: &Analysis,
    estimates: &[Estimate],
    converged: bool,
    settings: &Settings,
) -> (Status, String) {
    let count = estimates.len();
    if !converged {
        let limit = settings.max_iterations;
        return (
            Status::NotConverged,
            format!("the limit of {limit} iterations was reached before the parameters settled"),
        );
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
