//! The answer of a comparison, for scripts and for people.

use cdpr::identification::fit::{Estimate, Status};
use cdpr::identification::selection::{Criterion, Judged, Judgement, RequirementOutcome, Selection};
use cdpr::identification::{Coverage, ErrorBlocks, coverage};
use serde::Serialize;

use super::Compared;
use crate::answer::Answer;
use crate::error_table::convergence_remark;
use crate::report::{Report, times};
use crate::table::{Table, cell};

/// What `select` and `demo` answer.
#[derive(Serialize)]
pub(crate) struct Selected {
    status: &'static str,
    robot: String,
    data: String,
    /// Of `data`; samples of a file for validation are told in `validation`.
    samples: usize,
    validation: String,
    criterion: Criterion,
    candidates: Vec<CandidateAnswer>,
    best: Option<String>,
    recommended: Option<String>,
    reason: String,
    /// The model that the robot runs before any calibration, against the recommended, else the best one.
    #[serde(skip_serializing_if = "Option::is_none")]
    as_given: Option<AsGiven>,
    /// Poses of the fit and of the validation.
    coverage: Coverage,
    seed: u64,
    warnings: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) out: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    timing: Option<Timing>,
}

#[derive(Serialize)]
struct CandidateAnswer {
    name: String,
    model: String,
    free: String,
    #[serde(flatten)]
    judged: Option<JudgedAnswer>,
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
}

#[derive(Serialize)]
struct JudgedAnswer {
    status: Status,
    reason: String,
    parameter_count: usize,
    iterations: u32,
    train: ErrorBlocks,
    validation: ErrorBlocks,
    folds: Vec<FoldAnswer>,
    /// Null for a candidate that cannot be judged by it.
    criterion: f64,
    standard_error: f64,
    /// Validation samples that criterion and standard error are of: those that all judged candidates answer.
    compared_samples: usize,
    /// The reason against judging the candidate.
    disqualified: Option<String>,
    rank: usize,
    condition: f64,
    condition_scaled: f64,
    singular_values: Vec<f64>,
    weak_directions: Vec<String>,
    weak_direction_count: usize,
    weak_direction_deviation_m: f64,
    /// Doubts about the parameters with their numbers: bounds, weak directions, a fit that did not end well.
    cautions: Vec<String>,
    noise_factor: f64,
    history: Vec<f64>,
    parameters: Vec<Estimate>,
    requirements: Vec<RequirementOutcome>,
    warnings: Vec<String>,
    #[serde(skip)]
    caution_words: String,
}

/// The criterion of the model as given, and how many times as large it is.
#[derive(Serialize)]
struct AsGiven {
    name: String,
    criterion: f64,
    ratio: f64,
}

impl AsGiven {
    /// Nothing where the verdict is about the model as given itself, or that is no candidate or cannot be judged.
    fn of(selection: &Selection) -> Option<Self> {
        let chosen = selection.recommended.or(selection.best)?;
        let given = selection.as_given().filter(|given| *given != chosen)?;
        let judged = |index: usize| selection.candidates[index].outcome.as_ref().ok().map(|judged| judged.criterion);
        let (before, after) = (judged(given)?, judged(chosen)?);
        let name = selection.candidates[given].name.clone();
        (before.is_finite() && after.is_finite()).then(|| Self { name, criterion: before, ratio: before / after })
    }
}

#[derive(Serialize)]
struct FoldAnswer {
    name: String,
    #[serde(flatten)]
    errors: ErrorBlocks,
}

/// Wall times: the only part of a result that differs between two runs.
#[derive(Serialize)]
struct Timing {
    total_s: f64,
    /// Mean time of one pose's cable lengths, in the order of the candidates.
    inverse_kinematics_us: Vec<Option<f64>>,
}

impl Selected {
    /// The answer without wall times, which is the same in every run.
    pub(crate) fn new(told: &Report<'_>) -> Self {
        let selection = told.selection;
        let name = |index: Option<usize>| index.map(|index| selection.candidates[index].name.clone());
        let chosen = selection.recommended.and_then(|index| selection.candidates[index].outcome.as_ref().ok());
        let mut warnings = told.warnings.to_vec();
        warnings.extend(chosen.iter().flat_map(|judgement| &judgement.fit.warnings).cloned());
        Self {
            status: if selection.recommended.is_some() { "recommended" } else { "none-good-enough" },
            robot: told.robot.name.clone(),
            data: told.data_name.to_owned(),
            samples: told.data_count,
            validation: told.validation_name.to_owned(),
            criterion: told.criterion,
            candidates: selection.candidates.iter().map(CandidateAnswer::new).collect(),
            best: name(selection.best),
            recommended: name(selection.recommended),
            reason: selection.reason.clone(),
            as_given: AsGiven::of(selection),
            coverage: coverage(told.robot, told.samples, told.folds),
            seed: told.seed,
            warnings,
            out: None,
            timing: None,
        }
    }

    /// The answer with wall times.
    pub(crate) fn with_timing(compared: &Compared) -> Self {
        let microseconds = |seconds: &Option<f64>| seconds.map(|seconds| 1e6 * seconds);
        let inverse_kinematics_us = compared.inverse_seconds.iter().map(microseconds).collect();
        Self {
            timing: Some(Timing { total_s: compared.seconds, inverse_kinematics_us }),
            ..Self::new(&compared.told())
        }
    }
}

impl CandidateAnswer {
    fn new(candidate: &Judged) -> Self {
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
        let fit = &judgement.fit;
        let fold = |(name, errors): &(String, ErrorBlocks)| FoldAnswer { name: name.clone(), errors: *errors };
        Self {
            status: fit.status,
            reason: fit.reason.clone(),
            parameter_count: fit.parameters.len(),
            iterations: fit.iterations,
            train: judgement.train,
            validation: judgement.validation,
            folds: judgement.folds.iter().map(fold).collect(),
            criterion: judgement.criterion,
            standard_error: judgement.standard_error,
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
            history: fit.history.clone(),
            parameters: fit.parameters.clone(),
            requirements: judgement.requirements.clone(),
            warnings: fit.warnings.clone(),
            caution_words: fit.caution_words(),
        }
    }
}

impl Answer for Selected {
    fn words(&self) -> String {
        let mut text = format!(
            "{}: {} samples of {}\njudged on {}\n\n{}\n",
            self.robot,
            self.samples,
            self.data,
            self.validation,
            self.table()
        );
        match &self.recommended {
            Some(name) => text.push_str(&format!("recommended: {name}\n  {}\n", self.reason)),
            None => text.push_str(&format!("no candidate is good enough\n  {}\n", self.reason)),
        }
        if let Some(AsGiven { name, criterion, ratio }) = &self.as_given {
            let value = self.criterion.format(*criterion);
            text.push_str(&format!("  today, `{name}` as given: {value}{}\n", times(*ratio)));
        }
        let chosen = self.candidates.iter().find(|candidate| Some(&candidate.name) == self.recommended.as_ref());
        let own = chosen.and_then(|candidate| candidate.judged.as_ref());
        for requirement in own.iter().flat_map(|judged| &judged.requirements) {
            text.push_str(&format!("  {requirement}: {}\n", if requirement.met { "met" } else { "broken" }));
        }
        for (index, remark) in self.warnings.iter().enumerate() {
            text.push_str(&format!("{}  {remark}\n", if index == 0 { "\nwarnings\n" } else { "" }));
        }
        if let Some(out) = &self.out {
            text.push_str(&format!("\nresults written to {out}: open {out}/report.html\n"));
        }
        text
    }

    fn is_negative(&self) -> bool {
        self.recommended.is_none()
    }
}

impl Selected {
    fn table(&self) -> String {
        let criterion = self.criterion;
        let unit = criterion.unit();
        let mut table = Table::with_heading(vec![
            "candidate".to_owned(),
            "free".to_owned(),
            format!("train {unit}"),
            format!("validation {unit}"),
            format!("± std. error {unit}"),
            "length rms mm".to_owned(),
            "rank".to_owned(),
            "condition".to_owned(),
            "caution".to_owned(),
        ])
        .left_column(8);
        for candidate in &self.candidates {
            let marker = if Some(&candidate.name) == self.recommended.as_ref() { "→ " } else { "  " };
            let mut cells = vec![format!("{marker}{}", candidate.name)];
            match &candidate.judged {
                Some(judged) => cells.extend([
                    judged.parameter_count.to_string(),
                    cell(Some(criterion.in_unit(criterion.of_blocks(&judged.train))), 3),
                    cell(Some(criterion.in_unit(judged.criterion)), 3),
                    cell(Some(criterion.in_unit(judged.standard_error)), 3),
                    cell(Some(1e3 * judged.validation.length_error_m.rms), 3),
                    judged.rank.to_string(),
                    cell(Some(judged.condition), 1),
                    judged.caution_words.clone(),
                ]),
                None => cells.extend([String::new(), "failed".to_owned()]),
            }
            table.row(cells);
        }
        let mut text = format!("error: {} on training and validation data\n\n{}", self.criterion.words(), table.text());
        for candidate in &self.candidates {
            if let Some(failure) = &candidate.failure {
                text.push_str(&format!("{} failed: {failure}\n", candidate.name));
            }
            let judged = candidate.judged.as_ref();
            if let Some(why) = judged.and_then(|judged| judged.disqualified.as_ref()) {
                text.push_str(&format!("{} cannot be judged: {why}\n", candidate.name));
            }
            let partly = judged.filter(|judged| judged.disqualified.is_none()).map(|judged| &judged.validation);
            if let Some(remark) = partly.and_then(|blocks| convergence_remark(blocks, "validation samples")) {
                text.push_str(&format!("{}: {remark}\n", candidate.name));
            }
        }
        text
    }
}
