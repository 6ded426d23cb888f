//! A calibration without measured poses on one screen: outcome, cautions, residuals, what the data leave free, largest changes.

use super::PoselessJudgement;
use super::identification_summary::{more, outcome};
use super::self_calibration_answer::{SelfCalibrationAnswer, comparison_words, length_words, sensor_words};
use super::start_words::start_words;
use super::summary_parts::{add_doubts, changes, ranges};
use crate::paragraphs::{Paragraphs, Tone};
use cdpr_calibration::coverage;

/// The calibration on one screen of so many columns, with what options asked for besides.
pub(super) fn summary(answer: &SelfCalibrationAnswer, width: usize) -> Paragraphs {
    let SelfCalibrationAnswer { robot, data, samples, found, warnings, .. } = answer;
    let fit = &found.fit;
    let mut page = Paragraphs::default();
    page.add(Tone::Plain, &format!("{robot}: {samples} samples of {data}, poses unknown"));
    page.gap();
    outcome(&mut page, answer.verdict, (&answer.label, &fit.reason), warnings);
    add_doubts(&mut page, warnings);
    page.gap();
    page.add(Tone::Plain, &length_words(found));
    found.sensors.iter().for_each(|sensor| page.add(Tone::Plain, &sensor_words(sensor)));
    page.add(Tone::Plain, &answer.gauge_words());
    page.add(Tone::Plain, &answer.validation.iter().map(PoselessJudgement::words).collect::<String>());
    page.add(Tone::Plain, &answer.comparison.iter().map(comparison_words).collect::<String>());
    page.gap();
    let table = changes(&answer.largest_changes, found.parameter_count, width);
    if !table.is_empty() {
        page.add(Tone::Plain, &table);
        page.gap();
    }
    page.add(Tone::Plain, &ranges(&coverage(fit.model.robot(), &found.samples, &[])));
    if fit.starts.optima.len() > 1 {
        page.add(Tone::Plain, &start_words(&fit.starts, Some(width)));
    }
    page.add(Tone::Plain, &answer.course.iter().map(|course| course.words(Some(width))).collect::<String>());
    page.add(Tone::Plain, &answer.file_words());
    page.add(Tone::Plain, &more(warnings.remarks.len(), 0));
    page
}
