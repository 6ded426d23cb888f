//! An identification on one screen: outcome, cautions, errors, largest changes, worst cable, range of the samples.

use cdpr_calibration::selection::Warnings;
use cdpr_calibration::{Verdict, coverage};

use super::Answer;
use super::error_table::headline_errors;
use super::frame_words::{frame_words, shift_words};
use super::identification_answer::IdentificationAnswer;
use super::identification_words::{all_words, clock_words, error_columns, verdict_words};
use super::reduction_answer::ReductionAnswer;
use super::start_words::start_words;
use super::summary_parts::{add_doubts, changes, counted, ranges, tone, worst_cable};
use crate::paragraphs::{Paragraphs, Tone};

/// The identification on one screen of so many columns, with what options asked for besides.
pub(super) fn summary(answer: &IdentificationAnswer, width: usize) -> Paragraphs {
    let IdentificationAnswer { robot, told, found, .. } = answer;
    let fit = &found.fit;
    let mut page = Paragraphs::default();
    page.add(Tone::Plain, &format!("{robot}: {} samples of {}", found.sample_count, told.data));
    page.gap();
    outcome(&mut page, answer.verdict, &answer.label, &fit.reason, &told.warnings);
    add_doubts(&mut page, &told.warnings);
    page.gap();
    page.add(Tone::Plain, &headline_errors(answer.pattern, &error_columns(found), Some(width)));
    page.add(
        Tone::Plain,
        &told.validation_data.iter().map(|name| format!("validation: {name}, not fitted to\n")).collect::<String>(),
    );
    page.gap();
    let table = changes(&answer.largest_changes, fit.parameters.len(), width);
    if !table.is_empty() {
        page.add(Tone::Plain, &table);
        page.gap();
    }
    page.add(Tone::Plain, &clock_words(fit));
    page.add(Tone::Plain, &fit.frames.as_ref().map(frame_words).unwrap_or_default());
    page.add(Tone::Plain, &shift_words(&fit.shifts));
    page.add(Tone::Plain, &worst_cable(found.worst_cable).unwrap_or_default());
    page.add(Tone::Plain, &ranges(&coverage(fit.model.robot(), &found.train_samples, &[])));
    if fit.starts.optima.len() > 1 {
        page.add(Tone::Plain, &start_words(&fit.starts, Some(width)));
    }
    page.add(Tone::Plain, &asked(answer, width));
    answer.asked_remarks.iter().for_each(|remark| page.add(Tone::Caution, &format!("caution: {remark}")));
    page.add(
        Tone::Plain,
        &told.out.iter().map(|path| format!("calibrated robot written to {path}\n")).collect::<String>(),
    );
    page.add(Tone::Plain, &more(told.warnings.remarks.len() - answer.asked_remarks.len(), fit.outliers.len()));
    page
}

/// Adds the outcome of a fit: its word and the name of the model, and the reason of its end where no doubt repeats it.
pub(super) fn outcome(page: &mut Paragraphs, verdict: Verdict, label: &str, reason: &str, warnings: &Warnings) {
    page.add(tone(verdict), &format!("{}: {label}", verdict_words(verdict).trim_end_matches(',')));
    let is_of_end = matches!(verdict, Verdict::NotConverged | Verdict::NotIdentifiable | Verdict::NotPredictive);
    if is_of_end && warnings.doubts.iter().all(|doubt| !doubt.words().contains(reason)) {
        page.add(Tone::Plain, &format!("  {reason}"));
    }
}

/// Sections that options ask for.
fn asked(answer: &IdentificationAnswer, width: usize) -> String {
    let width = Some(width);
    let mut text: String = answer.course.iter().map(|course| course.words(width)).collect();
    text.push_str(&answer.uncertainty.words(width));
    text.push_str(&answer.objective.words(&answer.found, answer.pattern, width));
    text.extend(answer.path.iter().map(|path| path.words(width)));
    text.extend(answer.reduction.iter().map(ReductionAnswer::words));
    text.extend(answer.scaling.iter().map(|scaling| scaling.words(width)));
    text
}

/// Sentence on where the rest is, with so many remarks and outliers in it.
pub(super) fn more(remarks: usize, outliers: usize) -> String {
    let counts = [(remarks, "warning"), (outliers, "outlier")];
    let counts: String =
        counts.into_iter().filter(|(count, _)| *count > 0).map(|(count, noun)| counted(count, noun) + ", ").collect();
    format!("more with --verbose: {counts}every parameter, rank and condition, all errors\n")
}

impl Answer for IdentificationAnswer {
    fn is_negative(&self) -> bool {
        self.verdict.is_negative()
    }

    fn may_be_accepted(&self) -> bool {
        self.verdict.may_be_accepted()
    }

    fn words(&self, width: Option<usize>) -> String {
        all_words(self, width)
    }

    fn summary(&self, width: usize) -> Option<Paragraphs> {
        Some(summary(self, width))
    }
}
