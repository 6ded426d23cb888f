//! Parameters that depend on each other, followed along the penalty.

use nalgebra::DVector;

use super::subproblem::{Group, Subproblem};
use crate::minimize::dense::DenseEquations;
use crate::problem::Problem;

/// Most steps at one penalty.
const STEPS: usize = 200;
/// Share of λ to which the conditions of the optimum are fulfilled: far below what its values are good for.
const EXACT: f64 = 1e-8;
/// The same in units of rounding: of second derivatives times metres, and of the root of squares and second derivatives.
const ROUNDING: (f64, f64) = (1e-13, 1e-12);
/// Damping after a first step that does not help, and its growth.
const DAMPING: (f64, f64) = (1e-4, 10.0);
/// Share of the cost that is rounding, and steps in succession that gain no more: conditions along weak directions are then as exact as numbers are.
const STALLED: (f64, usize) = (1e-13, 4);
/// Steps below this are rounding (m).
const RESTING: f64 = 1e-13;

/// Half the squares of a block of parameters beside their penalty, in metres of cable from its centre.
pub(super) struct Part {
    /// Block of the problem.
    block: usize,
    /// Metres that one unit of each parameter is worth.
    pub(super) scales: Vec<f64>,
    /// Values at which the penalty is 0.
    pub(super) centre: Vec<f64>,
    /// Every parameter in one group, by its place.
    pub(super) groups: Vec<Group>,
    /// Parameters with a ridge.
    pub(super) ridge: Vec<bool>,
    /// Of the changes (m).
    pub(super) bounds: Vec<(f64, f64)>,
    here: Place,
    trial: Place,
}

#[derive(Clone)]
struct Place {
    /// Changes from the centre (m).
    changes: DVector<f64>,
    /// The squares there with half their derivatives, by changes.
    quadratic: DenseEquations,
}

impl Part {
    /// At values of parameters that have no penalty.
    pub(super) fn new(
        block: usize,
        centre: Vec<f64>,
        scales: Vec<f64>,
        groups: Vec<Group>,
        ridge: Vec<bool>,
        bounds: Vec<(f64, f64)>,
    ) -> Self {
        let count = scales.len();
        let here = Place { changes: DVector::zeros(count), quadratic: DenseEquations::new(count) };
        Self { block, scales, centre, groups, ridge, bounds, trial: here.clone(), here }
    }

    /// Takes the squares where the part stands.
    pub(super) fn begin(&mut self, problem: &mut Problem<'_>) {
        self.trial.changes.clone_from(&self.here.changes);
        self.evaluate(problem);
        std::mem::swap(&mut self.here, &mut self.trial);
    }

    /// Values of the parameters; exactly the centre where the change is 0.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> {
        self.values_at(&self.here.changes)
    }

    fn values_at(&self, changes: &DVector<f64>) -> impl Iterator<Item = f64> {
        (0..self.centre.len()).map(|k| self.centre[k] + changes[k] / self.scales[k])
    }

    /// Changes from the centre (m).
    pub(super) fn changes(&self) -> impl Iterator<Item = f64> {
        self.here.changes.iter().copied()
    }

    /// Whether each parameter is off the centre or free of penalty.
    pub(super) fn is_off(&self) -> Vec<bool> {
        let mut is_off: Vec<bool> = self.here.changes.iter().map(|change| *change != 0.0).collect();
        let smooth = self.groups.iter().filter(|group| group.weight == 0.0);
        smooth.flat_map(|group| &group.members).for_each(|&k| is_off[k] = true);
        is_off
    }

    /// ½χ².
    pub(super) fn half_squares(&self) -> f64 {
        0.5 * self.here.quadratic.cost
    }

    /// Largest second derivative of a parameter with a penalty (1/m²).
    pub(super) fn curvature(&self) -> f64 {
        let penalised = self.groups.iter().filter(|group| group.weight > 0.0).flat_map(|group| &group.members);
        let of = |k: usize| self.here.quadratic.hessian[(k, k)];
        let ridge = (0..self.ridge.len()).filter(|&k| self.ridge[k]).map(of);
        penalised.map(|&k| of(k)).chain(ridge).fold(0.0, f64::max)
    }

    /// Least λ that keeps all penalised groups at 0 here.
    pub(super) fn least_holding(&self) -> f64 {
        let gradient = &self.here.quadratic.gradient;
        let of = |group: &Group| group.norm(gradient) / group.weight;
        self.groups.iter().filter(|group| group.weight > 0.0).map(of).fold(0.0, f64::max)
    }

    /// ½χ² and the norms that the penalty weighs, at the least squares.
    pub(super) fn at_the_least(&mut self, problem: &mut Problem<'_>) -> (f64, f64) {
        let here = self.here.clone();
        self.minimise(problem, 0.0);
        let norms = self.groups.iter().map(|group| group.penalty(1.0, &self.here.changes)).sum();
        let half = self.half_squares();
        self.here = here;
        (half, norms)
    }

    /// Descends to the least value for this λ; false where it is not found.
    pub(super) fn minimise(&mut self, problem: &mut Problem<'_>, lambda: f64) -> bool {
        let (mut damping, mut stalled) = (0.0, 0);
        for _ in 0..STEPS {
            let tolerance = self.tolerance(lambda);
            if self.violation(lambda) <= tolerance {
                return true;
            }
            let quadratic = self.with_ridge(&self.here, lambda, damping);
            let Self { groups, bounds, .. } = &*self;
            let subproblem = Subproblem { quadratic: &quadratic, at: &self.here.changes, groups, lambda, bounds };
            let mut changes = self.here.changes.clone();
            subproblem.solve(&mut changes, 0.1 * tolerance);
            let step = (&changes - &self.here.changes).amax();
            self.trial.changes = changes;
            let is_finite = self.evaluate(problem);
            let (trial, here) = (self.cost(&self.trial, lambda), self.cost(&self.here, lambda));
            if is_finite && trial <= here + 1e-12 * here.abs() {
                std::mem::swap(&mut self.here, &mut self.trial);
                damping = if damping <= DAMPING.0 { 0.0 } else { damping / DAMPING.1 };
            } else {
                damping = f64::max(DAMPING.0, DAMPING.1 * damping);
            }
            stalled = if (here - trial).abs() <= STALLED.0 * here.abs() { stalled + 1 } else { 0 };
            if step <= RESTING || stalled >= STALLED.1 {
                return true;
            }
        }
        false
    }

    /// Distance from the conditions of the least value.
    pub(super) fn violation(&self, lambda: f64) -> f64 {
        let mut gradient = self.here.quadratic.gradient.clone();
        for k in (0..self.ridge.len()).filter(|&k| self.ridge[k]) {
            gradient[k] += lambda * self.here.changes[k];
        }
        let of = |group: &Group| group.violation(lambda, &self.here.changes, &gradient, &self.bounds);
        self.groups.iter().map(of).fold(0.0, f64::max)
    }

    fn tolerance(&self, lambda: f64) -> f64 {
        let DenseEquations { cost, hessian, .. } = &self.here.quadratic;
        let curvature = hessian.diagonal().max();
        let is_slope = lambda.is_finite() && !self.ridge.contains(&true);
        let fraction = if is_slope { EXACT * lambda } else { 0.0 };
        fraction + ROUNDING.0 * curvature + ROUNDING.1 * (cost * curvature).sqrt()
    }

    fn with_ridge(&self, place: &Place, lambda: f64, damping: f64) -> DenseEquations {
        let mut quadratic = place.quadratic.clone();
        for k in 0..self.ridge.len() {
            if self.ridge[k] {
                quadratic.gradient[k] += lambda * place.changes[k];
                quadratic.hessian[(k, k)] += lambda;
            }
            quadratic.hessian[(k, k)] *= 1.0 + damping;
        }
        quadratic
    }

    fn cost(&self, place: &Place, lambda: f64) -> f64 {
        let groups = self.groups.iter().map(|group| group.penalty(lambda, &place.changes)).sum::<f64>();
        let ridge = (0..self.ridge.len()).filter(|&k| self.ridge[k]).map(|k| place.changes[k].powi(2)).sum::<f64>();
        0.5 * place.quadratic.cost + groups + if ridge > 0.0 { 0.5 * lambda * ridge } else { 0.0 }
    }

    /// The squares at the trial's changes.
    fn evaluate(&mut self, problem: &mut Problem<'_>) -> bool {
        let values: Vec<f64> = self.values_at(&self.trial.changes).collect();
        let is_finite = problem.write(self.block, &values, &mut self.trial.quadratic);
        let DenseEquations { gradient, hessian, .. } = &mut self.trial.quadratic;
        for i in 0..values.len() {
            gradient[i] /= self.scales[i];
            (0..values.len()).for_each(|j| hessian[(i, j)] /= self.scales[i] * self.scales[j]);
        }
        is_finite
    }
}
