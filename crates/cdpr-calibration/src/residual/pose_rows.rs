//! Whitened rows of a model at its optimum, by its parameters and by the motion of the platform.

use nalgebra::{DMatrix, DVector};

use cdpr_model::geometry::{Pose, Wrench};

/// Whitened rows that share parameters.
pub(crate) struct RowBlock {
    /// Places of the parameters in the list of all.
    pub(crate) parameters: Vec<usize>,
    /// Rows by these parameters.
    pub(crate) by_parameters: DMatrix<f64>,
    /// Rows by the motion of the platform along the degrees of freedom of the pattern.
    pub(crate) by_pose: DMatrix<f64>,
    pub(crate) residuals: DVector<f64>,
    /// Rows of one sample, which follow each other.
    pub(crate) rows_of_sample: usize,
    /// Poses at which the rows hold: the measured ones, or where the model and they agree best.
    pub(crate) poses: Vec<Pose>,
    /// Wrenches among the rows.
    pub(crate) wrenches: Option<Wrenches>,
}

/// Wrenches that the rows of a sample balance, for the part of a row's change that only its axes make: a motion of everything together turns them,
/// or moves the point that they are about, and changes no balance.
pub(crate) struct Wrenches {
    /// Imbalance of each sample (world, about the platform's origin).
    pub(crate) residuals: Vec<Wrench>,
    /// Whitened rows by wrenches along the degrees of freedom of the pattern.
    pub(crate) whitened: DMatrix<f64>,
}
