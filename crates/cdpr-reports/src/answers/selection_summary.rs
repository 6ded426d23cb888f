//! A comparison on one screen: verdict, cautions, candidates, largest changes, worst cable, range of the samples.

use cdpr_calibration::Verdict;
use cdpr_calibration::selection::Judgement;

use super::frame_words::{frame_words, shift_words};
use super::summary_parts::{add_doubts, changes, counted, ranges, tone, worst_cable};
use super::{AsGiven, CandidateAnswer, SelectionAnswer};
use crate::number_format::significant;
use crate::paragraphs::{Paragraphs, Tone};
use crate::report::{times, value_and_error};
use crate::table::Table;

/// The comparison on one screen of so many columns.
pub(super) fn summary(answer: &SelectionAnswer<'_>, width: usize) -> Paragraphs {
    let mut page = Paragraphs::default();
    page.add(
        Tone::Plain,
        &format!("{}: {} samples of {}, judged on {}", answer.robot, answer.samples, answer.data, answer.validation),
    );
    page.gap();
    verdict(&mut page, answer);
    add_doubts(&mut page, &answer.warnings);
    page.gap();
    page.add(Tone::Plain, &candidates(answer, width));
    page.gap();
    if let Some(shown) = answer.places.shown.map(|index| &answer.candidates[index]) {
        let count = shown.judged.map_or(0, |judged| judged.fit.parameters.len());
        page.add(Tone::Plain, &changes(&answer.largest_changes, count, width));
        if !answer.largest_changes.is_empty() {
            page.gap();
        }
    }
    page.add(Tone::Plain, &worst_cable(answer.worst_cable).unwrap_or_default());
    page.add(Tone::Plain, &ranges(&answer.coverage));
    page.add(Tone::Plain, &more(answer));
    page
}

/// The outcome: the candidate by both of its names, why it, its error, and the limits.
fn verdict(page: &mut Paragraphs, answer: &SelectionAnswer<'_>) {
    match answer.places.recommended.map(|index| &answer.candidates[index]) {
        Some(chosen) => {
            let words = match answer.verdict {
                Verdict::Sound => "recommended",
                Verdict::WithCaution => "recommended with caution",
                _ => "the best that there is, not to be trusted",
            };
            page.add(tone(answer.verdict), &format!("{words}: {}", chosen.label));
            page.add(Tone::Plain, &format!("  {}", of_chosen(answer, chosen)));
            for requirement in chosen.judged.iter().flat_map(|judged| &judged.requirements) {
                let (tone, word) = if requirement.met { (Tone::Plain, "met") } else { (Tone::Refusal, "broken") };
                page.add(tone, &format!("  {requirement}: {word}"));
            }
            page.add(Tone::Plain, &format!("  on the command line: {}", chosen.name));
        }
        None => {
            page.add(Tone::Refusal, "no candidate is good enough");
            page.add(Tone::Plain, &format!("  {}", answer.reason));
        }
    }
    let recorded = answer.frames.map(frame_words).unwrap_or_default() + &shift_words(answer.shifts);
    recorded.lines().for_each(|line| page.add(Tone::Plain, &format!("  {line}")));
}

/// Error of the recommended candidate, that of today's model, and why it is the one.
fn of_chosen(answer: &SelectionAnswer<'_>, chosen: &CandidateAnswer<'_>) -> String {
    let value = |judged: &Judgement| answer.criterion.format_with_error(judged.criterion, judged.standard_error);
    let error = chosen.judged.map(|judged| format!("{} {}", answer.criterion, value(judged))).unwrap_or_default();
    let why = match answer.places.best.map(|index| &answer.candidates[index]) {
        Some(best) if best.name != chosen.name => {
            let of_best = best.judged.map(|judged| format!(" ({})", value(judged))).unwrap_or_default();
            format!("the simplest that is as good as the best on the same samples, {}{of_best}", best.label)
        }
        _ => "the best, and no simpler one is as good on the same samples".to_owned(),
    };
    let today = answer.as_given.as_ref().map(|AsGiven { criterion, standard_error, ratio, .. }| {
        let value = answer.criterion.format_with_error(*criterion, *standard_error);
        format!("; today, as given: {value}{}", times(*ratio))
    });
    format!("{error}{}; {why}", today.unwrap_or_default())
}

/// Candidates by their plain names in five columns.
fn candidates(answer: &SelectionAnswer<'_>, width: usize) -> String {
    let (criterion, unit) = (answer.criterion, answer.criterion.unit());
    let heading = ["candidate", &format!("error {unit}"), "±", "lengths mm", "caution"];
    let mut table = Table::new(heading).left_column(4);
    for candidate in &answer.candidates {
        let marker = if Some(candidate.name) == answer.recommended.as_deref() { "→ " } else { "  " };
        let mut cells = vec![format!("{marker}{}", candidate.label)];
        match candidate.judged {
            Some(judged) => {
                let (value, error) = value_and_error(criterion, judged.criterion, judged.standard_error);
                let lengths = significant(1e3 * judged.validation.length_error_m.rms, 3);
                let caution = match judged.disqualified {
                    Some(_) => "cannot be judged".to_owned(),
                    None => judged.fit.caution_words(),
                };
                cells.extend([value, error, lengths, caution]);
            }
            None => cells.extend([String::new(), String::new(), String::new(), "failed".to_owned()]),
        }
        table.row(cells);
    }
    format!("candidates by {criterion} on validation data, and rms error of lengths\n{}", table.text(Some(width)))
}

/// Sentence on where the rest is.
fn more(answer: &SelectionAnswer<'_>) -> String {
    let remarks = match answer.warnings.remarks.len() {
        0 => String::new(),
        count => format!("{}, ", counted(count, "warning")),
    };
    let page = answer.out.as_ref().map(|out| format!("results written to {out}: open {out}/report.html\n"));
    format!("{}more with --verbose: {remarks}the reason, other criteria, all columns\n", page.unwrap_or_default())
}
