//! Tensions that follow the load without kinks (Ueland, Sauder and Skjetne 2021): a p-norm about the reference with
//! smooth limits, and a slack of the load where balance would cost too much.
//!
//! min Σ φᵢ(fᵢ) + Σ ψ(sᵣ) with Aᵀ f + w = s, rows divided by their length, and φᵢ = |(f − f_ref)/α|ᵖ/p − c log (f −
//! f_min)/α − c log (f_max − f)/α, α half the largest range, c the smoothing width squared, 2 ≤ p ≤ 8.
//! Without the barriers a tension would run into its limit with a kink; a tension that p = 2 would put just on its
//! limit, with the reference in the middle, stays away from it by the smoothing width times α. As the width goes to 0,
//! the tensions tend to those of `qp` (p = 2).
//!
//! The slack s makes the problem solvable at any load. The paper prices it at √(ε + s²), which leaves some slack at
//! every load; here ψ is given by the inverse of its slope, s = h(λ) = α (c/κ u² + u⁴/100) with u = α|λ|/κ − 1 where
//! this is above 0, and 0 elsewhere: balance is exact until the multiplier of a row reaches κ/α, when tensions are
//! nearer than about c α/κ to the edge of the feasible loads. There the slack grows gradually, and the status is not
//! feasible.
//!
//! **Search:** the dual problem in the n multipliers, smooth and concave, by Newton's method: G(λ) = Aᵀ f(λ) + w − h(λ)
//! = 0 with φ′(f) = −A λ, a scalar equation per cable. A step is shortened where the slope of the dual along it changes
//! its sign. Low prices κ come first: if their answer has no slack, it is that of the last price. **Continuity:** f and
//! λ are C¹ functions of load, matrix, limits and reference at every load: φ″ > 0, and h is C¹ (implicit function
//! theorem). **Stop rule:** G below 1e-14 of its terms, or below 1e-10 and not falling. **Warm start:** the last
//! multipliers; the answer changes by rounding only.
//!
//! E. Ueland, T. Sauder, R. Skjetne, "Optimal Force Allocation for Overconstrained Cable-Driven Parallel Robots:
//! Continuously Differentiable Solutions With Assessment of Computational Efficiency", IEEE Transactions on Robotics
//! 37(2), 2021.

#[cfg(test)]
mod tests;

use super::affine::dot;
use super::closed_form::ROUNDING;
use super::distribute::{Chosen, Distribute, FoundTensions, NoDerivative, Problem, Task, Written};
use super::response::optimum::Optimum;
use super::{InputError, Limits, Options};

/// κ: prices of the slack, in the order tried, relative to the slope of the p-norm, which is 1 at a distance of α from
/// the reference.
const PRICES: [f64; 3] = [10.0, 100.0, LAST_PRICE];
const LAST_PRICE: f64 = 1e3;
/// Slack as a fraction of α, without its c/κ term, when a multiplier is twice the price.
const STEEP: f64 = 0.01;
/// Newton steps allowed at each price.
const MAX_STEPS: u32 = 200;
/// Fractions of its terms below which a row is balanced: the first at once, the second if G does not fall any more.
const BALANCED: [f64; 2] = [1e-14, 1e-10];
/// Largest slope of the dual behind its maximum along a step, relative to that at the start, that is accepted.
const TURNED: f64 = 0.1;

/// φ of one cable in units of α, as a function of the tension above its least one.
#[derive(Clone, Copy, Debug, Default)]
struct Cost {
    /// Largest less least tension; 0 if the cable has no range.
    range: f64,
    reference: f64,
    p: f64,
    /// c, the square of the smoothing width.
    barrier: f64,
}

impl Cost {
    /// The first and second derivative of |x|ᵖ/p.
    fn norm(&self, z: f64) -> (f64, f64) {
        let x = z - self.reference;
        if self.p == 2.0 {
            return (x, 1.0);
        }
        let power = x.abs().powf(self.p - 2.0);
        (power * x, (self.p - 1.0) * power)
    }

    /// φ′ and φ″.
    fn slopes(&self, z: f64) -> (f64, f64) {
        let (slope, curvature) = self.norm(z);
        let (below, above) = (1.0 / z, 1.0 / (self.range - z));
        (slope + self.barrier * (above - below), curvature + self.barrier * (above * above + below * below))
    }

    /// Tension above the least one at which φ′ has this value, and 1/φ″ there; by Newton's method between bounds that
    /// close in.
    fn place(&self, slope: f64, start: f64) -> (f64, f64) {
        let (mut low, mut high) = (0.0, self.range);
        // bounds from one barrier alone, with the other terms at their least or largest value
        let (to_least, to_largest) = (self.norm(0.0).0 - slope, slope - self.norm(self.range).0);
        if to_least > 0.0 {
            high = f64::min(high, self.barrier / to_least);
        }
        if to_largest > 0.0 {
            low = f64::max(low, self.range - self.barrier / to_largest);
        }
        let mut z = if start > low && start < high { start } else { 0.5 * (low + high) };
        for _ in 0..100 {
            let (at, curvature) = self.slopes(z);
            if at > slope {
                high = z
            } else {
                low = z
            }
            let next = z - (at - slope) / curvature;
            let next = if next > low && next < high { next } else { 0.5 * (low + high) };
            let change = (next - z).abs();
            z = next;
            if change <= f64::max(1e-14 * z.min(self.range - z), 2e-16 * self.range) {
                break;
            }
        }
        (z, 1.0 / self.slopes(z).1)
    }
}

/// Memory for one problem in units of α, and the last multipliers.
#[derive(Clone, Debug)]
pub(super) struct SmoothNorm {
    dof: usize,
    /// c, the square of the smoothing width.
    barrier: f64,
    /// Aᵀ by columns, rows divided by their length.
    matrix: Vec<f64>,
    /// Load and pulls of the least tensions, with the scaled rows.
    load: Vec<f64>,
    /// Largest sum of a row's terms by amount, to which rounding is relative.
    size: f64,
    price: f64,
    costs: Vec<Cost>,
    /// Tensions above the least ones, and 1/φ″.
    places: Vec<f64>,
    yields: Vec<f64>,
    multipliers: Vec<f64>,
    next: Vec<f64>,
    /// G, one entry per row.
    unbalanced: Vec<f64>,
    step: Vec<f64>,
    hessian: Vec<f64>,
}

impl SmoothNorm {
    pub(super) fn new(cable_count: usize, dof: usize) -> Self {
        Self {
            dof,
            barrier: 0.0,
            matrix: vec![0.0; cable_count * dof],
            load: vec![0.0; dof],
            size: 0.0,
            price: LAST_PRICE,
            costs: vec![Cost::default(); cable_count],
            places: vec![0.0; cable_count],
            yields: vec![0.0; cable_count],
            multipliers: vec![0.0; dof],
            next: vec![0.0; dof],
            unbalanced: vec![0.0; dof],
            step: vec![0.0; dof],
            hessian: vec![0.0; dof * dof],
        }
    }

    /// Loads a problem; returns α (N).
    fn load(&mut self, task: &Task<'_>, limits: &Limits) -> f64 {
        let ranges = || limits.minimum().iter().zip(limits.maximum()).map(|(least, largest)| largest - least);
        let unit = 0.5 * ranges().fold(limits.tolerance(), f64::max);
        let unit = if unit > 0.0 { unit } else { 1.0 };
        for (cable, (cost, range)) in self.costs.iter_mut().zip(ranges()).enumerate() {
            let least = limits.minimum()[cable];
            *cost = cost_of(task.options, range, unit, task.reference[cable] - least);
            if range <= limits.tolerance() {
                cost.range = 0.0;
            }
        }
        self.barrier = task.options.smoothing.powi(2);
        let matrix = task.problem.structure_matrix;
        self.size = 0.0;
        for row in 0..self.dof {
            let length = matrix.row(row).norm();
            let length = if length > 0.0 { length } else { 1.0 };
            let mut sum = task.problem.wrench[row] / (length * unit);
            let mut size = sum.abs();
            for (cable, least) in limits.minimum().iter().enumerate() {
                let entry = matrix[(row, cable)] / length;
                self.matrix[cable * self.dof + row] = entry;
                sum += entry * (least / unit);
                size += (entry * (least / unit)).abs() + (entry * self.costs[cable].range).abs();
            }
            self.load[row] = sum;
            self.size = self.size.max(size);
        }
        unit
    }

    /// h and h′ at a multiplier, in units of α.
    fn slack(&self, multiplier: f64) -> (f64, f64) {
        let beyond = (multiplier.abs() / self.price - 1.0).max(0.0);
        let (soft, square) = (self.barrier / self.price, beyond * beyond);
        let amount = (soft + STEEP * square) * square;
        (amount * multiplier.signum(), (2.0 * soft + 4.0 * STEEP * square) * beyond / self.price)
    }

    /// Writes f(λ), 1/φ″ and G at the next multipliers.
    fn evaluate(&mut self) {
        let dof = self.dof;
        for row in 0..dof {
            self.unbalanced[row] = self.load[row] - self.slack(self.next[row]).0;
        }
        for (cable, column) in self.matrix.chunks_exact(dof).enumerate() {
            let cost = &self.costs[cable];
            let (place, give) = match cost.range {
                0.0 => (0.0, 0.0),
                _ => cost.place(-dot(column, &self.next), self.places[cable]),
            };
            (self.places[cable], self.yields[cable]) = (place, give);
            self.unbalanced.iter_mut().zip(column).for_each(|(sum, entry)| *sum += entry * place);
        }
    }

    /// Writes Newton's step from the current point: (Aᵀ φ″⁻¹ A + h′) step = G.
    fn newton(&mut self) {
        let dof = self.dof;
        self.hessian.fill(0.0);
        for (column, give) in self.matrix.chunks_exact(dof).zip(&self.yields) {
            for (row, entry) in column.iter().enumerate() {
                for (place, other) in self.hessian[row * dof..][..=row].iter_mut().zip(column) {
                    *place += give * entry * other;
                }
            }
        }
        for row in 0..dof {
            self.hessian[row * dof + row] += self.slack(self.multipliers[row]).1;
        }
        self.step.copy_from_slice(&self.unbalanced);
        solve_in_place(&mut self.hessian, &mut self.step);
        // where the system is almost singular a multiplier may grow to four times its size
        let most = |list: &[f64]| list.iter().fold(0.0_f64, |most, number| most.max(number.abs()));
        let (reach, length) = (4.0 * most(&self.multipliers).max(1.0), most(&self.step));
        if length > reach {
            self.step.iter_mut().for_each(|step| *step *= reach / length);
        }
    }

    /// Shortens the step until the slope of the dual at its end has not changed its sign by more than `TURNED`.
    fn search_line(&mut self) {
        let along = dot(&self.unbalanced, &self.step);
        let mut part = 1.0;
        for _ in 0..60 {
            for (next, (here, step)) in self.next.iter_mut().zip(self.multipliers.iter().zip(&self.step)) {
                *next = here + part * step;
            }
            self.evaluate();
            let slope = dot(&self.unbalanced, &self.step);
            if !(slope < -TURNED * along) {
                break;
            }
            part *= (along / (along - slope)).clamp(0.1, 0.5);
        }
        self.multipliers.copy_from_slice(&self.next);
    }

    /// Newton's method at one price; returns the steps taken, and true if G has become 0.
    fn run(&mut self) -> (u32, bool) {
        let most = |list: &[f64]| list.iter().fold(0.0_f64, |most, number| most.max(number.abs()));
        self.next.copy_from_slice(&self.multipliers);
        self.evaluate();
        let mut last = most(&self.unbalanced);
        for steps in 0..MAX_STEPS {
            if last <= BALANCED[0] * self.size {
                return (steps, true);
            }
            self.newton();
            self.search_line();
            let here = most(&self.unbalanced);
            if here <= BALANCED[1] * self.size && here > 0.5 * last {
                return (steps + 1, true);
            }
            if !here.is_finite() {
                break;
            }
            last = here;
        }
        (MAX_STEPS, false)
    }

    /// True if a row has a slack.
    fn has_slack(&self) -> bool {
        self.multipliers.iter().any(|multiplier| multiplier.abs() > self.price)
    }

    /// Newton's method at rising prices; returns the steps taken, and true if the load is balanced.
    fn balance(&mut self) -> (u32, bool) {
        let (mut steps, mut has_settled) = (0, false);
        for price in PRICES {
            self.price = price;
            if self.has_slack() && price < LAST_PRICE {
                continue;
            }
            let (more, settled) = self.run();
            (steps, has_settled) = (steps + more, settled);
            if !self.has_slack() {
                break;
            }
        }
        (steps, has_settled && !self.has_slack())
    }
}

/// φ of a cable with this range (N) and a reference this far above its least tension (N), in units of `unit` (N).
fn cost_of(options: &Options<'_>, range: f64, unit: f64, reference: f64) -> Cost {
    Cost { range: range / unit, reference: reference / unit, p: options.p, barrier: options.smoothing.powi(2) }
}

/// Solves a system by Cholesky factors of its lower half, row by row; pivots below rounding are raised.
fn solve_in_place(matrix: &mut [f64], right: &mut [f64]) {
    let n = right.len();
    let floor = (0..n).fold(1e-60, |most: f64, row| most.max(1e-15 * matrix[row * n + row]));
    for row in 0..n {
        for column in 0..=row {
            let (above, here) = matrix.split_at(row * n);
            let earlier = if column < row { &above[column * n..][..column] } else { &here[..column] };
            let entry = here[column] - dot(earlier, &here[..column]);
            matrix[row * n + column] = match column < row {
                true => entry / matrix[column * n + column],
                false => entry.max(floor).sqrt(),
            };
        }
        right[row] = (right[row] - dot(&matrix[row * n..][..row], right)) / matrix[row * n + row];
    }
    for row in (0..n).rev() {
        let later: f64 = (row + 1..n).map(|later| matrix[later * n + row] * right[later]).sum();
        right[row] = (right[row] - later) / matrix[row * n + row];
    }
}

/// True if every row of Aᵀ f + w is rounding of its terms.
fn is_balanced(problem: &Problem<'_>, tensions: &[f64]) -> bool {
    problem.wrench.iter().enumerate().all(|(row, load)| {
        let terms = || tensions.iter().enumerate().map(|(cable, f)| problem.structure_matrix[(row, cable)] * f);
        let size = terms().fold(load.abs(), |size, term| size + term.abs());
        terms().fold(*load, |sum, term| sum + term).abs() <= ROUNDING * size
    })
}

impl Distribute for SmoothNorm {
    fn forget(&mut self) {
        self.multipliers.fill(0.0);
        self.places.fill(0.0);
    }

    fn search(&mut self, task: &Task<'_>, found: &mut FoundTensions<'_>) -> Result<bool, InputError> {
        let p = task.options.p;
        if p < 2.0 {
            let expected = "from 2 to 8 for tensions without kinks";
            return Err(InputError::OptionValue { what: "p of the p-norm", value: p, expected });
        }
        let unit = self.load(task, found.limits);
        // the exact programme reports numbers that cannot be calculated with
        if !self.matrix.iter().chain(&self.load).chain([&self.size]).all(|number| number.is_finite()) {
            return Ok(false);
        }
        if !self.multipliers.iter().all(|multiplier| multiplier.is_finite()) {
            self.forget();
        }
        let (steps, is_found) = self.balance();
        *found.iterations = steps;
        for (f, (least, place)) in found.tensions.iter_mut().zip(found.limits.minimum().iter().zip(&self.places)) {
            *f = least + unit * place;
        }
        found.limits.clamp(found.tensions);
        Ok(is_found && is_balanced(&task.problem, found.tensions))
    }

    /// Derivative of balanced tensions, with p = 2 and the default smoothing width.
    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        let Chosen { problem, limits, tensions } = *chosen;
        let ends = |cable: usize| (limits.minimum()[cable], limits.maximum()[cable]);
        let has_range = |cable: &usize| ends(*cable).1 - ends(*cable).0 > limits.tolerance();
        let free: Vec<usize> = (0..tensions.len()).filter(has_range).collect();
        let unit = 0.5 * free.iter().map(|&cable| ends(cable).1 - ends(cable).0).fold(0.0, f64::max);
        let slopes = |cable: usize| {
            let (least, largest) = ends(cable);
            let cost = cost_of(&Options::default(), largest - least, unit, limits.middle(cable) - least);
            let (slope, curvature) = cost.slopes((tensions[cable] - least) / unit);
            (unit * slope, curvature)
        };
        let optimum = Optimum::of(problem.structure_matrix, tensions, free, &slopes).ok_or(NoDerivative::Pinned)?;
        Ok(Some(Box::new(optimum)))
    }
}
