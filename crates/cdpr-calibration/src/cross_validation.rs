//! Errors on samples that fits have not seen, fold by fold.

use thiserror::Error;

use crate::evaluation::{Evaluation, EvaluationError, evaluate_fitted};
use crate::fit::{self, Fit, fit_observed};
use crate::progress::Progress;
use cdpr_model::measurement::{Fold, Samples};
use cdpr_model::model::{FreeParameters, Model};
use cdpr_model::robot::ParameterKind;

/// The reported fit, and the errors of fits on samples that they have not seen.
#[derive(Clone, Debug)]
pub struct CrossValidation {
    /// Fit to the training part of one fold; of several folds to all samples. Its outliers count within `part`, see
    /// [`Fit::renumber_outliers`].
    pub fit: Fit,
    /// Samples of the reported fit, by number from 0.
    pub part: Vec<usize>,
    /// Errors of the fitted models on the samples that their folds hold out.
    pub after: Evaluation,
    /// Errors of the model as given on the same samples; empty if its file says nothing of a load that is free.
    pub before: Evaluation,
}

/// Reason for which there is no cross-validation.
#[derive(Clone, Debug, PartialEq, Error)]
#[error(transparent)]
pub enum CrossValidationError {
    /// Data that do not fit the free parameters.
    Fit(#[from] fit::InputError),
    /// A fitted model that cannot be compared with the data.
    Evaluation(#[from] EvaluationError),
}

/// Fits that [`cross_validate`] makes: one for a single fold, else one for each and one to all samples.
pub fn cross_validation_fits(folds: &[Fold]) -> usize {
    if folds.len() == 1 { 1 } else { folds.len() + 1 }
}

/// Samples of the fit that is reported, by number from 0: the training part of one fold, all samples if several folds
/// take turns.
pub(crate) fn reported_part(samples: &Samples, folds: &[Fold]) -> Vec<usize> {
    if let [fold] = folds { fold.train.clone() } else { (0..samples.len()).collect() }
}

/// Fits a model to samples and judges fits on samples that they have not seen.
///
/// With one fold the fit to its training part is reported and judged; with several, a fit to all samples is reported
/// and each fold is judged by a fit of its own. The loss is chosen once, by the reported fit. `progress` is called after
/// each start of each fit.
pub fn cross_validate(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &fit::Settings,
    folds: &[Fold],
    progress: &Progress<'_>,
) -> Result<CrossValidation, CrossValidationError> {
    let part = reported_part(samples, folds);
    let reported = fit_observed(model, &samples.subset(&part), free, settings, progress)?;
    let own_settings = fit::Settings { loss: reported.loss, ..settings.clone() };
    let (mut after, mut before) = (Evaluation::default(), Evaluation::default());
    for fold in folds {
        let of_fold = match folds.len() {
            1 => None,
            _ => Some(fit_observed(model, &samples.subset(&fold.train), free, &own_settings, progress)?),
        };
        let fitted = of_fold.as_ref().unwrap_or(&reported);
        after.extend(&held_out_errors(fitted, samples, &fold.validation)?);
        let in_robot_frame = fitted.in_robot_frame(&samples.subset(&fold.validation));
        before.extend(&evaluate_given(model, &in_robot_frame, free)?);
    }
    Ok(CrossValidation { fit: reported, part, after, before })
}

/// Errors of a fitted model on samples that it has not seen, by their numbers from 0.
pub(crate) fn held_out_errors(
    fitted: &Fit,
    samples: &Samples,
    held_out: &[usize],
) -> Result<Evaluation, EvaluationError> {
    let as_fitted = match fitted.clock_offset {
        // the clocks of the whole recording: a pose at the edge of a fold needs its neighbours
        Some(_) => fitted.as_fitted(samples).subset(held_out),
        None => fitted.as_fitted(&samples.subset(held_out)),
    };
    evaluate_fitted(&fitted.model, &as_fitted)
}

/// Errors of a model as given; empty if the load is free and the robot's file says nothing of it.
pub fn evaluate_given(model: &Model, samples: &Samples, free: &FreeParameters) -> Result<Evaluation, EvaluationError> {
    match evaluate_fitted(model, samples) {
        Err(EvaluationError::Load(_)) if free.names(ParameterKind::Wrench) => Ok(Evaluation::default()),
        other => other,
    }
}
