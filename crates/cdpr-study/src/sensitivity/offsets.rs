//! Winch offsets under deviations.

use serde::{Deserialize, Serialize};

use cdpr_model::reading::keywords;

keywords!(Offsets: Kept = "kept", SetAnew = "set-anew");

/// Effect of deviations on the winch offsets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Offsets {
    /// The offsets are numbers in the winches: they were set before anything deviated, and stay.
    #[default]
    Kept,
    /// The winches are set at the initial pose after everything has deviated, so that deviations that do the same everywhere are
    /// taken up.
    SetAnew,
}
