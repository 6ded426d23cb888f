//! Smaller model that a fit proposes: JSON and words.

use cdpr_calibration::Reduction;
use schemars::JsonSchema;
use serde::Serialize;

use crate::keys::ReductionKeys;
use crate::number_format::{decimals_for, fixed};
use crate::report::Addition;

/// Smaller model, with the numbers that show it.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Reduction")]
pub struct ReductionAnswer {
    #[serde(flatten, with = "ReductionKeys")]
    found: Reduction,
    #[serde(skip_serializing_if = "Option::is_none")]
    out: Option<String>,
}

impl ReductionAnswer {
    /// Of a proposal, with the name of the file that it is written to.
    pub fn new(found: Reduction, out: Option<String>) -> Self {
        Self { found, out }
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
        let Reduction { reason, patterns: [before, after], parameter_count: [full, reduced], .. } = &self.found;
        let decimals = decimals_for(Some(1e3 * self.found.standard_error));
        let [of_full, of_reduced] = self.found.position_mean_m.map(|error| fixed(1e3 * error, decimals));
        let pattern = if before == after {
            String::new()
        } else {
            format!(", motion pattern {} → {}", before.name(), after.name())
        };
        let difference = self.found.difference;
        let apart = format!(
            "{} ± {} mm more",
            fixed(1e3 * difference.mean, decimals + 1),
            fixed(1e3 * difference.standard_error, decimals + 1)
        );
        let file = match &self.out {
            Some(out) => format!("written to {out}"),
            None => "`--out-reduced FILE` writes it".to_owned(),
        };
        [
            format!("{full} → {reduced} parameters{pattern}"),
            format!("{reason}."),
            format!(
                "Held-out position error, mean: {of_reduced} instead of {of_full} mm, on the same samples {apart}; {file}"
            ),
        ]
    }
}
