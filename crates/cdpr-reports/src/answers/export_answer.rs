//! Figures of a result, configurations of firmware and tables for controllers, as they were written.

use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use schemars::JsonSchema;
use serde::Serialize;

use super::Answer;

/// Configuration of a firmware.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Firmware")]
pub struct FirmwareAnswer {
    status: &'static str,
    robot: String,
    /// Lines of the configuration.
    lines: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    out: Option<String>,
}

impl FirmwareAnswer {
    /// Lines for a robot, and the file that they were written to.
    pub fn new(robot: String, lines: Vec<String>, out: Option<String>) -> Self {
        Self { status: "written", robot, lines, out }
    }
}

impl Answer for FirmwareAnswer {
    fn words(&self, _width: Option<usize>) -> String {
        match &self.out {
            None => self.lines.join("\n") + "\n",
            Some(out) => format!("{} lines of configuration of {} written to {out}\n", self.lines.len(), self.robot),
        }
    }

    fn is_verbatim(&self) -> bool {
        self.out.is_none()
    }
}

/// Table of lengths for a controller.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "LengthTable")]
pub struct TableAnswer {
    status: &'static str,
    robot: String,
    model: String,
    /// Map that corrects the lengths.
    #[serde(skip_serializing_if = "Option::is_none")]
    compensation: Option<String>,
    /// Number of poses.
    poses: usize,
    /// Lengths of the cables pose by pose (m).
    cable_lengths_m: Vec<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    out: Option<String>,
    #[serde(skip)]
    text: String,
}

impl TableAnswer {
    /// Lengths of a model at poses, corrected by the map of a file, as the text of a table and the file that it was written to.
    pub fn new(model: &Model, compensation: Option<String>, table: &Samples, out: Option<String>) -> Self {
        Self {
            status: "written",
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            compensation,
            poses: table.len(),
            cable_lengths_m: (0..table.len()).map(|pose| table.lengths_of(pose).to_vec()).collect(),
            out,
            text: table.to_csv(model.robot()),
        }
    }

    /// Text of the table (CSV).
    pub fn text(&self) -> &str {
        &self.text
    }
}

impl Answer for TableAnswer {
    fn words(&self, _width: Option<usize>) -> String {
        let Self { robot, model, poses, .. } = self;
        let Some(out) = &self.out else { return self.text.clone() };
        let map = self.compensation.as_ref().map_or_else(String::new, |file| format!(" corrected by {file}"));
        format!("lengths of {robot}, model {model}{map}, at {poses} poses written to {out}\n")
    }

    fn is_verbatim(&self) -> bool {
        self.out.is_none()
    }
}

/// Figures of a result.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ExportedFigures")]
pub struct ExportAnswer {
    status: &'static str,
    reason: Option<String>,
    /// File of the result.
    result: String,
    /// Candidate that the figures show; null where there is none to choose.
    candidate: Option<String>,
    out: String,
    files: Vec<String>,
    /// Figures that the result has no numbers for.
    skipped: Vec<SkippedFigure>,
}

/// A figure that the result has no numbers for.
#[derive(Serialize, JsonSchema)]
pub struct SkippedFigure {
    /// Its file.
    pub figure: &'static str,
    /// Reason in words.
    pub reason: &'static str,
}

impl ExportAnswer {
    /// Files of a result about a candidate, written to a folder, and those that were not.
    pub fn new(
        result: String,
        candidate: Option<String>,
        out: String,
        files: Vec<String>,
        skipped: Vec<SkippedFigure>,
    ) -> Self {
        let reason = files.is_empty().then(|| {
            let why: Vec<String> = skipped.iter().map(|one| format!("{}: {}", one.figure, one.reason)).collect();
            format!("nothing of the result can be shown: {}", why.join("; "))
        });
        let status = if reason.is_none() { "written" } else { "empty" };
        Self { status, reason, result, candidate, out, files, skipped }
    }
}

impl Answer for ExportAnswer {
    fn words(&self, _width: Option<usize>) -> String {
        let about = self.candidate.as_ref().map(|name| format!(", candidate {name}")).unwrap_or_default();
        let files: String = self.files.iter().map(|name| format!("  {name}\n")).collect();
        format!("figures of {}{about}\n\n{files}\nwritten to {}\n", self.result, self.out)
    }

    /// A result of which nothing can be shown.
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }
}
