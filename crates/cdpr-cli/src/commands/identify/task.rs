//! One identification: its fits, and errors on data that they saw and did not see.

use cdpr_calibration::fit::{self, descent_count};
use cdpr_calibration::{CrossValidationError, cross_validation_fits};
use cdpr_model::measurement::{Samples, Split};
use cdpr_model::model::Model;
use cdpr_reports::answers::ObjectiveAnswer;
use cdpr_study::{Driven, Identification, IdentificationData, compare_objectives, identify};

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

impl Task<'_> {
    pub(super) fn tell_about_unused_column(&self, output: &Output) {
        let Arguments { split, validation, .. } = self.arguments;
        if split.is_none() && validation.is_none() && Split::Column.folds(self.samples, 0).is_ok() {
            output.remark("all rows are fitted to; `--split column` holds out those that the column `set` names");
        }
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
        let data = IdentificationData { samples: self.samples, folds: &folds, other };
        let step = || self.progress.step_of_work();
        identify(self.model, data, &self.arguments.free, &self.settings(), &step).map_err(|error| self.refused(&error))
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

    /// The objective, with the errors of the calibrated model on a machine.
    pub(super) fn objective(&self, found: &Identification) -> Result<ObjectiveAnswer, Failure> {
        let settings = self.settings();
        let driven = |model: &Model| self.drive.map(|drive| drive.of(model)).transpose();
        let drive = |model: &Model| match driven(model) {
            Ok(None) => Driven::Nowhere,
            Ok(Some(accuracy)) => Driven::To(Box::new(accuracy)),
            Err(failure) => Driven::Refused(failure.message().to_owned()),
        };
        let objectives = match self.arguments.compare_objectives {
            true => compare_objectives(self.model, &found.train_samples, &self.arguments.free, &settings, &drive)
                .map_err(|error| Failure::refused(&self.arguments.data.name(), &error))?,
            false => Vec::new(),
        };
        Ok(ObjectiveAnswer {
            objective: settings.objective,
            minimize: settings.minimize,
            driven: driven(&found.fit.model)?,
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
}
