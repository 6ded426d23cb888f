//! The simplest control model that is good enough, on data it was not fitted to.

mod requirement;

pub use requirement::{Requirement, RequirementError, RequirementOutcome};
use serde::Serialize;
use thiserror::Error;

use super::candidate::Candidate;
use super::evaluation::{ErrorBlocks, Evaluation, evaluate};
use super::fit::{self, Fit};
use super::{bootstrap, fit::fit};
use crate::measurement::{Fold, Samples};
use crate::model::Model;
use crate::robot::Robot;

/// Which error decides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Criterion {
    /// Mean position error (m, eq. 3.4).
    #[default]
    Position,
    /// Mean rotation error (rad).
    Rotation,
    /// Mean over samples of the mean length error of the cables (m).
    Length,
    /// Mean over samples of the 2-norm of the tension errors (N); only models that know tensions have it.
    Tension,
}

impl Criterion {
    /// The quantity in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Position => "mean position error",
            Self::Rotation => "mean rotation error",
            Self::Length => "mean cable-length error",
            Self::Tension => "mean tension error (2-norm over cables)",
        }
    }

    /// Unit for people.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Rotation => "°",
            Self::Position | Self::Length => "mm",
            Self::Tension => "N",
        }
    }

    /// Name of the error figure that [`Requirement`] limits, without its unit.
    pub fn metric(self) -> &'static str {
        match self {
            Self::Position => "position_mean",
            Self::Rotation => "rotation_mean",
            Self::Length => "length_mean_abs",
            Self::Tension => "tension_mean_norm",
        }
    }

    /// A value (SI) in the unit for people.
    pub fn in_unit(self, value: f64) -> f64 {
        match self {
            Self::Rotation => value.to_degrees(),
            Self::Position | Self::Length => 1e3 * value,
            Self::Tension => value,
        }
    }

    /// The criterion out of error blocks (SI); NaN for a model that has none.
    pub fn of_blocks(self, blocks: &ErrorBlocks) -> f64 {
        match self {
            Self::Position => blocks.position_error_m.mean,
            Self::Rotation => blocks.rotation_error_rad.mean,
            Self::Length => blocks.length_error_m.mean_abs,
            Self::Tension => blocks.tension_error.map_or(f64::NAN, |error| error.mean_norm),
        }
    }

    /// A value for people: mm, degrees or N.
    pub fn format(self, value: f64) -> String {
        let value = self.in_unit(value);
        match self {
            Self::Rotation => format!("{value:.4}°"),
            Self::Position | Self::Length => format!("{value:.3} mm"),
            Self::Tension => format!("{value:.1} N"),
        }
    }

    /// The error of each sample.
    fn of(self, evaluation: &Evaluation) -> Vec<f64> {
        match self {
            Self::Position => evaluation.position.clone(),
            Self::Rotation => evaluation.rotation.clone(),
            Self::Length => {
                let mean = |errors: &[f64]| errors.iter().map(|x| x.abs()).sum::<f64>() / errors.len() as f64;
                evaluation.length.chunks(evaluation.cable_count.max(1)).map(mean).collect()
            }
            Self::Tension => (0..evaluation.len()).map(|sample| evaluation.tension_norm_of(sample)).collect(),
        }
    }
}

/// How candidates are compared.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// The error that decides.
    pub criterion: Criterion,
    /// Limits that a recommended candidate must keep on validation data.
    pub requirements: Vec<Requirement>,
    /// Priors, held parameters and tolerances of every fit.
    pub fit: fit::Settings,
    /// Seed of the bootstrap.
    pub seed: u64,
}

/// One candidate with everything known about it.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The candidate in the notation of the command line; also its name.
    pub name: String,
    /// The candidate.
    pub candidate: Candidate,
    /// What could be judged, or why the candidate could not be identified.
    pub outcome: Result<Judgement, String>,
}

/// Fit and errors of one candidate.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// Parameters from all training data; from all data when the folds take turns.
    pub fit: Fit,
    /// Errors on the data that `fit` was fitted to.
    pub train: ErrorBlocks,
    /// Errors on data that the predicting fit had not seen, all folds together.
    pub validation: ErrorBlocks,
    /// The same fold by fold.
    pub folds: Vec<(String, ErrorBlocks)>,
    /// Validation errors sample by sample, in the order of `validation_samples`.
    pub validation_errors: Evaluation,
    /// Indices of those samples in the data set.
    pub validation_samples: Vec<usize>,
    /// Mean of the criterion on validation data.
    pub criterion: f64,
    /// Its standard error by block bootstrap.
    pub standard_error: f64,
    /// The limits and how the candidate stands to them.
    pub requirements: Vec<RequirementOutcome>,
}

impl Judgement {
    fn meets_requirements(&self) -> bool {
        self.requirements.iter().all(|requirement| requirement.met)
    }
}

/// The comparison and its result.
#[derive(Clone, Debug)]
pub struct Selection {
    /// The candidates in the order given: from simple to complex.
    pub candidates: Vec<Judged>,
    /// Index of the candidate with the smallest criterion.
    pub best: Option<usize>,
    /// Index of the recommended candidate; `None` when none meets the requirements.
    pub recommended: Option<usize>,
    /// The reason in words and numbers.
    pub reason: String,
}

/// A comparison that cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum InputError {
    /// No candidates.
    #[error("there are no candidates to compare")]
    NoCandidates,
    /// No validation data.
    #[error("there are no validation samples: give --validation, a column `set`, or another --split")]
    NoValidation,
    /// Every candidate failed.
    #[error("no candidate could be identified; {name}: {reason}")]
    AllFailed {
        /// The first candidate.
        name: String,
        /// Why it failed.
        reason: String,
    },
}

/// Identifies every candidate on the training part of each fold, judges it on the validation part, and recommends the
/// first (simplest) one whose mean criterion lies within one standard error of the best and that meets the requirements.
///
/// With one fold the reported fit is that of its training part; with several, of all samples. `progress` is called after
/// each fit, from any thread; there are [`fit_count`] of them when every candidate can be fitted.
pub fn select(
    robot: &Robot,
    candidates: &[Candidate],
    samples: &Samples,
    folds: &[Fold],
    settings: &Settings,
    progress: &(dyn Fn() + Sync),
) -> Result<Selection, InputError> {
    if candidates.is_empty() {
        return Err(InputError::NoCandidates);
    }
    if folds.iter().all(|fold| fold.validation.is_empty()) {
        return Err(InputError::NoValidation);
    }
    let judge_one = |candidate: &Candidate| {
        let outcome = judge(robot, candidate, samples, folds, settings, progress);
        Judged { name: candidate.to_string(), candidate: candidate.clone(), outcome }
    };
    let judged = map_all(candidates, judge_one);
    if let Some(Judged { name, outcome: Err(reason), .. }) =
        judged.iter().all(|judged| judged.outcome.is_err()).then(|| &judged[0])
    {
        return Err(InputError::AllFailed { name: name.clone(), reason: reason.clone() });
    }
    Ok(recommend(judged, settings.criterion))
}

/// Fits that [`select`] makes: one of each candidate and fold, and one of all samples where there are several folds.
pub fn fit_count(candidates: &[Candidate], folds: &[Fold]) -> usize {
    let of_one = if folds.len() == 1 { 1 } else { folds.len() + 1 };
    candidates.len() * of_one
}

#[cfg(feature = "parallel")]
fn map_all<T: Send>(candidates: &[Candidate], work: impl Fn(&Candidate) -> T + Sync + Send) -> Vec<T> {
    use rayon::prelude::*;
    candidates.par_iter().map(work).collect()
}

#[cfg(not(feature = "parallel"))]
fn map_all<T>(candidates: &[Candidate], work: impl Fn(&Candidate) -> T) -> Vec<T> {
    candidates.iter().map(work).collect()
}

fn judge(
    robot: &Robot,
    candidate: &Candidate,
    samples: &Samples,
    folds: &[Fold],
    settings: &Settings,
    progress: &(dyn Fn() + Sync),
) -> Result<Judgement, String> {
    let model = Model::new(robot.clone(), candidate.composition).map_err(|error| error.to_string())?;
    let fit_to = |part: &Samples| {
        let fitted = fit(&model, part, &candidate.free, &settings.fit).map_err(|error| error.to_string());
        progress();
        fitted
    };
    let mut errors = Evaluation::default();
    let mut fold_blocks = Vec::new();
    let mut validation_samples = Vec::new();
    let mut single = None;
    for fold in folds {
        let train = samples.subset(&fold.train);
        let fitted = fit_to(&train)?;
        let evaluation =
            evaluate(&fitted.model, &samples.subset(&fold.validation)).map_err(|error| error.to_string())?;
        fold_blocks.push((fold.name.clone(), evaluation.blocks()));
        errors.extend(&evaluation);
        validation_samples.extend(&fold.validation);
        single = Some((fitted, train));
    }
    let (reported, train) = match single {
        Some(pair) if folds.len() == 1 => pair,
        _ => (fit_to(samples)?, samples.clone()),
    };
    let series = settings.criterion.of(&errors);
    let validation = errors.blocks();
    Ok(Judgement {
        train: evaluate(&reported.model, &train).map_err(|error| error.to_string())?.blocks(),
        fit: reported,
        requirements: settings.requirements.iter().map(|requirement| requirement.judge(&validation)).collect(),
        validation,
        folds: fold_blocks,
        criterion: series.iter().sum::<f64>() / series.len() as f64,
        standard_error: bootstrap::standard_error(&series, settings.seed),
        validation_errors: errors,
        validation_samples,
    })
}

fn recommend(candidates: Vec<Judged>, criterion: Criterion) -> Selection {
    let judged: Vec<(usize, &Judgement)> =
        candidates.iter().enumerate().filter_map(|(index, c)| Some((index, c.outcome.as_ref().ok()?))).collect();
    let finite = || judged.iter().filter(|(_, judgement)| judgement.criterion.is_finite());
    let Some(&(best, best_judgement)) = finite().min_by(|a, b| a.1.criterion.total_cmp(&b.1.criterion)) else {
        let reason = match criterion {
            Criterion::Tension => {
                "no candidate predicts a tension for every validation sample: that takes an elastic model and recorded tensions"
            }
            _ => "no candidate predicts a pose for every validation sample",
        };
        let reason = reason.to_owned();
        return Selection { candidates, best: None, recommended: None, reason };
    };
    let error = if best_judgement.standard_error.is_finite() { best_judgement.standard_error } else { 0.0 };
    let limit = best_judgement.criterion + error;
    let near = |judgement: &Judgement| judgement.criterion <= limit;
    let chosen = finite().find(|(_, judgement)| near(judgement) && judgement.meets_requirements());
    let text = Reason { names: &candidates, criterion, best, limit };
    let (recommended, reason) = match chosen {
        Some(&(index, judgement)) => (Some(index), text.for_choice(index, judgement, &judged)),
        None => (None, text.for_none(&judged)),
    };
    Selection { best: Some(best), recommended, reason, candidates }
}

/// Words for the outcome.
struct Reason<'a> {
    names: &'a [Judged],
    criterion: Criterion,
    best: usize,
    limit: f64,
}

impl Reason<'_> {
    fn for_choice(&self, index: usize, judgement: &Judgement, judged: &[(usize, &Judgement)]) -> String {
        let name = |index: usize| &self.names[index].name;
        let (words, value) = (self.criterion.words(), self.criterion.format(judgement.criterion));
        let limit = self.criterion.format(self.limit);
        let mut text = match index == self.best {
            true => format!(
                "`{}` has the smallest {words} on validation data, {value}, and no simpler candidate comes within one \
                 standard error of it ({limit})",
                name(index)
            ),
            false => format!(
                "`{}` is the simplest candidate whose {words} on validation data, {value}, lies within one standard error \
                 ({limit}) of the best, `{}`",
                name(index),
                name(self.best)
            ),
        };
        let simpler = judged.iter().rev().find(|(other, _)| *other < index);
        if let Some((other, rejected)) = simpler {
            let why = if rejected.criterion <= self.limit { "but breaks a requirement" } else { "" };
            let other_value = self.criterion.format(rejected.criterion);
            text.push_str(format!("; the next simpler one, `{}`, has {other_value} {why}", name(*other)).trim_end());
        }
        if judgement.fit.status != fit::Status::Converged {
            text.push_str(&format!(". Caution: {}", judgement.fit.reason));
        }
        text
    }

    fn for_none(&self, judged: &[(usize, &Judgement)]) -> String {
        let best = judged.iter().find(|(index, _)| *index == self.best);
        let broken = best.into_iter().flat_map(|(_, judgement)| &judgement.requirements).filter(|r| !r.met);
        let broken: Vec<String> = broken.map(ToString::to_string).collect();
        format!(
            "no candidate within one standard error of the best, `{}` ({}), meets the requirements; it breaks: {}",
            self.names[self.best].name,
            self.criterion.format(self.limit),
            if broken.is_empty() { "none itself".to_owned() } else { broken.join(", ") }
        )
    }
}
