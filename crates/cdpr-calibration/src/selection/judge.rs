//! Fits of one candidate to the training parts, and its errors on what each held out.

use super::settings::Settings;
use super::{CandidateFailure, Judgement};
use crate::candidate::Candidate;
use crate::cross_validation::{held_out_errors, reported_part};
use crate::evaluation::{Evaluation, evaluate_fitted};
use crate::fit::{self, Fit, Status, fit_observed};
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
    /// A number for every sample, the same for repeated poses.
    pub(super) groups: &'a [usize],
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

/// Fit of the richest candidate that fits, to the part that is reported.
pub(super) struct Richest {
    pub(super) place: usize,
    pub(super) fit: Fit,
}

impl Richest {
    /// Loss of the other candidates where it is chosen by the data: squares if no sample is an outlier.
    fn loss(&self, asked: Loss) -> Loss {
        if asked == Loss::Auto && self.fit.outliers.is_empty() { Loss::Squared } else { asked }
    }
}

impl Problem<'_> {
    /// The candidate with the most parameters whose fit finds an optimum with a forward problem, and that fit; `None` if none does.
    pub(super) fn richest(&self, candidates: &[Candidate]) -> Option<Richest> {
        let part = reported_part(self.samples, self.folds);
        let model = |candidate: &Candidate| Model::new(self.robot.clone(), candidate.composition).ok();
        let count = |candidate: &Candidate| {
            candidate.free.parameters(&model(candidate)?, &self.settings.fit.hold).ok().map(|all| all.len())
        };
        let counted = candidates.iter().enumerate().filter_map(|(place, candidate)| Some((count(candidate)?, place)));
        let mut order: Vec<(usize, usize)> = counted.collect();
        order.sort_by_key(|&(count, place)| (std::cmp::Reverse(count), place));
        order.into_iter().find_map(|(_, place)| {
            let candidate = &candidates[place];
            let fit = self.fit_silently(&model(candidate)?, candidate, &part, self.settings.fit.loss).ok()?;
            matches!(fit.status, Status::Converged | Status::NotIdentifiable).then_some(Richest { place, fit })
        })
    }

    /// Returns the judgement of a candidate (`place`: its index); only outliers of `richest` are named.
    pub(super) fn judge(
        &self,
        candidate: &Candidate,
        place: usize,
        richest: Option<&Richest>,
    ) -> Result<Judgement, CandidateFailure> {
        let Self { samples, folds, .. } = *self;
        let model = Model::new(self.robot.clone(), candidate.composition)?;
        // the loss is chosen once, by all data of the reported fit
        let part = reported_part(samples, folds);
        let asked = self.settings.fit.loss;
        let mut reported = match richest {
            Some(own) if own.place == place => {
                self.progress.report().map_err(fit::InputError::from)?;
                own.fit.clone()
            }
            Some(other) => {
                let mut fit = self.fit_to(&model, candidate, &part, other.loss(asked))?;
                if asked != Loss::Squared {
                    fit.keep_outliers(&other.fit);
                }
                fit
            }
            None => self.fit_to(&model, candidate, &part, asked)?,
        };
        let train = samples.subset(&part);
        let train = reported.as_fitted(&train).subset(&reported.trusted_samples(train.len()));
        let train = evaluate_fitted(&reported.model, &train)?.blocks();
        reported.renumber_outliers(&part);
        let mut errors = Evaluation::default();
        let (mut validation_samples, mut fold_sizes) = (Vec::new(), Vec::new());
        for fold in folds {
            let own = match folds.len() {
                1 => None,
                _ => Some(self.fit_to(&model, candidate, &fold.train, reported.loss)?),
            };
            errors.extend(&held_out_errors(own.as_ref().unwrap_or(&reported), samples, &fold.validation)?);
            validation_samples.extend(&fold.validation);
            fold_sizes.push((fold.name.clone(), fold.validation.len()));
        }
        let region_errors = self.errors_on_regions(&model, candidate, reported.loss)?;
        Ok(Judgement { region_errors, ..Judgement::new(reported, train, errors, validation_samples, fold_sizes) })
    }

    fn fit_to(&self, model: &Model, candidate: &Candidate, part: &[usize], loss: Loss) -> Result<Fit, fit::InputError> {
        let fitted = self.fit_silently(model, candidate, part, loss);
        self.progress.report()?;
        fitted
    }

    /// A fit that is no step of the work that is reported.
    pub(super) fn fit_silently(
        &self,
        model: &Model,
        candidate: &Candidate,
        part: &[usize],
        loss: Loss,
    ) -> Result<Fit, fit::InputError> {
        let settings = fit::Settings { loss, ..self.settings.fit.clone() };
        let silent = || self.progress.silent();
        fit_observed(model, &self.samples.subset(part), &candidate.free, &settings, &silent)
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
            let fitted = self.fit_to(model, candidate, &region.train, loss)?;
            errors.extend(&held_out_errors(&fitted, self.samples, &region.validation)?);
        }
        Ok((!self.regions.is_empty()).then_some(errors))
    }
}
