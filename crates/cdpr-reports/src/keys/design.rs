//! Planned measurements.

use cdpr_calibration::{CurvePoint, GridComparison, ParameterPrediction, Plan, PosePrediction, Predicted};
use serde::Serialize;

use super::adapters::tables;
use super::{Each, Maybe};

/// Poses that tell most, with what they tell.
#[derive(Serialize)]
#[serde(remote = "Plan")]
pub(crate) struct PlanKeys {
    parameter_count: usize,
    rank: usize,
    log_det: Option<f64>,
    condition: Option<f64>,
    sigma_min: f64,
    trace_inverse: Option<f64>,
    i_value: Option<f64>,
    starts: u32,
    #[serde(rename = "share")]
    fraction: f64,
    #[serde(with = "Each::<CurvePointKeys>")]
    curve: Vec<CurvePoint>,
    #[serde(with = "GridKeys")]
    grid: GridComparison,
    all_log_det: Option<f64>,
}

/// Information of the best poses of a number.
#[derive(Serialize)]
#[serde(remote = "CurvePoint")]
struct CurvePointKeys {
    count: usize,
    log_det: Option<f64>,
}

/// Plain grid of as many poses.
#[derive(Serialize)]
#[serde(remote = "GridComparison")]
struct GridKeys {
    log_det: Option<f64>,
    efficiency: Option<f64>,
}

/// Deviations that measurements lead to.
#[derive(Serialize)]
#[serde(remote = "Predicted")]
pub(crate) struct PredictedKeys {
    #[serde(rename = "assumed_length_sigma_m")]
    assumed: Option<f64>,
    #[serde(with = "Each::<ParameterPredictionKeys>")]
    deviations: Vec<ParameterPrediction>,
    #[serde(with = "Maybe::<PosePredictionKeys>")]
    pose: Option<PosePrediction>,
    weak_directions: Vec<String>,
}

/// Deviation of a parameter, in its `unit`.
#[derive(Serialize)]
#[serde(remote = "ParameterPrediction")]
struct ParameterPredictionKeys {
    parameter: String,
    unit: &'static str,
    sigma: Option<f64>,
}

/// Deviation of the pose that a controller with the identified parameters drives to.
#[derive(Serialize)]
#[serde(remote = "PosePrediction")]
struct PosePredictionKeys {
    position_m: f64,
    position_max_m: f64,
    rotation_rad: f64,
    poses: usize,
}

tables!(
    CurvePointKeys: CurvePoint,
    PredictedKeys: Predicted,
    ParameterPredictionKeys: ParameterPrediction,
    PosePredictionKeys: PosePrediction,
);
