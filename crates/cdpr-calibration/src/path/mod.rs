//! Penalties on parameters: what they cost in squares, which parameters leave, and the penalty that data held out choose (eq. 4.32, 4.38).
//!
//! Weights of rows, and for elastic models corrected poses and tensions, are those of least squares, so that the path ends there at λ = 0. From λ_max
//! on, the largest pull of the squares on a penalised parameter at the centre, every one stays there.

mod course;
mod part;
mod settings;
mod subproblem;
#[cfg(test)]
mod tests;
mod validation;

use super::cross_validation::reported_part;
use super::fit::{self, Fit, InputError, check_recording, checked_parameters};
use super::loss::Loss;
use super::residual::balance::start::checked_start;
use cdpr_model::measurement::{Fold, Samples};
use cdpr_model::model::{FreeParameters, Model};
use cdpr_model::reading::Keyword;
use cdpr_model::robot::Parameter;
use course::{Place, Question};
pub use settings::{PathSettings, Penalty, Towards};
use validation::{Validated, validated};

/// Least values along a penalty, from the largest down to 0.
#[derive(Clone, Debug)]
pub struct PenaltyPath {
    /// Penalties with their least values.
    pub points: Vec<PathPoint>,
    /// All free parameters, in the order of their values.
    pub parameters: Vec<PathParameter>,
    /// Point with the least error on data held out, where a place of the path predicts any.
    pub best: Option<usize>,
    /// Point of the largest penalty that is as good as the best on the same samples.
    pub chosen: Option<usize>,
    /// Names of the parameters that stay at the centre at the chosen penalty.
    pub left: Vec<String>,
    /// Calibrated model at the chosen penalty; as given where none is chosen.
    pub model: Model,
}

/// Least value at one penalty.
#[derive(Clone, Debug, PartialEq)]
pub struct PathPoint {
    /// λ: per metre of cable (lasso), per its square (ridge).
    pub lambda: f64,
    /// Parameters off the centre of the penalty, and those without penalty.
    pub parameter_count: usize,
    /// Mean error on data held out (SI).
    pub validation: Option<f64>,
    /// Its standard error by a bootstrap of blocks.
    pub standard_error: Option<f64>,
    /// χ² of data and priors, without the penalty.
    pub squares: f64,
    /// False where the limit of steps was reached.
    pub converged: bool,
    /// Values of all parameters.
    pub values: Vec<f64>,
    /// Their changes from the centre in metres of cable, which the penalty is of.
    pub changes_m: Vec<f64>,
}

/// One free parameter of a path.
#[derive(Clone, Debug, PartialEq)]
pub struct PathParameter {
    /// Name.
    pub name: String,
    /// Unit; empty for a ratio.
    pub unit: &'static str,
    /// Value at which it has no penalty.
    pub centre: f64,
    /// Whether the penalty acts on it.
    pub is_penalised: bool,
    /// Largest λ of the path at which it is off the centre; `None` where it never is or has no penalty.
    pub enters: Option<f64>,
}

/// Follows a penalty on the samples of a fit that are no outliers: from the penalty that holds everything to least squares.
///
/// `folds` are those of the samples; the path is of the training part of one fold, of all samples where several take turns. Only squares of
/// lengths and wrenches have a path: other objectives, robust losses that were asked for, frames and clocks are refused.
pub fn penalty_path(
    model: &Model,
    samples: &Samples,
    fit: &Fit,
    settings: &fit::Settings,
    free: &FreeParameters,
    path: &PathSettings,
    folds: &[Fold],
) -> Result<PenaltyPath, InputError> {
    is_path_of(free, settings)?;
    let settings = fit::Settings { loss: Loss::Squared, ..settings.clone() };
    let parameters = checked_parameters(model, samples, free, &settings)?;
    let folds = trusted(samples, fit, folds);
    let part = samples.subset(&reported_part(samples, &folds));
    let model = checked_start(model, &part, &parameters)?;
    let question = Question { model: &model, parameters: &parameters, settings: &settings, path };
    let places = question.follow(&part, None)?;
    let found = validated(&question, samples, &folds, part.len(), &places)?;
    Ok(told(&question, &places, found))
}

/// Refuses what is no sum of squares of the robot's parameters alone.
pub(super) fn is_path_of(free: &FreeParameters, settings: &fit::Settings) -> Result<(), InputError> {
    check_recording(free, settings)?;
    let is_robust = !matches!(settings.loss, Loss::Auto | Loss::Squared);
    if settings.is_other_objective() || is_robust {
        let words = match is_robust {
            true => format!("the loss `{}`", settings.loss.name()),
            false => format!("the {} of {} residuals", settings.minimize, settings.objective.name()),
        };
        return Err(InputError::PenaltyCost { words });
    }
    Ok(())
}

/// The folds without the outliers of a fit.
fn trusted(samples: &Samples, fit: &Fit, folds: &[Fold]) -> Vec<Fold> {
    let kept = fit.trusted_samples(samples.len());
    let of = |places: &[usize]| places.iter().copied().filter(|place| kept.binary_search(place).is_ok()).collect();
    let fold = |fold: &Fold| Fold { train: of(&fold.train), validation: of(&fold.validation), name: fold.name.clone() };
    folds.iter().map(fold).collect()
}

fn told(question: &Question<'_>, places: &[Place], found: Option<Validated>) -> PenaltyPath {
    let Question { model, parameters, .. } = question;
    let figure = |values: fn(&Validated) -> &Vec<f64>, k: usize| found.as_ref().map(|found| values(found)[k]);
    let point = |(k, place): (usize, &Place)| PathPoint {
        lambda: place.lambda,
        parameter_count: place.is_off.iter().filter(|is_off| **is_off).count(),
        validation: figure(|found| &found.errors, k).filter(|error| error.is_finite()),
        standard_error: figure(|found| &found.standard_errors, k).filter(|error| error.is_finite()),
        squares: place.squares,
        converged: place.converged,
        values: place.values.clone(),
        changes_m: place.changes.clone(),
    };
    let parameter = |(k, parameter): (usize, &Parameter)| {
        let is_penalised = question.is_penalised(parameter);
        let can_leave = is_penalised && question.path.penalty != Penalty::Ridge;
        let first = places.iter().find(|place| place.is_off[k]).filter(|_| can_leave);
        PathParameter {
            name: parameter.name(model.robot()),
            unit: parameter.unit(model.robot()),
            centre: question.centre(parameter),
            is_penalised,
            enters: first.map(|place| place.lambda),
        }
    };
    let all: Vec<PathParameter> = parameters.iter().enumerate().map(parameter).collect();
    let chosen = found.as_ref().map(|found| found.chosen);
    let values = chosen.map(|chosen| &places[chosen].values);
    let left = |(k, one): (usize, &PathParameter)| {
        chosen.filter(|&chosen| !places[chosen].is_off[k]).map(|_| one.name.clone())
    };
    PenaltyPath {
        points: places.iter().enumerate().map(point).collect(),
        best: found.as_ref().map(|found| found.best),
        chosen,
        left: all.iter().enumerate().filter_map(left).collect(),
        model: values.and_then(|values| model.with_parameters(parameters, values)).unwrap_or_else(|| (*model).clone()),
        parameters: all,
    }
}
