//! Machines in time.

use cdpr_plant::Energy;
use schemars::JsonSchema;
use serde::Serialize;

use super::adapters::tables;
use crate::recording::Violation;

/// Energy of platform, cables and weight.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Energy")]
#[schemars(rename = "Energy")]
pub(crate) struct EnergyKeys {
    /// Kinetic energy of the platform and the drums.
    kinetic: f64,
    /// Elastic energy of the cables at their controlled lengths.
    elastic: f64,
    /// Potential of the platform's weight and of constant forces, zero at the world's origin; moments of constant direction have none.
    potential: f64,
}

/// Limit that a cable broke.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Violation")]
#[schemars(rename = "Violation")]
pub(crate) struct ViolationKeys {
    /// Key of the robot file that states it.
    #[schemars(with = "String")]
    limit: Option<&'static str>,
    /// Limit (N); 0 for a slack cable.
    #[serde(rename = "limit_N")]
    bound: f64,
    /// Number of the cable, from 1.
    #[serde(getter = "number")]
    cable: usize,
    /// Time at which it happens first (s).
    #[serde(rename = "first_s")]
    first: f64,
    /// Tension farthest from the limit.
    #[serde(rename = "worst_N")]
    worst: f64,
    /// Length of all steps that end with it.
    #[serde(rename = "duration_s")]
    duration: f64,
    /// The violation in a sentence.
    words: String,
}

/// Cable that was slack.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Violation")]
#[schemars(rename = "Slack")]
pub(crate) struct SlackKeys {
    /// Number of the cable, from 1.
    #[serde(getter = "number")]
    cable: usize,
    /// Time at which it happens first (s).
    #[serde(rename = "first_s")]
    first: f64,
    /// Total length of the steps whose ends break the limit (s).
    #[serde(rename = "duration_s")]
    duration: f64,
}

fn number(violation: &Violation) -> usize {
    violation.cable + 1
}

tables!(EnergyKeys: Energy, ViolationKeys: Violation, SlackKeys: Violation);
