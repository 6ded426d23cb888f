//! The answer of a comparison of candidates.

use cdpr_calibration::fit::Estimate;
use cdpr_calibration::selection::{
    HeldOut, JudgedCandidate, Judgement, RequirementOutcome, Selection, SelectionCriterion,
};
use cdpr_calibration::{Coverage, ErrorBlocks, Information, Loss, Outlier, RecordingFrames, Verdict, coverage};
use serde::Serialize;

use super::RatingAnswer;
use crate::report::Report;

/// Candidates with their errors on data held out, and the choice among them; keys and units as in `result.json`.
#[derive(Serialize)]
pub struct SelectionAnswer {
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
    pub criterion: SelectionCriterion,
    /// The candidates, from simple to complex.
    pub candidates: Vec<CandidateAnswer>,
    /// Name of the candidate with the least criterion.
    pub best: Option<String>,
    /// Name of the recommended candidate.
    pub recommended: Option<String>,
    /// False where nothing is recommended, or nobody should work with what is; the warnings say why.
    pub trusted: bool,
    /// How far the recommended candidate may be relied on; `None` without one.
    #[serde(skip)]
    pub verdict: Option<Verdict>,
    /// Reason of the outcome, in words.
    pub reason: String,
    /// Choices of all criteria, and whether they agree.
    pub rating: RatingAnswer,
    /// The model that the robot runs before any calibration, against the recommended, else the best one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub as_given: Option<AsGiven>,
    /// Effects and parameters that no candidate has, with the reason where robot file or data forbid them.
    pub untried: Vec<String>,
    /// Poses of the fit and of the validation.
    pub coverage: Coverage,
    /// Outliers of the recommended candidate's fit, else of the best one's.
    pub outliers: Vec<Outlier>,
    /// Frames of tracker and marker of the recommended, else the best candidate, where they were free.
    #[serde(flatten)]
    pub frames: Option<RecordingFrames>,
    /// Seed of the bootstrap.
    pub seed: u64,
    /// Warnings for the reader, doubts about the outcome first.
    pub warnings: Vec<String>,
    /// Number of these doubts.
    #[serde(skip)]
    pub doubts: usize,
    /// Folder of the result's files.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub out: Option<String>,
    /// Wall times.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub timing: Option<Timing>,
}

/// A candidate of a comparison.
#[derive(Serialize)]
pub struct CandidateAnswer {
    /// Name.
    pub name: String,
    /// Effects of the model.
    pub model: String,
    /// Free parameters.
    pub free: String,
    /// Fit and errors, where the candidate could be identified.
    #[serde(flatten)]
    pub judged: Option<JudgedAnswer>,
    /// Reason why the candidate could not be identified.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
}

/// Fit of a candidate and its errors.
#[derive(Serialize)]
pub struct JudgedAnswer {
    /// How far the candidate may be relied on, as `cdpr identify` tells it.
    pub status: &'static str,
    /// Reason of the outcome, in words.
    pub reason: String,
    /// Number of free parameters.
    pub parameter_count: usize,
    /// Steps of the fit.
    pub iterations: u32,
    /// Errors on the data of the fit.
    pub train: ErrorBlocks,
    /// Errors on data held out.
    pub validation: ErrorBlocks,
    /// Errors on data held out, fold by fold.
    pub folds: Vec<FoldAnswer>,
    /// Null for a candidate that cannot be judged by it.
    pub criterion: f64,
    /// Standard error of the criterion.
    pub standard_error: f64,
    /// Mean position error as a share of the diagonal of the validation positions (eq. 3.5).
    pub relative_position_error: Option<f64>,
    /// Criterion on regions left out, where they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leave_region_out: Option<HeldOut>,
    /// Likelihood and information criteria of the fit.
    #[serde(flatten)]
    pub information: Option<Information>,
    /// Validation samples that criterion and standard error are of: those that all judged candidates answer.
    pub compared_samples: usize,
    /// The reason against judging the candidate.
    pub disqualified: Option<String>,
    /// Rank of the Jacobian.
    pub rank: usize,
    /// Condition number of the Jacobian.
    pub condition: f64,
    /// Condition number with columns of length one.
    pub condition_scaled: f64,
    /// Singular values of the Jacobian, from large to small.
    pub singular_values: Vec<f64>,
    /// Combinations of parameters that the data hardly determine.
    pub weak_directions: Vec<String>,
    /// Number of these combinations.
    pub weak_direction_count: usize,
    /// Deviation that such a combination may have (m).
    pub weak_direction_deviation_m: f64,
    /// Doubts about the parameters with their numbers: bounds, weak directions, a fit that did not end well.
    pub cautions: Vec<String>,
    /// Residuals in units of the sensor accuracies.
    pub noise_factor: f64,
    /// The loss of the fit.
    pub loss: Loss,
    /// Its outliers.
    pub outliers: Vec<Outlier>,
    /// Validation samples that no candidate explains and no figure counts.
    pub set_aside_samples: usize,
    /// Weighted sum of squares after each step of the fit.
    pub history: Vec<f64>,
    /// Identified parameters.
    pub parameters: Vec<Estimate>,
    /// How late poses are recorded, where the offset of the clocks was free (s).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clock_offset_s: Option<f64>,
    /// Frames of tracker and marker, where they were free.
    #[serde(flatten)]
    pub frames: Option<RecordingFrames>,
    /// Requirements with their outcomes.
    pub requirements: Vec<RequirementOutcome>,
    /// False where nobody should work with the candidate: its errors break a rule of plausibility, or its fit found no optimum.
    pub trusted: bool,
    /// Reasons not to trust the candidate.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub distrust: Vec<String>,
    /// Warnings for the reader.
    pub warnings: Vec<String>,
    /// Cautions in few words.
    #[serde(skip)]
    pub caution_words: String,
}

/// The criterion of the model as given, and how many times as large it is.
#[derive(Serialize)]
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
    fn of(selection: &Selection) -> Option<Self> {
        let chosen = selection.recommended.or(selection.best)?;
        let given = selection.as_given().filter(|given| *given != chosen)?;
        let judged = |index: usize| selection.candidates[index].outcome.as_ref().ok();
        let (Judgement { criterion, standard_error, .. }, after) = (judged(given)?, judged(chosen)?.criterion);
        let name = selection.candidates[given].name.clone();
        let (criterion, standard_error) = (*criterion, *standard_error);
        (criterion.is_finite() && after.is_finite()).then(|| Self {
            name,
            criterion,
            standard_error,
            ratio: criterion / after,
        })
    }
}

/// Errors on the data that one fold held out.
#[derive(Serialize)]
pub struct FoldAnswer {
    /// Name.
    pub name: String,
    /// Errors on the validation samples of the fold.
    #[serde(flatten)]
    pub errors: ErrorBlocks,
}

/// Wall times: the only part of a result that differs between two runs.
#[derive(Serialize)]
pub struct Timing {
    /// Time of the comparison (s).
    pub total_s: f64,
    /// Mean time of one pose's cable lengths, in the order of the candidates.
    pub inverse_kinematics_us: Vec<Option<f64>>,
}

impl SelectionAnswer {
    /// The answer without wall times, which is the same in every run.
    pub fn new(told: &Report<'_>) -> Self {
        let selection = told.selection;
        let name = |index: Option<usize>| index.map(|index| selection.candidates[index].name.clone());
        let judged = |index: Option<usize>| index.and_then(|index| selection.candidates[index].outcome.as_ref().ok());
        let shown = judged(selection.shown());
        let warnings = told.told_warnings();
        let verdict = selection.recommended.map(|_| told.verdict(&warnings));
        Self {
            status: verdict.map_or("none-good-enough", |verdict| told.status(verdict)),
            trusted: verdict.is_some_and(Verdict::is_trusted),
            verdict,
            robot: told.robot.name.clone(),
            data: told.data_name.to_owned(),
            samples: told.data_count,
            validation: told.validation_name.to_owned(),
            criterion: told.criterion,
            candidates: selection.candidates.iter().map(CandidateAnswer::new).collect(),
            best: name(selection.best),
            recommended: name(selection.recommended),
            reason: selection.reason.clone(),
            rating: RatingAnswer::new(&selection.rating),
            as_given: AsGiven::of(selection),
            untried: selection.untried.clone(),
            coverage: coverage(told.robot, told.samples, told.folds),
            outliers: shown.map_or_else(Vec::new, |judgement| judgement.fit.outliers.clone()),
            frames: shown.and_then(|judgement| judgement.fit.frames.clone()),
            seed: told.seed,
            doubts: warnings.doubts.len(),
            warnings: warnings.list(),
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

impl CandidateAnswer {
    fn new(candidate: &JudgedCandidate) -> Self {
        Self {
            name: candidate.name.clone(),
            model: candidate.candidate.composition.to_string(),
            free: candidate.candidate.free.to_string(),
            judged: candidate.outcome.as_ref().ok().map(JudgedAnswer::new),
            failure: candidate.outcome.as_ref().err().map(ToString::to_string),
        }
    }
}

impl JudgedAnswer {
    fn new(judgement: &Judgement) -> Self {
        let (fit, verdict) = (&judgement.fit, judgement.verdict());
        let fold = |(name, errors): &(String, ErrorBlocks)| FoldAnswer { name: name.clone(), errors: *errors };
        Self {
            status: verdict.fit_status(),
            reason: fit.reason.clone(),
            parameter_count: fit.parameters.len(),
            iterations: fit.iterations,
            train: judgement.train,
            validation: judgement.validation,
            folds: judgement.folds.iter().map(fold).collect(),
            criterion: judgement.criterion,
            standard_error: judgement.standard_error,
            relative_position_error: judgement.relative_position_error,
            leave_region_out: judgement.regions,
            information: judgement.information,
            compared_samples: judgement.compared_samples,
            disqualified: judgement.disqualified.clone(),
            rank: fit.analysis.rank,
            condition: fit.analysis.condition,
            condition_scaled: fit.analysis.condition_scaled,
            singular_values: fit.analysis.singular_values.clone(),
            weak_directions: fit.analysis.weak_directions.clone(),
            weak_direction_count: fit.analysis.weak_direction_count,
            weak_direction_deviation_m: fit.analysis.weak_deviation,
            cautions: fit.cautions(),
            noise_factor: fit.noise_factor,
            loss: fit.loss,
            outliers: fit.outliers.clone(),
            set_aside_samples: judgement.set_aside.len(),
            history: fit.history.clone(),
            parameters: fit.parameters.clone(),
            clock_offset_s: fit.clock_offset.map(|clock| clock.seconds),
            frames: fit.frames.clone(),
            requirements: judgement.requirements.clone(),
            trusted: verdict.is_trusted(),
            distrust: judgement.distrust.reasons.iter().map(|doubt| doubt.words.clone()).collect(),
            warnings: fit.outlier_warning.iter().chain(&fit.warnings).cloned().collect(),
            caution_words: fit.caution_words(),
        }
    }
}
