//! Course of the residuals over one parameter (Figs. 6.11, 6.12), and the interval that the likelihood's profile gives.

#[cfg(test)]
mod tests;

use crate::progress::unobserved;

use super::settings::{ASSUMED_NOISE, ASSUMED_TENSION_SHARE, prior_sigma};
use super::{Fit, InputError, Settings};
use crate::evaluation::evaluate_fitted;
use crate::loss::Loss;
use crate::objective::Minimize;
use crate::problem::Problem;
use crate::residual::length_errors::length_errors;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, Robot};

/// Points of a profile on each side of the optimum, and how far they go in standard deviations.
const POINTS: i32 = 6;
const DEVIATIONS: f64 = 3.0;

/// Most steps towards an end of an interval, and the share of its length to which it is found.
const STEPS: u32 = 40;
const FOUND: f64 = 1e-4;

/// Share of a deviation at which the curvature is taken.
const NEAR: f64 = 0.25;

/// Standard deviations beyond which an interval counts as open.
const OPEN: f64 = 50.0;

/// Course of the weighted squares (of the objective) over one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// Name of the parameter.
    pub parameter: String,
    /// Its unit.
    pub unit: &'static str,
    /// Optimal value.
    pub value: f64,
    /// Linear standard deviation.
    pub sigma: f64,
    /// Half width of the linear 95 % interval in these ([`Analysis::quantile_95`](crate::Analysis)).
    pub quantile_95: f64,
    /// Rise of the weighted squares at the ends of the interval: the square of `quantile_95` times that of the noise that `sigma` is of.
    pub threshold: f64,
    /// Ends of the 95 % interval of the profile likelihood, the others refitted; `None` where it is open.
    pub interval: [Option<f64>; 2],
    /// Root mean square of the length residuals at the optimum (m).
    pub length_rms_m: f64,
    /// The same of the model as given, the level to compare with (m).
    pub given_length_rms_m: f64,
    /// Points from small to large values.
    pub points: Vec<ProfilePoint>,
}

/// One value of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePoint {
    /// Value minus the optimal one.
    pub shift: f64,
    /// Rise of the weighted squares, the other parameters held.
    pub held: f64,
    /// The same, the others refitted.
    pub refitted: f64,
    /// Root mean square of the length residuals, the others held (m).
    pub length_rms_m: f64,
    /// Mean position error of the prediction from the recorded lengths, the others held (m).
    pub position_mean_m: f64,
}

/// Profiles of these free parameters (places in [`Fit::parameters`]); of parameters that the data do not determine there is none.
///
/// Profiles are of the squares of the samples that are no outliers, in the frames and on the clock that were found; costs that are no sums of
/// squares are refused. Where parameters have priors and no accuracy is stated, the noise is what the residuals tell.
pub fn profiles(
    given: &Model,
    samples: &Samples,
    fit: &Fit,
    settings: &Settings,
    chosen: &[usize],
) -> Result<Vec<Profile>, InputError> {
    if settings.minimize != Minimize::Squares && !chosen.is_empty() {
        return Err(InputError::ProfileCost { minimize: settings.minimize });
    }
    let samples = fit.as_fitted(samples).subset(&fit.trusted_samples(samples.len()));
    let problem = Course::new(given, samples, fit, settings)?;
    chosen.iter().filter_map(|&place| problem.profile(place).transpose()).collect()
}

/// The problem of a fit near its optimum.
pub(crate) struct Course<'a> {
    fit: &'a Fit,
    pub(crate) settings: Settings,
    pub(crate) samples: Samples,
    pub(crate) parameters: Vec<Parameter>,
    /// Parameters with a prior at the centre of it, the others at their optimum.
    pub(crate) base: Model,
    given: &'a Model,
}

impl<'a> Course<'a> {
    pub(crate) fn new(
        given: &'a Model,
        mut samples: Samples,
        fit: &'a Fit,
        settings: &Settings,
    ) -> Result<Self, InputError> {
        let stated = samples.sigmas.length.is_some() || samples.sigmas.position.is_some();
        let weighs_priors = !settings.priors.is_empty() && !settings.is_other_objective();
        if !stated && weighs_priors && fit.noise_factor.is_finite() {
            samples.sigmas.length = Some(ASSUMED_NOISE * fit.noise_factor);
            let tensions = samples.tensions.as_ref().filter(|_| samples.sigmas.tension.is_none());
            let mean = tensions.map(|tensions| tensions.iter().sum::<f64>() / tensions.len() as f64);
            samples.sigmas.tension =
                mean.map(|mean| ASSUMED_TENSION_SHARE * mean * fit.noise_factor).or(samples.sigmas.tension);
        }
        let mut robot = fit.model.robot().clone();
        for estimate in fit.parameters.iter().filter(|estimate| estimate.prior_sigma.is_some()) {
            estimate.parameter.set(&mut robot, estimate.start);
        }
        Ok(Self {
            base: Model::new(robot, fit.model.composition())?,
            settings: Settings { starts: 1, loss: Loss::Squared, ..settings.clone() },
            parameters: fit.parameters.iter().map(|estimate| estimate.parameter).collect(),
            samples,
            fit,
            given,
        })
    }

    fn profile(&self, place: usize) -> Result<Option<Profile>, InputError> {
        let estimate = &self.fit.parameters[place];
        let Some(sigma) = estimate.sigma.filter(|sigma| *sigma > 0.0) else { return Ok(None) };
        let held_at_optimum = self.held(place, 0.0)?.0;
        let refitted_at_optimum = self.refitted(place, 0.0)?;
        let mut points = Vec::new();
        for step in -POINTS..=POINTS {
            let shift = DEVIATIONS * sigma * f64::from(step) / f64::from(POINTS);
            if !self.is_inside(place, shift) {
                continue;
            }
            let (held, model) = self.held(place, shift)?;
            let refitted = self.refitted(place, shift)? - refitted_at_optimum;
            points.push(ProfilePoint {
                shift,
                held: held - held_at_optimum,
                refitted,
                length_rms_m: length_rms(&model, &self.samples),
                position_mean_m: evaluate_fitted(&model, &self.samples)
                    .map_or(f64::NAN, |errors| errors.blocks().position_error_m.mean),
            });
        }
        let quantile_95 = self.fit.analysis.quantile_95;
        let threshold = quantile_95 * quantile_95 * self.noise_square(place, sigma, refitted_at_optimum)?;
        let end = |side: f64| -> Result<Option<f64>, InputError> {
            let rise = |shift: f64| Ok(self.refitted(place, side * shift)? - refitted_at_optimum - threshold);
            Ok(self.crossing(place, (side, sigma), &rise)?.map(|shift| estimate.value + side * shift))
        };
        Ok(Some(Profile {
            parameter: estimate.name.clone(),
            unit: estimate.unit,
            value: estimate.value,
            sigma,
            quantile_95,
            threshold,
            interval: [end(-1.0)?, end(1.0)?],
            length_rms_m: length_rms(&self.fit.model, &self.samples),
            given_length_rms_m: length_rms(self.given, &self.samples),
            points,
        }))
    }

    /// Square of the noise of a parameter in units of the weights, as its deviation has it: the rise one deviation away, by the curvature at the
    /// optimum. Correlated samples and residuals beyond the accuracies enlarge the one as they enlarge the other.
    fn noise_square(&self, place: usize, sigma: f64, refitted_at_optimum: f64) -> Result<f64, InputError> {
        let shifts = [-NEAR, NEAR].map(|fraction| fraction * sigma);
        let inside = shifts.into_iter().filter(|&shift| self.is_inside(place, shift));
        let rises = inside.map(|shift| Ok(self.refitted(place, shift)? - refitted_at_optimum));
        let rises: Vec<f64> = rises.collect::<Result<_, InputError>>()?;
        Ok(rises.iter().sum::<f64>() / (rises.len() as f64 * NEAR * NEAR))
    }

    /// Shift at which a rise goes through zero; `None` where it does not within the bounds and [`OPEN`] deviations.
    fn crossing(
        &self,
        place: usize,
        (side, sigma): (f64, f64),
        rise: &dyn Fn(f64) -> Result<f64, InputError>,
    ) -> Result<Option<f64>, InputError> {
        let (mut below, mut above) = (0.0, self.fit.analysis.quantile_95 * sigma);
        while self.is_inside(place, side * above) && rise(above)? < 0.0 {
            (below, above) = (above, 2.0 * above);
            if above > OPEN * sigma {
                return Ok(None);
            }
        }
        if !self.is_inside(place, side * above) {
            return Ok(None);
        }
        for _ in 0..STEPS {
            if above - below <= FOUND * above {
                break;
            }
            let middle = 0.5 * (below + above);
            if rise(middle)? < 0.0 { below = middle } else { above = middle }
        }
        Ok(Some(0.5 * (below + above)))
    }

    fn is_inside(&self, place: usize, shift: f64) -> bool {
        let (low, high) = self.parameters[place].bounds();
        let value = self.fit.parameters[place].value + shift;
        value >= low && value <= high
    }

    /// Weighted squares of the rows with one parameter shifted and the others held, and the model.
    fn held(&self, place: usize, shift: f64) -> Result<(f64, Model), InputError> {
        let model = self.shifted(self.fit.model.robot(), place, shift)?;
        let cost = self.least(&model, &[])?;
        Ok((cost + self.own_prior(place, shift), model))
    }

    /// Least weighted squares with one parameter shifted and the others free.
    fn refitted(&self, place: usize, shift: f64) -> Result<f64, InputError> {
        let mut others = self.parameters.clone();
        others.remove(place);
        let model = self.shifted(self.base.robot(), place, shift)?;
        Ok(self.least(&model, &others)? + self.own_prior(place, shift))
    }

    fn shifted(&self, robot: &Robot, place: usize, shift: f64) -> Result<Model, InputError> {
        let mut robot = robot.clone();
        self.parameters[place].set(&mut robot, self.fit.parameters[place].value + shift);
        Ok(Model::new(robot, self.base.composition())?)
    }

    /// ((p − p_start)/σ_prior)² of the shifted parameter.
    fn own_prior(&self, place: usize, shift: f64) -> f64 {
        let estimate = &self.fit.parameters[place];
        let sigma = prior_sigma(&self.settings, estimate.parameter.kind);
        sigma.map_or(0.0, |sigma| ((estimate.change + shift) / sigma).powi(2))
    }

    /// Least weighted squares of data and priors over these parameters.
    fn least(&self, model: &Model, parameters: &[Parameter]) -> Result<f64, InputError> {
        Ok(self.minimise(model, &self.samples, parameters)?.1)
    }

    /// The model at the least weighted squares over these parameters, and that sum.
    fn minimise(&self, model: &Model, samples: &Samples, parameters: &[Parameter]) -> Result<(Model, f64), InputError> {
        let samples = &*model.with_lengths(samples)?;
        let mut problem = Problem::new(model, samples, parameters, &self.settings)?;
        let end = problem.minimize(&unobserved)?.end;
        Ok((problem.model_at(&end.values)?, end.cost))
    }

    /// The model at the optimum of all parameters on other samples, from other start values; `None` where there is none.
    pub(crate) fn again(&self, base: &Model, samples: &Samples) -> Option<Model> {
        let (model, cost) = self.minimise(base, samples, &self.parameters).ok()?;
        cost.is_finite().then_some(model)
    }
}

/// Root mean square of modelled minus recorded lengths (m); not a number for models whose lengths depend on tensions.
fn length_rms(model: &Model, samples: &Samples) -> f64 {
    let Ok(recorded) = model.with_lengths(samples) else { return f64::NAN };
    let residuals: Vec<f64> = match model.needs_tensions() {
        true => evaluate_fitted(model, &recorded).map_or_else(|_| Vec::new(), |errors| errors.length),
        false => (0..samples.len()).flat_map(|sample| length_errors(model, &recorded, sample)).collect(),
    };
    (residuals.iter().map(|x| x * x).sum::<f64>() / residuals.len() as f64).sqrt()
}
