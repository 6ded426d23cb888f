//! Source of a robot's numbers, and what it prints of real machines.

use serde::{Deserialize, Serialize};

/// Source of a robot's numbers.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// Publication or owner.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub citation: Option<String>,
    /// Equations or tables of the publication.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub equations: Option<String>,
    /// Repository the numbers were read from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub repository: Option<String>,
    /// Commit of that repository.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub commit: Option<String>,
    /// Licence of the numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub licence: Option<String>,
    /// File in that repository.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Errors that publications print of real machines; `cdpr benchmark` shows them beside its own.
    #[serde(default, skip_serializing)]
    pub published: Vec<PublishedErrors>,
}

/// Mean errors of a real machine, as a publication prints them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct PublishedErrors {
    /// Machine, its state and its control model in words.
    pub machine: String,
    /// Mean position error (m).
    pub position_mean_m: f64,
    /// Mean rotation error (rad).
    pub rotation_mean_rad: Option<f64>,
    /// Mean magnitude of the length errors (m).
    pub length_mean_abs_m: Option<f64>,
    /// Mean over poses of the 2-norm of the tension errors (N).
    pub tension_mean_norm_N: Option<f64>,
    /// Publication with section or equation.
    pub source: String,
}
