//! Least squares of lengths and wrenches: the problem that all parameters of an elastic model share.

use super::linearization::Linearization;
use super::normal::NormalEquations;
use super::rows::{RowModel, SampleRows, first_columns};
use crate::fit::{Settings, prior_sigma};
pub(super) use crate::joint_descent::End;
use crate::joint_descent::{Around, Equations, System, damped_step, descend};
use crate::loss::RobustLoss;
use crate::misfit::Misfit;
use crate::unit_scale::joint_scales;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::solve::{NormalSystem, Rules};
use cdpr_model::statics::Load;

/// The problem that a descent solves.
#[derive(Clone)]
pub(super) struct Problem<'a> {
    /// The model at its start values.
    pub(super) model: &'a Model,
    pub(super) samples: &'a Samples,
    pub(super) tensions: &'a [f64],
    pub(super) parameters: &'a [Parameter],
    pub(super) settings: &'a Settings,
    /// A loss other than least squares.
    pub(super) loss: Option<RobustLoss>,
    /// The file's values, where priors are centred.
    pub(super) start: Vec<f64>,
    /// Metres that one unit of each parameter is worth.
    scale: Vec<f64>,
}

/// An undamped Gauss–Newton step.
pub(super) struct PlainStep {
    /// Parameter values after the step.
    pub(super) values: Vec<f64>,
    /// Predicted reduction of the cost (twice that of the quadratic model).
    pub(super) predicted_reduction: f64,
    /// Cost where it started.
    pub(super) cost: f64,
}

impl<'a> Problem<'a> {
    pub(super) fn new(
        model: &'a Model,
        samples: &'a Samples,
        tensions: &'a [f64],
        parameters: &'a [Parameter],
        settings: &'a Settings,
    ) -> Self {
        Self {
            model,
            samples,
            tensions,
            parameters,
            settings,
            loss: None,
            start: parameters.iter().map(|parameter| parameter.value(model.robot())).collect(),
            scale: joint_scales(model, parameters, &samples.lengths, tensions),
        }
    }

    /// Metres that one unit of each parameter is worth.
    pub(super) fn scale(&self) -> &[f64] {
        &self.scale
    }

    /// The same under another loss.
    pub(super) fn under(&self, loss: RobustLoss) -> Self {
        Self { loss: Some(loss), ..self.clone() }
    }

    /// The model at other parameter values.
    pub(super) fn model_at(&self, values: &[f64]) -> Option<Model> {
        self.model.with_parameters(self.parameters, values)
    }

    /// Normal equations at `values`; false where a row is not finite.
    pub(super) fn equations(
        &self,
        values: &[f64],
        at: &Linearization,
        rows: &mut SampleRows,
        equations: &mut NormalEquations,
    ) -> bool {
        equations.clear();
        let Some(model) = self.model_at(values) else { return false };
        let Ok(load) = Load::of(model.robot()) else { return false };
        let row_model = RowModel::new(&model, load, self.parameters);
        at.add_to(&row_model, self.samples, self.loss, rows, equations);
        for (k, sigma) in self.priors() {
            let (weight, change) = (1.0 / (sigma * sigma), values[k] - self.start[k]);
            equations.add_to_cost(weight * change * change);
            equations.add_to_gradient(k, weight * change);
            equations.add_to_diagonal(k, weight);
        }
        equations.cost().is_finite()
    }

    /// Place and standard deviation of every prior.
    fn priors(&self) -> impl Iterator<Item = (usize, f64)> {
        let sigma = |(k, parameter): (usize, &Parameter)| Some((k, prior_sigma(self.settings, parameter.kind)?));
        self.parameters.iter().enumerate().filter_map(sigma)
    }

    /// Misfit where a descent ended, in units of the weights.
    pub(super) fn misfit(&self, end: &End, at: &Linearization) -> Misfit {
        let square = |(k, sigma): (usize, f64)| ((end.values[k] - self.start[k]) / sigma).powi(2);
        let rows = at.informative_rows() + self.priors().count();
        Misfit {
            cost: end.cost,
            prior_cost: self.priors().map(square).sum(),
            freedom: rows.saturating_sub(self.parameters.len()),
        }
    }

    /// One undamped step; `None` where it is not determined or a bound is in its way.
    pub(super) fn plain_step(&self, from: &[f64], at: &Linearization) -> Option<PlainStep> {
        let mut rows = SampleRows::new(self.model, self.parameters.len());
        let mut equations = NormalEquations::new(&rows, &first_columns(self.model, self.parameters));
        if !self.equations(from, at, &mut rows, &mut equations) {
            return None;
        }
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

    /// Cost at `values`; infinite where a row is not finite.
    pub(super) fn cost(&self, values: &[f64], at: &Linearization) -> f64 {
        let mut rows = SampleRows::new(self.model, self.parameters.len());
        let mut equations = NormalEquations::new(&rows, &first_columns(self.model, self.parameters));
        if self.equations(values, at, &mut rows, &mut equations) { equations.cost() } else { f64::INFINITY }
    }

    /// Descends from these values until the next step promises no more than this share of the cost.
    pub(super) fn descend(&self, from: &[f64], at: &Linearization, stop: f64) -> End {
        let rows = SampleRows::new(self.model, self.parameters.len());
        let equations = NormalEquations::new(&rows, &first_columns(self.model, self.parameters));
        let rules = Rules {
            tolerance: self.settings.tolerance,
            max_iterations: self.settings.max_iterations,
            least_gain: stop,
            rule: self.settings.minimizer.rule(),
        };
        let Settings { minimizer, keeps_course, .. } = *self.settings;
        let around =
            Around { parameters: self.parameters, scale: &self.scale, minimizer, keeps_course, ends_ahead: false };
        descend(&mut Squares { problem: self, at, rows }, &around, from, equations, &rules)
    }
}

/// Least squares of lengths and wrenches.
struct Squares<'a, 'p> {
    problem: &'a Problem<'p>,
    at: &'a Linearization,
    rows: SampleRows,
}

impl System for Squares<'_, '_> {
    type Equations = NormalEquations;

    fn write(&mut self, values: &[f64], equations: &mut NormalEquations) -> bool {
        self.problem.equations(values, self.at, &mut self.rows, equations)
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
