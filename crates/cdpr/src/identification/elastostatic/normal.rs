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
        let rows = &self.rows.entries;
        // four rows of the sum at a time, so that each load of a row of J serves four products
        for first in (0..stride).step_by(4) {
            for block in (0..first + 4).step_by(LANES) {
                let at = |k: usize| (first + k) * stride + block;
                let mut sums = [
                    l.load(&self.sums[at(0)..]),
                    l.load(&self.sums[at(1)..]),
                    l.load(&self.sums[at(2)..]),
                    l.load(&self.sums[at(3)..]),
                ];
                for row in 0..count {
                    let values = l.load(&rows[row * stride + block..]);
                    let factors = &rows[row * stride + first..][..4];
                    for k in 0..4 {
                        sums[k] = sums[k] + l.constant(factors[k]) * values;
                    }
                }
                for k in 0..4 {
                    sums[k].store(&mut self.sums[at(k)..]);
                }
            }
        }
    }
}

/// Forward substitution with the lower factor, one block of columns at a time.
#[inline(always)]
fn substitute<L: Lanes>(l: L, factor: &[f64], rows: &mut SampleRows) {
    let (count, stride) = (rows.count, rows.stride);
    for block in (0..stride).step_by(LANES) {
        for row in 0..count {
            let mut value = l.load(&rows.entries[row * stride + block..]);
            for k in 0..row {
                value = value - l.constant(factor[row * count + k]) * l.load(&rows.entries[k * stride + block..]);
            }
            (value * l.constant(factor[row * count + row])).store(&mut rows.entries[row * stride + block..]);
        }
    }
}
