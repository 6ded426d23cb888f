//! Vectors of elastic models in joint space: wrenches and lengths at the measured poses and tensions (eq. 4.38), whitened there.

use super::vectors::{Stacked, Vectors};
use crate::elastostatic::Balance;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Wrench and length residuals in standard deviations of what was measured, n + m a sample.
pub(super) struct BalanceVectors<'a> {
    model: &'a Model,
    samples: &'a Samples,
    parameters: &'a [Parameter],
    balance: Balance,
}

impl<'a> BalanceVectors<'a> {
    pub(super) fn new(model: &'a Model, samples: &'a Samples, parameters: &'a [Parameter], balance: Balance) -> Self {
        Self { model, samples, parameters, balance }
    }
}

impl Vectors for BalanceVectors<'_> {
    fn size(&self) -> usize {
        self.model.dof() + self.model.cable_count()
    }

    fn samples(&self) -> usize {
        self.samples.len()
    }

    fn write(&mut self, values: &[f64], stacked: &mut Stacked) -> bool {
        let Some(model) = self.model.with_parameters(self.parameters, values) else { return false };
        let entries = |row: usize, column: Option<usize>, value: f64| match column {
            Some(column) => stacked.jacobian[(row, column)] = value,
            None => stacked.residuals[row] = value,
        };
        self.balance.write(&model, self.samples, self.parameters, entries).is_some() && stacked.is_finite()
    }
}
