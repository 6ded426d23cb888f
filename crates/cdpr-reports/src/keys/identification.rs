//! Identified models, with and without measured poses.

use cdpr_calibration::fit::Fit;
use cdpr_calibration::{Comparison, ErrorBlocks, GaugeFixing, ObjectiveValues, SelfCalibration, SensorFit};
use cdpr_calibration::{Minimize, Objective};
use cdpr_model::control::PoseErrorStatistics;
use cdpr_study::accuracy::Accuracy;
use cdpr_study::{Identification, JudgedOptimum, OptimumOf};
use serde::Serialize;

use super::adapters::tables;
use super::fit::{FitKeys, PoselessFitKeys};
use super::{Each, ErrorBlockKeys, Maybe, PoseErrorKeys, Word};

/// Fit with the errors that judge it.
#[derive(Serialize)]
#[serde(remote = "Identification")]
pub(crate) struct IdentificationKeys {
    #[serde(flatten, with = "FitKeys")]
    fit: Fit,
    #[serde(rename = "samples")]
    sample_count: usize,
    #[serde(with = "ErrorBlockKeys")]
    train: ErrorBlocks,
    #[serde(with = "ErrorBlockKeys")]
    train_before: ErrorBlocks,
    #[serde(with = "Maybe::<ErrorBlockKeys>", skip_serializing_if = "Option::is_none")]
    validation: Option<ErrorBlocks>,
    #[serde(with = "Maybe::<ErrorBlockKeys>", skip_serializing_if = "Option::is_none")]
    validation_before: Option<ErrorBlocks>,
    #[serde(with = "ObjectiveKeys")]
    objective_values: ObjectiveValues,
    #[serde(with = "ObjectiveKeys")]
    objective_values_before: ObjectiveValues,
}

/// Norms of the residual vectors of samples.
#[derive(Serialize)]
#[serde(remote = "ObjectiveValues")]
struct ObjectiveKeys {
    #[serde(with = "PoseErrorKeys")]
    length_norm_m: PoseErrorStatistics,
    #[serde(with = "PoseErrorKeys")]
    pose_norm_m: PoseErrorStatistics,
    rotation_length_m: f64,
}

/// Optimum of an objective, or the model as given, judged by all objectives.
#[derive(Serialize)]
#[serde(remote = "JudgedOptimum")]
pub(crate) struct OptimumKeys {
    #[serde(flatten, with = "Maybe::<OptimumOfKeys>")]
    of: Option<OptimumOf>,
    converged: bool,
    #[serde(flatten, with = "ObjectiveKeys")]
    values: ObjectiveValues,
    #[serde(with = "ErrorBlockKeys")]
    predicted: ErrorBlocks,
    #[serde(skip_serializing_if = "Option::is_none")]
    driven: Option<Accuracy>,
    #[serde(skip_serializing_if = "Option::is_none")]
    not_driven: Option<String>,
}

/// Objective and cost of an optimum.
#[derive(Serialize)]
#[serde(remote = "OptimumOf")]
struct OptimumOfKeys {
    #[serde(with = "Word")]
    objective: Objective,
    #[serde(with = "Word")]
    minimize: Minimize,
}

/// Robot calibrated by its own sensors.
#[derive(Serialize)]
#[serde(remote = "SelfCalibration")]
pub(crate) struct SelfCalibrationKeys {
    #[serde(flatten, with = "PoselessFitKeys")]
    fit: Fit,
    parameter_count: usize,
    equations: usize,
    cost_m2: f64,
    length_rms_m: f64,
    /// Residuals of each sensor, where there are others than lengths.
    #[serde(with = "Each::<SensorKeys>", skip_serializing_if = "Vec::is_empty")]
    sensors: Vec<SensorFit>,
    #[serde(with = "GaugeFixingKeys")]
    gauge: GaugeFixing,
}

/// Residuals of a sensor, in its `unit`.
#[derive(Serialize)]
#[serde(remote = "SensorFit")]
struct SensorKeys {
    sensor: &'static str,
    unit: &'static str,
    rms: f64,
    sigma: f64,
    is_stated: bool,
    rows: usize,
    redundancy: f64,
}

/// Motions that no row sees, and the convention that fixes them.
#[derive(Serialize)]
#[serde(remote = "GaugeFixing")]
struct GaugeFixingKeys {
    kind: &'static str,
    free: Vec<&'static str>,
    motions: Vec<String>,
    held: Vec<String>,
    at_origin: bool,
}

/// Anchors beside those of another robot.
#[derive(Serialize)]
#[serde(remote = "Comparison")]
pub(crate) struct ComparisonKeys {
    robot: String,
    rms_m: f64,
    distance_m: Vec<f64>,
    scale: f64,
    is_mirrored: bool,
}

tables!(
    OptimumKeys: JudgedOptimum,
    OptimumOfKeys: OptimumOf,
    SensorKeys: SensorFit,
    ComparisonKeys: Comparison,
);
