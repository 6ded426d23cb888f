//! One identification: its fits, and errors on data that they saw and did not see.

use cdpr_calibration::fit::{self, Fit, descent_count};
use cdpr_calibration::selection::Warnings;
use cdpr_calibration::{
    CourseStep, CrossValidation, CrossValidationError, DoubtKind, ErrorBlocks, Evaluation, Loss, ObjectiveValues,
    clock_warning, course, cross_validate, cross_validation_fits, evaluate_fitted, evaluate_given, frame_warning,
};
use cdpr_model::measurement::{Samples, Split};
use cdpr_model::model::Model;
use cdpr_reports::answers::{self, IdentificationAnswer, ObjectiveAnswer};
use cdpr_study::{Driven, compare_objectives};

use super::Arguments;
use super::driving::Drive;
use crate::answer::Output;
use crate::failure::Failure;
use crate::progress::Progress;

/// One identification with its data.
pub(super) struct Task<'a> {
    pub(super) model: &'a Model,
    pub(super) samples: &'a Samples,
    pub(super) arguments: &'a Arguments,
    pub(super) drive: Option<&'a Drive>,
    pub(super) progress: &'a Progress,
}

/// The reported fit.
pub(super) struct Identification {
    pub(super) fit: Fit,
    /// Number of samples that it was fitted to.
    pub(super) samples: usize,
    pub(super) frame_warning: Option<String>,
    /// Samples that it was fitted to without outliers, in the robot's frame, with the clocks of the record.
    pub(super) train: Samples,
    /// The same with the clocks that it found.
    pub(super) train_on_one_clock: Samples,
    /// Errors of the calibrated model and of the model as given on samples that it was not fitted to.
    pub(super) validation: Option<(Evaluation, Evaluation)>,
    pub(super) course: Vec<CourseStep>,
}

impl Task<'_> {
    pub(super) fn tell_about_unused_column(&self, output: &Output) {
        let Arguments { split, validation, .. } = self.arguments;
        if split.is_none() && validation.is_none() && Split::Column.folds(self.samples, 0).is_ok() {
            output.remark("all rows are fitted to; `--split column` holds out those that the column `set` names");
        }
    }

    /// A fit to these samples.
    fn of(
        &self,
        fit: Fit,
        samples: &Samples,
        validation: Option<(Evaluation, Evaluation)>,
    ) -> Result<Identification, Failure> {
        let trusted = fit.trusted_samples(samples.len());
        let train_on_one_clock = fit.as_fitted(samples).subset(&trusted);
        let train = fit.in_robot_frame(samples).subset(&trusted);
        let frame_warning = frame_warning(self.model.robot(), &fit, samples, &self.settings());
        let course = course(samples, &fit, &self.settings())
            .map_err(|error| Failure::refused(&self.arguments.data.name(), &error))?;
        Ok(Identification { fit, samples: samples.len(), frame_warning, train, train_on_one_clock, validation, course })
    }

    /// Fits to all samples, or to folds of them; other samples, if given, judge the fit.
    pub(super) fn identify(&self, other: Option<&Samples>) -> Result<Identification, Failure> {
        let folds = match self.arguments.split.filter(|_| other.is_none()) {
            Some(split) => split
                .folds(self.samples, self.arguments.seed)
                .map_err(|error| Failure::refused(&format!("{}: --split", self.arguments.data.name()), &error))?,
            None => Vec::new(),
        };
        self.progress.expect(self.descents(cross_validation_fits(&folds)));
        let (free, settings) = (&self.arguments.free, self.settings());
        let found = cross_validate(self.model, self.samples, free, &settings, &folds, &|| self.progress.step_of_work());
        let CrossValidation { mut fit, part, after, before } = found.map_err(|error| self.refused(&error))?;
        let train = self.samples.subset(&part);
        fit.warnings.extend(clock_warning(&fit, &train, free, &settings));
        let validation = match other {
            Some(other) => Some((
                self.evaluate(&fit.model, &fit.as_fitted(other))?,
                self.evaluate_given(&fit.in_robot_frame(other))?,
            )),
            None => (!folds.is_empty()).then_some((after, before)),
        };
        let mut result = self.of(fit, &train, validation)?;
        result.fit.renumber_outliers(&part);
        Ok(result)
    }

    /// Refuses what a fit refuses, by the option or the file that is at fault.
    fn refused(&self, error: &CrossValidationError) -> Failure {
        match error {
            CrossValidationError::Fit(fit::InputError::Parameters(error)) => {
                Failure::refused("--free or --hold", error)
            }
            CrossValidationError::Fit(error) => Failure::refused(&self.arguments.data.name(), error),
            CrossValidationError::Evaluation(error) => Failure::refused(&self.model.robot().name, error),
        }
    }

    pub(super) fn settings(&self) -> fit::Settings {
        self.arguments.settings()
    }

    /// Descents of this many fits.
    pub(super) fn descents(&self, fits: usize) -> usize {
        fits * descent_count(&self.settings())
    }

    /// Errors of a model that was fitted.
    fn evaluate(&self, model: &Model, samples: &Samples) -> Result<Evaluation, Failure> {
        evaluate_fitted(model, samples).map_err(|error| Failure::refused(&self.model.robot().name, &error))
    }

    /// Errors of the model as given.
    fn evaluate_given(&self, samples: &Samples) -> Result<Evaluation, Failure> {
        evaluate_given(self.model, samples, &self.arguments.free)
            .map_err(|error| Failure::refused(&self.model.robot().name, &error))
    }

    /// Error figures without the samples that neither model explains, which a warning counts.
    fn blocks(&self, after: Evaluation, before: Evaluation, warnings: &mut Warnings) -> [ErrorBlocks; 2] {
        let aside = if self.arguments.loss == Loss::Squared { Vec::new() } else { after.unexplained_with(&before) };
        if aside.is_empty() {
            return [after.blocks(), before.blocks()];
        }
        let (count, all) = (aside.len(), after.len());
        warnings.remarks.push(format!(
            "outliers: {count} of {all} validation samples are left out of the errors, since neither the model as given nor the \
             identified one explains them"
        ));
        let kept: Vec<usize> = (0..all).filter(|place| !aside.contains(place)).collect();
        [&after, &before].map(|errors| if errors.is_empty() { errors.blocks() } else { errors.subset(&kept).blocks() })
    }

    /// The objective, with the errors of the calibrated model on the samples and on a machine.
    fn objective(&self, fit: &Fit, train: [&Evaluation; 2], samples: &Samples) -> Result<ObjectiveAnswer, Failure> {
        let settings = self.settings();
        let values = |errors| ObjectiveValues::of(self.model, samples, errors, settings.rotation_length);
        let driven = |model: &Model| self.drive.map(|drive| drive.of(model)).transpose();
        let drive = |model: &Model| match driven(model) {
            Ok(None) => Driven::Nowhere,
            Ok(Some(accuracy)) => Driven::To(Box::new(accuracy)),
            Err(failure) => Driven::Refused(failure.message().to_owned()),
        };
        let objectives = match self.arguments.compare_objectives {
            true => compare_objectives(self.model, samples, &self.arguments.free, &settings, &drive)
                .map_err(|error| Failure::refused(&self.arguments.data.name(), &error))?,
            false => Vec::new(),
        };
        Ok(ObjectiveAnswer {
            objective: settings.objective,
            minimize: settings.minimize,
            loss: fit.loss,
            objective_values: values(train[0]),
            objective_values_before: values(train[1]),
            certificate: fit.certificate.clone(),
            converged: fit.status != fit::Status::NotConverged,
            driven: driven(&fit.model)?,
            driven_before: driven(self.model)?,
            objectives,
        })
    }

    /// Data of the validation errors.
    pub(super) fn validation_name(&self) -> Option<String> {
        let Arguments { validation, split, .. } = self.arguments;
        let file = validation.as_ref().map(|path| path.display().to_string());
        file.or_else(|| split.map(|split| format!("held-out parts ({split})")))
    }

    pub(super) fn answer(
        &self,
        result: Identification,
        mut warnings: Warnings,
    ) -> Result<IdentificationAnswer, Failure> {
        let Identification { fit, samples, frame_warning, train, train_on_one_clock, validation, .. } = result;
        warnings.doubt(DoubtKind::Frames, frame_warning);
        let validation = validation.map(|(after, before)| self.blocks(after, before, &mut warnings));
        let errors = [self.evaluate(&fit.model, &train_on_one_clock)?, self.evaluate_given(&train)?];
        let objective = self.objective(&fit, [&errors[0], &errors[1]], &train)?;
        Ok(IdentificationAnswer::new(answers::Identification {
            model: self.model,
            free: self.arguments.free.to_string(),
            data: self.arguments.data.name(),
            samples,
            sigmas: train.sigmas,
            train: errors.map(|errors| errors.blocks()),
            fit,
            objective,
            validation_data: self.validation_name(),
            validation,
            warnings,
            out: self.arguments.out.as_ref().map(|path| path.display().to_string()),
        }))
    }
}
