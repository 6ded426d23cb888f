//! Norms of the residuals that objectives make small.

use cdpr_model::control::PoseErrorStatistics;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;

use crate::evaluation::Evaluation;
use crate::residual::default_length;

/// Norms of the residual vectors of samples: their rms, mean and maximum are what the costs of both objectives minimise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectiveValues {
    /// 2-norm over the cables of a sample's length residuals (m).
    pub length_norm_m: PoseErrorStatistics,
    /// √(‖Δr‖² + L² Δφ²) of a sample's predicted pose (m).
    pub pose_norm_m: PoseErrorStatistics,
    /// L, the length by which rotations count (m).
    pub rotation_length_m: f64,
}

impl ObjectiveValues {
    /// Values of a model's errors on samples; L is the default one without a length.
    pub fn of(model: &Model, samples: &Samples, errors: &Evaluation, rotation_length: Option<f64>) -> Self {
        let length = rotation_length.unwrap_or_else(|| default_length(model, samples));
        let poses = errors.position.iter().zip(&errors.rotation);
        let poses = poses.map(|(position, rotation)| position.hypot(length * rotation));
        let lengths = errors.length.chunks(errors.cable_count.max(1));
        let lengths = lengths.map(|sample| sample.iter().map(|residual| residual * residual).sum::<f64>().sqrt());
        Self { length_norm_m: finite(lengths), pose_norm_m: finite(poses), rotation_length_m: length }
    }
}

/// Statistics of the norms that are numbers.
fn finite(norms: impl Iterator<Item = f64>) -> PoseErrorStatistics {
    PoseErrorStatistics::of(&norms.filter(|norm| norm.is_finite()).collect::<Vec<_>>())
}
