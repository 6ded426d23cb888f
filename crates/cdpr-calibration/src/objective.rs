//! Objectives of an identification: which residuals are made small, and by which cost of all samples.

use cdpr_model::reading::{Keyword, keywords};

/// Residuals that an identification makes small.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Objective {
    /// Modelled minus recorded lengths at the measured poses, of elastic models with the wrenches there (joint space, eq. 4.8, 4.38).
    #[default]
    Length,
    /// Predicted minus measured poses at the recorded lengths, of elastic models with the tensions there (Cartesian space, eq. 4.1, 4.31).
    Pose,
    /// The same, poses in the box of a task by their full weight, others by less (Cartesian space, where it matters).
    PoseInTask,
    /// Both together, each in its stated accuracy, of rigid models: poses are unknowns beside the parameters (total least squares).
    Both,
}

/// Cost of the residual vectors of all samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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

keywords!(Objective: Length = "length", Pose = "pose", PoseInTask = "pose-in-task", Both = "both");

keywords!(Minimize: Squares = "squares", Mean = "mean", Max = "max");

impl std::fmt::Display for Minimize {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(self.name())
    }
}
