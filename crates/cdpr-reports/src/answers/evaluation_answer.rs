//! Errors of a model on measurements.

use std::fmt::Write;

use cdpr_calibration::selection::Warnings;
use cdpr_calibration::{ErrorBlocks, Evaluation, Verdict, distrust};
use cdpr_model::compensation::Beyond;
use cdpr_model::geometry::MotionPattern;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use schemars::JsonSchema;
use serde::Serialize;

use super::error_table::{Source, error_table};
use super::identification_words::reason_of;
use super::{Answer, axis_names, beyond_words, components};
use crate::keys::{BeyondKeys, ErrorBlockKeys, WarningKeys};

/// Errors of a model on measurements, in short.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Evaluation")]
pub struct EvaluationAnswer {
    robot: String,
    model: String,
    data: String,
    status: &'static str,
    /// Samples without an answer, else the reason not to trust the errors.
    reason: Option<String>,
    #[serde(skip)]
    unanswered: Option<String>,
    /// False where a rule of plausibility is broken or a sample has no answer.
    trusted: bool,
    #[serde(skip)]
    verdict: Verdict,
    #[serde(flatten, with = "ErrorBlockKeys")]
    blocks: ErrorBlocks,
    /// Map that corrects the lengths.
    #[serde(skip_serializing_if = "Option::is_none")]
    compensation: Option<UsedMap>,
    /// File of the errors sample by sample.
    #[serde(skip_serializing_if = "Option::is_none")]
    out_errors: Option<String>,
    /// Doubts about the data, then rules of plausibility that the errors break.
    #[serde(flatten, with = "WarningKeys")]
    #[schemars(with = "WarningKeys")]
    warnings: Warnings,
    #[serde(skip)]
    pattern: MotionPattern,
}

/// Map that corrects lengths.
#[derive(Serialize, JsonSchema)]
struct UsedMap {
    /// File of the map.
    file: String,
    /// Samples beyond those of the map, at which the model stands alone, and in the margin around them.
    #[serde(flatten, with = "BeyondKeys")]
    beyond: Beyond,
}

/// Why the forward problem failed, by the first sample at which it did.
fn unanswered(evaluation: &Evaluation) -> Option<String> {
    let (sample, why) = evaluation.not_converged.first()?;
    let (failed, all) = (evaluation.not_converged.len(), evaluation.len());
    Some(format!(
        "the forward problem of {failed} of {all} samples has no answer, first at sample {}: {why}",
        sample + 1
    ))
}

/// Errors sample by sample (CSV), of a planar robot along the axes of its plane; a number that does not exist is left empty.
pub fn errors_csv(model: &Model, evaluation: &Evaluation) -> String {
    let (robot, cables) = (model.robot(), model.cable_count());
    let mut text = "sample,position_error_m".to_owned();
    axis_names(robot).iter().for_each(|axis| text.push_str(&format!(",error_{axis}_m")));
    text.push_str(",rotation_error_rad");
    (1..=cables).for_each(|cable| text.push_str(&format!(",length_error_m_{cable}")));
    let has_tensions = !evaluation.tension.is_empty();
    (1..=cables).filter(|_| has_tensions).for_each(|cable| text.push_str(&format!(",tension_error_N_{cable}")));
    let has_swivels = !evaluation.swivel.is_empty();
    (1..=cables).filter(|_| has_swivels).for_each(|cable| text.push_str(&format!(",swivel_error_rad_{cable}")));
    text.push_str(",converged\n");
    let failed: Vec<usize> = evaluation.not_converged.iter().map(|(sample, _)| *sample).collect();
    for sample in 0..evaluation.len() {
        let mut numbers = vec![evaluation.position[sample]];
        numbers.extend(components(robot, &evaluation.position_vector[sample].into()));
        numbers.push(evaluation.rotation[sample]);
        numbers.extend(&evaluation.length[sample * cables..][..cables]);
        if has_tensions {
            numbers.extend(&evaluation.tension[sample * cables..][..cables]);
        }
        if has_swivels {
            numbers.extend(&evaluation.swivel[sample * cables..][..cables]);
        }
        text.push_str(&(sample + 1).to_string());
        for number in numbers {
            // writing to a String cannot fail
            let _ = if number.is_finite() { write!(text, ",{number}") } else { write!(text, ",") };
        }
        text.push_str(if failed.binary_search(&sample).is_ok() { ",false\n" } else { ",true\n" });
    }
    text
}

impl EvaluationAnswer {
    /// Errors on samples of data of a name and with doubts about them, with the name of the file that has them sample by sample.
    pub fn new(
        model: &Model,
        data: String,
        samples: &Samples,
        doubts: Warnings,
        evaluation: &Evaluation,
        out_errors: Option<String>,
    ) -> Self {
        let (unanswered, blocks) = (unanswered(evaluation), evaluation.blocks());
        let mut warnings = doubts;
        warnings.doubts.extend(distrust(model.robot(), model, samples, &blocks).reasons);
        let verdict = Verdict::of_predictions(&warnings.doubts, unanswered.is_none());
        Self {
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            data,
            status: verdict.fit_status(),
            reason: unanswered.clone().or_else(|| reason_of(verdict, &warnings.doubts)),
            unanswered,
            trusted: verdict.is_trusted(),
            verdict,
            blocks,
            compensation: None,
            out_errors,
            warnings,
            pattern: model.robot().motion_pattern,
        }
    }

    /// The same with the file of the map that corrects the lengths, and the samples beyond those of the map.
    #[must_use]
    pub fn with_compensation(mut self, file: Option<String>, beyond: Beyond) -> Self {
        if let Some(file) = file {
            let (samples, of_map) = (format!("{} samples", self.blocks.samples), format!("those of {file}"));
            self.warnings.remarks.extend(beyond_words(beyond, &samples, &of_map, "they are not corrected"));
            self.compensation = Some(UsedMap { file, beyond });
        }
        self
    }
}

impl Answer for EvaluationAnswer {
    fn is_negative(&self) -> bool {
        self.verdict.is_negative()
    }

    fn may_be_accepted(&self) -> bool {
        self.verdict.may_be_accepted()
    }

    fn words(&self, width: Option<usize>) -> String {
        let Self { robot, model, data, blocks, .. } = self;
        let corrected =
            self.compensation.as_ref().map_or_else(String::new, |map| format!(" corrected by {}", map.file));
        let mut text = format!("{robot}, model {model}{corrected}, on {data} ({} samples)\n", blocks.samples);
        self.warnings.list().iter().for_each(|warning| text.push_str(&format!("caution: {warning}\n")));
        if let Some(reason) = &self.unanswered {
            let answered = match blocks.answered {
                0 => "there is no error of the pose to tell".to_owned(),
                count => format!("errors of the pose are those of the other {count}"),
            };
            text.push_str(&format!("{reason}; {answered}\n"));
        }
        text.push_str(&format!("\n{}", error_table(self.pattern, &[("value", blocks)], Source::Measurements, width)));
        if let Some(path) = &self.out_errors {
            text.push_str(&format!("\nerrors of every sample written to {path}\n"));
        }
        text
    }
}
