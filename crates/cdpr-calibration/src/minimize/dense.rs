//! Normal equations of parameters that tie all samples together.

use nalgebra::{DMatrix, DVector};

use super::descent::{Equations, damped_step};
use cdpr_model::solve::NormalSystem;

/// Cost with half its derivatives.
#[derive(Clone, Debug)]
pub(crate) struct DenseEquations {
    pub(crate) cost: f64,
    pub(crate) gradient: DVector<f64>,
    pub(crate) hessian: DMatrix<f64>,
}

impl DenseEquations {
    pub(crate) fn new(parameters: usize) -> Self {
        Self {
            cost: f64::INFINITY,
            gradient: DVector::zeros(parameters),
            hessian: DMatrix::zeros(parameters, parameters),
        }
    }
}

impl NormalSystem for DenseEquations {
    fn gradient(&self, k: usize) -> f64 {
        self.gradient[k]
    }

    fn entry(&self, i: usize, j: usize) -> f64 {
        self.hessian[(i, j)]
    }

    #[inline]
    fn column(&self, j: usize) -> impl Fn(usize) -> f64 {
        let column = &self.hessian.as_slice()[j * self.gradient.len()..][..self.gradient.len()];
        move |i| column[i]
    }

    fn damped(&self, held: &[bool], damping: f64, step: &mut [f64]) -> Option<()> {
        damped_step(self, held, damping, step)
    }
}

impl Equations for DenseEquations {
    fn cost(&self) -> f64 {
        self.cost
    }
}
