//! Schemas of the parts of a capability that are put together key by key.

use schemars::JsonSchema;

use super::PoseAnswer;

/// Limit that a load, an acceleration or a speed comes to.
#[derive(JsonSchema)]
#[schemars(rename = "CapabilityLimit")]
#[expect(dead_code, reason = "only the schema is made of it")]
pub(super) struct LimitDetail {
    /// Kind of the limit.
    limit: String,
    /// Cable at the limit, from 1; null where no single one is.
    cable: Option<usize>,
    /// Name of the cable.
    cable_name: Option<String>,
    /// Cables at their largest tension, from 1.
    at_tension_max: Vec<usize>,
    /// Cables at their least tension, from 1.
    at_tension_min: Vec<usize>,
}

/// How a number was found, or the reason why there is none.
#[derive(JsonSchema)]
#[expect(dead_code, reason = "only the schema is made of it")]
pub(super) struct CapabilityDetail {
    /// Limit that no more is possible for.
    limited_by: Option<LimitDetail>,
    /// Pose at which it is.
    at_pose: Option<PoseAnswer>,
    /// Mass that is carried for certain (kg).
    #[serde(rename = "at_least_kg")]
    #[serde(skip_serializing_if = "Option::is_none")]
    mass: Option<f64>,
    /// Speed that is kept for certain (m/s).
    #[serde(rename = "at_least_m_s")]
    #[serde(skip_serializing_if = "Option::is_none")]
    speed: Option<f64>,
    /// Acceleration that is kept for certain (m/s²).
    #[serde(rename = "at_least_m_s2")]
    #[serde(skip_serializing_if = "Option::is_none")]
    acceleration: Option<f64>,
    /// Share by which the number may be too large.
    #[serde(skip_serializing_if = "Option::is_none")]
    gap: Option<f64>,
    /// Direction at which it is, as a unit vector.
    #[serde(skip_serializing_if = "Option::is_none")]
    direction: Option<Vec<f64>>,
    /// Reason why there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

/// Accelerations in every direction and along the axes.
#[derive(JsonSchema)]
#[expect(dead_code, reason = "only the schema is made of it")]
pub(super) struct AccelerationValues {
    /// Acceleration in every direction (m/s²).
    ball: Option<f64>,
    /// Acceleration in both senses of each axis (m/s²).
    per_axis: Vec<Option<f64>>,
}

/// Details of accelerations in every direction and along the axes.
#[derive(JsonSchema)]
#[expect(dead_code, reason = "only the schema is made of it")]
pub(super) struct AccelerationDetails {
    /// Acceleration in every direction.
    ball: CapabilityDetail,
    /// Acceleration in both senses of each axis.
    per_axis: Vec<CapabilityDetail>,
}

/// Pose at which the own load is not held.
#[derive(JsonSchema)]
#[expect(dead_code, reason = "only the schema is made of it")]
pub(super) struct PoseNotHeld {
    /// The pose.
    at_pose: PoseAnswer,
    /// Force that is lacking (N).
    #[serde(rename = "lacking_N")]
    lacking: f64,
    /// Limit that is in the way.
    limited_by: LimitDetail,
}
