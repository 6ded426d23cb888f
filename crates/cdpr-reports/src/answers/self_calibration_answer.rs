//! A robot calibrated without measured poses: JSON and words.

use cdpr_calibration::candidate::plain_name;
use cdpr_calibration::fit::Estimate;
use cdpr_calibration::selection::Warnings;
use cdpr_calibration::{Comparison, GaugeFixing, SelfCalibration, SensorFit, Verdict};
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use schemars::JsonSchema;
use serde::Serialize;

use super::CourseAnswer;
use super::PoseAnswer;
use super::PoselessJudgement;
use super::summary_parts::MOST_CHANGES;
use crate::keys::{ComparisonKeys, Maybe, SelfCalibrationKeys, WarningKeys};
use crate::number_format::significant;
use crate::report::Addition;

/// Parameters found from lengths at unknown poses.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "SelfCalibration")]
pub struct SelfCalibrationAnswer {
    pub(super) robot: String,
    pub(super) model: String,
    /// Free parameters.
    free: String,
    pub(super) data: String,
    /// Number of samples.
    pub(super) samples: usize,
    status: &'static str,
    /// False where nobody should work with the parameters; the warnings say why.
    trusted: bool,
    #[serde(skip)]
    pub(super) verdict: Verdict,
    #[serde(flatten, with = "SelfCalibrationKeys")]
    pub(super) found: SelfCalibration,
    /// Anchors on the frame, cable by cable (m).
    frame_anchors_m: Vec<Vec<f64>>,
    /// Poses at which the lengths fit best.
    poses: Vec<PoseAnswer>,
    /// Errors on samples that were not fitted to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) validation: Option<PoselessJudgement>,
    /// Anchors beside those of another robot.
    #[serde(with = "Maybe::<ComparisonKeys>", skip_serializing_if = "Option::is_none")]
    pub(super) comparison: Option<Comparison>,
    /// Course of the fit, where it is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) course: Option<CourseAnswer>,
    #[serde(flatten, with = "WarningKeys")]
    #[schemars(with = "WarningKeys")]
    pub(super) warnings: Warnings,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) out: Option<String>,
    /// File of the poses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) out_poses: Option<String>,
    /// Effects and free parameters in plain words.
    #[serde(skip)]
    pub(super) label: String,
    /// Parameters that changed most.
    #[serde(skip)]
    pub(super) largest_changes: Vec<Estimate>,
}

impl SelfCalibrationAnswer {
    /// Of a calibration of a model's parameters, named, from data of a name; names of the files that are written.
    pub fn new(
        found: SelfCalibration,
        model: &Model,
        free: String,
        data: String,
        of_data: &Warnings,
        [out, out_poses]: [Option<String>; 2],
    ) -> Self {
        let warnings = found.fit.own_warnings(&found.distrust(), of_data);
        let verdict = Verdict::of_fit(&warnings.doubts);
        let axes = model.axes();
        let anchor = |cable: &cdpr_model::robot::Cable| axes.iter().map(|axis| axis.dot(&cable.frame_anchor)).collect();
        // the text is the one of the parameters themselves
        let named = free.parse().unwrap_or_default();
        Self {
            label: plain_name(model.composition(), &named, Some(found.parameter_count)),
            largest_changes: found.fit.largest_changes(&found.samples, MOST_CHANGES).into_iter().cloned().collect(),
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            free,
            data,
            samples: found.samples.len(),
            status: verdict.fit_status(),
            trusted: verdict.is_trusted(),
            verdict,
            frame_anchors_m: found.fit.model.robot().cables.iter().map(anchor).collect(),
            poses: found.samples.poses.iter().map(|pose| PoseAnswer::new(model.robot(), pose)).collect(),
            found,
            validation: None,
            comparison: None,
            course: None,
            warnings,
            out,
            out_poses,
        }
    }

    /// The same with errors on other samples, and beside another robot.
    #[must_use]
    pub fn with_judgements(self, validation: Option<PoselessJudgement>, comparison: Option<Comparison>) -> Self {
        Self { validation, comparison, ..self }
    }

    /// The same with the course of the fit.
    #[must_use]
    pub fn with_course(self, course: Option<CourseAnswer>) -> Self {
        Self { course, ..self }
    }

    /// Warnings, those that doubt the outcome first.
    pub fn warnings(&self) -> &Warnings {
        &self.warnings
    }

    /// The calibrated robot, whose file says how far it may be relied on.
    pub fn calibrated(&self) -> Robot {
        self.found.fit.model.robot().clone().with_calibration(self.status)
    }

    /// Outcome of the fit in words.
    pub fn reason(&self) -> &str {
        &self.found.fit.reason
    }

    /// Parts of its page.
    pub fn additions(&self) -> Vec<Addition> {
        self.course.iter().map(CourseAnswer::addition).collect()
    }

    /// Motions that the data leave free, and parameters that fix them.
    pub(super) fn gauge_words(&self) -> String {
        let GaugeFixing { kind, motions, held, at_origin, .. } = &self.found.gauge;
        let mut text = String::new();
        if *at_origin {
            text.push_str("lengths count from their values at the world's origin, which is where they were zeroed\n");
        }
        if !motions.is_empty() {
            let image = if self.found.gauge.free.contains(&"mirror") { ", and mirror images" } else { "" };
            let fixed = match *kind {
                "anchors" => format!("fixed by {} at the file's values", held.join(", ")),
                _ => "fixed by anchors that change least from the file's".to_owned(),
            };
            let what = if self.found.sensors.is_empty() { "length" } else { "measurement" };
            text.push_str(&format!("no {what} changes by: {}{image}; {fixed}\n", motions.join(", ")));
        }
        text
    }

    /// Files that are written.
    pub(super) fn file_words(&self) -> String {
        let files = [("calibrated robot", &self.out), ("samples with the poses found", &self.out_poses)];
        let line = |(what, path): (&str, &Option<String>)| Some(format!("{what} written to {}\n", path.as_ref()?));
        files.into_iter().filter_map(line).collect()
    }
}

/// Residuals of the lengths.
pub(super) fn length_words(found: &SelfCalibration) -> String {
    let (rms, squares) = (significant(1e3 * found.length_rms_m, 3), significant(1e6 * found.cost_m2, 6));
    format!("lengths: {rms} mm rms, sum of squares {squares} mm²\n")
}

/// Residuals of a sensor beside the accuracy that weighs them.
pub(super) fn sensor_words(fit: &SensorFit) -> String {
    let SensorFit { sensor, unit, rms, sigma, is_stated, .. } = fit;
    let (factor, unit) = match *unit {
        "m" => (1e3, "mm"),
        "rad" => (1.0_f64.to_degrees(), "°"),
        other => (1.0, other),
    };
    let origin = if *is_stated { "stated" } else { "told by the residuals" };
    let [rms, sigma] = [rms, sigma].map(|value| significant(factor * value, 3));
    format!("  {sensor}: {rms} {unit} rms; accuracy {sigma} {unit}, {origin}\n")
}

/// Anchors beside those of another robot.
pub(super) fn comparison_words(comparison: &Comparison) -> String {
    let Comparison { robot, rms_m, scale, is_mirrored, .. } = comparison;
    let mirrored = if *is_mirrored { " (mirrored)" } else { "" };
    format!(
        "beside {robot}{mirrored}: anchors are {} mm (rms) from its own after the best motion; it is {} times as large\n",
        significant(1e3 * rms_m, 3),
        significant(*scale, 5)
    )
}
