//! Lengths and wrenches of an elastic model with the weights and corrections of its optimum.

use super::descent::Problem;
use super::linearization::Linearization;
use super::normal::NormalEquations;
use super::optimum::Optimum;
use super::rows::{SampleRows, first_columns};
use crate::fit::Settings;
use crate::quadratic::{HalfSquares, Quadratic};
use cdpr_model::measurement::Samples;
use cdpr_model::robot::Parameter;

/// Rows of all samples where poses, tensions and weights no longer change.
pub(crate) struct FrozenBalance<'a> {
    problem: Problem<'a>,
    at: &'a Linearization,
    rows: SampleRows,
    equations: NormalEquations,
}

impl<'a> FrozenBalance<'a> {
    pub(crate) fn new(
        optimum: &'a Optimum,
        samples: &'a Samples,
        parameters: &'a [Parameter],
        settings: &'a Settings,
    ) -> Self {
        let model = &optimum.start_model;
        let problem = Problem::new(model, samples, &optimum.tensions, parameters, settings);
        let rows = SampleRows::new(model, parameters.len());
        let equations = NormalEquations::new(&rows, &first_columns(model, parameters));
        Self { problem, at: &optimum.linearization, rows, equations }
    }

    /// Metres that one unit of each parameter is worth.
    pub(crate) fn scales(&self) -> Vec<f64> {
        self.problem.scale().to_vec()
    }
}

impl HalfSquares for FrozenBalance<'_> {
    fn write(&mut self, values: &[f64], to: &mut Quadratic) -> bool {
        if !self.problem.equations(values, self.at, &mut self.rows, &mut self.equations) {
            return false;
        }
        to.value = 0.5 * self.equations.cost();
        for i in 0..values.len() {
            to.gradient[i] = self.equations.gradient(i);
            (0..=i).for_each(|j| {
                let entry = self.equations.entry(i, j);
                (to.hessian[(i, j)], to.hessian[(j, i)]) = (entry, entry);
            });
        }
        true
    }
}
