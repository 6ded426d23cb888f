//! Errors over the poses of a study, in short.

use cdpr_model::control::PoseErrorStatistics;
use cdpr_study::Experiment;
use cdpr_study::field::{Field, Summary};
use schemars::JsonSchema;
use serde::Serialize;

use super::{Answer, control_title, gain_words, title};
use crate::keys::SummaryKeys;
use crate::number_format::{cell, significant};
use crate::table::Table;

/// Errors of a study with the files that tell more.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Study")]
pub struct StudyAnswer {
    status: &'static str,
    reason: Option<String>,
    control: String,
    machine: String,
    #[serde(flatten, with = "SummaryKeys")]
    summary: Summary,
    winch_offsets_m: Vec<f64>,
    seed: u64,
    files: Vec<String>,
}

/// Reason why poses have no answer, by the first of them.
fn unanswered(found: &Field) -> Option<String> {
    let failed = found.summary.samples - found.summary.converged;
    let (pose, first) = found.samples.iter().enumerate().find(|(_, sample)| sample.exact.is_none())?;
    let why = first.outcome.reason.as_deref().unwrap_or("no reason is known");
    Some(format!("{failed} of {} poses have no answer, first pose {}: {why}", found.summary.samples, pose + 1))
}

impl StudyAnswer {
    /// Reason of an answer that is negative.
    pub fn reason(&self) -> Option<&str> {
        self.reason.as_deref()
    }

    /// Errors of an experiment at the poses that this seed gives, with the names of the files written.
    pub fn new(experiment: &Experiment, found: &Field, seed: u64, files: Vec<String>) -> Self {
        let reason = unanswered(found);
        Self {
            status: if reason.is_none() { "converged" } else { "not-converged" },
            reason,
            control: control_title(experiment),
            machine: title(&experiment.machine),
            summary: found.summary.clone(),
            winch_offsets_m: experiment.offsets.clone(),
            seed,
            files,
        }
    }
}

/// Statistics of one kind of error.
pub(crate) struct ErrorRow {
    /// Word of this kind in JSON.
    pub(crate) name: &'static str,
    /// Unit for people.
    pub(crate) unit: &'static str,
    /// From the library's unit to this one.
    pub(crate) factor: f64,
    /// Statistics in the library's unit.
    pub(crate) error: PoseErrorStatistics,
}

/// Subjects of a field's statistics, in the order of all tables; forces where the machine has any, tensions where they are commanded.
pub(crate) fn error_rows(summary: &Summary) -> Vec<ErrorRow> {
    let millimetres = |name, error| ErrorRow { name, unit: "mm", factor: 1e3, error };
    let mut rows = vec![
        millimetres("position, exact", summary.position_error_m),
        millimetres("position, one linear step", summary.linear_position_error_m),
        millimetres("linear step beside exact", summary.linear_residual_m),
        ErrorRow {
            name: "rotation, exact",
            unit: "°",
            factor: 1.0_f64.to_degrees(),
            error: summary.rotation_error_rad,
        },
    ];
    let newtons = |name, error| ErrorRow { name, unit: "N", factor: 1.0, error };
    rows.extend(summary.residual_force.map(|force| newtons("residual force, held at the pose", force)));
    rows.extend(summary.tension_error.map(|error| {
        let (mean, rms, max) = (error.mean_abs, error.rms, error.max);
        let known = PoseErrorStatistics { mean, rms, median: f64::NAN, p95: f64::NAN, max };
        newtons("tension, emerging less commanded", known)
    }));
    rows
}

impl Answer for StudyAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut text = format!("{} drives {} to {} poses\n", self.control, self.machine, self.summary.samples);
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}; the others count\n"));
        }
        let mut table = Table::new(["error", "unit", "mean", "rms", "median", "p95", "max"]).left_column(1);
        for ErrorRow { name, unit, factor, error } in error_rows(&self.summary) {
            let numbers = [error.mean, error.rms, error.median, error.p95, error.max];
            let cells = numbers.map(|number| cell(Some(factor * number), 3));
            table.row([vec![name.to_owned(), unit.to_owned()], cells.to_vec()].concat());
        }
        text.push_str(&format!("\n{}", table.text(width)));
        if let Some(map) = &self.summary.compensation {
            text.push_str(&gain_words(&self.summary.position_error_m, &map.without.position_error_m));
        }
        if let Some(relative) = self.summary.relative_position_error {
            let diameter = significant(self.summary.diameter_m, 3);
            text.push_str(&format!(
                "\nmean error: {} % of the {diameter} m across the poses\n",
                significant(100.0 * relative, 3)
            ));
        }
        let share = 100.0 * self.summary.linear_trusted_share;
        text.push_str(&format!("the linear step is within a tenth of the error at {share:.0} % of the poses\n"));
        text.push_str(&format!("\nwrote {}\n", self.files.join(", ")));
        text
    }
}
