//! The optimum of every objective, judged by all others.

use crate::accuracy::Accuracy;
use cdpr_calibration::evaluation::{ErrorBlocks, evaluate_fitted};
use cdpr_calibration::fit::{InputError, Settings, Status, fit};
use cdpr_calibration::{Minimize, Objective, ObjectiveValues};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, Model};
use cdpr_model::reading::Keyword;

/// An optimum, or the model as given, with all measures by which it is judged.
#[derive(Clone, Debug, PartialEq)]
pub struct JudgedOptimum {
    /// Objective and cost of the optimum; `None` for the model as given.
    pub of: Option<OptimumOf>,
    /// True if the search ended at an optimum.
    pub converged: bool,
    /// Costs of all objectives.
    pub values: ObjectiveValues,
    /// Errors of predicted poses from the recorded lengths, and of modelled lengths at the measured poses.
    pub predicted: ErrorBlocks,
    /// Accuracy of the controller with these parameters on a machine; `None` if there is none.
    pub driven: Option<Accuracy>,
    /// Reason in words for which it does not drive the machine.
    pub not_driven: Option<String>,
}

/// Outcome of driving a machine with a calibrated model.
#[derive(Clone, Debug, PartialEq)]
pub enum Driven {
    /// There is no machine.
    Nowhere,
    /// Errors on the machine.
    To(Box<Accuracy>),
    /// Reason for which it does not drive.
    Refused(String),
}

/// Objective and cost function of an optimum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OptimumOf {
    /// Residuals that are minimized.
    pub objective: Objective,
    /// Cost function over all samples.
    pub minimize: Minimize,
}

/// The model as given and the optimum of every objective under every cost, each judged by all objectives, and by
/// `drive`, which drives a machine with a calibrated model if there is one.
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
        if objective != Objective::Length && !objective.has_residuals(model, samples, settings) {
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
