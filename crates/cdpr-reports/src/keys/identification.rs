//! Identified models, with and without measured poses.

use cdpr_calibration::fit::Fit;
use cdpr_calibration::{
    Comparison, ErrorBlocks, GaugeFixing, ObjectiveValues, PredictedBand, SelfCalibration, SensorFit,
};
use cdpr_model::reading::Keyword;
use cdpr_study::{Identification, JudgedOptimum, OptimumOf};
use schemars::JsonSchema;
use serde::Serialize;

use super::adapters::keys;
use super::fit::{FitKeys, PoselessFitKeys};
use super::{AccuracyKeys, Each, ErrorBlockKeys, Maybe, PoseErrorKeys, PredictedBandKeys};

/// Fit with the errors that judge it.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Identification")]
pub(crate) struct IdentificationKeys {
    #[serde(flatten, with = "FitKeys")]
    fit: Fit,
    /// Number of samples that it was fitted to.
    #[serde(rename = "samples")]
    sample_count: usize,
    /// Errors of the calibrated model on these samples.
    #[serde(with = "ErrorBlockKeys")]
    train: ErrorBlocks,
    /// Errors of the model as given on these samples.
    #[serde(with = "ErrorBlockKeys")]
    train_before: ErrorBlocks,
    /// Errors of the calibrated model on samples that it was not fitted to; null if there are none.
    #[serde(with = "Maybe::<ErrorBlockKeys>", skip_serializing_if = "Option::is_none")]
    validation: Option<ErrorBlocks>,
    /// Errors of the model as given on these samples.
    #[serde(with = "Maybe::<ErrorBlockKeys>", skip_serializing_if = "Option::is_none")]
    validation_before: Option<ErrorBlocks>,
    /// Values of every objective for the calibrated model on the samples of the fit.
    #[serde(with = "ObjectiveKeys")]
    objective_values: ObjectiveValues,
    /// Values of every objective for the model as given.
    #[serde(with = "ObjectiveKeys")]
    objective_values_before: ObjectiveValues,
}

/// Robot calibrated by its own sensors.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "SelfCalibration")]
pub(crate) struct SelfCalibrationKeys {
    #[serde(flatten, with = "PoselessFitKeys")]
    fit: Fit,
    /// Free parameters, those that the gauge holds included.
    parameter_count: usize,
    /// Equations that the poses leave for the parameters.
    equations: usize,
    /// Σ of the squared length residuals (m²).
    cost_m2: f64,
    /// Their root mean square (m).
    length_rms_m: f64,
    /// Residuals of each sensor, where there are others than lengths.
    #[serde(with = "Each::<SensorKeys>", skip_serializing_if = "Vec::is_empty")]
    sensors: Vec<SensorFit>,
    /// Motions of everything that the data leave free, and parameters that fix them.
    #[serde(with = "GaugeFixingKeys")]
    gauge: GaugeFixing,
    #[serde(flatten, with = "Maybe::<PredictedBandKeys>")]
    #[schemars(with = "Option<PredictedBandKeys>")]
    band: Option<PredictedBand>,
}

keys! {
    /// Norms of the residual vectors of samples.
    ObjectiveKeys as "ObjectiveValues" of ObjectiveValues {
        /// 2-norm over the cables of a sample's length residuals (m).
        length_norm_m by PoseErrorKeys,
        /// √(‖Δr‖² + L² Δφ²) of a sample's predicted pose (m).
        pose_norm_m by PoseErrorKeys,
        /// L, the length by which rotations count (m).
        rotation_length_m,
    }
    /// Optimum of an objective, or the model as given, judged by all objectives.
    OptimumKeys of JudgedOptimum {
        /// Objective and cost of the optimum; null for the model as given.
        of unless none among OptimumOfKeys,
        /// True if the search ended at an optimum.
        converged,
        /// Costs of all objectives.
        values among ObjectiveKeys,
        /// Errors of predicted poses from the recorded lengths, and of modelled lengths at the measured poses.
        predicted by ErrorBlockKeys,
        /// Accuracy of the controller with these parameters on a machine; null if there is none.
        driven unless none by Maybe<AccuracyKeys>,
        /// Reason in words for which it does not drive the machine.
        not_driven unless none,
    }
    /// Objective and cost of an optimum.
    OptimumOfKeys of OptimumOf {
        /// Residuals that are minimized.
        objective.name(),
        /// Cost function over all samples.
        minimize.name(),
    }
    /// Residuals of a sensor, in its `unit`.
    SensorKeys of SensorFit {
        /// `length`, `tension`, `swivel`, `position` or `rotation`.
        sensor,
        /// Unit of the deviations: m, N or rad.
        unit,
        /// Root mean square of the residuals.
        rms,
        /// Accuracy that weighs the rows, as a standard deviation.
        sigma,
        /// True where the accuracy is stated; another one is found from the residuals.
        is_stated,
        /// Its rows.
        rows,
        /// Rows that neither poses nor parameters use up: what is left to judge it by.
        redundancy,
    }
    /// Motions that no row sees, and the convention that fixes them.
    GaugeFixingKeys of GaugeFixing {
        /// `anchors`: parameters held at the file's values; `least-change`: anchors as near to the file's as the data let them be; `known`: measurements leave nothing to fix.
        kind,
        /// Freedom that the data leave: `translation`, `rotation`, `mirror`, `scale`.
        free,
        /// The motions that no row sees, and the size where the lengths leave it open.
        motions,
        /// Parameters that stay at the file's values to fix them.
        held,
        /// True where lengths count from their values at the world's origin.
        at_origin,
    }
    /// Anchors beside those of another robot.
    ComparisonKeys as "AnchorComparison" of Comparison {
        /// Name of the other robot.
        robot,
        /// Root mean square of the anchors' distances from its anchors (m).
        rms_m,
        /// Distance of each anchor, cable by cable (m).
        distance_m,
        /// Factor by which the other robot is larger; it is not taken away from the distances.
        scale,
        /// True where the mirror image was taken.
        is_mirrored,
    }
}
