//! One problem as methods see it.

use nalgebra::DMatrix;

/// The balance that is asked for: Aᵀ f + w = 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Problem<'a> {
    pub(super) structure_matrix: &'a DMatrix<f64>,
    pub(super) wrench: &'a [f64],
}
