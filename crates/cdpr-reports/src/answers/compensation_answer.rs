//! A smooth correction of lengths, and what it is worth on samples held out.

use cdpr::geometry::MotionPattern;
use cdpr::identification::compensation::{Compensated, Judged};
use cdpr::identification::selection::Warnings;
use cdpr::model::Model;
use serde::Serialize;

use super::Answer;
use super::error_table::{Source, error_table};
use crate::number_format::significant;

/// A map in short.
#[derive(Serialize)]
pub struct CompensationAnswer {
    robot: String,
    model: String,
    data: String,
    status: &'static str,
    reason: Option<String>,
    /// Samples that the map is made of.
    samples: usize,
    /// Distance over which corrections hang together.
    length_scale_m: f64,
    /// Variance of noise as a multiple of that of the smooth part.
    noise_ratio: f64,
    /// Errors on samples held out in turn.
    held_out: Judged,
    #[serde(skip_serializing_if = "Option::is_none")]
    out: Option<String>,
    warnings: Vec<String>,
    #[serde(skip)]
    pattern: MotionPattern,
}

impl CompensationAnswer {
    /// The answer for a model on data of a name and with doubts about them, with the file that was written.
    pub fn new(model: &Model, (data, doubts): (String, Warnings), found: Compensated, out: Option<String>) -> Self {
        let Compensated { map, judged, reason } = found;
        let mut warnings = doubts.list;
        if judged.outside > 0 {
            warnings.push(format!(
                "{} of {} samples lie beyond the others when they are held out: the model stands alone there",
                judged.outside, judged.samples
            ));
        }
        Self {
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            data,
            status: if reason.is_none() { "helps" } else { "no-help" },
            reason,
            samples: map.sample_count(),
            length_scale_m: map.length_scale(),
            noise_ratio: map.noise_ratio(),
            held_out: judged,
            out,
            warnings,
            pattern: model.robot().motion_pattern,
        }
    }
}

impl Answer for CompensationAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let Self { robot, model, data, samples, held_out, .. } = self;
        let mut text = format!("{robot}, model {model}, corrected over the workspace by {samples} samples of {data}\n");
        self.warnings.iter().for_each(|warning| text.push_str(&format!("caution: {warning}\n")));
        self.reason.iter().for_each(|reason| text.push_str(&format!("{reason}\n")));
        text.push_str(&format!(
            "corrections hang together over {} m, noise has {} times the variance of the smooth part\n\non samples held out in turn\n",
            significant(self.length_scale_m, 3),
            significant(self.noise_ratio, 1)
        ));
        let blocks = [("model alone", &held_out.without), ("with the map", &held_out.with)];
        text.push_str(&error_table(self.pattern, &blocks, Source::Measurements, width));
        if let Some(path) = &self.out {
            text.push_str(&format!("\nmap written to {path}: use it by --compensation {path}, in studies by compensation = \"{path}\" of [control]\n"));
        }
        text
    }
}
