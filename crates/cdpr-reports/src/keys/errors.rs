//! Statistics of errors.

use cdpr_calibration::ErrorBlocks;
use cdpr_model::control::{LengthErrorStatistics, PoseErrorStatistics, TensionErrorStatistics};
use schemars::JsonSchema;
use serde::Serialize;

use super::Maybe;
use super::adapters::tables;
use super::table_schema::nullable_numbers;

/// Statistics of position (m) or rotation errors (rad) over poses; null without any.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "PoseErrorStatistics")]
#[schemars(rename = "PoseErrors", transform = nullable_numbers)]
pub(crate) struct PoseErrorKeys {
    /// Mean (eq. 3.4).
    mean: f64,
    /// Root mean square.
    rms: f64,
    /// Median.
    median: f64,
    /// 95 % quantile: 95 % of the errors are smaller.
    p95: f64,
    /// Largest.
    max: f64,
}

/// Statistics of length errors over poses and cables (m); null without any.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "LengthErrorStatistics")]
#[schemars(rename = "LengthErrors", transform = nullable_numbers)]
pub(crate) struct LengthErrorKeys {
    /// Mean of the magnitudes.
    mean_abs: f64,
    /// Root mean square.
    rms: f64,
    /// 95 % quantile of the magnitudes: 95 % are smaller.
    p95: f64,
    /// Largest magnitude.
    max: f64,
}

/// Statistics of tension errors over poses and cables (N); null without any.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "TensionErrorStatistics")]
#[schemars(rename = "TensionErrors", transform = nullable_numbers)]
pub(crate) struct TensionErrorKeys {
    /// Mean over poses of the 2-norm over cables.
    mean_norm: f64,
    /// Mean of the magnitudes.
    mean_abs: f64,
    /// Root mean square.
    rms: f64,
    /// Largest magnitude.
    max: f64,
}

/// Errors of a model on data.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "ErrorBlocks")]
#[schemars(rename = "ErrorBlocks")]
pub(crate) struct ErrorBlockKeys {
    /// Number of samples.
    samples: usize,
    /// Distance between predicted and measured position (m).
    #[serde(with = "PoseErrorKeys")]
    position_error_m: PoseErrorStatistics,
    /// Geodesic angle between predicted and measured orientation (rad).
    #[serde(with = "PoseErrorKeys")]
    rotation_error_rad: PoseErrorStatistics,
    /// Modelled minus recorded lengths at the measured poses (m).
    #[serde(with = "LengthErrorKeys")]
    length_error_m: LengthErrorStatistics,
    /// Predicted minus recorded tensions; null for a model that knows none, or data without.
    #[serde(rename = "tension_error_N", with = "Maybe::<TensionErrorKeys>", skip_serializing_if = "Option::is_none")]
    tension_error: Option<TensionErrorStatistics>,
    /// Modelled minus recorded swivel angles at the poses where measurements agree best; null where there are none.
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
