//! Candidates compared without measured poses, by what they predict of a machine's own sensors.

use std::ops::ControlFlow;

use super::by_band::{choose_by_band, doubts_of_band};
use super::comparison::{Compared, Comparing};
use super::settings::Settings;
use super::{CandidateFailure, InputError, JudgedCandidate, Judgement, Selection, SelectionCriterion};
use super::{comparison, map_all, preferences, rating, recommend, untried};
use crate::candidate::Candidate;
use crate::cross_validation::reported_part;
use crate::evaluation::Evaluation;
use crate::fit;
use crate::plausibility::{Distrust, distrust};
use crate::progress::SharedProgress;
use crate::self_calibration::{Calibrated, Calibrations};
use cdpr_model::measurement::{Fold, InternalSamples, Samples};
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;

/// Identifies every candidate on the training part of each fold without measured poses, judges it by what it predicts of the sensors on the validation part, and
/// recommends one as [`select`](super::select) does; with the samples at the poses that the candidate shown finds.
///
/// Each validation sample has the pose that its own rows tell, by the model as it is; its errors are residuals scaled for what the pose takes up of them. Models that
/// are as good as the best on the same samples are named as not told apart.
pub fn select_without_poses(
    robot: &Robot,
    candidates: &[Candidate],
    internal: &InternalSamples,
    folds: &[Fold],
    settings: &Settings,
    progress: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<(Selection, Samples), InputError> {
    if candidates.is_empty() {
        return Err(InputError::NoCandidates);
    }
    if folds.iter().all(|fold| fold.validation.is_empty()) {
        return Err(InputError::NoValidation);
    }
    let fit = fit::Settings { starts: settings.fit.starts.max(STARTS), ..settings.fit.clone() };
    let progress = &SharedProgress::of(progress);
    let problem = Problem { robot, internal, folds, settings: &fit, progress };
    let judge_one = |place: usize| (candidates[place].clone(), problem.judge(&candidates[place]));
    let outcomes = map_all(candidates.len(), judge_one);
    if progress.is_stopped() {
        return Err(InputError::Stopped);
    }
    let mut found = Vec::new();
    let mut judged = Vec::new();
    for (candidate, outcome) in outcomes {
        let (outcome, samples) = outcome.map_or_else(|error| (Err(error), None), |(own, at)| (Ok(own), Some(at)));
        judged.push(JudgedCandidate { name: candidate.to_string(), candidate, outcome });
        found.push(samples);
    }
    if let Some(error) = InputError::where_all_failed(&judged) {
        return Err(error);
    }
    let compared = Compared::Criterion(settings.criterion);
    comparison::compare(&mut judged, &Comparing { settings, compared, groups: &[] });
    for judgement in judged.iter_mut().filter_map(|candidate| candidate.outcome.as_mut().ok()) {
        let of_samples = std::mem::take(&mut judgement.distrust.reasons);
        judgement.distrust = distrust(robot, &judgement.fit.model, &internal.samples, &judgement.validation);
        judgement.distrust.reasons.extend(of_samples);
        judgement.distrust.reasons.extend(doubts_of_band(judgement.pose_band.as_ref(), internal));
    }
    let mut selection = recommend(judged, compared, settings.criterion);
    choose_by_band(&mut selection);
    let outcome = preferences::Outcome {
        candidates: &selection.candidates,
        best: selection.best,
        recommended: selection.recommended,
        groups: &[],
    };
    selection.rating = rating::rate(outcome, settings);
    selection.untried = untried::untried(robot, candidates, internal.samples.tensions.is_some());
    selection.reason.extend(not_told_apart(&selection, settings.criterion));
    let shown = selection.shown().and_then(|index| found.swap_remove(index));
    Ok((selection, shown.unwrap_or_else(|| internal.samples.clone())))
}

/// Starts of every fit, at least: lengths alone have local optima.
const STARTS: u32 = 5;

struct Problem<'a> {
    robot: &'a Robot,
    internal: &'a InternalSamples,
    folds: &'a [Fold],
    settings: &'a fit::Settings,
    progress: &'a SharedProgress<'a>,
}

impl Problem<'_> {
    /// The candidate judged, and all samples at the poses of its reported fit.
    fn judge(&self, candidate: &Candidate) -> Result<(Judgement, Samples), CandidateFailure> {
        let Self { internal, folds, settings, .. } = *self;
        let model = Model::new(self.robot.clone(), candidate.composition)?;
        let calibrations = Calibrations { model: &model, internal, free: &candidate.free, settings };
        let calibrated = |part: &[usize]| {
            let found = calibrations.from(part, &|| self.progress.silent());
            self.progress.report()?;
            found
        };
        let part = reported_part(&internal.samples, folds);
        let reported = calibrations.with_band(&part, &|| self.progress.silent());
        self.progress.report().map_err(fit::InputError::from)?;
        let reported = reported?;
        let train = reported.predict(&internal.subset(&part))?.blocks();
        let mut errors = Evaluation::default();
        for fold in folds {
            let own: Option<Calibrated> = if folds.len() == 1 { None } else { Some(calibrated(&fold.train)?) };
            errors.extend(&own.as_ref().unwrap_or(&reported).predict(&internal.subset(&fold.validation))?);
        }
        let places = folds.iter().flat_map(|fold| fold.validation.iter().copied()).collect();
        let sizes = folds.iter().map(|fold| (fold.name.clone(), fold.validation.len())).collect();
        let samples = reported.samples(internal)?;
        let Calibrated { fit, band: pose_band, doubts: reasons, .. } = reported;
        let distrust = Distrust { reasons };
        Ok((Judgement { pose_band, distrust, ..Judgement::new(fit, train, errors, places, sizes) }, samples))
    }
}

/// Words for the candidates that validation data do not tell from the best.
fn not_told_apart(selection: &Selection, criterion: SelectionCriterion) -> Option<String> {
    let judged = || {
        let outcomes = selection.candidates.iter().map(|one| (&one.name, one.outcome.as_ref().ok()));
        outcomes.filter_map(|(name, judgement)| Some((name, judgement.filter(|own| own.criterion.is_finite())?)))
    };
    let best_mean = selection.candidates.get(selection.best?)?.outcome.as_ref().ok()?.compared_mean;
    let is_near = |own: &Judgement| own.difference.is_some_and(|difference| difference.is_none(best_mean));
    let names: Vec<String> = judged().filter(|(_, own)| is_near(own)).map(|(name, _)| format!("`{name}`")).collect();
    (names.len() > 1).then(|| {
        format!(
            "; these data do not tell apart {}: the {criterion} of each is as good as that of the best on the same samples",
            names.join(", ")
        )
    })
}
