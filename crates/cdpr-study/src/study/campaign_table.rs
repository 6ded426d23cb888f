//! Rounds of planned measurements in a study file.

use serde::Deserialize;

/// Rounds in which poses are planned, measured and identified from (`cdpr campaign`).
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CampaignTable {
    /// Parameters to identify, by the names of `cdpr identify --free`.
    pub free: String,
    /// Parameters that stay as they are although `free` names them.
    #[serde(default)]
    pub hold: String,
    /// Ridges towards the file's values, e.g. `["platform-anchor=0.02"]`.
    #[serde(default)]
    pub prior: Vec<String>,
    /// Measure by which poses are chosen, by the names of `cdpr plan --criterion`; `d` when missing.
    pub criterion: Option<String>,
    /// Poses to measure in every round.
    #[schemars(range(min = 1))]
    pub poses_per_round: usize,
    /// Levels of tension of an elastic control model at every pose, from which a design chooses as from poses: the middle of the limits, and those towards both ends of every direction that changes no wrench; 1 when missing.
    #[serde(default = "tension_levels")]
    #[schemars(range(min = 1))]
    pub tension_levels: usize,
    /// Most rounds; 10 when missing.
    #[serde(default = "rounds")]
    #[schemars(range(min = 1, max = 1000))]
    pub rounds: u32,
    /// Most poses over all rounds.
    #[schemars(range(min = 1))]
    pub budget: Option<usize>,
    /// Mean position error on held-out samples at which the campaign ends (m).
    pub accuracy_m: Option<f64>,
    /// Source of the records.
    #[serde(default)]
    pub record: CampaignRecord,
}

/// Source of the records of a campaign.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CampaignRecord {
    /// The machine of the study, with its sensor noise.
    #[default]
    Virtual,
    /// Files that a real robot recorded: the campaign waits for them.
    Files,
}

fn tension_levels() -> usize {
    1
}

fn rounds() -> u32 {
    10
}
