//! Statistics of errors.

use cdpr_calibration::ErrorBlocks;
use cdpr_model::control::{LengthErrorStatistics, PoseErrorStatistics, TensionErrorStatistics};
use schemars::JsonSchema;
use serde::Serialize;

use super::Maybe;
use super::adapters::{nullable_numbers, tables};

/// Statistics of position (m) or rotation errors (rad) over poses; null without any.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "PoseErrorStatistics")]
#[schemars(rename = "PoseErrors", transform = nullable_numbers)]
pub(crate) struct PoseErrorKeys {
    mean: f64,
    rms: f64,
    median: f64,
    p95: f64,
    max: f64,
}

/// Statistics of length errors over poses and cables (m); null without any.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "LengthErrorStatistics")]
#[schemars(rename = "LengthErrors", transform = nullable_numbers)]
pub(crate) struct LengthErrorKeys {
    mean_abs: f64,
    rms: f64,
    p95: f64,
    max: f64,
}

/// Statistics of tension errors over poses and cables (N); null without any.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "TensionErrorStatistics")]
#[schemars(rename = "TensionErrors", transform = nullable_numbers)]
pub(crate) struct TensionErrorKeys {
    /// Mean over poses of the 2-norm over cables.
    mean_norm: f64,
    mean_abs: f64,
    rms: f64,
    max: f64,
}

/// Errors of a model on data.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "ErrorBlocks")]
#[schemars(rename = "ErrorBlocks")]
pub(crate) struct ErrorBlockKeys {
    samples: usize,
    #[serde(with = "PoseErrorKeys")]
    position_error_m: PoseErrorStatistics,
    #[serde(with = "PoseErrorKeys")]
    rotation_error_rad: PoseErrorStatistics,
    #[serde(with = "LengthErrorKeys")]
    length_error_m: LengthErrorStatistics,
    #[serde(rename = "tension_error_N", with = "Maybe::<TensionErrorKeys>", skip_serializing_if = "Option::is_none")]
    tension_error: Option<TensionErrorStatistics>,
    #[serde(rename = "swivel_error_rad", with = "Maybe::<LengthErrorKeys>", skip_serializing_if = "Option::is_none")]
    swivel_error: Option<LengthErrorStatistics>,
    /// Samples whose forward problem has an answer.
    answered: usize,
    /// Samples whose forward problem has none.
    not_converged: usize,
    /// Samples with a modelled length of every cable.
    length_samples: usize,
}

tables!(
    PoseErrorKeys: PoseErrorStatistics,
    LengthErrorKeys: LengthErrorStatistics,
    TensionErrorKeys: TensionErrorStatistics,
    ErrorBlockKeys: ErrorBlocks,
);
