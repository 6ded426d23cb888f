//! Whitened rows and the normal equations they add up to, parameters in lanes.

use super::rows::SampleRows;
use crate::scalar::{Kernel, LANES, Lanes, dispatch};

/// Σ \[J r\]ᵀ Σ⁻¹ \[J r\] over samples: JᵀWJ, JᵀWr and rᵀWr in one symmetric matrix, lower triangle.
#[derive(Clone, Debug)]
pub(super) struct NormalEquations {
    parameter_count: usize,
    stride: usize,
    entries: Vec<f64>,
}

impl NormalEquations {
    pub(super) fn new(rows: &SampleRows) -> Self {
        let stride = rows.stride;
        Self { parameter_count: rows.parameter_count, stride, entries: vec![0.0; stride * stride] }
    }

    pub(super) fn clear(&mut self) {
        self.entries.fill(0.0);
    }

    /// Weighted sum of squares.
    pub(super) fn cost(&self) -> f64 {
        self.entries[self.parameter_count * self.stride + self.parameter_count]
    }

    pub(super) fn add_to_cost(&mut self, amount: f64) {
        self.entries[self.parameter_count * self.stride + self.parameter_count] += amount;
    }

    /// JᵀWr of one parameter.
    pub(super) fn gradient(&self, k: usize) -> f64 {
        self.entries[self.parameter_count * self.stride + k]
    }

    pub(super) fn add_to_gradient(&mut self, k: usize, amount: f64) {
        self.entries[self.parameter_count * self.stride + k] += amount;
    }

    /// JᵀWJ of two parameters.
    pub(super) fn entry(&self, i: usize, j: usize) -> f64 {
        self.entries[i.max(j) * self.stride + i.min(j)]
    }

    pub(super) fn add_to_diagonal(&mut self, k: usize, amount: f64) {
        self.entries[k * self.stride + k] += amount;
    }

    /// Adds the rows of one sample, which are whitened in place.
    pub(super) fn add(&mut self, factor: &[f64], rows: &mut SampleRows) {
        dispatch(AddSample { factor, rows, sums: &mut self.entries });
    }
}

/// Whitens the rows of a sample in place: solves L X = \[J r\].
pub(super) fn whiten(factor: &[f64], rows: &mut SampleRows) {
    dispatch(Whiten { factor, rows });
}

struct Whiten<'a> {
    factor: &'a [f64],
    rows: &'a mut SampleRows,
}

impl Kernel for Whiten<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        substitute(l, self.factor, self.rows);
    }
}

struct AddSample<'a> {
    factor: &'a [f64],
    rows: &'a mut SampleRows,
    sums: &'a mut [f64],
}

impl Kernel for AddSample<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        substitute(l, self.factor, self.rows);
        let (count, stride) = (self.rows.count, self.rows.stride);
        let blocks = stride / LANES;
        let (rows, _) = self.rows.entries.as_chunks::<LANES>();
        let (sums, _) = self.sums.as_chunks_mut::<LANES>();
        let (rows, sums) = (&rows[..count * blocks], &mut sums[..stride * blocks]);
        // eight rows of the sum at a time, so that each load of a row of J serves eight products
        for first in 0..blocks {
            for block in 0..=first {
                let zero = l.constant(0.0);
                let mut tile = [zero; LANES];
                for row in 0..count {
                    let values = l.load(&rows[row * blocks + block]);
                    let factors = &rows[row * blocks + first];
                    for k in 0..LANES {
                        tile[k] = tile[k] + l.constant(factors[k]) * values;
                    }
                }
                for k in 0..LANES {
                    let sum = &mut sums[(first * LANES + k) * blocks + block];
                    (l.load(sum) + tile[k]).store(sum);
                }
            }
        }
    }
}

/// Columns whose substitution runs side by side: each waits for its own earlier rows.
const SIDE_BY_SIDE: usize = 4;

/// Forward substitution with the lower factor, some blocks of columns side by side.
#[inline(always)]
fn substitute<L: Lanes>(l: L, factor: &[f64], rows: &mut SampleRows) {
    let (count, blocks) = (rows.count, rows.stride / LANES);
    let (entries, _) = rows.entries.as_chunks_mut::<LANES>();
    let entries = &mut entries[..count * blocks];
    let mut block = 0;
    while block < blocks {
        match blocks - block {
            SIDE_BY_SIDE.. => substitute_blocks::<L, SIDE_BY_SIDE>(l, factor, entries, count, blocks, block),
            2.. => substitute_blocks::<L, 2>(l, factor, entries, count, blocks, block),
            _ => substitute_blocks::<L, 1>(l, factor, entries, count, blocks, block),
        }
        block += match blocks - block {
            SIDE_BY_SIDE.. => SIDE_BY_SIDE,
            2.. => 2,
            _ => 1,
        };
    }
}

#[inline(always)]
fn substitute_blocks<L: Lanes, const B: usize>(
    l: L,
    factor: &[f64],
    entries: &mut [[f64; LANES]],
    count: usize,
    blocks: usize,
    first: usize,
) {
    for row in 0..count {
        let own = &factor[row * count..][..count];
        let mut values = [l.constant(0.0); B];
        for b in 0..B {
            values[b] = l.load(&entries[row * blocks + first + b]);
        }
        for k in 0..row {
            let weight = l.constant(own[k]);
            for b in 0..B {
                values[b] = values[b] - weight * l.load(&entries[k * blocks + first + b]);
            }
        }
        let inverse = l.constant(own[row]);
        for b in 0..B {
            (values[b] * inverse).store(&mut entries[row * blocks + first + b]);
        }
    }
}
