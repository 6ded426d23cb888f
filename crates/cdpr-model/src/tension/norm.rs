//! The lowest and the highest tensions, by a p-norm: `minimum` is min ‖f‖ₚ, `maximum` is min ‖f_max − f‖ₚ, both within
//! balance and limits, 1 ≤ p ≤ 8 (Verhoeven 2004; Gosselin and Grenier 2011).
//!
//! `maximum` measures the distance to the largest tensions: the largest norm of f itself would be a corner of the set,
//! hard to find and jumping with the load. All problems are convex and solved by exact quadratic programmes:
//!
//! * p = 2: one programme with its reference at 0 or f_max.
//! * p = 1: the linear programme min Σ f or max Σ f, by proximal points (Rockafellar 1976): each step is the programme
//!   with the last tensions, moved down or up by an amount that grows, as its reference. A step that changes nothing
//!   proves the optimum, and it comes after finitely many, mostly two or three. The tensions are pulls, so that a least
//!   limit below 0 counts with its sign. If several tensions have the same sum, the answer is the one that the steps
//!   reach from the tensions nearest to the reference.
//! * otherwise: Newton's method, each step a programme in the metric of the second derivatives, with a line search. It
//!   ends when the tensions change by less than 1e-8 of the largest limit, or Σ |f|ᵖ can fall by less than 1e-13 of
//!   itself (1e-8 after 200 steps).
//!
//! **Continuity:** one answer that follows the load continuously for p > 1; jumps between corners for p = 1. **Warm
//! start:** the active limits of the last programme; the answer changes by rounding only.

use nalgebra::DMatrix;

use super::distribute::{self, Chosen, Distribute, FoundTensions, ON_LIMIT, Problem, Task, Written};
use super::quadratic::{self, Status};
use super::response::optimum;
use super::{InputError, Limits};

/// Steps allowed.
const MAX_STEPS: u32 = 200;
/// Change of tensions, as a fraction of the largest limit, below which Newton's method has settled.
const SETTLED: f64 = 1e-8;
/// Fraction of Σ |f|ᵖ below which a further decrease ends the search: tensions that hardly count in a large p may then
/// keep their values.
const NO_GAIN: f64 = 1e-13;
/// The same fraction once all steps are used up: tensions that hardly count may still change then.
const LITTLE_GAIN: f64 = 1e-8;
/// Least weight of a cable in one programme; the largest is its reciprocal.
const LEAST_WEIGHT: f64 = 1e-6;

/// Tensions from which the norm measures the distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Extreme {
    /// ‖f‖
    Zero,
    /// ‖f_max − f‖
    Largest,
}

/// Memory for the programmes of one norm.
#[derive(Clone, Debug)]
pub(super) struct ExtremeNorm {
    end: Extreme,
    qp: quadratic::Solver,
    matrix: DMatrix<f64>,
    limits: Limits,
    reference: Vec<f64>,
    weights: Vec<f64>,
    next: Vec<f64>,
}

impl ExtremeNorm {
    pub(super) fn new(end: Extreme, cable_count: usize, dof: usize) -> Self {
        Self {
            end,
            qp: quadratic::Solver::new(cable_count, dof),
            matrix: DMatrix::zeros(dof, cable_count),
            limits: Limits::zero(cable_count),
            reference: vec![0.0; cable_count],
            weights: vec![1.0; cable_count],
            next: vec![0.0; cable_count],
        }
    }

    /// Tension of a cable at which the norm is zero (N).
    fn target(&self, limits: &Limits, cable: usize) -> f64 {
        match self.end {
            Extreme::Zero => 0.0,
            Extreme::Largest => limits.maximum()[cable],
        }
    }

    /// Moves allowed tensions to the optimum; returns the number of programmes solved, `None` if they did not settle.
    fn run(
        &mut self,
        problem: &Problem<'_>,
        limits: &Limits,
        p: f64,
        tensions: &mut [f64],
    ) -> Result<Option<u32>, InputError> {
        if p == 1.0 {
            return self.linear(problem, limits, tensions);
        }
        for cable in 0..tensions.len() {
            self.reference[cable] = self.target(limits, cable);
        }
        let found = self.qp.solve(problem.structure_matrix, problem.wrench, limits, Some(&self.reference))?;
        if found.status != Status::Feasible {
            return Ok(None);
        }
        tensions.copy_from_slice(&found.tensions);
        // large exponents are approached by doubling: Newton's method converges slowly from far away
        let (mut exponent, mut steps) = (2.0, 1);
        while exponent != p {
            exponent = if p < exponent { p } else { p.min(2.0 * exponent) };
            match self.newton(problem, limits, exponent, tensions)? {
                Some(more) => steps += more,
                None => return Ok(None),
            }
        }
        Ok(Some(steps))
    }

    fn linear(
        &mut self,
        problem: &Problem<'_>,
        limits: &Limits,
        tensions: &mut [f64],
    ) -> Result<Option<u32>, InputError> {
        let unit = limits.diameter().max(limits.tolerance()) * if self.end == Extreme::Zero { -1.0 } else { 1.0 };
        let mut factor = 2.0;
        for step in 1..=MAX_STEPS {
            let away = factor * unit;
            // along edges on which the sum hardly changes the steps must be long; beyond this factor rounding dominates
            factor = f64::min(4.0 * factor, 1e5);
            self.reference.iter_mut().zip(tensions.iter()).for_each(|(reference, f)| *reference = f + away);
            let found = self.qp.solve(problem.structure_matrix, problem.wrench, limits, Some(&self.reference))?;
            if found.status != Status::Feasible {
                return Ok(None);
            }
            let change = largest_difference(&found.tensions, tensions);
            tensions.copy_from_slice(&found.tensions);
            if change <= 10.0 * limits.tolerance() {
                return Ok(Some(step));
            }
        }
        Ok(None)
    }

    fn newton(
        &mut self,
        problem: &Problem<'_>,
        limits: &Limits,
        p: f64,
        tensions: &mut [f64],
    ) -> Result<Option<u32>, InputError> {
        // tolerances are relative to the largest limit
        let settled = SETTLED * 1e10 * limits.tolerance();
        let mut last_gain = f64::INFINITY;
        for step in 1..=MAX_STEPS {
            if !self.model(problem, limits, p, tensions)? {
                return Ok(Some(step));
            }
            let (change, gain) = self.search_line(limits, p, tensions);
            if change <= settled || gain <= NO_GAIN {
                return Ok(Some(step));
            }
            last_gain = gain;
        }
        Ok((last_gain <= LITTLE_GAIN).then_some(MAX_STEPS))
    }

    /// Writes the optimum of the quadratic model at these tensions to `next`, by a programme in f √weight. False if all
    /// tensions are at the target, or the programme is not feasible.
    fn model(&mut self, problem: &Problem<'_>, limits: &Limits, p: f64, tensions: &[f64]) -> Result<bool, InputError> {
        let away = |cable: usize, f: f64| f - self.target(limits, cable);
        let furthest = tensions.iter().enumerate().fold(0.0_f64, |most, (cable, f)| most.max(away(cable, *f).abs()));
        if !(furthest > limits.tolerance()) {
            return Ok(false);
        }
        for (cable, f) in tensions.iter().enumerate() {
            let part = (f - self.target(limits, cable)) / furthest;
            // of |x|ᵖ/p: slope |x|ᵖ⁻¹, curvature (p − 1) |x|ᵖ⁻²
            let weight = ((p - 1.0) * part.abs().powf(p - 2.0)).clamp(LEAST_WEIGHT, 1.0 / LEAST_WEIGHT);
            let slope = part.signum() * part.abs().powf(p - 1.0);
            let root = weight.sqrt();
            self.weights[cable] = root;
            self.reference[cable] = root * (f - furthest * slope / weight);
            for row in 0..self.matrix.nrows() {
                self.matrix[(row, cable)] = problem.structure_matrix[(row, cable)] / root;
            }
        }
        self.limits.scale_from(limits, &self.weights);
        // the columns change at every step: the limits that were active last time are a start like any other
        let found = self.qp.solve(&self.matrix, problem.wrench, &self.limits, Some(&self.reference))?;
        if found.status != Status::Feasible {
            return Ok(false);
        }
        for (cable, next) in self.next.iter_mut().enumerate() {
            *next = found.tensions[cable] / self.weights[cable];
        }
        Ok(true)
    }

    /// Moves towards `next` as far as the norm falls enough; returns the largest change of a tension (N), and the
    /// predicted decrease of Σ |f|ᵖ as a fraction of it.
    fn search_line(&self, limits: &Limits, p: f64, tensions: &mut [f64]) -> (f64, f64) {
        let target = |cable: usize| self.target(limits, cable);
        let furthest =
            tensions.iter().enumerate().fold(0.0_f64, |most, (cable, f)| most.max((f - target(cable)).abs()));
        let at = |part: f64| -> f64 {
            let ends = tensions.iter().zip(&self.next).enumerate();
            ends.map(|(cable, (f, next))| ((f + part * (next - f) - target(cable)) / furthest).abs().powf(p)).sum()
        };
        let slope: f64 = (tensions.iter().zip(&self.next).enumerate())
            .map(|(cable, (f, next))| {
                let part = (f - target(cable)) / furthest;
                p * part.signum() * part.abs().powf(p - 1.0) * (next - f) / furthest
            })
            .sum();
        let here = at(0.0);
        let mut part = 1.0;
        while at(part) > here + 1e-4 * part * slope && part > 1e-10 {
            part *= 0.5;
        }
        let change = part * largest_difference(tensions, &self.next);
        tensions.iter_mut().zip(&self.next).for_each(|(f, next)| *f += part * (next - *f));
        (change, -slope / here)
    }
}

impl Distribute for ExtremeNorm {
    fn forget(&mut self) {
        self.qp.forget();
    }

    fn refine(
        &mut self,
        task: &Task<'_>,
        _qp: &mut quadratic::Solver,
        found: &mut FoundTensions<'_>,
    ) -> Result<(), InputError> {
        if *found.status == distribute::Status::Feasible {
            let steps = self.run(&task.problem, found.limits, task.options.p, found.tensions)?;
            found.settle(steps);
        }
        Ok(())
    }

    /// The derivative for p = 2.
    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        optimum::nearest(chosen, chosen.between_limits(ON_LIMIT), &|cable| self.target(chosen.limits, cable))
    }
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()))
}
