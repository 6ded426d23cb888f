//! A smooth correction of lengths, and what it is worth on samples held out.

use cdpr_calibration::compensation::{Compensated, Judged};
use cdpr_calibration::selection::Warnings;
use cdpr_model::compensation::Extent;
use cdpr_model::geometry::MotionPattern;
use cdpr_model::model::Model;
use schemars::JsonSchema;
use serde::Serialize;

use super::error_table::{Source, error_table};
use super::{Answer, PoseAnswer, beyond_words};
use crate::keys::{Each, ExtentKeys, JudgedMapKeys};
use crate::number_format::significant;

/// A map in short.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Compensation")]
pub struct CompensationAnswer {
    robot: String,
    model: String,
    data: String,
    status: &'static str,
    /// Verdict, and by which rules it is given.
    reason: String,
    /// Samples that the map is made of.
    samples: usize,
    /// Distance over which corrections hang together.
    length_scale_m: f64,
    /// Variance of noise as a multiple of that of the smooth part.
    noise_ratio: f64,
    /// Reach of the samples, within which the map acts as a whole, and margins over which it fades.
    region: MapRegion,
    /// Errors on samples held out in turn.
    #[serde(with = "JudgedMapKeys")]
    held_out: Judged,
    #[serde(skip_serializing_if = "Option::is_none")]
    out: Option<String>,
    warnings: Vec<String>,
    #[serde(skip)]
    pattern: MotionPattern,
}

/// Reach of the samples of a map.
#[derive(Serialize, JsonSchema)]
struct MapRegion {
    /// Pose about which coordinates count.
    centre: PoseAnswer,
    /// Ranges of the coordinates.
    #[serde(with = "Each::<ExtentKeys>")]
    coordinates: Vec<Extent>,
}

impl MapRegion {
    /// Middle, ends and margins in a sentence.
    fn words(&self) -> String {
        let coordinate = |extent: &Extent| {
            let Extent { axis, unit, ends: [low, high], margin } = extent;
            let [low, high, margin] = [low, high, margin].map(|value| significant(*value, 3));
            format!("{axis} {low} to {high} {unit} (margin {margin} {unit})")
        };
        let coordinates: Vec<String> = self.coordinates.iter().map(coordinate).collect();
        format!(
            "the map acts as a whole in the box of its samples, about {}: {}; over the margins around it, and in gaps between samples, it fades to zero",
            self.centre.words(),
            coordinates.join(", ")
        )
    }
}

impl CompensationAnswer {
    /// The answer for a model on data of a name and with doubts about them, with the file that was written.
    pub fn new(model: &Model, data: String, doubts: Warnings, found: Compensated, out: Option<String>) -> Self {
        let Compensated { map, judged, helps, reason } = found;
        let facts = map.facts();
        let mut warnings = doubts.list();
        let (samples, alone) = (format!("{} samples", judged.samples), "the model stands alone there");
        warnings.extend(beyond_words(judged.beyond, &samples, "the others when they are held out", alone));
        Self {
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            data,
            status: if helps { "helps" } else { "no-help" },
            reason,
            samples: facts.samples,
            length_scale_m: facts.length_scale,
            noise_ratio: facts.noise_ratio,
            region: MapRegion { centre: PoseAnswer::new(model.robot(), &facts.centre), coordinates: facts.extents },
            held_out: judged,
            out,
            warnings,
            pattern: model.robot().motion_pattern,
        }
    }
}

impl Answer for CompensationAnswer {
    fn is_negative(&self) -> bool {
        self.status == "no-help"
    }

    fn words(&self, width: Option<usize>) -> String {
        let Self { robot, model, data, samples, held_out, .. } = self;
        let mut text = format!("{robot}, model {model}, corrected over the workspace by {samples} samples of {data}\n");
        self.warnings.iter().for_each(|warning| text.push_str(&format!("caution: {warning}\n")));
        text.push_str(&format!("{}\n{}\n", self.reason, self.region.words()));
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
