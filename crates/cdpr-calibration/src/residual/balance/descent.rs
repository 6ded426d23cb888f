//! Squares of lengths and wrenches, as the loop of all descents sees them.

use super::BalanceResidual;
use super::normal::NormalEquations;
use super::rows::{RowModel, SampleRows, first_columns};
use crate::minimize::dense::DenseEquations;
use crate::minimize::descent::{End, Equations, System, damped_step, descend};
use crate::minimize::unknowns::{Pace, Ridge, Shape, Unknowns};
use cdpr_model::robot::Parameter;
use cdpr_model::solve::NormalSystem;
use cdpr_model::statics::Load;

/// An undamped Gauss–Newton step.
pub(super) struct PlainStep {
    /// Parameter values after the step.
    pub(super) values: Vec<f64>,
    /// Predicted reduction of the cost (twice that of the quadratic model).
    pub(super) predicted_reduction: f64,
    /// Cost where it started.
    pub(super) cost: f64,
}

/// Squares of lengths, wrenches and priors.
struct Squares<'a, 'r> {
    residual: &'a BalanceResidual<'r>,
    ridges: Vec<Ridge>,
    rows: SampleRows,
}

impl System for Squares<'_, '_> {
    type Equations = NormalEquations;

    fn write(&mut self, values: &[f64], equations: &mut NormalEquations) -> bool {
        if !self.residual.add_all(values, &mut self.rows, equations) {
            return false;
        }
        for &Ridge { parameter, centre, weight } in &self.ridges {
            let change = values[parameter] - centre;
            equations.add_to_cost(weight * change * change);
            equations.add_to_gradient(parameter, weight * change);
            equations.add_to_diagonal(parameter, weight);
        }
        equations.cost().is_finite()
    }
}

impl BalanceResidual<'_> {
    /// Writes the normal equations of data at parameter values; false where a row is not finite.
    fn add_all(&self, values: &[f64], rows: &mut SampleRows, equations: &mut NormalEquations) -> bool {
        equations.clear();
        let Some(model) = self.model.with_parameters(self.parameters, values) else { return false };
        let Ok(load) = Load::of(model.robot()) else { return false };
        let row_model = RowModel::new(&model, load, self.parameters);
        self.at.add_to(&row_model, self.samples, self.loss, rows, equations);
        equations.cost().is_finite()
    }

    fn memory(&self) -> (SampleRows, NormalEquations) {
        let rows = SampleRows::new(&self.model, self.parameters.len());
        let equations = NormalEquations::new(&rows, &first_columns(&self.model, self.parameters));
        (rows, equations)
    }

    /// Writes Σ rᵀr, Jᵀr and JᵀJ; false where a row is not finite.
    pub(super) fn write_dense(&self, values: &[f64], to: &mut DenseEquations) -> bool {
        let (mut rows, mut equations) = self.memory();
        if !self.add_all(values, &mut rows, &mut equations) {
            to.cost = f64::INFINITY;
            return true;
        }
        to.cost = equations.cost();
        for i in 0..values.len() {
            to.gradient[i] = equations.gradient(i);
            (0..=i).for_each(|j| {
                let entry = equations.entry(i, j);
                (to.hessian[(i, j)], to.hessian[(j, i)]) = (entry, entry);
            });
        }
        true
    }

    /// Descends from these values until the next step promises no more than this share of the cost.
    pub(super) fn descend_from(&self, from: &[f64], own: &Unknowns<'_>, least_gain: f64) -> End {
        let (rows, equations) = self.memory();
        let pace = Pace { shape: Shape::Square, least_gain, patience: None };
        let mut squares = Squares { residual: self, ridges: own.ridges().collect(), rows };
        descend(&mut squares, &own.around(false), from, equations, &own.rules(&pace))
    }

    /// One undamped step; `None` where it is not determined or a bound is in its way.
    pub(super) fn plain_step(&self, from: &[f64], own: &Unknowns<'_>) -> Option<PlainStep> {
        let (rows, mut equations) = self.memory();
        let mut squares = Squares { residual: self, ridges: own.ridges().collect(), rows };
        squares.write(from, &mut equations).then_some(())?;
        let mut step = vec![0.0; from.len()];
        damped_step(&equations, &vec![false; from.len()], 0.0, &mut step)?;
        let values: Vec<f64> = from.iter().zip(&step).map(|(value, step)| value + step).collect();
        let inside = |(parameter, value): (&Parameter, &f64)| {
            let (low, high) = parameter.bounds();
            *value > low && *value < high
        };
        let predicted_reduction = -(0..step.len()).map(|k| step[k] * equations.gradient(k)).sum::<f64>();
        let all_inside = self.parameters.iter().zip(&values).all(inside);
        all_inside.then_some(PlainStep { values, predicted_reduction, cost: equations.cost() })
    }
}

impl NormalSystem for NormalEquations {
    fn gradient(&self, k: usize) -> f64 {
        self.gradient(k)
    }

    fn entry(&self, i: usize, j: usize) -> f64 {
        self.entry(i, j)
    }

    fn damped(&self, held: &[bool], damping: f64, step: &mut [f64]) -> Option<()> {
        damped_step(self, held, damping, step)
    }
}

impl Equations for NormalEquations {
    fn cost(&self) -> f64 {
        self.cost()
    }
}
