//! Every objective's optimum, judged by all others.

use serde::Serialize;

use super::metric::default_length;
use super::problem::ObjectiveVectors;
use super::{Minimize, Objective};
use crate::identification::evaluation::{ErrorBlocks, Evaluation, evaluate_fitted};
use crate::identification::fit::{InputError, Settings, Status, fit};
use crate::measurement::Samples;
use crate::metamodel::accuracy::Accuracy;
use crate::metamodel::errors::PoseErrorStatistics;
use crate::model::{FreeParameters, Model};
use crate::reading::Keyword;

/// Norms of the residual vectors of samples: their rms, mean and maximum are what the costs of both objectives minimise.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ObjectiveValues {
    /// 2-norm over the cables of a sample's length residuals (m).
    pub length_norm_m: PoseErrorStatistics,
    /// √(‖Δr‖² + L² Δφ²) of a sample's predicted pose (m).
    pub pose_norm_m: PoseErrorStatistics,
    /// L, the length by which rotations count (m).
    pub rotation_length_m: f64,
}

/// An optimum, or the model as given, with everything it is judged by.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct JudgedOptimum {
    /// Objective and cost of the optimum; `None` for the model as given.
    #[serde(flatten)]
    pub of: Option<OptimumOf>,
    /// True where the search ended at an optimum.
    pub converged: bool,
    /// Costs of all objectives.
    #[serde(flatten)]
    pub values: ObjectiveValues,
    /// Predicted poses from the recorded lengths, and modelled lengths at the measured poses.
    pub predicted: ErrorBlocks,
    /// The controller with these parameters on a machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub driven: Option<Accuracy>,
    /// Reason in words why it does not drive there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub not_driven: Option<String>,
}

/// Outcome of putting a calibrated model on a machine.
#[derive(Clone, Debug, PartialEq)]
pub enum Driven {
    /// There is no machine.
    Nowhere,
    /// Errors there.
    To(Box<Accuracy>),
    /// Reason why it does not drive.
    Refused(String),
}

/// Objective and cost of an optimum.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OptimumOf {
    /// Residuals.
    pub objective: Objective,
    /// Cost of all samples.
    pub minimize: Minimize,
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

/// The model as given and the optimum of every objective under every cost, each judged by all of them, and by `drive`, which puts a calibrated
/// model on a machine where there is one.
pub fn compare_objectives(
    model: &Model,
    samples: &Samples,
    free: &FreeParameters,
    settings: &Settings,
    drive: &dyn Fn(&Model) -> Driven,
) -> Result<Vec<JudgedOptimum>, InputError> {
    let judged = |calibrated: &Model, of: Option<OptimumOf>, converged: bool| {
        let errors = evaluate_fitted(calibrated, samples).ok()?;
        let (driven, not_driven) = match drive(calibrated) {
            Driven::Nowhere => (None, None),
            Driven::To(accuracy) => (Some(*accuracy), None),
            Driven::Refused(reason) => (None, Some(reason)),
        };
        Some(JudgedOptimum {
            of,
            converged,
            values: ObjectiveValues::of(model, samples, &errors, settings.rotation_length),
            predicted: errors.blocks(),
            driven,
            not_driven,
        })
    };
    let mut all: Vec<JudgedOptimum> = judged(model, None, true).into_iter().collect();
    for &objective in Objective::ALL {
        if objective == Objective::Both
            && ObjectiveVectors::of(model, samples, &[], &Settings { objective, ..settings.clone() }).is_err()
        {
            continue;
        }
        for &minimize in Minimize::ALL {
            let settings = Settings { objective, minimize, ..settings.clone() };
            let found = fit(model, samples, free, &settings)?;
            let converged = found.status != Status::NotConverged;
            all.extend(judged(&found.model, Some(OptimumOf { objective, minimize }), converged));
        }
    }
    Ok(all)
}
