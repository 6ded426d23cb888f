//! One identification: its fits, and errors on data that they saw and did not see.

use cdpr_calibration::fit::{self, Fit, descent_count, fit_observed};
use cdpr_calibration::selection::Warnings;
use cdpr_calibration::{
    CourseStep, DoubtKind, ErrorBlocks, Evaluation, EvaluationError, Loss, ObjectiveValues, clock_warning, course,
    evaluate_fitted, frame_warning,
};
use cdpr_model::measurement::{Samples, Split};
use cdpr_model::model::Model;
use cdpr_model::robot::ParameterKind;
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

/// The reported fit, how many samples it was fitted to, those of them that are no outliers, and errors on data that it was not fitted
/// to (after, before).
pub(super) struct Identification {
    pub(super) fit: Fit,
    pub(super) samples: usize,
    pub(super) frame_warning: Option<String>,
    pub(super) train: Samples,
    pub(super) train_on_one_clock: Samples,
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

    /// A fit to all samples.
    fn of_all(&self, fit: Fit, validation: Option<(Evaluation, Evaluation)>) -> Result<Identification, Failure> {
        self.of(fit, self.samples, validation)
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

    /// Fits to all samples or to those of the one fold; several folds are only fitted to for judging.
    pub(super) fn identify(&self, other: Option<&Samples>) -> Result<Identification, Failure> {
        if let Some(other) = other {
            let fit = self.fit(self.samples)?;
            let validation = Some((
                self.evaluate(&fit.model, &fit.as_fitted(other))?,
                self.evaluate_given(&fit.in_robot_frame(other))?,
            ));
            return self.of_all(fit, validation);
        }
        let Some(split) = self.arguments.split else {
            return self.of_all(self.fit(self.samples)?, None);
        };
        let folds = split
            .folds(self.samples, self.arguments.seed)
            .map_err(|error| Failure::refused(&format!("{}: --split", self.arguments.data.name()), &error))?;
        self.progress.expect(self.descents(if folds.len() == 1 { 1 } else { folds.len() + 1 }));
        let (mut after, mut before) = (Evaluation::default(), Evaluation::default());
        // the loss is chosen once, by all data of the reported fit
        let everything: Vec<usize> = (0..self.samples.len()).collect();
        let part = if let [fold] = &folds[..] { &fold.train } else { &everything };
        let train = self.samples.subset(part);
        let reported = self.fit(&train)?;
        for fold in &folds {
            let held = self.samples.subset(&fold.validation);
            let of_fold = match folds.len() {
                1 => None,
                _ => Some(self.fit_under(reported.loss, &self.samples.subset(&fold.train))?),
            };
            let fit = of_fold.as_ref().unwrap_or(&reported);
            // the whole recording has the neighbours of a pose at the edge of a part
            let as_fitted = match fit.clock_offset {
                Some(_) => fit.as_fitted(self.samples).subset(&fold.validation),
                None => fit.as_fitted(&held),
            };
            after.extend(&self.evaluate(&fit.model, &as_fitted)?);
            before.extend(&self.evaluate_given(&fit.in_robot_frame(&held))?);
        }
        let mut result = self.of(reported, &train, Some((after, before)))?;
        result.fit.renumber_outliers(part);
        Ok(result)
    }

    pub(super) fn settings(&self) -> fit::Settings {
        self.arguments.settings()
    }

    /// Descents of this many fits.
    pub(super) fn descents(&self, fits: usize) -> usize {
        fits * descent_count(&self.settings())
    }

    fn fit(&self, samples: &Samples) -> Result<Fit, Failure> {
        self.fit_under(self.arguments.loss, samples)
    }

    fn fit_under(&self, loss: Loss, samples: &Samples) -> Result<Fit, Failure> {
        let step = || self.progress.step();
        let (free, settings) = (&self.arguments.free, fit::Settings { loss, ..self.settings() });
        let mut fit = fit_observed(self.model, samples, free, &settings, &step).map_err(|error| match error {
            fit::InputError::Parameters(error) => Failure::refused("--free or --hold", &error),
            error => Failure::refused(&self.arguments.data.name(), &error),
        })?;
        fit.warnings.extend(clock_warning(&fit, samples, free, &settings));
        Ok(fit)
    }

    /// Errors of a model that was fitted.
    fn evaluate(&self, model: &Model, samples: &Samples) -> Result<Evaluation, Failure> {
        evaluate_fitted(model, samples).map_err(|error| Failure::refused(&self.model.robot().name, &error))
    }

    /// Errors of the model as given; none where a file that a free wrench completes says nothing of the load.
    fn evaluate_given(&self, samples: &Samples) -> Result<Evaluation, Failure> {
        match evaluate_fitted(self.model, samples) {
            Err(EvaluationError::Load(_)) if self.arguments.free.names(ParameterKind::Wrench) => {
                Ok(Evaluation::default())
            }
            other => other.map_err(|error| Failure::refused(&self.model.robot().name, &error)),
        }
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
