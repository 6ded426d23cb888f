//! Errors over the poses of a study, in short.

use cdpr_study::Experiment;
use cdpr_study::field::{Field, Summary};
use serde::Serialize;

use super::{Answer, control_title, gain_words, title};
use crate::number_format::{cell, significant};
use crate::study_page::{ErrorRow, error_rows};
use crate::table::Table;

/// Errors of a study with the files that tell more.
#[derive(Serialize)]
pub struct StudyAnswer {
    status: &'static str,
    reason: Option<String>,
    control: String,
    machine: String,
    #[serde(flatten)]
    summary: Summary,
    winch_offsets_m: Vec<f64>,
    seed: u64,
    files: Vec<String>,
}

/// Reason why poses have no answer, by the first of them.
pub fn unanswered(found: &Field) -> Option<String> {
    let failed = found.summary.samples - found.summary.converged;
    let (pose, first) = found.samples.iter().enumerate().find(|(_, sample)| sample.exact.is_none())?;
    let why = first.outcome.reason.as_deref().unwrap_or("no reason is known");
    Some(format!("{failed} of {} poses have no answer, first pose {}: {why}", found.summary.samples, pose + 1))
}

impl StudyAnswer {
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
