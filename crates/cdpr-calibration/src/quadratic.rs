//! Half the weighted squares of a model near parameter values.

use nalgebra::{DMatrix, DVector};

/// Value ½χ² with its derivatives by the parameters, the second ones without those of the residuals (JᵀWJ).
#[derive(Clone, Debug)]
pub(super) struct Quadratic {
    pub(super) value: f64,
    pub(super) gradient: DVector<f64>,
    pub(super) hessian: DMatrix<f64>,
}

/// Half the weighted squares of data and priors, with weights that do not change.
pub(super) trait HalfSquares {
    /// Writes value and derivatives at parameter values; false where a row is not finite.
    fn write(&mut self, values: &[f64], to: &mut Quadratic) -> bool;
}

impl Quadratic {
    pub(super) fn new(parameters: usize) -> Self {
        Self {
            value: f64::INFINITY,
            gradient: DVector::zeros(parameters),
            hessian: DMatrix::zeros(parameters, parameters),
        }
    }
}
