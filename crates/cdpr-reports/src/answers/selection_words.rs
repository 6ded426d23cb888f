//! The answer of a comparison, for people.

use cdpr_calibration::Verdict;
use cdpr_calibration::selection::SelectionCriterion;

use super::error_table::convergence_remark;
use super::frame_words::{frame_words, shift_words};
use super::identification_words::doubt_words;
use super::rating_answer::{above_least, has_others, largest};
use super::selection_summary::summary;
use super::{Answer, AsGiven, SelectionAnswer};
use crate::number_format::{NONE, condition, significant};
use crate::paragraphs::Paragraphs;
use crate::report::{times, value_and_error};
use crate::table::Table;

impl Answer for SelectionAnswer<'_> {
    fn words(&self, width: Option<usize>) -> String {
        let mut text =
            format!("{}: {} samples of {}\njudged on {}\n", self.robot, self.samples, self.data, self.validation);
        text.push_str(&doubt_words(&self.warnings.doubts));
        text.push_str(&format!("\n{}\n", table(self, width)));
        match &self.recommended {
            Some(name) => {
                let words = match self.verdict {
                    Verdict::Sound => "recommended",
                    Verdict::WithCaution => "recommended with caution",
                    _ => "the best that there is, not to be trusted",
                };
                text.push_str(&format!("{words}: {name}\n  {}\n", self.reason));
            }
            None => text.push_str(&format!("no candidate is good enough\n  {}\n", self.reason)),
        }
        if !self.rating.words.is_empty() {
            text.push_str(&format!("  {}\n", self.rating.words));
        }
        if let Some(AsGiven { name, criterion, standard_error, ratio }) = &self.as_given {
            let value = self.criterion.format_with_error(*criterion, *standard_error);
            text.push_str(&format!("  today, `{name}` as given: {value}{}\n", times(*ratio)));
        }
        if let Some(frames) = self.frames {
            frame_words(frames).lines().for_each(|line| text.push_str(&format!("  {line}\n")));
        }
        shift_words(self.shifts).lines().for_each(|line| text.push_str(&format!("  {line}\n")));
        if !self.untried.is_empty() {
            text.push_str(&format!("  not among the candidates: {}\n", self.untried.join("; ")));
        }
        let chosen = self.candidates.iter().find(|candidate| Some(candidate.name) == self.recommended.as_deref());
        let own = chosen.and_then(|candidate| candidate.judged);
        for requirement in own.iter().flat_map(|judged| &judged.requirements) {
            text.push_str(&format!("  {requirement}: {}\n", if requirement.met { "met" } else { "broken" }));
        }
        if let Some(table) = rating_table(self, width) {
            text.push_str(&format!("\n{table}"));
        }
        for (index, remark) in self.warnings.remarks.iter().enumerate() {
            text.push_str(&format!("{}  {remark}\n", if index == 0 { "\nwarnings\n" } else { "" }));
        }
        if let Some(out) = &self.out {
            text.push_str(&format!("\nresults written to {out}: open {out}/report.html\n"));
        }
        text
    }

    fn summary(&self, width: usize) -> Option<Paragraphs> {
        Some(summary(self, width))
    }

    fn is_negative(&self) -> bool {
        self.recommended.is_none() || self.verdict.is_negative()
    }

    fn may_be_accepted(&self) -> bool {
        self.recommended.is_some() && self.verdict.may_be_accepted()
    }
}

/// Candidates with their errors, and remarks on those that failed.
fn table(answer: &SelectionAnswer<'_>, width: Option<usize>) -> String {
    let criterion = answer.criterion;
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
    for candidate in &answer.candidates {
        let marker = if Some(candidate.name) == answer.recommended.as_deref() { "→ " } else { "  " };
        let mut cells = vec![format!("{marker}{}", candidate.name)];
        match candidate.judged {
            Some(judged) => {
                let (value, error) = value_and_error(criterion, judged.criterion, judged.standard_error);
                cells.extend([
                    judged.fit.parameters.len().to_string(),
                    significant(criterion.in_unit(criterion.of_blocks(&judged.train)), 3),
                    value,
                    error,
                    significant(1e3 * judged.validation.length_error_m.rms, 3),
                    judged.fit.analysis.rank.to_string(),
                    condition(judged.fit.analysis.condition),
                    judged.fit.caution_words(),
                ]);
            }
            None => cells.extend([String::new(), "failed".to_owned()]),
        }
        table.row(cells);
    }
    let mut text = format!("error: {} on training and validation data\n\n{}", answer.criterion, table.text(width));
    for candidate in &answer.candidates {
        if let Some(failure) = &candidate.failure {
            text.push_str(&format!("{} failed: {failure}\n", candidate.name));
        }
        let judged = candidate.judged;
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

/// The candidates by all criteria, for people; `None` if none rates them.
fn rating_table(answer: &SelectionAnswer<'_>, width: Option<usize>) -> Option<String> {
    let criteria = answer.rating.criteria;
    if !has_others(criteria) || answer.candidates.len() < 2 {
        return None;
    }
    let turns = largest(criteria, SelectionCriterion::Rotation, 0).is_some();
    let regions = answer.candidates.iter().any(|one| one.judged.is_some_and(|own| own.regions.is_some()));
    let unit = answer.criterion.unit();
    let mut heading = vec!["candidate".to_owned(), "ΔAIC".to_owned(), "ΔBIC".to_owned(), "relative %".to_owned()];
    heading.push("largest mm".to_owned());
    heading.extend(turns.then(|| "largest °".to_owned()));
    heading.extend(regions.then(|| format!("regions {unit}")));
    heading.extend(regions.then(|| format!("± std. error {unit}")));
    let mut table = Table::with_heading(heading);
    for (index, candidate) in answer.candidates.iter().enumerate() {
        let Some(own) = candidate.judged else { continue };
        let marker = if Some(candidate.name) == answer.recommended.as_deref() { "→ " } else { "  " };
        let relative = own.relative_position_error.map_or_else(|| NONE.to_owned(), |share| significant(1e2 * share, 3));
        let mut cells = vec![format!("{marker}{}", candidate.name)];
        cells.extend([above_least(criteria, "aic", index), above_least(criteria, "bic", index), relative]);
        cells.push(largest(criteria, SelectionCriterion::Position, index).unwrap_or_else(|| NONE.to_owned()));
        cells.extend(largest(criteria, SelectionCriterion::Rotation, index).filter(|_| turns));
        if let Some(held) = own.regions {
            cells.extend(<[String; 2]>::from(value_and_error(answer.criterion, held.criterion, held.standard_error)));
        }
        table.row(cells);
    }
    Some(format!("rated by other criteria (ΔAIC, ΔBIC: above the least of the same rows)\n\n{}", table.text(width)))
}
