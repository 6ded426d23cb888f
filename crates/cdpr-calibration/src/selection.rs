//! The simplest control model that is good enough, on data it was not fitted to.

mod by_band;
mod comparison;
mod criterion;
mod judge;
mod judgement;
mod preferences;
mod rating;
mod reason;
mod recording;
mod requirement;
mod settings;
mod soundness;
mod untried;
mod warnings;
mod without_poses;
mod worse;

pub use criterion::SelectionCriterion;
pub use judgement::{CandidateFailure, ComparedError, HeldOut, JudgedCandidate, Judgement};
pub use preferences::Preference;
pub use rating::Rating;
use std::ops::ControlFlow;

use crate::paired::repeated_poses;
use crate::progress::SharedProgress;
use comparison::{Compared, Comparing};

use reason::{Reason, nobody};
pub use requirement::{Requirement, RequirementError, RequirementOutcome};
pub use settings::Settings;
use thiserror::Error;
pub use warnings::Warnings;
pub use without_poses::select_without_poses;

use super::candidate::{Candidate, KnownTensions};
use super::clock_test::clock_warning;
use super::findings::{Examined, findings};
use super::fit::{self, Prior, frames_that_fit};
use super::plausibility::distrust;
use cdpr_model::finding::Finding;
use cdpr_model::measurement::{Fold, Samples, SplitError};
use cdpr_model::model::{Composition, RecordingParameter};
use cdpr_model::robot::Robot;

/// The comparison and its result.
#[derive(Clone, Debug)]
pub struct Selection {
    /// The candidates in the order given: from simple to complex.
    pub candidates: Vec<JudgedCandidate>,
    /// Index of the candidate with the smallest criterion.
    pub best: Option<usize>,
    /// Index of the recommended candidate; `None` when none meets the requirements.
    pub recommended: Option<usize>,
    /// The reason in words and numbers.
    pub reason: String,
    /// The same candidates by other criteria, and whether these agree.
    pub rating: Rating,
    /// Effects and parameters that no candidate has, with the reason where robot file or data forbid them.
    pub untried: Vec<String>,
    /// Frames of tracker and marker and the offset of the clocks that were freed in every candidate, since the data fit the robot no other way, in
    /// words.
    pub frames: Option<String>,
    /// The same where the offset of the clocks alone was freed.
    pub clock: Option<String>,
    /// Priors that nobody stated.
    pub assumed: Vec<Prior>,
    /// Findings about the candidate of [`Selection::shown`], by data, numbers and statics.
    pub findings: Vec<Finding>,
}

impl Selection {
    /// Findings about the candidate shown.
    fn examined(
        &self,
        given: &Robot,
        samples: &Samples,
        held_out: &[usize],
        richest: Option<&fit::Fit>,
    ) -> Vec<Finding> {
        let shown = self.shown().and_then(|index| self.candidates[index].outcome.as_ref().ok());
        let Some(judgement) = shown else { return Vec::new() };
        let (fit, position_error) = (&judgement.fit, judgement.validation.position_error_m.mean);
        findings(&Examined { given, samples, held_out, fit, richest: richest.unwrap_or(fit), position_error })
    }

    /// Adds a warning to the recommended, else the best candidate, where the clocks of poses and lengths differ.
    fn test_clock(&mut self, samples: &Samples, settings: &fit::Settings) {
        let Some(index) = self.recommended.or(self.best) else { return };
        let judged = &mut self.candidates[index];
        if let Ok(judgement) = &mut judged.outcome {
            let warning = clock_warning(&judgement.fit, samples, &judged.candidate.free, settings);
            judgement.fit.warnings.extend(warning);
        }
    }

    /// The model that a robot runs before any calibration, as far as it is among the candidates: point outlets with nothing
    /// freed, else the first with nothing freed.
    pub fn as_given(&self) -> Option<usize> {
        let is_given = |judged: &JudgedCandidate| judged.candidate.free.leaves_robot() && judged.outcome.is_ok();
        let is_plain = |judged: &JudgedCandidate| judged.candidate.composition == Composition::STANDARD;
        let plain = self.candidates.iter().position(|judged| is_given(judged) && is_plain(judged));
        plain.or_else(|| self.candidates.iter().position(is_given))
    }

    fn of(candidates: Vec<JudgedCandidate>, [best, recommended]: [Option<usize>; 2], reason: String) -> Self {
        let rating = Rating::default();
        Self {
            candidates,
            best,
            recommended,
            reason,
            rating,
            untried: Vec::new(),
            frames: None,
            clock: None,
            assumed: Vec::new(),
            findings: Vec::new(),
        }
    }
}

/// A comparison that cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum InputError {
    /// The caller's progress asked to stop.
    #[error("the work was stopped before its end, as its caller asked")]
    Stopped,
    /// No candidates.
    #[error("there are no candidates to compare")]
    NoCandidates,
    /// No validation data.
    #[error("there are no validation samples: no other data, no column `set`, and a split that leaves none")]
    NoValidation,
    /// Regions that cannot be left out.
    #[error("regions to leave out: {0}")]
    Regions(#[from] SplitError),
    /// Every candidate failed.
    #[error("no candidate could be identified; {name}: {reason}")]
    AllFailed {
        /// The first candidate.
        name: String,
        /// Its failure.
        reason: CandidateFailure,
    },
}

impl InputError {
    /// The failure of the first candidate where all of them failed.
    fn where_all_failed(judged: &[JudgedCandidate]) -> Option<Self> {
        let JudgedCandidate { name, outcome: Err(reason), .. } = judged.first()? else { return None };
        let all = judged.iter().all(|judged| judged.outcome.is_err());
        all.then(|| Self::AllFailed { name: name.clone(), reason: reason.clone() })
    }
}

/// Identifies every candidate on the training part of each fold, judges it on the validation part, and recommends the
/// first (simplest) one that is as good as the best on the same samples and meets the requirements.
///
/// Samples are outliers where the richest candidate that fits has them as such: what a simpler model does not explain is its misfit, not dirt.
/// Frames of tracker and marker and the offset of the clocks are freed in every candidate where the richest one fits the data much better with them, if the settings try it.
///
/// Validation samples that no candidate explains, beyond 8 robust standard deviations for all of them, are set aside for all alike unless
/// the loss is squared: an outlier in the data is nobody's error.
///
/// With one fold the reported fit is that of its training part; with several, of all samples. `progress` is called after
/// each fit, from any thread, and may stop the work; there are [`fit_count`] of them when every candidate can be fitted.
pub fn select(
    robot: &Robot,
    candidates: &[Candidate],
    samples: &Samples,
    folds: &[Fold],
    settings: &Settings,
    progress: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Selection, InputError> {
    if candidates.is_empty() {
        return Err(InputError::NoCandidates);
    }
    if folds.iter().all(|fold| fold.validation.is_empty()) {
        return Err(InputError::NoValidation);
    }
    let (candidates, frames) = in_needed_frames(robot, candidates, samples, folds, settings);
    let regions = judge::regions(samples, folds, settings.regions)?;
    let progress = &SharedProgress::of(progress);
    let groups = repeated_poses(robot, samples);
    let problem = judge::Problem { robot, samples, folds, regions: &regions, settings, progress, groups: &groups };
    let mut richest = problem.richest(&candidates);
    let (mut candidates, mut frames, mut clock) = (candidates, frames, None);
    let asked = richest.as_ref().filter(|_| settings.tries_recording);
    if let Some(needed) = asked.and_then(|richest| recording::needed(&problem, richest, &candidates)) {
        candidates = with_recording(&candidates, &needed.freed);
        richest = Some(needed.richest);
        match (needed.freed == [RecordingParameter::ClockOffset], frames.take()) {
            (true, before) => (frames, clock) = (before, Some(needed.words)),
            (false, Some(before)) => frames = Some(format!("{before}; {}", needed.words)),
            (false, None) => frames = Some(needed.words),
        }
    }
    let mut judged = judge_all(&problem, &candidates, richest.as_ref())?;
    for judgement in judged.iter_mut().filter_map(|candidate| candidate.outcome.as_mut().ok()) {
        let seen = judgement.fit.as_fitted(&samples.subset(&judgement.validation_samples));
        judgement.distrust = distrust(robot, &judgement.fit.model, &seen, &judgement.validation);
    }
    rating::inform(robot, samples, &mut judged, settings);
    soundness::judge(&mut judged, samples);
    let mut selection = recommend(judged, Compared::of(robot, settings), settings.criterion);
    let (best, recommended) = (selection.best, selection.recommended);
    selection.rating = rating::rate(
        preferences::Outcome { candidates: &selection.candidates, best, recommended, groups: &groups },
        settings,
    );
    let held_out = if let [fold] = folds { &fold.validation[..] } else { &[] };
    selection.findings = selection.examined(robot, samples, held_out, richest.as_ref().map(|richest| &richest.fit));
    // a cause that explains the residuals is not asked for again
    if selection.findings.iter().all(|finding| finding.explains.is_none()) {
        selection.test_clock(samples, &settings.fit);
    }
    selection.untried =
        untried::untried(robot, &candidates, KnownTensions::of(robot, samples) != KnownTensions::Unknown);
    selection.frames = frames;
    selection.clock = clock;
    selection.assumed.clone_from(&settings.assumed);
    Ok(selection)
}

/// Judges all candidates and compares them; outliers are those of the richest one that fits.
fn judge_all(
    problem: &judge::Problem<'_>,
    candidates: &[Candidate],
    richest: Option<&judge::Richest>,
) -> Result<Vec<JudgedCandidate>, InputError> {
    let judge_one = |place: usize| {
        let candidate = &candidates[place];
        let outcome = problem.judge(candidate, place, richest);
        JudgedCandidate { name: candidate.to_string(), candidate: candidate.clone(), outcome }
    };
    let mut judged = map_all(candidates.len(), judge_one);
    if problem.progress.is_stopped() {
        return Err(InputError::Stopped);
    }
    if let Some(error) = InputError::where_all_failed(&judged) {
        return Err(error);
    }
    let compared = Compared::of(problem.robot, problem.settings);
    comparison::compare(&mut judged, &Comparing { settings: problem.settings, compared, groups: problem.groups });
    Ok(judged)
}

/// The candidates with quantities of the recording free.
fn with_recording(candidates: &[Candidate], freed: &[RecordingParameter]) -> Vec<Candidate> {
    let with = |candidate: &Candidate| Candidate { free: candidate.free.with_recording(freed), ..candidate.clone() };
    candidates.iter().map(with).collect()
}

/// The candidates with frames of tracker and marker free where the poses fit the robot in no other way and none names them, and the words
/// that tell it.
fn in_needed_frames(
    robot: &Robot,
    candidates: &[Candidate],
    samples: &Samples,
    folds: &[Fold],
    settings: &Settings,
) -> (Vec<Candidate>, Option<String>) {
    let names_frames = |candidate: &Candidate| {
        RecordingParameter::FRAMES.into_iter().any(|frame| candidate.free.names_recording(frame))
    };
    let train = samples.subset(&folds[0].train);
    // frames are found by squares of lengths
    let needed = match candidates.iter().any(names_frames) || settings.fit.is_other_objective() {
        true => None,
        false => frames_that_fit(robot, &train, &settings.fit.hold),
    };
    let Some((freed, words)) = needed else { return (candidates.to_vec(), None) };
    let words = format!("{words}: free in every candidate, and the calibrated robot stays in the frame of its file");
    (with_recording(candidates, &freed), Some(words))
}

/// Fits that [`select`] makes: one of each candidate and fold, one of all samples where there are several folds, and one of each region
/// left out besides.
pub fn fit_count(candidates: &[Candidate], folds: &[Fold], settings: &Settings) -> usize {
    let of_one = if folds.len() == 1 { 1 } else { folds.len() + 1 };
    candidates.len() * (of_one + settings.regions)
}

#[cfg(feature = "parallel")]
fn map_all<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync + Send) -> Vec<T> {
    use rayon::prelude::*;
    (0..count).into_par_iter().map(work).collect()
}

#[cfg(not(feature = "parallel"))]
fn map_all<T>(count: usize, work: impl Fn(usize) -> T) -> Vec<T> {
    (0..count).map(work).collect()
}

/// Recommends the simplest candidate that is as good as the best and meets the requirements: of sound ones where there is one, else of all.
fn recommend(candidates: Vec<JudgedCandidate>, compared: Compared, criterion: SelectionCriterion) -> Selection {
    let judged: Vec<(usize, &Judgement)> =
        candidates.iter().enumerate().filter_map(|(index, c)| Some((index, c.outcome.as_ref().ok()?))).collect();
    // parameters on the way to an optimum are those of no model, however good their errors are
    let finite = || judged.iter().filter(|(_, own)| own.compared_mean.is_finite() && own.has_converged());
    let Some(&(best, best_judgement)) = finite().min_by(|a, b| a.1.compared_mean.total_cmp(&b.1.compared_mean)) else {
        let reason = nobody(&judged, &candidates, criterion);
        return Selection::of(candidates, [None, None], reason);
    };
    let is_as_good =
        |own: &Judgement| own.difference.is_some_and(|difference| difference.is_none(best_judgement.compared_mean));
    let as_good = || finite().filter(|(_, own)| is_as_good(own) && own.meets_requirements());
    let chosen = as_good().find(|(_, own)| own.unsound.is_none()).or_else(|| as_good().next());
    let text = Reason { names: &candidates, criterion, compared, best, best_mean: best_judgement.compared_mean };
    let (recommended, reason) = match chosen {
        Some(&(index, judgement)) => (Some(index), text.for_choice(index, judgement, &judged)),
        None => (None, text.for_none(&judged)),
    };
    Selection::of(candidates, [Some(best), recommended], reason)
}
