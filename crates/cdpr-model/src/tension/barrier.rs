//! The barrier method: the analytic centre of the allowed tensions, max Σ log (f − f_min) + log (f_max − f).
//!
//! The product of the distances to all limits is largest at one point inside the set, found by Newton's method in the
//! coordinates λ of f + H λ. The start lies strictly inside: the optimum of the quadratic programme with limits
//! narrowed by a fraction of their range. The step is damped as the theory of self-concordant functions requires
//! (Nesterov and Nemirovskii 1994), so that the search converges from any start; the last steps double the digits.
//!
//! **Continuity:** the centre is a smooth function (C¹ and beyond) of load, matrix and limits wherever the set has an
//! inside: the implicit function theorem with a positive definite Hessian. At the edge of the workspace, where the set
//! shrinks to a point, it tends to that point. If the set is so thin that no limits narrowed by 1e-9 of their range
//! leave tensions, the answer is the optimum of the programme. **Stop rule:** a Newton step of less than 1e-11 of the
//! distances to the limits, or one that rounding keeps from shrinking. **Warm start:** the last tensions, brought into
//! balance, if they are strictly inside; the answer changes by rounding only.

use super::affine::{Affine, add_scaled, dot};
use super::distribute::{Chosen, Distribute, FoundTensions, NoDerivative, Status, Task, Written};
use super::quadratic;
use super::response::optimum::Optimum;
use super::{InputError, Limits};

/// Fractions of their ranges by which the limits are narrowed, in the order tried.
const MARGINS: [f64; 6] = [0.25, 0.05, 0.01, 1e-3, 1e-5, 1e-9];

/// Newton steps before giving up: a start at a margin of 1e-9 needs about 60.
const MAX_STEPS: u32 = 300;
/// Length of Newton's step in the metric of the barrier below which the centre is found.
const SETTLED: f64 = 1e-11;
/// Length of a step below which no further decrease means rounding: tensions that are large beside their distance to
/// the limits.
const ROUNDING: f64 = 1e-5;

/// The method: memory for the solutions of the balance, for the start, and for Newton's method.
#[derive(Clone, Debug)]
pub(super) struct Centre {
    balanced: Affine,
    search: Search,
    narrow: Limits,
    /// The last centre (N), once there is one.
    last: Vec<f64>,
    has_last: bool,
}

impl Centre {
    pub(super) fn new(cable_count: usize, dof: usize) -> Self {
        Self {
            balanced: Affine::new(cable_count, dof),
            search: Search::new(cable_count),
            narrow: Limits::zero(cable_count),
            last: vec![0.0; cable_count],
            has_last: false,
        }
    }

    /// Moves allowed tensions to the analytic centre and returns the steps taken. If the set has no inside, the answer
    /// is the optimum of the programme, after 0 steps.
    fn run(
        &mut self,
        task: &Task<'_>,
        limits: &Limits,
        qp: &mut quadratic::Solver,
        tensions: &mut [f64],
    ) -> Result<Option<u32>, InputError> {
        let Task { problem, reference, .. } = *task;
        self.balanced.load(problem.structure_matrix, problem.wrench)?;
        let mut is_inside = false;
        if self.has_last {
            self.narrow.narrow_from(limits, MARGINS[2]);
            self.balanced.nearest(&self.last, tensions);
            is_inside = self.narrow.contain(tensions, 0.0);
        }
        let mut margins = MARGINS.iter();
        while !is_inside {
            let Some(&margin) = margins.next() else { break };
            self.narrow.narrow_from(limits, margin);
            let found = qp.solve(problem.structure_matrix, problem.wrench, &self.narrow, Some(reference))?;
            is_inside = found.status == quadratic::Status::Feasible;
            if is_inside {
                tensions.copy_from_slice(&found.tensions);
            }
        }
        self.has_last = false;
        if !is_inside {
            let found = qp.solve(problem.structure_matrix, problem.wrench, limits, Some(reference))?;
            tensions.copy_from_slice(&found.tensions);
            return Ok(Some(0));
        }
        let steps = self.search.run(&mut self.balanced, limits, tensions);
        self.has_last = steps.is_some();
        self.last.copy_from_slice(tensions);
        Ok(steps)
    }
}

impl Distribute for Centre {
    fn forget(&mut self) {
        self.has_last = false;
    }

    fn refine(
        &mut self,
        task: &Task<'_>,
        qp: &mut quadratic::Solver,
        found: &mut FoundTensions<'_>,
    ) -> Result<(), InputError> {
        if *found.status == Status::Feasible {
            let steps = self.run(task, found.limits, qp, found.tensions)?;
            found.settle(steps);
        }
        Ok(())
    }

    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        let Chosen { problem, limits, tensions } = chosen;
        let optimum = Optimum::barrier(problem.structure_matrix, tensions, limits).ok_or(NoDerivative::Thin)?;
        Ok(Some(Box::new(optimum)))
    }
}

/// Memory for one Newton step.
#[derive(Clone, Debug)]
struct Search {
    /// Square root of the curvature per cable, and the slope divided by it.
    roots: Vec<f64>,
    slopes: Vec<f64>,
    /// Factors Q and R of H with its rows multiplied by the roots.
    orthogonal: Vec<f64>,
    triangle: Vec<f64>,
    step: Vec<f64>,
}

impl Search {
    fn new(cable_count: usize) -> Self {
        Self {
            roots: vec![0.0; cable_count],
            slopes: vec![0.0; cable_count],
            orthogonal: vec![0.0; cable_count * cable_count],
            triangle: vec![0.0; cable_count * cable_count],
            step: vec![0.0; cable_count],
        }
    }

    /// Moves tensions from strictly inside the limits to the centre; returns the steps taken, `None` if it did not
    /// converge. Cables without a range are fixed first.
    fn run(&mut self, balanced: &mut Affine, limits: &Limits, tensions: &mut [f64]) -> Option<u32> {
        for (cable, (least, largest)) in limits.minimum().iter().zip(limits.maximum()).enumerate() {
            if largest - least <= limits.tolerance() {
                balanced.fix(cable, *least, tensions);
            }
        }
        if balanced.dimension() == 0 {
            return Some(0);
        }
        let mut last = f64::INFINITY;
        for steps in 0..MAX_STEPS {
            let length = self.newton(balanced, limits, tensions)?;
            // beyond 1/4 a whole step may lead outside, the fraction 1/(1 + length) of it does not
            let part = if length > 0.25 { 1.0 / (1.0 + length) } else { 1.0 };
            for (column, along) in self.step[..balanced.dimension()].iter().enumerate() {
                add_scaled(tensions, part * along, balanced.column(column));
            }
            if length < SETTLED || (length < ROUNDING && length > 0.5 * last) {
                return Some(steps);
            }
            last = length;
        }
        None
    }

    /// Writes Newton's step; returns its length in the metric of the barrier, `None` if it is not finite.
    ///
    /// Uses a QR factorisation of √curvature · H: near a limit curvatures differ by more than the square of rounding.
    fn newton(&mut self, balanced: &Affine, limits: &Limits, tensions: &[f64]) -> Option<f64> {
        let (dimension, cables) = (balanced.dimension(), tensions.len());
        let ends = limits.minimum().iter().zip(limits.maximum());
        for (cable, (f, (least, largest))) in tensions.iter().zip(ends).enumerate() {
            let is_fixed = largest - least <= limits.tolerance();
            let (below, above) = (1.0 / (f - least), 1.0 / (largest - f));
            let root = (above * above + below * below).sqrt();
            (self.roots[cable], self.slopes[cable]) =
                if is_fixed { (0.0, 0.0) } else { (root, (above - below) / root) };
        }
        (0..dimension).for_each(|index| self.orthogonalize(index, balanced));
        let mut square = 0.0;
        for index in 0..dimension {
            let along = -dot(&self.orthogonal[index * cables..][..cables], &self.slopes);
            square += along * along;
            self.step[index] = along;
        }
        for index in (0..dimension).rev() {
            for later in index + 1..dimension {
                self.step[index] -= self.triangle[later * dimension + index] * self.step[later];
            }
            self.step[index] /= self.triangle[index * dimension + index];
        }
        let is_finite = self.step[..dimension].iter().all(|step| step.is_finite());
        is_finite.then_some(f64::sqrt(square))
    }

    /// Writes one column of Q and R.
    fn orthogonalize(&mut self, index: usize, balanced: &Affine) {
        let (dimension, cables) = (balanced.dimension(), self.roots.len());
        let (done, rest) = self.orthogonal.split_at_mut(index * cables);
        let column = &mut rest[..cables];
        let terms = balanced.column(index).iter().zip(&self.roots);
        column.iter_mut().zip(terms).for_each(|(place, (entry, root))| *place = entry * root);
        let entries = &mut self.triangle[index * dimension..][..dimension];
        entries.fill(0.0);
        // twice: the first pass leaves rounding of long columns in short ones
        for _ in 0..2 {
            for (earlier, entry) in done.chunks_exact(cables).zip(entries.iter_mut()) {
                let along = dot(earlier, column);
                *entry += along;
                add_scaled(column, -along, earlier);
            }
        }
        let length = dot(column, column).sqrt();
        entries[index] = length;
        column.iter_mut().for_each(|entry| *entry /= length);
    }
}
