//! Statistical bound of the error of a size: the region and a method's result are compared at points drawn at random.
//!
//! Methods judge chosen points, so they miss parts or gaps between them, and no sum over their cells shows how large
//! these are. A point drawn at random lies in a set of any shape with the probability of the set's size. One point is
//! drawn in each of many cells of equal size; the points at which region and result differ are counted, and bounds for
//! sums of independent numbers turn the counts into a bound of the difference in size. It holds for any region, at a
//! stated confidence.

use super::{Bounds, Point, Region};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Probability with which a size lies within its bound, for any region.
pub const CONFIDENCE: f64 = 0.999;

/// Most audits of one region among which one may be chosen; all of them hold together with [`CONFIDENCE`].
pub(super) const LOOKS: u64 = 8;

/// Points of the region kept by an audit.
const KEPT: usize = 64;

/// Points compared at once.
const BLOCK: usize = 1 << 15;

/// Counts of random points at which a region differs from the result of a method.
#[derive(Clone, Debug, PartialEq)]
pub struct Audit {
    /// Points drawn.
    pub points: u64,
    /// Points that belong to the region.
    pub feasible_points: u64,
    /// Points that belong to the region, but not to the result.
    pub missed: u64,
    /// Points that belong to the result, but not to the region.
    pub added: u64,
    /// Some of the points that belong to the region (m).
    pub inside: Vec<Point>,
    /// Size of the box (m², m³).
    size: f64,
}

/// Count of cells of equal size along each axis, about `cells` in all and no more.
pub(super) fn strata(bounds: &Bounds, cells: u64) -> [usize; 3] {
    let dimension = bounds.dimension();
    let mut counts = [1; 3];
    // an axis too short for a cell leaves its fraction to the others
    let (mut open, mut left) = ((0..dimension).collect::<Vec<_>>(), cells.max(1) as f64);
    open.sort_by(|a, b| bounds.extent(*a).total_cmp(&bounds.extent(*b)));
    while let Some(&axis) = open.first() {
        let size: f64 = open.iter().map(|&axis| bounds.extent(axis)).product();
        let along = bounds.extent(axis) * (left / size).powf(1.0 / open.len() as f64);
        counts[axis] = along.floor().max(1.0) as usize;
        left = (left / counts[axis] as f64).max(1.0);
        open.remove(0);
    }
    counts
}

impl Audit {
    /// Compares the region with a result at about `points` points; each seed draws other points.
    pub fn of(
        region: &Region<'_>,
        bounds: &Bounds,
        [points, seed]: [u64; 2],
        found: &mut dyn FnMut(&[Point], &mut [bool]),
    ) -> Self {
        let mut audit =
            Self { points: 0, feasible_points: 0, missed: 0, added: 0, inside: Vec::new(), size: bounds.size() };
        let mut drawn = Drawn::new(bounds, points, seed);
        let (mut block, mut holds, mut counts) = (Vec::with_capacity(BLOCK), Vec::new(), Vec::new());
        loop {
            block.clear();
            block.extend(drawn.by_ref().take(BLOCK));
            if block.is_empty() {
                return audit;
            }
            holds.resize(block.len(), false);
            counts.resize(block.len(), false);
            region.holds_all(&block, &mut holds);
            found(&block, &mut counts);
            audit.add(&block, &holds, &counts);
        }
    }

    fn add(&mut self, points: &[Point], holds: &[bool], found: &[bool]) {
        let stride = (points.len() / KEPT).max(1);
        for (index, point) in points.iter().enumerate() {
            self.points += 1;
            self.feasible_points += u64::from(holds[index]);
            self.missed += u64::from(holds[index] && !found[index]);
            self.added += u64::from(!holds[index] && found[index]);
            if holds[index] && (self.inside.len() < KEPT / 2 || index % stride == 0) && self.inside.len() < KEPT {
                self.inside.push(*point);
            }
        }
    }

    /// Size of the box divided by the number of points (m², m³).
    fn fraction(&self) -> f64 {
        self.size / self.points.max(1) as f64
    }

    /// Largest difference between the size found and the size of the region (m², m³), with [`CONFIDENCE`].
    pub fn error_bound(&self) -> f64 {
        let [least, largest] = self.difference();
        least.abs().max(largest.abs())
    }

    /// Half the width of the interval of [`Audit::difference`] (m², m³): more points make it smaller, a better result
    /// does not.
    pub(crate) fn uncertainty(&self) -> f64 {
        let [least, largest] = self.difference();
        0.5 * (largest - least)
    }

    /// Interval of the size of the region minus the size found (m², m³), with [`CONFIDENCE`].
    pub(crate) fn difference(&self) -> [f64; 2] {
        let surprise = surprise();
        let [missed, added] = [self.missed, self.added].map(|count| limits(count as f64, surprise));
        let apart = [missed[0] - added[1], missed[1] - added[0]];
        // Bernstein: steps of at most 1, with a variance of at most the frequency at which they are not 0
        let often = limits((self.missed + self.added) as f64, surprise)[1];
        let away = surprise / 3.0 + (surprise * surprise / 9.0 + 2.0 * often * surprise).sqrt();
        let mean = self.missed as f64 - self.added as f64;
        [(mean - away).max(apart[0]), (mean + away).min(apart[1])].map(|count| count * self.fraction())
    }

    /// Least size of the missed part of the region (m², m³), with [`CONFIDENCE`].
    pub(crate) fn missed_at_least(&self) -> f64 {
        limits(self.missed as f64, surprise())[0] * self.fraction()
    }
}

/// Negative logarithm of the probability at which each of the eight inequalities of an audit may fail.
fn surprise() -> f64 {
    -((1.0 - CONFIDENCE) / (8 * LOOKS) as f64).ln()
}

/// Interval of the expectation of a count of independent events: λ − k + k ln(k/λ) ≤ surprise (Chernoff).
fn limits(count: f64, surprise: f64) -> [f64; 2] {
    let excess = |mean: f64| mean - count + if count > 0.0 { count * (count / mean).ln() } else { 0.0 } - surprise;
    let bisect = |mut inside: f64, mut outside: f64| {
        for _ in 0..100 {
            let middle = 0.5 * (inside + outside);
            *(if excess(middle) > 0.0 { &mut outside } else { &mut inside }) = middle;
        }
        outside
    };
    let above = bisect(count, count + 2.0 * surprise + (2.0 * count * surprise).sqrt());
    [if count > 0.0 { bisect(count, 0.0) } else { 0.0 }, above]
}

/// Iterator over points of a box, one at random in each stratum.
struct Drawn<'a> {
    bounds: &'a Bounds,
    counts: [usize; 3],
    next: usize,
    random: ChaCha8Rng,
}

impl<'a> Drawn<'a> {
    fn new(bounds: &'a Bounds, points: u64, seed: u64) -> Self {
        Self { bounds, counts: strata(bounds, points), next: 0, random: ChaCha8Rng::seed_from_u64(seed) }
    }
}

impl Iterator for Drawn<'_> {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        let [columns, rows, layers] = self.counts;
        let index = self.next;
        if index >= columns * rows * layers {
            return None;
        }
        self.next += 1;
        let cell = [index % columns, index / columns % rows, index / columns / rows];
        let mut point = [0.0; 3];
        for (axis, along) in point.iter_mut().enumerate().take(self.bounds.dimension()) {
            let fraction = (cell[axis] as f64 + self.random.random::<f64>()) / self.counts[axis] as f64;
            *along = self.bounds.least()[axis] + fraction * self.bounds.extent(axis);
        }
        Some(point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without an event the mean is below −ln of the probability; with many events it is off by √(2 k s) at most.
    #[test]
    fn limits_of_a_count_are_those_of_chernoff() {
        assert!((limits(0.0, 9.0)[1] - 9.0).abs() < 1e-9 && limits(0.0, 9.0)[0] == 0.0);
        let [least, largest] = limits(1e6, 9.0);
        let normal = (2.0 * 1e6 * 9.0_f64).sqrt();
        assert!((1e6 - least - normal).abs() < 10.0 && (largest - 1e6 - normal).abs() < 10.0, "{least} {largest}");
        for count in [1.0, 3.0, 40.0] {
            for mean in limits(count, 9.0) {
                let excess = mean - count + count * (count / mean).ln();
                assert!((excess - 9.0).abs() < 1e-6, "{count} {mean} {excess}");
            }
        }
    }

    #[test]
    fn strata_fill_flat_and_long_boxes() {
        let counts = |ends: &[f64], cells: u64| strata(&Bounds::new(ends.len() / 2, ends).unwrap(), cells);
        assert_eq!(counts(&[0.0, 1.0, 0.0, 1.0], 100), [10, 10, 1]);
        assert_eq!(counts(&[0.0, 1.0, 0.0, 1.0, 0.0, 1e-6], 100), [10, 10, 1]);
        assert_eq!(counts(&[0.0, 1e9, 0.0, 1.0], 100), [100, 1, 1]);
        let [x, y, z] = counts(&[0.0, 4.0, 0.0, 2.0, 0.0, 1.0], 100_000);
        assert!((90_000..=100_000).contains(&(x * y * z)) && x > y && y > z, "{x} {y} {z}");
    }
}
