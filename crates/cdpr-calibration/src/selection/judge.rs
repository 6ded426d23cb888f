//! Fits of one candidate to the training parts, and its errors on what each held out.

use super::settings::Settings;
use super::{CandidateFailure, Judgement};
use crate::candidate::Candidate;
use crate::cross_validation::{held_out_errors, reported_part};
use crate::evaluation::{Evaluation, evaluate_fitted};
use crate::fit::{self, Fit, fit_observed};
use crate::loss::Loss;
use crate::progress::SharedProgress;
use cdpr_model::measurement::{Fold, Samples, Split, SplitError};
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;

/// Samples and their parts, on which candidates are judged.
pub(super) struct Problem<'a> {
    pub(super) robot: &'a Robot,
    pub(super) samples: &'a Samples,
    pub(super) folds: &'a [Fold],
    /// Regions that are left out besides.
    pub(super) regions: &'a [Fold],
    pub(super) settings: &'a Settings,
    pub(super) progress: &'a SharedProgress<'a>,
}

/// So many regions of the samples of the reported fit, each left out in turn.
pub(super) fn regions(samples: &Samples, folds: &[Fold], count: usize) -> Result<Vec<Fold>, SplitError> {
    if count == 0 {
        return Ok(Vec::new());
    }
    let part = reported_part(samples, folds);
    let of_all = |places: Vec<usize>| places.into_iter().map(|place| part[place]).collect();
    let regions = Split::Region(count).folds(&samples.subset(&part), 0)?;
    let region = |fold: Fold| Fold { train: of_all(fold.train), validation: of_all(fold.validation), ..fold };
    Ok(regions.into_iter().map(region).collect())
}

impl Problem<'_> {
    pub(super) fn judge(&self, candidate: &Candidate) -> Result<Judgement, CandidateFailure> {
        let Self { samples, folds, .. } = *self;
        let model = Model::new(self.robot.clone(), candidate.composition)?;
        // the loss is chosen once, by all data of the reported fit
        let part = reported_part(samples, folds);
        let mut reported = self.fit_to(&model, candidate, (&part, self.settings.fit.loss))?;
        let train = samples.subset(&part);
        let train = reported.as_fitted(&train).subset(&reported.trusted_samples(train.len()));
        let train = evaluate_fitted(&reported.model, &train)?.blocks();
        reported.renumber_outliers(&part);
        let mut errors = Evaluation::default();
        let (mut validation_samples, mut fold_sizes) = (Vec::new(), Vec::new());
        for fold in folds {
            let own = match folds.len() {
                1 => None,
                _ => Some(self.fit_to(&model, candidate, (&fold.train, reported.loss))?),
            };
            errors.extend(&held_out_errors(own.as_ref().unwrap_or(&reported), samples, &fold.validation)?);
            validation_samples.extend(&fold.validation);
            fold_sizes.push((fold.name.clone(), fold.validation.len()));
        }
        let region_errors = self.errors_on_regions(&model, candidate, reported.loss)?;
        Ok(Judgement { region_errors, ..Judgement::new(reported, train, errors, validation_samples, fold_sizes) })
    }

    fn fit_to(
        &self,
        model: &Model,
        candidate: &Candidate,
        (part, loss): (&[usize], Loss),
    ) -> Result<Fit, fit::InputError> {
        let settings = fit::Settings { loss, ..self.settings.fit.clone() };
        let silent = || self.progress.silent();
        let fitted = fit_observed(model, &self.samples.subset(part), &candidate.free, &settings, &silent);
        self.progress.report()?;
        fitted
    }

    /// Errors on the regions left out besides; `None` without any.
    fn errors_on_regions(
        &self,
        model: &Model,
        candidate: &Candidate,
        loss: Loss,
    ) -> Result<Option<Evaluation>, CandidateFailure> {
        let mut errors = Evaluation::default();
        for region in self.regions {
            let fitted = self.fit_to(model, candidate, (&region.train, loss))?;
            errors.extend(&held_out_errors(&fitted, self.samples, &region.validation)?);
        }
        Ok((!self.regions.is_empty()).then_some(errors))
    }
}
