//! A control model as a controller uses it: lengths for poses.

use super::input_error::InputError;
use crate::geometry::Pose;
use crate::model::Model;
use crate::statics::{self, Load};
use crate::tension::{Limits, quadratic};

/// A control model that commands a machine.
pub(super) struct Controller<'a> {
    model: &'a Model,
    /// How tensions are chosen, where lengths depend on them.
    distribution: Option<Distribution>,
}

/// What the choice of tensions depends on.
struct Distribution {
    load: Load,
    limits: Limits,
    solver: quadratic::Solver,
}

impl<'a> Controller<'a> {
    pub(super) fn new(model: &'a Model) -> Result<Self, InputError> {
        let distribution = match model.composition().is_elastic() {
            true => Some(Distribution {
                load: Load::of(model.robot())?,
                limits: Limits::of(model.robot(), None, None)?,
                solver: quadratic::Solver::new(model.cable_count(), model.dof()),
            }),
            false => None,
        };
        Ok(Self { model, distribution })
    }

    /// Lengths for a pose in the units of the model's encoders (m), or why there are none.
    pub(super) fn lengths(&mut self, pose: &Pose) -> Result<Vec<f64>, String> {
        match &mut self.distribution {
            None => {
                let lengths = self.model.cable_lengths(pose).map_err(|reason| reason.to_string())?;
                Ok(recorded(self.model, &lengths))
            }
            Some(distribution) => {
                let tensions = distribution.tensions(self.model, pose)?;
                lengths_at(self.model, pose, tensions).map_err(|reason| reason.to_string())
            }
        }
    }
}

impl Distribution {
    /// The tensions nearest to the middle of the limits that keep them and balance the load (N), or why there are none.
    fn tensions(&mut self, model: &Model, pose: &Pose) -> Result<&[f64], String> {
        let structure_matrix = model.structure_matrix(pose).map_err(|reason| reason.to_string())?;
        let wrench = self.load.in_pattern(model, pose);
        // a pose is answered to the same bits whatever was asked before
        self.solver.forget();
        let found = self
            .solver
            .solve(&structure_matrix, wrench.as_slice(), &self.limits, None)
            .map_err(|error| error.to_string())?;
        match found.reason() {
            None => Ok(&found.tensions),
            Some(reason) => Err(format!("the control model finds no tensions: {reason}")),
        }
    }
}

/// Lengths with which a model's cables have these tensions at a pose, in the units of its encoders (m).
pub(super) fn lengths_at(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<Vec<f64>, statics::StaticsError> {
    Ok(recorded(model, &statics::controlled_lengths(model, pose, tensions)?))
}

fn recorded(model: &Model, controlled: &[f64]) -> Vec<f64> {
    controlled.iter().enumerate().map(|(cable, &length)| model.recorded_length(cable, length)).collect()
}
