//! One model identified from measurements, with errors on samples that it was fitted to and on samples that it was not.

use cdpr_calibration::fit::{Fit, Settings};
use cdpr_calibration::{
    CourseStep, CrossValidation, CrossValidationError, ErrorBlocks, Evaluation, Examined, Loss, ObjectiveValues,
    Progress, WorstCable, clock_warning, course, cross_validate, evaluate_fitted, evaluate_given, findings,
    frame_warning,
};
use cdpr_model::finding::Finding;
use cdpr_model::measurement::{Fold, Samples};
use cdpr_model::model::{FreeParameters, Model};

/// Samples that a model is identified from, and those that judge it.
#[derive(Clone, Copy, Debug)]
pub struct IdentificationData<'a> {
    /// Samples of the fit, or of all folds.
    pub samples: &'a Samples,
    /// Parts that are held out; empty if all samples are fitted to.
    pub folds: &'a [Fold],
    /// Other samples, which judge the fit instead of folds.
    pub other: Option<&'a Samples>,
}

/// A fit with the errors that judge it.
#[derive(Clone, Debug)]
pub struct Identification {
    /// The fit; outliers are numbered as the data are.
    pub fit: Fit,
    /// Number of samples that it was fitted to.
    pub sample_count: usize,
    /// Samples that it was fitted to without outliers, in the robot's frame, with the clocks of the record.
    pub train_samples: Samples,
    /// Errors of the calibrated model on these samples.
    pub train: ErrorBlocks,
    /// Errors of the model as given on these samples.
    pub train_before: ErrorBlocks,
    /// Errors of the calibrated model on samples that it was not fitted to; `None` if there are none.
    pub validation: Option<ErrorBlocks>,
    /// Errors of the model as given on these samples.
    pub validation_before: Option<ErrorBlocks>,
    /// Values of every objective for the calibrated model on the samples of the fit.
    pub objective_values: ObjectiveValues,
    /// Values of every objective for the model as given.
    pub objective_values_before: ObjectiveValues,
    /// Course of the fit; empty if it was not kept ([`Settings::keeps_course`]).
    pub course: Vec<CourseStep>,
    /// Doubt about the frames of the poses, in words.
    pub frame_warning: Option<String>,
    /// Validation samples that no error counts, in words.
    pub set_aside_warning: Option<String>,
    /// Findings about the fit, by data, numbers and statics.
    pub findings: Vec<Finding>,
    /// Cable whose lengths the calibrated model gets worst on the samples of the fit.
    pub worst_cable: Option<WorstCable>,
}

/// Identifies a model and judges it; `progress` is called after each start of each fit.
pub fn identify(
    model: &Model,
    data: IdentificationData<'_>,
    free: &FreeParameters,
    settings: &Settings,
    progress: &Progress<'_>,
) -> Result<Identification, CrossValidationError> {
    let IdentificationData { samples, folds, other } = data;
    let CrossValidation { mut fit, part, after, before } =
        cross_validate(model, samples, free, settings, folds, progress)?;
    let own = samples.subset(&part);
    let validation = match other {
        Some(other) => Some((
            evaluate_fitted(&fit.model, &fit.as_fitted(&other.clone().of_another_record()))?,
            evaluate_given(model, &fit.in_robot_frame(other), free)?,
        )),
        None => (!folds.is_empty()).then_some((after, before)),
    };
    let (validation, set_aside_warning) = match validation {
        Some((after, before)) => {
            let (blocks, warning) = validation_errors(&after, &before, settings.loss);
            (Some(blocks), warning)
        }
        None => (None, None),
    };
    let trusted = fit.trusted_samples(own.len());
    let train_samples = fit.in_robot_frame(&own).subset(&trusted);
    let frame_warning = frame_warning(model.robot(), &fit, &own, settings);
    let course = course(&own, &fit, settings)?;
    let errors = evaluate_fitted(&fit.model, &fit.as_fitted(&own).subset(&trusted))?;
    let errors_before = evaluate_given(model, &train_samples, free)?;
    fit.renumber_outliers(&part);
    let mean = |blocks: &ErrorBlocks| blocks.position_error_m.mean;
    let position_error = validation.as_ref().map_or_else(|| mean(&errors.blocks()), |[after, _]| mean(after));
    let found = examined(model, samples, other, &fit, position_error);
    // a cause that explains the residuals is not asked for again
    if found.iter().all(|finding| finding.explains.is_none()) {
        fit.warnings.extend(clock_warning(&fit, &own, free, settings));
    }
    let values = |errors| ObjectiveValues::of(model, &train_samples, errors, settings.rotation_length);
    Ok(Identification {
        sample_count: own.len(),
        train: errors.blocks(),
        train_before: errors_before.blocks(),
        validation: validation.map(|[after, _]| after),
        validation_before: validation.map(|[_, before]| before),
        objective_values: values(&errors),
        objective_values_before: values(&errors_before),
        fit,
        train_samples,
        course,
        frame_warning,
        set_aside_warning,
        findings: found,
        worst_cable: errors.worst_cable(),
    })
}

/// Findings about the fit by its samples and those that judge it, by the file's numbers and statics.
fn examined(model: &Model, samples: &Samples, other: Option<&Samples>, fit: &Fit, position_error: f64) -> Vec<Finding> {
    let joined = other.and_then(|other| samples.followed_by(other).ok());
    let held_out: Vec<usize> = joined.as_ref().map_or_else(Vec::new, |all| (samples.len()..all.len()).collect());
    let (samples, given) = (joined.as_ref().unwrap_or(samples), model.robot());
    findings(&Examined { given, samples, held_out: &held_out, fit, richest: fit, position_error })
}

/// Errors after and before without the samples that neither model explains, and how many these are, in words.
fn validation_errors(after: &Evaluation, before: &Evaluation, loss: Loss) -> ([ErrorBlocks; 2], Option<String>) {
    let aside = if loss == Loss::Squared { Vec::new() } else { after.unexplained_with(before) };
    if aside.is_empty() {
        return ([after.blocks(), before.blocks()], None);
    }
    let (count, all) = (aside.len(), after.len());
    let warning = format!(
        "outliers: {count} of {all} validation samples are left out of the errors, since neither the model as given nor the \
         identified one explains them"
    );
    let kept: Vec<usize> = (0..all).filter(|place| !aside.contains(place)).collect();
    let blocks = |errors: &Evaluation| if errors.is_empty() { errors.blocks() } else { errors.subset(&kept).blocks() };
    ([blocks(after), blocks(before)], Some(warning))
}
