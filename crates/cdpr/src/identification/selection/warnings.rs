//! Everything a reader has to know before using a choice: the one list that text, JSON and page tell.

use super::{Judgement, Selection, worse};
use crate::identification::evaluation::ErrorBlocks;
use crate::identification::fit::Fit;
use crate::identification::outliers::set_aside_warning;
use crate::identification::plausibility::Distrust;
use crate::measurement::Samples;

/// Warnings about a selection, in the order in which they are told.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Warnings {
    /// Doubts about the outcome itself, which stand before it.
    pub doubts: Vec<String>,
    /// Remarks about data and fit.
    pub remarks: Vec<String>,
}

impl Warnings {
    /// All of them, doubts first.
    pub fn all(&self) -> impl Iterator<Item = &String> {
        self.doubts.iter().chain(&self.remarks)
    }
}

/// Facts that speak for or against a fit, apart from the fit itself.
#[derive(Clone, Copy)]
pub struct Findings<'a> {
    /// Rules of plausibility that its errors break.
    pub distrust: &'a Distrust,
    /// Errors of the model as given, and of the fitted one.
    pub before_and_after: Option<[&'a ErrorBlocks; 2]>,
    /// Name of the model as given.
    pub as_given: &'a str,
    /// Remarks of those who read the samples.
    pub of_data: &'a [String],
}

impl Fit {
    /// Warnings about this fit alone.
    pub fn warnings_with(&self, findings: Findings<'_>) -> Warnings {
        self.gathered(findings, Vec::new(), None)
    }

    fn gathered(&self, findings: Findings<'_>, of_comparison: Vec<String>, unanswered: Option<String>) -> Warnings {
        let Findings { distrust, before_and_after, as_given, of_data } = findings;
        let of_outliers = self.warnings.first().filter(|_| !self.outliers.is_empty()).cloned();
        let mut doubts = distrust.reasons.clone();
        doubts.extend(of_outliers.into_iter().chain(of_comparison).chain(self.doubts()));
        doubts.extend(before_and_after.and_then(|[before, after]| worse_than(as_given, before, after)));
        let mut remarks: Vec<String> = Vec::new();
        for remark in of_data.iter().cloned().chain(self.warnings.iter().cloned()).chain(unanswered) {
            if !doubts.contains(&remark) && !remarks.contains(&remark) {
                remarks.push(remark);
            }
        }
        Warnings { doubts, remarks }
    }
}

fn worse_than(today: &str, before: &ErrorBlocks, after: &ErrorBlocks) -> Option<String> {
    let worse = worse::worse(before, after);
    (!worse.is_empty())
        .then(|| format!("worse than with `{today}` as given, which the robot runs today: {}", worse.join("; ")))
}

impl Selection {
    /// Index of the candidate that an answer is about: the recommended one, else the best, else the first that could be identified.
    pub fn shown(&self) -> Option<usize> {
        let judged = |index: &usize| self.candidates.get(*index).is_some_and(|candidate| candidate.outcome.is_ok());
        self.recommended.or(self.best).filter(judged).or_else(|| (0..self.candidates.len()).find(judged))
    }

    /// Warnings about the candidate of [`Selection::shown`]; `of_data` are remarks of those who read the samples.
    pub fn warnings(&self, samples: &Samples, of_data: &[String]) -> Warnings {
        let shown = self.shown().and_then(|index| self.candidates[index].outcome.as_ref().ok());
        let Some(judgement) = shown else { return Warnings { doubts: Vec::new(), remarks: of_data.to_vec() } };
        let judged = |index: usize| self.candidates[index].outcome.as_ref().ok();
        let given = self.as_given().filter(|_| self.recommended.is_some());
        let findings = Findings {
            distrust: &judgement.distrust,
            before_and_after: given.and_then(judged).map(|given| [&given.validation, &judgement.validation]),
            as_given: given.map_or("", |given| &self.candidates[given].name),
            of_data,
        };
        judgement.fit.gathered(findings, of_comparison(judgement, samples), unanswered(judgement))
    }
}

/// Samples that no candidate explains, and those that not all answer.
fn of_comparison(judgement: &Judgement, samples: &Samples) -> Vec<String> {
    let places: Vec<usize> = judgement.set_aside.iter().map(|&place| judgement.validation_samples[place]).collect();
    let aside = set_aside_warning(&places, judgement.validation_samples.len(), samples);
    let (compared, all) = (judgement.compared_samples, judgement.validation.samples);
    let is_part = judgement.disqualified.is_none() && compared > 0 && compared < all;
    let partly = is_part
        .then(|| format!("compared on the {compared} of {all} validation samples that all judged candidates answer"));
    aside.into_iter().chain(partly).collect()
}

/// Samples without a pose, with the reason of the first.
fn unanswered(judgement: &Judgement) -> Option<String> {
    let missing = &judgement.validation_errors.not_converged;
    let (row, reason) = missing.first()?;
    let sample = judgement.validation_samples.get(*row).unwrap_or(row) + 1;
    Some(format!(
        "the forward problem of {} of {} validation samples has no answer, so that they have no error of the pose; the first is sample \
         {sample}: {reason}",
        missing.len(),
        judgement.validation_samples.len()
    ))
}
