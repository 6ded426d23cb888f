//! Whitened rows of a model at its optimum for given frames.

use crate::fit::{InputError, Settings};
use crate::identifiability::prior_weights;
use crate::problem::Problem;
use crate::progress::unobserved;
use crate::residual::rows::RowBlock;
use cdpr_model::geometry::Twist;
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Model, RecordingParameter};
use cdpr_model::robot::Parameter;

/// A model at its optimum for given frames.
pub(super) struct Fitted {
    pub(super) blocks: Vec<RowBlock>,
    /// Values of the parameters, and those of the file.
    pub(super) values: Vec<f64>,
    pub(super) start: Vec<f64>,
    pub(super) basis: Vec<Twist>,
    /// 1/σ² of the parameters' priors, 0 without one.
    pub(super) priors: Vec<f64>,
}

impl Fitted {
    pub(super) fn of(
        model: &Model,
        samples: &Samples,
        parameters: &[Parameter],
        settings: &Settings,
    ) -> Result<Self, InputError> {
        let mut problem = Problem::new(model, samples, parameters, settings)?;
        let optimum = problem.minimize(&unobserved)?;
        let calibrated = problem.model_at(&optimum.end.values)?;
        let rows = problem.residual.pose_rows(&calibrated, &optimum.end.values, &optimum.norms);
        let blocks =
            rows.unwrap_or(Err(InputError::RecordingCost { name: RecordingParameter::TrackerFrame.name() }))?;
        let values = |model: &Model| parameters.iter().map(|parameter| parameter.value(model.robot())).collect();
        Ok(Self {
            blocks,
            values: values(&calibrated),
            start: values(model),
            basis: model.twist_basis().to_vec(),
            priors: prior_weights(parameters, settings),
        })
    }
}
