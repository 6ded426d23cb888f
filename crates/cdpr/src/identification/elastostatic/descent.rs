//! Damped Gauss–Newton descent of all parameters together, within bounds.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::linearization::Linearization;
use super::normal::NormalEquations;
use super::rows::{RowModel, SampleRows, first_columns};
use crate::identification::fit::{Settings, prior_sigma};
use crate::identification::loss::RobustLoss;
use crate::identification::misfit::Misfit;
use crate::identification::worth::Worth;
use crate::measurement::Samples;
use crate::model::Model;
use crate::robot::{Parameter, ParameterKind};
use crate::solve::{
    self, Control, NormalSystem, OF_SINGULAR, REGULAR, Room, Rules, Step, StepRule, Stop, Surroundings, Trial, descend,
    minimizer,
};
use crate::statics::Load;

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

/// End of a descent.
#[derive(Clone, Debug)]
pub(super) struct End {
    pub(super) values: Vec<f64>,
    pub(super) cost: f64,
    pub(super) iterations: u32,
    pub(super) history: Vec<f64>,
    pub(super) converged: bool,
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
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let (length, tension) = (mean(&samples.lengths), mean(tensions).max(1e-9));
        let compliance =
            parameters.iter().filter(|p| p.kind == ParameterKind::Compliance).map(|p| p.value(model.robot()));
        let compliance = compliance.fold(1e-7, f64::max);
        let scale = |parameter: &Parameter| match parameter.kind {
            ParameterKind::Compliance => tension * length,
            ParameterKind::HiddenLength => 1e-3,
            ParameterKind::TensionScale => compliance * tension * length,
            ParameterKind::TensionOffset | ParameterKind::Wrench => compliance * length,
            kind => Worth::of(&model.robot().cables[parameter.cable], length).metres(kind),
        };
        Self {
            model,
            samples,
            tensions,
            parameters,
            settings,
            loss: None,
            start: parameters.iter().map(|parameter| parameter.value(model.robot())).collect(),
            scale: parameters.iter().map(scale).collect(),
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
        let mut robot = self.model.robot().clone();
        for (parameter, &value) in self.parameters.iter().zip(values) {
            parameter.set(&mut robot, value);
        }
        Model::new(robot, self.model.composition()).ok()
    }

    /// Normal equations at `values`; false where a row is not finite.
    fn equations(
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
        at.add_to(&row_model, self.samples, self.loss, (rows, equations));
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
        let step = solve(&equations, &vec![false; from.len()], 0.0)?;
        let values: Vec<f64> = from.iter().zip(&step).map(|(value, step)| value + step).collect();
        let inside = |(parameter, value): (&Parameter, &f64)| {
            let (low, high) = parameter.bounds();
            *value > low && *value < high
        };
        let predicted_reduction = -(0..step.len()).map(|k| step[k] * equations.gradient(k)).sum::<f64>();
        let all_inside = self.parameters.iter().zip(&values).all(inside);
        all_inside.then_some(PlainStep { values, predicted_reduction, cost: equations.cost() })
    }

    /// Descends from these values until the next step promises no more than this share of the cost.
    pub(super) fn descend(&self, from: &[f64], at: &Linearization, stop: f64) -> End {
        let rows = SampleRows::new(self.model, self.parameters.len());
        let equations = NormalEquations::new(&rows, &first_columns(self.model, self.parameters));
        let trial = Place { values: from.to_vec(), equations };
        let mut descent = Descent { problem: self, at, rows, here: trial.clone(), trial, history: Vec::new() };
        descent.here.equations.add_to_cost(f64::INFINITY);
        let rules = Rules {
            tolerance: self.settings.tolerance,
            max_iterations: if from.is_empty() { 0 } else { self.settings.max_iterations },
            least_gain: stop,
            rule: self.settings.minimizer.rule(),
        };
        let end = descend(&mut descent, &rules);
        let mut iterations = end.iterations as u32;
        let Place { mut values, equations } = descent.here;
        if end.stop() == Stop::Degenerate {
            return End { values, cost: f64::NAN, iterations, history: Vec::new(), converged: false };
        }
        // a parameter that moves nothing at all is analysis' to name
        let converged = from.is_empty() || matches!(end.stop(), Stop::Stationary | Stop::Singular);
        if end.stop() == Stop::Stationary && end.damping == 0.0 {
            iterations += 1;
            // the gradient still knows the way to more digits, and the step costs no evaluation
            if let Some((step, _)) = self.step(&values, &equations, &Control::none()) {
                values.iter_mut().zip(step).for_each(|(value, step)| *value += step);
            }
        }
        End { values, cost: equations.cost(), iterations, history: descent.history, converged }
    }

    /// A step that respects the bounds, and whether something cut it.
    fn step(&self, values: &[f64], equations: &NormalEquations, control: &Control<f64>) -> Option<(Vec<f64>, bool)> {
        let room = |(parameter, value): (&Parameter, &f64)| -> Room {
            let (low, high) = parameter.bounds();
            (low - value, high - value)
        };
        let room: Vec<Room> = self.parameters.iter().zip(values).map(room).collect();
        let around = Surroundings { room: &room, scale: &self.scale };
        let (mut held, mut step) = (vec![false; values.len()], vec![0.0; values.len()]);
        let is_cut = self.settings.minimizer.step(equations, around, control, (&mut held, &mut step))?;
        Some((step, is_cut))
    }
}

/// Parameter values with their normal equations.
#[derive(Clone)]
struct Place {
    values: Vec<f64>,
    equations: NormalEquations,
}

/// Least squares of lengths and wrenches, as the loop of all searches sees it.
struct Descent<'a, 'p> {
    problem: &'a Problem<'p>,
    at: &'a Linearization,
    rows: SampleRows,
    here: Place,
    trial: Place,
    history: Vec<f64>,
}

impl solve::Problem for Descent<'_, '_> {
    type Number = f64;

    fn step(&mut self, control: &Control<f64>) -> Step<f64> {
        let Place { values, equations } = &self.here;
        let Some((step, is_cut)) = self.problem.step(values, equations, control) else {
            return Step::whole(0.0, false);
        };
        for (trial, (value, step)) in self.trial.values.iter_mut().zip(values.iter().zip(&step)) {
            *trial = value + step;
        }
        let size = minimizer::size(&step, &self.problem.scale);
        let gain = self.problem.settings.minimizer.gain(equations, &step, equations.cost());
        Step { size, gain, is_cut, is_regular: true }
    }

    fn evaluate(&mut self, _: f64, _: bool) -> Trial<f64> {
        let Self { problem, at, rows, trial, .. } = self;
        let is_finite = problem.equations(&trial.values, at, rows, &mut trial.equations);
        let (cost, here) = (trial.equations.cost(), self.here.equations.cost());
        Trial { helps: is_finite && cost <= here * (1.0 + 1e-12), gain: 1.0 - cost / here }
    }

    /// Steps along a descent that do not help however short leave rounding, as damped steps do once they are within the tolerance.
    fn rests(&mut self, size: f64, tolerance: f64) -> bool {
        size <= tolerance || self.problem.settings.minimizer.rule() == StepRule::Shortening
    }

    fn accept(&mut self, helps: bool, _: f64) {
        if helps {
            std::mem::swap(&mut self.here, &mut self.trial);
            self.history.push(self.here.equations.cost());
        }
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
        step.copy_from_slice(&solve(self, held, damping)?);
        Some(())
    }
}

/// Solves (H + damping · diag H) step = −gradient for the parameters that are not held, columns scaled to unit diagonal;
/// `None` when that matrix is not positive definite to rounding.
fn solve(equations: &NormalEquations, held: &[bool], damping: f64) -> Option<Vec<f64>> {
    let count = held.len();
    let scale: Vec<f64> = (0..count)
        .map(|k| match held[k] || !(equations.entry(k, k) > 0.0) {
            true => 0.0,
            false => 1.0 / equations.entry(k, k).sqrt(),
        })
        .collect();
    let matrix = DMatrix::from_fn(count, count, |i, j| match i == j {
        true => 1.0 + damping,
        false => equations.entry(i, j) * scale[i] * scale[j],
    });
    let factor = Cholesky::new(matrix)?;
    let smallest = factor.l_dirty().diagonal().min();
    // undamped, directions that nothing determines would wander on rounding errors
    if smallest * smallest < REGULAR && damping < OF_SINGULAR {
        return None;
    }
    let mut step = DVector::from_fn(count, |k, _| -equations.gradient(k) * scale[k]);
    factor.solve_mut(&mut step);
    Some((0..count).map(|k| step[k] * scale[k]).collect())
}
