//! The answer of a comparison of candidates.

use cdpr_calibration::fit::{Estimate, ShiftEstimate};
use cdpr_calibration::selection::{JudgedCandidate, Judgement, SelectionCriterion, Warnings};
use cdpr_calibration::{Coverage, Outlier, RecordingFrames, Verdict, WorstCable, coverage};
use schemars::JsonSchema;
use serde::Serialize;

use super::RatingAnswer;
use super::summary_parts::MOST_CHANGES;
use crate::keys::table_schema::nullable_numbers;
use crate::keys::{
    CoverageKeys, Each, JudgementKeys, Maybe, OutlierKeys, RecordingFrameKeys, ShiftKeys, WarningKeys, Word,
};
use crate::report::Report;

/// Candidates with their errors on data held out, and the choice among them; keys and units as in `result.json`.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Selection")]
pub struct SelectionAnswer<'a> {
    /// Outcome in a word.
    pub status: &'static str,
    /// Name of the robot.
    pub robot: String,
    /// Source of the samples.
    pub data: String,
    /// Of `data`; samples of a file for validation are told in `validation`.
    pub samples: usize,
    /// Choice of the validation data, in words.
    pub validation: String,
    /// The error that decides.
    #[serde(with = "Word")]
    pub criterion: SelectionCriterion,
    /// The candidates, from simple to complex.
    pub candidates: Vec<CandidateAnswer<'a>>,
    /// Name of the candidate with the least criterion.
    pub best: Option<String>,
    /// Name of the recommended candidate.
    pub recommended: Option<String>,
    /// False where nothing is recommended, or nobody should work with what is; the warnings say why.
    pub trusted: bool,
    /// How far the recommended candidate, or without one the one that details are about, may be relied on.
    #[serde(skip)]
    pub verdict: Verdict,
    /// Indices of candidates.
    #[serde(skip)]
    pub places: Places,
    /// Reason of the outcome, in words.
    pub reason: String,
    /// Choices of all criteria, and whether they agree.
    pub rating: RatingAnswer<'a>,
    /// The model that the robot runs before any calibration, against the recommended, else the best one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub as_given: Option<AsGiven>,
    /// Effects and parameters that no candidate has, with the reason where robot file or data forbid them.
    pub untried: Vec<String>,
    /// Poses of the fit and of the validation.
    #[serde(with = "CoverageKeys")]
    pub coverage: Coverage,
    /// Outliers of the recommended candidate's fit, else of the best one's.
    #[serde(with = "Each::<OutlierKeys>")]
    pub outliers: &'a [Outlier],
    /// Frames of tracker and marker of the recommended, else the best candidate, where they were free.
    #[serde(flatten, with = "Maybe::<RecordingFrameKeys>")]
    #[schemars(with = "Option<RecordingFrameKeys>")]
    pub frames: Option<&'a RecordingFrames>,
    /// Changes of recorded lengths inside the record, of the same candidate, where they were free.
    #[serde(rename = "length_shifts", with = "Each::<ShiftKeys>", skip_serializing_if = "<[_]>::is_empty")]
    pub shifts: &'a [ShiftEstimate],
    /// Parameters of the same candidate that changed most.
    #[serde(skip)]
    pub largest_changes: Vec<Estimate>,
    /// Cable whose lengths the same candidate gets worst on validation data.
    #[serde(skip)]
    pub worst_cable: Option<WorstCable>,
    /// Seed of the bootstrap.
    pub seed: u64,
    /// Warnings for the reader, doubts about the outcome first.
    #[serde(flatten, with = "WarningKeys")]
    #[schemars(with = "WarningKeys")]
    pub warnings: Warnings,
    /// Folder of the result's files.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub out: Option<String>,
    /// Wall times.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub timing: Option<Timing>,
}

/// Indices of the candidates that an answer is about.
#[derive(Clone, Copy)]
pub struct Places {
    /// The recommended one.
    pub recommended: Option<usize>,
    /// The one with the least criterion.
    pub best: Option<usize>,
    /// The one that details are about.
    pub shown: Option<usize>,
    /// The model that the robot runs before any calibration.
    pub as_given: Option<usize>,
}

/// A candidate of a comparison.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Candidate")]
pub struct CandidateAnswer<'a> {
    /// Name.
    pub name: &'a str,
    /// Name in plain words, with the number of free parameters.
    pub label: String,
    /// Effects of the model.
    pub model: String,
    /// Free parameters.
    pub free: String,
    /// Fit and errors, where the candidate could be identified.
    #[serde(flatten, with = "Maybe::<JudgementKeys>")]
    #[schemars(with = "Option<JudgementKeys>")]
    pub judged: Option<&'a Judgement>,
    /// Reason why the candidate could not be identified.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
}

/// The criterion of the model as given, and how many times as large it is.
#[derive(Serialize, JsonSchema)]
#[schemars(transform = nullable_numbers)]
pub struct AsGiven {
    /// Name.
    pub name: String,
    /// Criterion of the model as given (m, rad or N).
    pub criterion: f64,
    /// Its standard error.
    #[serde(skip)]
    pub standard_error: f64,
    /// Criterion of the model as given, divided by that of the verdict's candidate.
    pub ratio: f64,
}

impl AsGiven {
    /// `None` if the verdict is about the model as given itself, or that is no candidate or cannot be judged.
    fn of(candidates: &[CandidateAnswer<'_>], places: Places) -> Option<Self> {
        let chosen = places.recommended.or(places.best)?;
        let given = &candidates[places.as_given.filter(|given| *given != chosen)?];
        let (Judgement { criterion, standard_error, .. }, after) =
            (given.judged?, candidates[chosen].judged?.criterion);
        let name = given.name.to_owned();
        let (criterion, standard_error) = (*criterion, *standard_error);
        (criterion.is_finite() && after.is_finite()).then(|| Self {
            name,
            criterion,
            standard_error,
            ratio: criterion / after,
        })
    }
}

/// Wall times: the only part of a result that differs between two runs.
#[derive(Serialize, JsonSchema)]
pub struct Timing {
    /// Time of the comparison (s).
    pub total_s: f64,
    /// Mean time of one pose's cable lengths, in the order of the candidates.
    pub inverse_kinematics_us: Vec<Option<f64>>,
}

impl<'a> SelectionAnswer<'a> {
    /// The answer without wall times, which is the same in every run.
    pub fn new(told: &Report<'a>) -> Self {
        let selection = told.selection;
        let candidates: Vec<CandidateAnswer<'a>> = selection.candidates.iter().map(CandidateAnswer::new).collect();
        let (recommended, best) = (selection.recommended, selection.best);
        let places = Places { recommended, best, shown: selection.shown(), as_given: selection.as_given() };
        let name = |index: Option<usize>| index.map(|index| candidates[index].name.to_owned());
        let shown = places.shown.and_then(|index| candidates[index].judged);
        let warnings = told.told_warnings();
        let verdict = told.verdict(&warnings);
        Self {
            status: recommended.map_or("none-good-enough", |_| told.status(verdict)),
            trusted: recommended.is_some() && verdict.is_trusted(),
            verdict,
            places,
            robot: told.robot.name.clone(),
            data: told.data_name.to_owned(),
            samples: told.data_count,
            validation: told.validation_name.to_owned(),
            criterion: told.criterion,
            best: name(best),
            recommended: name(recommended),
            reason: selection.reason.clone(),
            rating: RatingAnswer::new(&selection.rating),
            as_given: AsGiven::of(&candidates, places),
            untried: selection.untried.clone(),
            coverage: coverage(told.robot, told.samples, told.folds),
            outliers: shown.map_or(&[], |judgement| &judgement.fit.outliers),
            frames: shown.and_then(|judgement| judgement.fit.frames.as_ref()),
            shifts: shown.map_or(&[], |judgement| &judgement.fit.shifts),
            largest_changes: shown.map_or_else(Vec::new, |judgement| {
                judgement.fit.largest_changes(told.samples, MOST_CHANGES).into_iter().cloned().collect()
            }),
            worst_cable: shown.and_then(Judgement::worst_cable),
            seed: told.seed,
            warnings,
            candidates,
            out: None,
            timing: None,
        }
    }

    /// The same answer with the wall time of the comparison, and of one pose's cable lengths with each candidate (s).
    pub fn with_timing(self, seconds: f64, inverse_seconds: &[Option<f64>]) -> Self {
        let inverse_kinematics_us =
            inverse_seconds.iter().map(|seconds| seconds.map(|seconds| 1e6 * seconds)).collect();
        Self { timing: Some(Timing { total_s: seconds, inverse_kinematics_us }), ..self }
    }
}

impl<'a> CandidateAnswer<'a> {
    fn new(candidate: &'a JudgedCandidate) -> Self {
        Self {
            name: &candidate.name,
            label: candidate.candidate.label(candidate.outcome.as_ref().ok().map(|own| own.fit.parameters.len())),
            model: candidate.candidate.composition.to_string(),
            free: candidate.candidate.free.to_string(),
            judged: candidate.outcome.as_ref().ok(),
            failure: candidate.outcome.as_ref().err().map(ToString::to_string),
        }
    }
}
