//! Errors of a model on samples without poses that it was not fitted to.

use cdpr_calibration::ErrorBlocks;
use cdpr_model::measurement::Split;
use schemars::JsonSchema;
use serde::Serialize;

use crate::keys::{ErrorBlockKeys, Maybe};
use crate::number_format::significant;

/// Errors of lengths and swivel angles at the poses where measurements agree best, of the calibrated model and of the one as given.
#[derive(Serialize, JsonSchema)]
pub struct PoselessJudgement {
    data: String,
    #[serde(flatten, with = "ErrorBlockKeys")]
    errors: ErrorBlocks,
    /// Of the model as given; `None` if it has no such poses.
    #[serde(with = "Maybe::<ErrorBlockKeys>")]
    before: Option<ErrorBlocks>,
}

impl PoselessJudgement {
    /// Errors on data of a name, after and before.
    pub fn new(data: String, errors: ErrorBlocks, before: Option<ErrorBlocks>) -> Self {
        Self { data, errors, before }
    }

    /// Errors on parts that calibrations did not see, scaled for what the poses of these samples take up of them.
    pub fn of_parts(split: Split, errors: ErrorBlocks, before: Option<ErrorBlocks>) -> Self {
        let data = format!("held-out parts ({split}; poses by their own rows, errors scaled for what these take up)");
        Self::new(data, errors, before)
    }

    pub(super) fn words(&self) -> String {
        let told = |errors: &ErrorBlocks| {
            let length = significant(1e3 * errors.length_error_m.rms, 3);
            let swivel = errors.swivel_error.as_ref().map(|swivel| significant(swivel.rms.to_degrees(), 3));
            format!("lengths {length} mm rms")
                + &swivel.map_or(String::new(), |swivel| format!(", swivels {swivel}° rms"))
        };
        let before = self.before.as_ref().map_or(String::new(), |before| format!(" (as given: {})", told(before)));
        format!("on {}: {}{before}\n", self.data, told(&self.errors))
    }
}
