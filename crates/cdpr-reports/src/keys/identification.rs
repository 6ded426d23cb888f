//! Identified models, with and without measured poses.

use cdpr_calibration::fit::Fit;
use cdpr_calibration::{
    Comparison, ErrorBlocks, GaugeFixing, ObjectiveValues, PredictedBand, SelfCalibration, SensorFit,
};
use cdpr_model::reading::Keyword;
use cdpr_study::{Identification, JudgedOptimum, OptimumOf};
use serde::Serialize;

use super::adapters::keys;
use super::fit::{FitKeys, PoselessFitKeys};
use super::{AccuracyKeys, Each, ErrorBlockKeys, Maybe, PoseErrorKeys, PredictedBandKeys};

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
    #[serde(flatten, with = "Maybe::<PredictedBandKeys>")]
    band: Option<PredictedBand>,
}

keys! {
    /// Norms of the residual vectors of samples.
    ObjectiveKeys of ObjectiveValues { length_norm_m by PoseErrorKeys, pose_norm_m by PoseErrorKeys, rotation_length_m }
    /// Optimum of an objective, or the model as given, judged by all objectives.
    OptimumKeys of JudgedOptimum {
        of among OptimumOfKeys, converged, values among ObjectiveKeys, predicted by ErrorBlockKeys,
        driven unless none by Maybe<AccuracyKeys>, not_driven unless none,
    }
    /// Objective and cost of an optimum.
    OptimumOfKeys of OptimumOf { objective.name(), minimize.name() }
    /// Residuals of a sensor, in its `unit`.
    SensorKeys of SensorFit { sensor, unit, rms, sigma, is_stated, rows, redundancy }
    /// Motions that no row sees, and the convention that fixes them.
    GaugeFixingKeys of GaugeFixing { kind, free, motions, held, at_origin }
    /// Anchors beside those of another robot.
    ComparisonKeys of Comparison { robot, rms_m, distance_m, scale, is_mirrored }
}
