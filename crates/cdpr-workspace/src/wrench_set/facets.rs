//! Hyperplane shifting: the facets of a zonotope from its generators.

use std::collections::HashSet;

/// A vector of up to six rows, filled up with zeros.
pub(super) type Rows = [f64; 6];

/// Fraction of a generator that may stick out of a hyperplane that contains it.
const FLAT: f64 = 1e-9;

/// The hyperplanes through the origin that are spanned by generators.
pub(super) struct Hyperplane {
    /// Unit normal.
    pub(super) normal: Rows,
    /// Bit i: generator i lies in the hyperplane.
    pub(super) contained: u64,
    /// Orthonormal vectors that span the hyperplane.
    pub(super) basis: [Rows; 6],
}

pub(super) fn dot(a: &Rows, b: &Rows) -> f64 {
    let mut sum = 0.0;
    for row in 0..6 {
        sum += a[row] * b[row];
    }
    sum
}

pub(super) fn norm(a: &Rows) -> f64 {
    dot(a, a).sqrt()
}

/// a + factor · b.
pub(super) fn moved(mut a: Rows, factor: f64, b: &Rows) -> Rows {
    for row in 0..6 {
        a[row] += factor * b[row];
    }
    a
}

/// Component of a vector orthogonal to orthonormal ones; computed twice, so that rounding does not accumulate.
pub(super) fn remainder(vector: &Rows, basis: &[Rows]) -> Rows {
    let mut rest = *vector;
    for _ in 0..2 {
        for unit in basis {
            rest = moved(rest, -dot(&rest, unit), unit);
        }
    }
    rest
}

/// All hyperplanes of `dimension`-space (its first rows) that contain dimension − 1 independent generators, each once.
///
/// Generators have the length 1 here and span the space.
pub(super) fn hyperplanes(units: &[Rows], dimension: usize) -> Vec<Hyperplane> {
    let mut search = Search { units, dimension, basis: [[0.0; 6]; 6], seen: HashSet::new(), found: Vec::new() };
    search.extend(0, 0);
    search.found
}

struct Search<'a> {
    units: &'a [Rows],
    dimension: usize,
    basis: [Rows; 6],
    seen: HashSet<u64>,
    found: Vec<Hyperplane>,
}

impl Search<'_> {
    /// Tries every further generator from index `first`, in addition to the `depth` generators that the basis spans.
    fn extend(&mut self, first: usize, depth: usize) {
        if depth + 1 >= self.dimension {
            return self.close(depth);
        }
        let last = self.units.len() + depth + 2 - self.dimension;
        for index in first..last.min(self.units.len()) {
            let rest = remainder(&self.units[index], &self.basis[..depth]);
            let length = norm(&rest);
            // dependent on earlier ones: any hyperplane through it is found without it
            if length > FLAT {
                self.basis[depth] = rest.map(|row| row / length);
                self.extend(index + 1, depth + 1);
            }
        }
    }

    fn close(&mut self, depth: usize) {
        let Some(normal) = self.normal(depth) else { return };
        let mut contained = 0;
        for (index, unit) in self.units.iter().enumerate() {
            if dot(&normal, unit).abs() <= FLAT {
                contained |= 1 << index;
            }
        }
        if self.seen.insert(contained) {
            self.found.push(Hyperplane { normal, contained, basis: self.basis });
        }
    }

    /// Unit normal to the basis: the orthogonal component of the axis that the basis covers least.
    fn normal(&self, depth: usize) -> Option<Rows> {
        let basis = &self.basis[..depth];
        let covered = |axis: usize| basis.iter().map(|unit| unit[axis] * unit[axis]).sum::<f64>();
        let axis = (0..self.dimension).min_by(|&a, &b| covered(a).total_cmp(&covered(b)))?;
        let mut unit = [0.0; 6];
        unit[axis] = 1.0;
        let rest = remainder(&unit, basis);
        let length = norm(&rest);
        (length > 0.0).then(|| rest.map(|row| row / length))
    }
}
