//! Levenberg–Marquardt search of the weighted complex residuals' least squares, delay included.

use cdpr_model::solve::{self, Control, Problem, Rules, Step, StepRule, Stop, Trial};

use super::points::Point;
use super::transfer::Transfer;
use crate::minimize::dense::DenseEquations;
use crate::minimize::descent::damped_step;

/// End of a search, in standard deviations of the parameters that remain to go.
const RULES: Rules<f64> = Rules { tolerance: 1e-5, max_iterations: 60, least_gain: 1e-13, rule: StepRule::Damping };

/// A function at a least sum of squares.
#[derive(Clone)]
pub(super) struct Refined {
    pub(super) transfer: Transfer,
    /// Sum of squares in standard deviations.
    pub(super) cost: f64,
    /// Half the second derivatives of the cost: the parameters' information.
    pub(super) equations: DenseEquations,
    pub(super) converged: bool,
}

impl Refined {
    /// Mean square of the residuals of so many points, in standard deviations.
    pub(super) fn mean_square(&self, points: usize) -> f64 {
        self.cost / (2.0 * points as f64 - self.equations.gradient.len() as f64).max(1.0)
    }
}

/// Searches from a function on.
pub(super) fn refined(points: &[Point], from: Transfer) -> Option<Refined> {
    let equations = DenseEquations::new(from.parameters().len());
    let here = (from.clone(), equations.clone());
    let mut search = Search { points, here, trial: (from, equations), step: Vec::new() };
    let end = solve::descend(&mut search, &RULES);
    let (transfer, equations) = search.here;
    let converged = matches!(end.stop(), Stop::Stationary | Stop::Stalled);
    let cost = equations.cost;
    cost.is_finite().then_some(Refined { transfer, cost, equations, converged })
}

struct Search<'a> {
    points: &'a [Point],
    here: (Transfer, DenseEquations),
    trial: (Transfer, DenseEquations),
    step: Vec<f64>,
}

impl Problem for Search<'_> {
    type Number = f64;

    fn step(&mut self, control: &Control<f64>) -> Step<f64> {
        let (transfer, equations) = &self.here;
        let mut values = transfer.parameters();
        self.step.resize(values.len(), 0.0);
        if damped_step(equations, &vec![false; values.len()], control.damping, &mut self.step).is_none() {
            return Step::whole(0.0, false);
        }
        values.iter_mut().zip(&self.step).for_each(|(value, step)| *value += step);
        self.trial.0 = transfer.with(&values);
        let slope = -self.step.iter().zip(equations.gradient.iter()).map(|(step, slope)| step * slope).sum::<f64>();
        // the length of a Gauss–Newton step in standard deviations
        Step { size: slope.max(0.0).sqrt(), gain: slope / equations.cost, is_cut: false, is_regular: true }
    }

    fn evaluate(&mut self, _: f64, _: bool) -> Trial<f64> {
        let (transfer, equations) = &mut self.trial;
        write(self.points, transfer, equations);
        let (cost, before) = (equations.cost, self.here.1.cost);
        Trial { helps: cost.is_finite() && cost <= before * (1.0 + 1e-12), gain: 1.0 - cost / before }
    }

    fn accept(&mut self, helps: bool, _: f64) {
        if helps {
            std::mem::swap(&mut self.here, &mut self.trial);
        }
    }
}

/// Writes cost and equations of a function.
fn write(points: &[Point], transfer: &Transfer, equations: &mut DenseEquations) {
    equations.cost = 0.0;
    equations.gradient.fill(0.0);
    equations.hessian.fill(0.0);
    let count = equations.gradient.len();
    for point in points {
        let value = transfer.response(point.frequency);
        let residual = (value - point.response) / point.sigma;
        let mut slopes = transfer.slopes(point.frequency);
        slopes.iter_mut().for_each(|slope| *slope *= value / point.sigma);
        equations.cost += residual.norm_sqr();
        for j in 0..count {
            equations.gradient[j] += (slopes[j].conj() * residual).re;
            for i in j..count {
                equations.hessian[(i, j)] += (slopes[i].conj() * slopes[j]).re;
            }
        }
    }
    equations.hessian.fill_upper_triangle_with_lower_triangle();
}
