//! The search of [`super::active_set`] for up to eight cables with one or two more than degrees of freedom: in the
//! plane of the coordinates λ at most two limits are active, so that no factorisation is needed and all numbers fit
//! into registers.
//!
//! The rules are the same: the limit that is missed most is added, and an active one is removed when its multiplier
//! reaches zero.

use super::block::Block;
use super::bound::{Bound, BoundEnd};
use crate::scalar::{Kernel, LANES, Lanes};
use crate::tension::Limits;

/// A search, and references to the places of its result.
pub(super) struct Plane<'a> {
    /// The null space (one or two columns) and after it a solution.
    pub(super) basis: &'a [Block],
    pub(super) minimum: &'a Block,
    pub(super) maximum: &'a Block,
    /// Tensions to be near to.
    pub(super) reference: &'a Block,
    pub(super) limits: &'a Limits,
    /// Limits to start from; at the end the active limits.
    pub(super) active: &'a mut Vec<Bound>,
    pub(super) weights: &'a mut [f64],
    pub(super) point: &'a mut Block,
    pub(super) iterations: &'a mut u32,
}

/// Squared length below which a row of an orthonormal basis is zero, for any limits.
pub(super) const ZERO: f64 = 1e-30;
/// Squared length below which the diameter of the limits decides whether it is zero.
pub(super) const SMALL: f64 = 1e-16;
/// Weight below which a multiplier does not fall.
pub(super) const NO_WEIGHT: f64 = 1e-12;
/// Squared length below which a limit depends on the other active ones of the last search, and is not resumed.
pub(super) const DEPENDENT: f64 = 1e-8;

type Pair = [f64; 2];

fn dot(a: Pair, b: Pair) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: Pair, b: Pair) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Active limits, their normals in λ, their multipliers, and the point that meets them.
struct State<'a> {
    columns: [&'a Block; 2],
    start: Pair,
    lambda: Pair,
    bounds: [Bound; 2],
    normals: [Pair; 2],
    multipliers: Pair,
    weights: Pair,
    count: usize,
    iterations: u32,
}

impl Kernel for Plane<'_> {
    type Output = BoundEnd;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> BoundEnd {
        let none = [0.0; LANES];
        let (columns, solution) = match self.basis {
            [first, second, solution] => ([first, second], solution),
            [first, solution, ..] => ([first, &none], solution),
            _ => return BoundEnd::TooLong,
        };
        let [first, second, solution] = [lanes.load(columns[0]), lanes.load(columns[1]), lanes.load(solution)];
        let reference = lanes.load(self.reference);
        let [x, y, _, _] = L::sums([first * reference, second * reference, reference, reference]);
        let space = [first, second, solution];
        let [minimum, maximum] = [lanes.load(self.minimum), lanes.load(self.maximum)];
        let tolerance = self.limits.tolerance();
        let mut state = State::new(columns, [x, y]);
        let nearest = tensions(lanes, &space, state.start).to_array();
        state.resume(self.active, &nearest, self.limits);
        let mut refined = false;
        let end = loop {
            let f = tensions(lanes, &space, state.lambda);
            let point = f.to_array();
            match most_missed(&(minimum - f).to_array(), &(f - maximum).to_array(), tolerance) {
                Some(bound) => {
                    if let Some(end) = state.add(bound, bound.missed(point[bound.cable], self.limits), self.limits) {
                        break end;
                    }
                }
                None if refined || state.are_met(&point, self.limits, tolerance) => break BoundEnd::Optimum,
                None => {
                    state.meet_all(&nearest, self.limits);
                    refined = true;
                }
            }
        };
        tensions(lanes, &space, state.lambda).store(self.point);
        self.active.clear();
        self.active.extend_from_slice(&state.bounds[..state.count]);
        self.weights[..state.count].copy_from_slice(&state.weights[..state.count]);
        *self.iterations = state.iterations;
        end
    }
}

/// f = p + H λ
#[inline(always)]
fn tensions<L: Lanes>(lanes: L, [first, second, solution]: &[L; 3], lambda: Pair) -> L {
    *solution + lanes.constant(lambda[0]) * *first + lanes.constant(lambda[1]) * *second
}

/// The limit missed most. Chosen without branches, since a processor cannot predict which one it is.
#[inline]
fn most_missed(below: &Block, above: &Block, tolerance: f64) -> Option<Bound> {
    let (mut worst, mut worst_cable) = (tolerance, LANES);
    for cable in 0..LANES {
        let missed = if below[cable] > above[cable] { below[cable] } else { above[cable] };
        worst_cable = if missed > worst { cable } else { worst_cable };
        worst = if missed > worst { missed } else { worst };
    }
    let cable = (worst_cable < LANES).then_some(worst_cable)?;
    Some(Bound { cable, sign: if below[cable] > above[cable] { 1.0 } else { -1.0 } })
}

impl<'a> State<'a> {
    #[inline]
    fn new(columns: [&'a Block; 2], start: Pair) -> Self {
        Self {
            columns,
            start,
            lambda: start,
            bounds: [Bound { cable: 0, sign: 1.0 }; 2],
            normals: [[0.0; 2]; 2],
            multipliers: [0.0; 2],
            weights: [0.0; 2],
            count: 0,
            iterations: 0,
        }
    }

    #[inline]
    fn normal(&self, bound: Bound) -> Pair {
        [bound.sign * self.columns[0][bound.cable], bound.sign * self.columns[1][bound.cable]]
    }

    #[inline]
    fn push(&mut self, bound: Bound, normal: Pair, multiplier: f64) {
        self.bounds[self.count] = bound;
        self.normals[self.count] = normal;
        self.multipliers[self.count] = multiplier;
        self.count += 1;
    }

    #[inline]
    fn remove(&mut self, index: usize) {
        if index == 0 {
            self.bounds[0] = self.bounds[1];
            self.normals[0] = self.normals[1];
            self.multipliers[0] = self.multipliers[1];
        }
        self.count -= 1;
    }

    /// Returns the part of a normal that is orthogonal to the active ones, and writes their weights in the remaining
    /// part.
    #[inline]
    fn free(&mut self, normal: Pair) -> Pair {
        match self.count {
            0 => normal,
            1 => {
                let active = self.normals[0];
                let square = dot(active, active);
                self.weights[0] = dot(normal, active) / square;
                // the component orthogonal to the active normal, without the difference of almost equal numbers
                let across = cross(active, normal) / square;
                [-across * active[1], across * active[0]]
            }
            _ => {
                let [first, second] = self.normals;
                let determinant = cross(first, second);
                self.weights = [cross(normal, second) / determinant, cross(first, normal) / determinant];
                [0.0; 2]
            }
        }
    }

    /// Moves to the nearest point that also meets this limit; active limits whose multiplier reaches zero are removed.
    #[inline(always)]
    fn add(&mut self, bound: Bound, missed: f64, limits: &Limits) -> Option<BoundEnd> {
        let normal = self.normal(bound);
        let (mut missed, mut multiplier) = (missed.max(0.0), 0.0);
        loop {
            self.iterations += 1;
            if self.iterations > 100 + 20 * LANES as u32 {
                return Some(BoundEnd::TooLong);
            }
            let step = self.free(normal);
            let free = dot(step, step);
            // no allowed tensions are further away than the diameter: a limit that needs a longer step cannot be met
            // this way
            let is_open = free > SMALL || (free > ZERO && missed < 4.0 * free.sqrt() * limits.diameter());
            let whole = if is_open { missed / free } else { f64::INFINITY };
            let (mut part, mut blocking) = (f64::INFINITY, None);
            for index in 0..self.count {
                let (multiplier, weight) = (self.multipliers[index], self.weights[index]);
                if weight > NO_WEIGHT && multiplier < part * weight {
                    (part, blocking) = (multiplier / weight, Some(index));
                }
            }
            let length = whole.min(part);
            if length.is_infinite() {
                // no active limit can be removed, or the multiplier of one has overflowed
                return Some(if blocking.is_none() { BoundEnd::Contradiction(bound) } else { BoundEnd::TooLong });
            }
            self.lambda = [self.lambda[0] + length * step[0], self.lambda[1] + length * step[1]];
            missed = (missed - length * free).max(0.0);
            multiplier += length;
            for index in 0..self.count {
                self.multipliers[index] = (self.multipliers[index] - length * self.weights[index]).max(0.0);
            }
            match blocking {
                Some(blocking) if part < whole => self.remove(blocking),
                _ => {
                    self.push(bound, normal, multiplier);
                    return None;
                }
            }
        }
    }

    /// Starts from limits that were active before, without those that depend on others or have a negative multiplier;
    /// `nearest` is the point without limits.
    #[inline]
    fn resume(&mut self, known: &[Bound], nearest: &Block, limits: &Limits) {
        for &bound in known.iter().take(2) {
            let normal = self.normal(bound);
            let free = self.free(normal);
            if dot(free, free) > DEPENDENT {
                self.push(bound, normal, 0.0);
            }
        }
        while self.count > 0 {
            self.meet_all(nearest, limits);
            let last = self.count - 1;
            let least = if self.multipliers[last] < self.multipliers[0] { last } else { 0 };
            if self.multipliers[least] >= 0.0 {
                return;
            }
            self.remove(least);
        }
        self.lambda = self.start;
    }

    /// Moves to the nearest point that meets the active limits, and writes their multipliers.
    #[inline]
    fn meet_all(&mut self, nearest: &Block, limits: &Limits) {
        let missed = |bound: Bound| bound.missed(nearest[bound.cable], limits);
        let way = match self.count {
            0 => [0.0; 2],
            1 => {
                let active = self.normals[0];
                let multiplier = missed(self.bounds[0]) / dot(active, active);
                self.multipliers[0] = multiplier;
                [multiplier * active[0], multiplier * active[1]]
            }
            _ => {
                let [first, second] = self.normals;
                let (a, b) = (missed(self.bounds[0]), missed(self.bounds[1]));
                let determinant = cross(first, second);
                let way = [(a * second[1] - b * first[1]) / determinant, (b * first[0] - a * second[0]) / determinant];
                self.multipliers = [cross(way, second) / determinant, cross(first, way) / determinant];
                way
            }
        };
        self.lambda = [self.start[0] + way[0], self.start[1] + way[1]];
    }

    #[inline]
    fn are_met(&self, point: &Block, limits: &Limits, tolerance: f64) -> bool {
        self.bounds[..self.count].iter().all(|bound| bound.missed(point[bound.cable], limits).abs() <= tolerance)
    }
}
