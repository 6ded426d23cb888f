//! Damped Gauss–Newton descent of all parameters together, within bounds.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::linearization::Linearization;
use super::normal::NormalEquations;
use super::rows::{RowModel, SampleRows, first_columns};
use crate::identification::fit::{Settings, prior_sigma};
use crate::identification::misfit::Misfit;
use crate::measurement::Samples;
use crate::model::{Model, Parameter, ParameterKind};
use crate::statics::Load;

/// The problem that a descent solves.
pub(super) struct Problem<'a> {
    /// The model at its start values.
    pub(super) model: &'a Model,
    pub(super) samples: &'a Samples,
    pub(super) tensions: &'a [f64],
    pub(super) parameters: &'a [Parameter],
    pub(super) settings: &'a Settings,
    /// The file's values, where priors are centred.
    pub(super) start: Vec<f64>,
    /// Metres that one unit of each parameter is worth.
    worth: Vec<f64>,
}

/// Where a descent ended.
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
    /// Where it leads.
    pub(super) values: Vec<f64>,
    /// What it promises to gain (twice that of the quadratic model).
    pub(super) promise: f64,
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
        let compliance = parameters.iter().filter(|p| p.kind == ParameterKind::Compliance).map(|p| p.value(model));
        let compliance = compliance.fold(1e-7, f64::max);
        let worth = |parameter: &Parameter| match parameter.kind {
            ParameterKind::LengthScale => length,
            ParameterKind::DrumRadius => length / parameter.value(model).max(1e-3),
            ParameterKind::Compliance => tension * length,
            ParameterKind::HiddenLength => 1e-3,
            ParameterKind::TensionScale => compliance * tension * length,
            ParameterKind::TensionOffset | ParameterKind::Wrench => compliance * length,
            _ => 1.0,
        };
        Self {
            model,
            samples,
            tensions,
            parameters,
            settings,
            start: parameters.iter().map(|parameter| parameter.value(model)).collect(),
            worth: parameters.iter().map(worth).collect(),
        }
    }

    /// Metres that one unit of each parameter is worth.
    pub(super) fn worth(&self) -> &[f64] {
        &self.worth
    }

    /// The model at other parameter values.
    pub(super) fn model_at(&self, values: &[f64]) -> Option<Model> {
        let mut robot = self.model.robot().clone();
        for (parameter, &value) in self.parameters.iter().zip(values) {
            parameter.assign(self.model, &mut robot, value);
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
        at.add_to(&row_model, self.samples, rows, equations);
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
        let promise = -(0..step.len()).map(|k| step[k] * equations.gradient(k)).sum::<f64>();
        let all_inside = self.parameters.iter().zip(&values).all(inside);
        all_inside.then_some(PlainStep { values, promise, cost: equations.cost() })
    }

    /// Descends from these values until the next step promises no more than this share of the cost.
    pub(super) fn descend(&self, from: &[f64], at: &Linearization, stop: f64) -> End {
        let mut rows = SampleRows::new(self.model, self.parameters.len());
        let mut current = NormalEquations::new(&rows, &first_columns(self.model, self.parameters));
        let mut next = current.clone();
        let mut end =
            End { values: from.to_vec(), cost: f64::NAN, iterations: 0, history: Vec::new(), converged: false };
        if !self.equations(from, at, &mut rows, &mut current) {
            return end;
        }
        end.history.push(current.cost());
        let (mut damping, mut last_size, mut settled) = (0.0_f64, 0.0_f64, false);
        end.converged = from.is_empty();
        while !end.converged && end.iterations < self.settings.max_iterations {
            end.iterations += 1;
            let Some(step) = self.step(&end.values, &current, damping) else {
                damping = f64::max(10.0 * damping, 1e-9);
                end.converged = damping > 1e9; // a parameter that moves nothing at all: analysis names it
                continue;
            };
            let size = step.iter().zip(&self.worth).map(|(step, worth)| (step * worth).abs()).fold(0.0, f64::max);
            let promise: f64 = -(0..step.len()).map(|k| step[k] * current.gradient(k)).sum::<f64>();
            let trial: Vec<f64> = end.values.iter().zip(&step).map(|(value, step)| value + step).collect();
            // no reduction that the rounding of the cost would show
            if settled || promise <= stop * current.cost() || size <= 1e-3 * self.settings.tolerance {
                if damping == 0.0 {
                    end.values = trial;
                }
                end.converged = true;
                break;
            }
            let is_finite = self.equations(&trial, at, &mut rows, &mut next);
            if is_finite && next.cost() <= current.cost() * (1.0 + 1e-12) {
                let contraction = size / last_size;
                settled = contraction < 0.5 && size * contraction <= self.settings.tolerance * (1.0 - contraction);
                last_size = size;
                std::mem::swap(&mut current, &mut next);
                end.values = trial;
                end.history.push(current.cost());
                damping = if damping <= 1e-8 { 0.0 } else { damping * 0.1 };
            } else {
                damping = f64::max(10.0 * damping, 1e-4);
                end.converged = damping > 1e12 && size <= self.settings.tolerance;
            }
        }
        end.cost = current.cost();
        end
    }

    /// Damped step that respects the bounds.
    fn step(&self, values: &[f64], equations: &NormalEquations, damping: f64) -> Option<Vec<f64>> {
        let count = values.len();
        let room: Vec<(f64, f64)> = (0..count)
            .map(|k| {
                let (low, high) = self.parameters[k].bounds();
                (low - values[k], high - values[k])
            })
            .collect();
        // a parameter on a bound that the gradient pushes outwards stays there
        let mut held: Vec<bool> = (0..count)
            .map(|k| {
                let gradient = equations.gradient(k);
                (room[k].0 >= 0.0 && gradient > 0.0) || (room[k].1 <= 0.0 && gradient < 0.0)
            })
            .collect();
        loop {
            let step = solve(equations, &held, damping)?;
            let outside = |k: usize| !held[k] && (step[k] < room[k].0 || step[k] > room[k].1);
            match (0..count).find(|&k| outside(k) && (room[k].0 >= 0.0 || room[k].1 <= 0.0)) {
                // already on the bound: hold it and solve for the others
                Some(k) => held[k] = true,
                None => {
                    let clamped = |k: usize| step[k].clamp(room[k].0.min(0.0), room[k].1.max(0.0));
                    return Some((0..count).map(clamped).collect());
                }
            }
        }
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
    if smallest * smallest < 1e-11 && damping < 1e-9 {
        return None;
    }
    let mut step = DVector::from_fn(count, |k, _| -equations.gradient(k) * scale[k]);
    factor.solve_mut(&mut step);
    Some((0..count).map(|k| step[k] * scale[k]).collect())
}
