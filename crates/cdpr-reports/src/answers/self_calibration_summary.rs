//! A calibration without measured poses in words, all of them and on one screen.

use super::identification_summary::{more, outcome};
use super::identification_words::{doubt_words, identifiability, parameters, verdict_words};
use super::self_calibration_answer::{SelfCalibrationAnswer, comparison_words, length_words, sensor_words};
use super::start_words::start_words;
use super::summary_parts::{add_doubts, changes, ranges};
use super::{Answer, PoselessJudgement};
use crate::paragraphs::{Paragraphs, Tone};
use cdpr_calibration::selection::Warnings;
use cdpr_calibration::{SelfCalibration, coverage};

/// The calibration on one screen of so many columns, with what options asked for besides.
pub(super) fn summary(answer: &SelfCalibrationAnswer, width: usize) -> Paragraphs {
    let SelfCalibrationAnswer { robot, data, samples, found, warnings, .. } = answer;
    let fit = &found.fit;
    let mut page = Paragraphs::default();
    page.add(Tone::Plain, &format!("{robot}: {samples} samples of {data}, poses unknown"));
    page.gap();
    outcome(&mut page, answer.verdict, &answer.label, &fit.reason, warnings);
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

impl Answer for SelfCalibrationAnswer {
    fn summary(&self, width: usize) -> Option<Paragraphs> {
        Some(summary(self, width))
    }

    fn is_negative(&self) -> bool {
        self.verdict.is_negative()
    }

    fn may_be_accepted(&self) -> bool {
        self.verdict.may_be_accepted()
    }

    fn words(&self, width: Option<usize>) -> String {
        let Self { robot, model, data, samples, found, .. } = self;
        let SelfCalibration { fit, parameter_count, equations, .. } = found;
        let mut text = format!(
            "{robot}, model {model}: {parameter_count} parameters from {samples} samples of {data}, poses unknown ({equations} equations are left for the parameters)\n"
        );
        let Warnings { doubts, remarks } = &self.warnings;
        text.push_str(&doubt_words(doubts));
        text.push_str(&format!(
            "{} after {} iterations: {}\n",
            verdict_words(self.verdict),
            fit.iterations,
            fit.reason
        ));
        text.push_str(&format!("ended by {}\n", fit.stopped_by));
        text.push_str(&length_words(found));
        found.sensors.iter().for_each(|fit| text.push_str(&sensor_words(fit)));
        text.push_str(&self.gauge_words());
        text.extend(self.validation.iter().map(PoselessJudgement::words));
        text.extend(self.comparison.iter().map(comparison_words));
        text.push_str(&format!(
            "\n{}\n{}",
            parameters(&fit.parameters, width),
            identifiability(&fit.analysis, *parameter_count, fit.noise_factor)
        ));
        text.extend(self.course.iter().map(|course| course.words(width)));
        if !remarks.is_empty() {
            text.push_str("\nwarnings\n");
            remarks.iter().for_each(|warning| text.push_str(&format!("  {warning}\n")));
        }
        text.push_str(&start_words(&fit.starts, width));
        self.file_words().lines().for_each(|line| text.push_str(&format!("\n{line}\n")));
        text
    }
}
