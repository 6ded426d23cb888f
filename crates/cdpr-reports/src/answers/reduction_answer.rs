//! Smaller model that a fit proposes: JSON and words.

use cdpr_calibration::{Evidence, Reduction};
use cdpr_model::geometry::MotionPattern;
use serde::Serialize;

use crate::number_format::{decimals_for, fixed};
use crate::report::Addition;

/// Smaller model, with the numbers that show it.
#[derive(Serialize)]
pub struct ReductionAnswer {
    evidence: Evidence,
    reason: String,
    patterns: [MotionPattern; 2],
    parameter_count: [usize; 2],
    left: Vec<String>,
    position_mean_m: [f64; 2],
    standard_error_m: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    out: Option<String>,
}

impl ReductionAnswer {
    /// Of a proposal, with the name of the file that it is written to.
    pub fn new(found: &Reduction, out: Option<String>) -> Self {
        Self {
            evidence: found.evidence,
            reason: found.reason.clone(),
            patterns: found.patterns,
            parameter_count: found.parameter_count,
            left: found.left.clone(),
            position_mean_m: found.position_mean_m,
            standard_error_m: found.standard_error,
            out,
        }
    }

    /// Part of a page.
    pub(super) fn addition(&self) -> Addition {
        let [heading, reason, errors] = self.sentences();
        Addition {
            id: "reduction",
            title: "Smaller model",
            gist: heading,
            sentences: vec![reason, errors],
            figure: None,
        }
    }

    pub(super) fn words(&self) -> String {
        let [heading, reason, errors] = self.sentences();
        format!("\nsmaller model: {heading}\n{reason}\n{errors}\n")
    }

    /// Size, reason and errors.
    fn sentences(&self) -> [String; 3] {
        let Self { reason, patterns: [before, after], parameter_count: [full, reduced], .. } = self;
        let decimals = decimals_for(Some(1e3 * self.standard_error_m));
        let [of_full, of_reduced] = self.position_mean_m.map(|error| fixed(1e3 * error, decimals));
        let pattern = if before == after {
            String::new()
        } else {
            format!(", motion pattern {} → {}", before.name(), after.name())
        };
        let error = fixed(1e3 * self.standard_error_m, decimals);
        let file = match &self.out {
            Some(out) => format!("written to {out}"),
            None => "`--out-reduced FILE` writes it".to_owned(),
        };
        [
            format!("{full} → {reduced} parameters{pattern}"),
            format!("{reason}."),
            format!("Held-out position error, mean: {of_reduced} instead of {of_full} ± {error} mm; {file}"),
        ]
    }
}
