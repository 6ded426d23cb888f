//! Everything a reader has to know before using a choice: the one list that text, JSON and page tell.

use super::{Judgement, Selection, worse};
use crate::identification::evaluation::ErrorBlocks;
use crate::identification::fit::Fit;
use crate::identification::outliers::set_aside_warning;
use crate::identification::plausibility::Distrust;
use crate::measurement::Samples;

/// Warnings in the order in which they are told.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Warnings {
    /// All of them.
    pub list: Vec<String>,
    /// Number of the first ones that doubt the outcome itself and stand before it; the others are remarks about data and fit.
    pub doubts: usize,
}

impl Warnings {
    /// Adds a doubt, behind those that are there.
    pub fn doubt(&mut self, words: Option<String>) {
        self.doubts += usize::from(words.is_some());
        words.into_iter().for_each(|words| self.list.insert(self.doubts - 1, words));
    }
}

/// The name of the model as given, its errors and those of the fitted one.
type Comparison<'a> = (&'a str, [&'a ErrorBlocks; 2]);

impl Fit {
    /// Warnings about this fit alone: rules of plausibility that its errors break, the model as given by name with its errors and
    /// those of the fitted one, and what those warn of who read the samples.
    pub fn warnings_with(&self, distrust: &Distrust, today: Comparison<'_>, of_data: &Warnings) -> Warnings {
        self.gathered(distrust, Some(today), Vec::new(), of_data)
    }

    /// The same where nothing compares it with the model as given.
    pub fn own_warnings(&self, of_data: &Warnings) -> Warnings {
        self.gathered(&Distrust::default(), None, Vec::new(), of_data)
    }

    /// Everything that a fit and its data are warned of: mistakes of the data stand first, for they explain the doubts that follow from them.
    fn gathered(
        &self,
        distrust: &Distrust,
        today: Option<Comparison<'_>>,
        of_comparison: Vec<String>,
        of_data: &Warnings,
    ) -> Warnings {
        let of_outliers = self.outlier_warning.clone();
        let (of_poses, remarks) = of_data.list.split_at(of_data.doubts);
        let mut list = of_poses.to_vec();
        list.extend(distrust.reasons.iter().cloned());
        list.extend(of_outliers.into_iter().chain(of_comparison).chain(self.doubts()));
        list.extend(today.and_then(|(name, [before, after])| worse_than(name, before, after)));
        let doubts = list.len();
        for remark in remarks.iter().chain(&self.warnings) {
            if !list.contains(remark) {
                list.push(remark.clone());
            }
        }
        Warnings { list, doubts }
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

    /// Warnings about the candidate of [`Selection::shown`]; `of_data` is what those warn of who read the samples.
    pub fn warnings(&self, samples: &Samples, of_data: &Warnings) -> Warnings {
        let judged = |index: usize| self.candidates[index].outcome.as_ref().ok();
        let Some(judgement) = self.shown().and_then(judged) else {
            return of_data.clone();
        };
        let given = self.as_given().filter(|_| self.recommended.is_some());
        let today = given.and_then(|given| {
            Some((self.candidates[given].name.as_str(), [&judged(given)?.validation, &judgement.validation]))
        });
        let mut of_data = of_data.clone();
        of_data.doubt(self.frames.clone());
        of_data.list.extend(unanswered(judgement));
        judgement.fit.gathered(&judgement.distrust, today, of_comparison(judgement, samples), &of_data)
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
