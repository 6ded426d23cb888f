//! The nearest point of a box within the solutions of the balance, by a dual active set (Goldfarb and Idnani 1983).
//!
//! The search starts at the nearest point f of the affine space f + H λ and adds the limit that is missed most, until
//! none is missed. Every point in between is the nearest one that keeps the limits in the active set, so that the
//! distance grows with every limit added, no set comes twice, and the last point is the optimum. If a limit can neither
//! be met nor exchanged against an active one, the multipliers prove that no tensions keep these limits.

use super::block::{Block, add_scaled, dot, fill, rotate};
use super::bound::{Bound, BoundEnd};
use super::plane::{DEPENDENT, NO_WEIGHT, Plane, SMALL, ZERO};
use crate::scalar::{LANES, dispatch_narrow};
use crate::tension::Limits;

/// Buffers and state of the search.
#[derive(Clone, Debug)]
pub(super) struct ActiveSet {
    cable_count: usize,
    blocks: usize,
    /// Columns of `basis`: m − rank.
    dimension: usize,
    /// Orthonormal basis of the null space. Its first columns span the active limits; the particular solution follows
    /// them.
    pub(super) basis: Vec<Block>,
    /// R of the active limits' rows in `basis`, by columns of m entries.
    triangle: Vec<f64>,
    pub(super) active: Vec<Bound>,
    multipliers: Vec<f64>,
    /// The active limits of the last search.
    remembered: Vec<Bound>,
    /// The row of `basis` for the limit to be added, times its sign.
    row: Vec<f64>,
    /// Rates at which the multipliers of active limits fall while a limit is being added.
    pub(super) weights: Vec<f64>,
    /// Tensions (N).
    pub(super) point: Vec<Block>,
    step: Vec<Block>,
    minimum: Vec<Block>,
    maximum: Vec<Block>,
    pub(super) iterations: u32,
}

impl ActiveSet {
    pub(super) fn new(cable_count: usize) -> Self {
        let blocks = cable_count.div_ceil(LANES);
        let vector = vec![[0.0; LANES]; blocks];
        Self {
            cable_count,
            blocks,
            dimension: 0,
            basis: vec![[0.0; LANES]; (cable_count + 1) * blocks],
            triangle: vec![0.0; cable_count * cable_count],
            active: Vec::with_capacity(cable_count),
            multipliers: Vec::with_capacity(cable_count),
            remembered: Vec::with_capacity(cable_count),
            row: vec![0.0; cable_count],
            weights: vec![0.0; cable_count],
            point: vector.clone(),
            step: vector.clone(),
            minimum: vector.clone(),
            maximum: vector,
            iterations: 0,
        }
    }
}

impl ActiveSet {
    /// Writes the nearest point to `reference`; `basis` holds the null space and after it a solution, as `Balance`
    /// writes them.
    pub(super) fn search(&mut self, dimension: usize, limits: &Limits, reference: Option<&[f64]>) -> BoundEnd {
        if self.blocks == 1 && (1..=2).contains(&dimension) {
            return self.search_plane(dimension, limits, reference);
        }
        let tolerance = limits.tolerance();
        self.begin(dimension, limits, reference);
        self.resume(limits);
        let mut refined = false;
        loop {
            match self.most_missed(tolerance) {
                Some(bound) => match self.add(bound, limits) {
                    None => {}
                    Some(end) => return end,
                },
                None if refined || self.active_limits_are_met(limits, tolerance) => return BoundEnd::Optimum,
                None => {
                    self.start(reference);
                    self.resume(limits);
                    refined = true;
                }
            }
        }
    }

    /// The same search for one or two more cables than degrees of freedom.
    fn search_plane(&mut self, dimension: usize, limits: &Limits, reference: Option<&[f64]>) -> BoundEnd {
        self.dimension = dimension;
        self.write_limits(limits);
        self.write_reference(reference);
        dispatch_narrow(Plane {
            basis: &self.basis[..=dimension],
            minimum: &self.minimum[0],
            maximum: &self.maximum[0],
            reference: &self.step[0],
            limits,
            active: &mut self.active,
            weights: &mut self.weights,
            point: &mut self.point[0],
            iterations: &mut self.iterations,
        })
    }

    /// Sets the point to the balanced tensions nearest to the reference, without regard to limits.
    pub(super) fn begin(&mut self, dimension: usize, limits: &Limits, reference: Option<&[f64]>) {
        self.dimension = dimension;
        self.iterations = 0;
        self.write_limits(limits);
        self.start(reference);
    }

    fn write_limits(&mut self, limits: &Limits) {
        fill(&mut self.minimum, limits.minimum().iter().copied());
        fill(&mut self.maximum, limits.maximum().iter().copied());
    }

    /// Writes the combination of cables that proves the contradiction: balance requires a larger value of it than any
    /// tensions within the limits have. The caller may overwrite the buffer.
    pub(super) fn write_contradiction(&mut self, bound: Bound) -> &mut [Block] {
        self.step.fill([0.0; LANES]);
        self.step[bound.cable / LANES][bound.cable % LANES] = -bound.sign;
        for (bound, &weight) in self.active.iter().zip(&self.weights) {
            // a weight is at most rounding above 0
            self.step[bound.cable / LANES][bound.cable % LANES] = weight.min(0.0) * bound.sign;
        }
        &mut self.step
    }

    /// Forgets which limits were active.
    pub(super) fn forget(&mut self) {
        self.active.clear();
    }

    /// Starts from the active set of the last search, without limits that depend on others or have a negative
    /// multiplier.
    fn resume(&mut self, limits: &Limits) {
        let known = self.active.len();
        self.remembered.clear();
        self.remembered.extend_from_slice(&self.active);
        self.active.clear();
        self.multipliers.clear();
        for index in 0..known {
            let bound = self.remembered[index];
            let free = self.look_along(bound);
            if free > DEPENDENT {
                self.insert(bound, 0.0);
            }
        }
        while !self.active.is_empty() {
            self.solve_for_active(limits);
            let least = (0..self.active.len()).min_by(|&a, &b| self.multipliers[a].total_cmp(&self.multipliers[b]));
            match least {
                Some(least) if self.multipliers[least] < 0.0 => self.remove(least),
                _ => break,
            }
        }
        for j in 0..self.active.len() {
            add_scaled(&mut self.point, self.row[j], &self.basis[j * self.blocks..(j + 1) * self.blocks]);
        }
    }

    /// Sets the point to the one of the affine space nearest to the reference.
    fn start(&mut self, reference: Option<&[f64]>) {
        self.write_reference(reference);
        let (blocks, end) = (self.blocks, self.dimension * self.blocks);
        self.point.copy_from_slice(&self.basis[end..end + blocks]);
        for column in self.basis[..end].chunks_exact(blocks) {
            add_scaled(&mut self.point, dot(column, &self.step), column);
        }
    }

    /// Writes the reference, by default the middle of the limits, to `step`.
    fn write_reference(&mut self, reference: Option<&[f64]>) {
        match reference {
            Some(reference) => fill(&mut self.step, reference.iter().copied()),
            None => {
                for ((middle, least), largest) in self.step.iter_mut().zip(&self.minimum).zip(&self.maximum) {
                    for k in 0..LANES {
                        middle[k] = 0.5 * (least[k] + largest[k]);
                    }
                }
            }
        }
    }

    /// Writes the multipliers of the active limits, and to `row` the step to the point that meets them all.
    fn solve_for_active(&mut self, limits: &Limits) {
        let (q, m) = (self.active.len(), self.cable_count);
        for j in 0..q {
            let cable = self.active[j].cable;
            let mut missed = self.active[j].missed(self.point[cable / LANES][cable % LANES], limits);
            for i in 0..j {
                missed -= self.triangle[j * m + i] * self.row[i];
            }
            self.row[j] = missed / self.triangle[j * m + j];
        }
        for i in (0..q).rev() {
            let mut value = self.row[i];
            for j in i + 1..q {
                value -= self.triangle[j * m + i] * self.multipliers[j];
            }
            self.multipliers[i] = value / self.triangle[i * m + i];
        }
    }

    fn most_missed(&self, tolerance: f64) -> Option<Bound> {
        let (mut worst, mut found) = (tolerance, None);
        let limits = self.minimum.as_flattened().iter().zip(self.maximum.as_flattened());
        for (cable, (&f, (&least, &largest))) in self.point.as_flattened().iter().zip(limits).enumerate() {
            let (below, above) = (least - f, f - largest);
            let missed = if below > above { below } else { above };
            if missed > worst {
                worst = missed;
                found = Some(Bound { cable, sign: if below > above { 1.0 } else { -1.0 } });
            }
        }
        found
    }

    fn active_limits_are_met(&self, limits: &Limits, tolerance: f64) -> bool {
        self.active.iter().all(|bound| {
            let f = self.point[bound.cable / LANES][bound.cable % LANES];
            bound.missed(f, limits).abs() <= tolerance
        })
    }

    /// Moves to the nearest point that also meets this limit; active limits whose multiplier reaches zero are removed.
    /// Returns `Some` if the search ends here.
    fn add(&mut self, bound: Bound, limits: &Limits) -> Option<BoundEnd> {
        let (block, lane) = (bound.cable / LANES, bound.cable % LANES);
        let mut multiplier = 0.0;
        loop {
            self.iterations += 1;
            if self.iterations > 100 + 20 * self.cable_count as u32 {
                return Some(BoundEnd::TooLong);
            }
            let free = self.look_along(bound);
            let missed = bound.missed(self.point[block][lane], limits).max(0.0);
            // no allowed tensions are further away than the diameter: a limit that needs a longer step cannot be met
            // this way
            let is_open = free > SMALL || (free > ZERO && missed < 4.0 * free.sqrt() * limits.diameter());
            let whole = if is_open { missed / free } else { f64::INFINITY };
            let (part, blocking) = self.first_to_vanish();
            let length = whole.min(part);
            if length.is_infinite() {
                // no active limit can be removed, or the multiplier of one has overflowed
                return Some(if blocking.is_none() { BoundEnd::Contradiction(bound) } else { BoundEnd::TooLong });
            }
            add_scaled(&mut self.point, length, &self.step);
            multiplier += length;
            for (u, weight) in self.multipliers.iter_mut().zip(&self.weights) {
                *u = (*u - length * weight).max(0.0);
            }
            match blocking {
                Some(blocking) if part < whole => self.remove(blocking),
                _ => {
                    self.insert(bound, multiplier);
                    return None;
                }
            }
        }
    }

    /// Writes the row, the step and the weights of a limit; returns the squared length of the part of its row that
    /// active limits leave free.
    fn look_along(&mut self, bound: Bound) -> f64 {
        let (q, m, blocks) = (self.active.len(), self.cable_count, self.blocks);
        let (block, lane) = (bound.cable / LANES, bound.cable % LANES);
        self.step.fill([0.0; LANES]);
        let mut free = 0.0;
        for j in 0..self.dimension {
            let column = &self.basis[j * blocks..(j + 1) * blocks];
            let entry = bound.sign * column[block][lane];
            self.row[j] = entry;
            if j >= q {
                free += entry * entry;
                add_scaled(&mut self.step, entry, column);
            }
        }
        for i in (0..q).rev() {
            let mut value = self.row[i];
            for j in i + 1..q {
                value -= self.triangle[j * m + i] * self.weights[j];
            }
            self.weights[i] = value / self.triangle[i * m + i];
        }
        free
    }

    /// Step length at which the first multiplier of an active limit reaches zero, and the index of that limit.
    fn first_to_vanish(&self) -> (f64, Option<usize>) {
        let mut first = (f64::INFINITY, None);
        for (j, (&u, &weight)) in self.multipliers.iter().zip(&self.weights).enumerate() {
            // weights below rounding are zero: rows of the basis have length 1
            if weight > NO_WEIGHT && u < first.0 * weight {
                first = (u / weight, Some(j));
            }
        }
        first
    }

    /// Adds a limit with a given `row`: rotates the free columns so that only one of them has a part in it.
    fn insert(&mut self, bound: Bound, multiplier: f64) {
        let (q, m, blocks) = (self.active.len(), self.cable_count, self.blocks);
        for j in (q + 1..self.dimension).rev() {
            let length = length_of(self.row[j - 1], self.row[j]);
            if self.row[j] != 0.0 && length > 0.0 {
                let turn = [self.row[j - 1] / length, self.row[j] / length];
                let (first, second) = self.basis.split_at_mut(j * blocks);
                rotate(&mut first[(j - 1) * blocks..], &mut second[..blocks], turn);
                self.row[j - 1] = length;
            }
        }
        self.triangle[q * m..q * m + q + 1].copy_from_slice(&self.row[..q + 1]);
        self.active.push(bound);
        self.multipliers.push(multiplier);
    }

    /// Removes an active limit and rotates R back to a triangle.
    fn remove(&mut self, index: usize) {
        let (m, blocks) = (self.cable_count, self.blocks);
        self.active.remove(index);
        self.multipliers.remove(index);
        let q = self.active.len();
        self.triangle.copy_within((index + 1) * m..(q + 1) * m, index * m);
        for j in index..q {
            let [above, below] = [self.triangle[j * m + j], self.triangle[j * m + j + 1]];
            let length = length_of(above, below);
            let [cos, sin] = [above / length, below / length];
            for column in j..q {
                let [above, below] = [self.triangle[column * m + j], self.triangle[column * m + j + 1]];
                self.triangle[column * m + j] = cos * above + sin * below;
                self.triangle[column * m + j + 1] = cos * below - sin * above;
            }
            let (first, second) = self.basis.split_at_mut((j + 1) * blocks);
            rotate(&mut first[j * blocks..], &mut second[..blocks], [cos, sin]);
        }
    }
}

/// √(a² + b²) of entries of orthonormal columns: no overflow is possible, and underflow gives zero.
fn length_of(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}
