//! Verdict on force control after an identification, as answers tell it.

use cdpr_study::force_tracking::ForceTracking;
use schemars::JsonSchema;
use serde::Serialize;

use crate::keys::ForceTrackingKeys;

/// Comparison of a force controller with the one before.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ForceTracking")]
pub(super) struct TrackingAnswer {
    /// The control model before.
    before: String,
    #[serde(flatten, with = "ForceTrackingKeys")]
    tracking: ForceTracking,
}

impl TrackingAnswer {
    pub(super) fn new(before: String, tracking: ForceTracking) -> Self {
        Self { before, tracking }
    }

    /// True if the machine follows the commanded tensions worse than before.
    pub(super) fn is_worse(&self) -> bool {
        self.tracking.is_worse()
    }

    /// Both errors in newtons.
    pub(super) fn change(&self) -> String {
        let ForceTracking { before_mean_norm_N: before, after_mean_norm_N: after, .. } = self.tracking;
        format!("{before:.1} → {after:.1} N")
    }

    /// The caution that stands before all else; `None` unless the machine follows the tensions worse.
    pub(super) fn caution(&self) -> Option<String> {
        self.is_worse().then(|| {
            format!(
                "force tracking is worse than with the control model before ({}): tensions miss the commanded ones by {}, the mean norm over the \
                 cables. Numbers that fit poses and lengths may stand for effects of the machine that the model lacks: forces need a model with these effects, or \
                 the one before",
                self.before,
                self.change()
            )
        })
    }
}
