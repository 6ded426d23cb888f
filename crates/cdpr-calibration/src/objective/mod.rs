//! Objectives of an identification: which residuals are made small, and by which cost of all samples.

mod balance;
mod bends;
mod cost;
mod dense;
mod fit;
mod lengths;
mod metric;
mod minimax;
mod pose_squares;
mod poseless;
mod poses;
mod problem;
mod report;
mod robust;
mod sensors;
#[cfg(test)]
mod tests;
mod unknown_poses;
mod values;
mod vectors;

pub(super) use fit::{Units, check_recording, optimum, search};
pub use minimax::{ActiveSample, Certificate};
pub(super) use poseless::PoselessVectors;
pub(super) use report::{fit, report};
pub(super) use sensors::{Layout, Sensor, SensorVectors, Swivel, Weights};
use serde::Serialize;

use cdpr_model::reading::{Keyword, keywords};

pub use values::ObjectiveValues;
pub(super) use vectors::{Latent, Stacked, Vectors};

/// Residuals that an identification makes small.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Objective {
    /// Modelled minus recorded lengths at the measured poses, of elastic models with the wrenches there (joint space, eq. 4.8, 4.38).
    #[default]
    Length,
    /// Predicted minus measured poses at the recorded lengths, of elastic models with the tensions there (Cartesian space, eq. 4.1, 4.31).
    Pose,
    /// Both together, each in its stated accuracy, of rigid models: poses are unknowns beside the parameters (total least squares).
    Both,
}

/// Cost of the residual vectors of all samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Minimize {
    /// Σ ‖r‖² (eq. 4.10).
    #[default]
    Squares,
    /// Mean of ‖r‖ (eq. 3.9).
    Mean,
    /// Largest ‖r‖ (eq. 3.10).
    Max,
}

keywords!(Objective: Length = "length", Pose = "pose", Both = "both");

keywords!(Minimize: Squares = "squares", Mean = "mean", Max = "max");

impl std::fmt::Display for Minimize {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(self.name())
    }
}
