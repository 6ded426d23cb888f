//! The balance of robots with up to eight cables and full rank, in the registers of one vector unit.
//!
//! The same Householder factors as in [`super::balance`], for a number of rows known to the compiler.

use super::block::{Block, KEEP, UNIT};
use crate::scalar::{Kernel, LANES, Lanes};
use crate::tension::limits::LARGEST;

/// Remaining length of a row (rows have length 1) below which it depends on the rows before it: the rank is lost.
pub(super) const LOST: f64 = 1e-12;
/// Remaining length above which the rank is certain without a search for the best order of the rows.
pub(super) const CERTAIN: f64 = 1e-5;

/// The factors and solutions of one problem with N rows, in the same places as those of the general code.
pub(super) struct Solutions<'a, const N: usize> {
    /// N × m, by columns.
    pub(super) structure_matrix: &'a [f64],
    pub(super) wrench: &'a [f64],
    /// N entries each.
    pub(super) row_scales: &'a mut [f64],
    pub(super) factors: &'a mut [f64],
    pub(super) reflectors: &'a mut [Block],
    /// R by columns of N entries, with the reciprocal on the diagonal.
    pub(super) triangle: &'a mut [f64],
    /// The null space, and after it the particular solution.
    pub(super) solutions: &'a mut [Block],
}

impl<const N: usize> Kernel for Solutions<'_, N> {
    /// False if the general code is needed: lost rank, or numbers that are not finite.
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> bool {
        let Some((mut rows, scales)) = self.rows(lanes) else { return false };
        let mut reflectors = [lanes.constant(0.0); N];
        let mut factors = [0.0; N];
        // w, then its residual after the columns of R
        let mut residual = [0.0; N];
        let mut y = [0.0; LANES];
        let mut size = 0.0;
        for j in 0..N {
            residual[j] = self.wrench[j] * scales[j];
            size += residual[j].abs();
        }
        if !(size < LARGEST) {
            return false;
        }
        for k in 0..N {
            let tail = rows[k] * lanes.load(&KEEP[k]);
            let products = products(lanes, tail, &rows, k);
            let square = products[k];
            let length = square.sqrt();
            if !(length > CERTAIN) {
                return false;
            }
            let head = rows[k].to_array()[k];
            let signed = length.copysign(head);
            let factor = 1.0 / (square + length * head.abs());
            let v = tail + lanes.load(&UNIT[k]) * lanes.constant(signed);
            let reciprocal = -1.0 / signed;
            y[k] = -residual[k] * reciprocal;
            for j in k + 1..N {
                let along = factor * (products[j] + signed * rows[j].to_array()[k]);
                rows[j] = rows[j] - lanes.constant(along) * v;
                let entry = rows[j].to_array()[k];
                residual[j] += entry * y[k];
                self.triangle[j * N + k] = entry;
            }
            self.triangle[k * N + k] = reciprocal;
            factors[k] = factor;
            reflectors[k] = v;
        }
        let cable_count = self.structure_matrix.len() / N;
        for first in (0..=cable_count - N).step_by(4) {
            let count = 4.min(cable_count - N + 1 - first);
            let mut four = [lanes.constant(0.0); 4];
            for place in 0..count {
                let column = N + first + place;
                four[place] = if column < cable_count { lanes.load(&UNIT[column]) } else { lanes.load(&y) };
            }
            for k in (0..N).rev() {
                let v = reflectors[k];
                let sums = L::sums([v * four[0], v * four[1], v * four[2], v * four[3]]);
                for place in 0..4 {
                    four[place] = four[place] - lanes.constant(factors[k] * sums[place]) * v;
                }
            }
            for place in 0..count {
                four[place].store(&mut self.solutions[first + place]);
            }
        }
        for k in 0..N {
            self.factors[k] = factors[k];
            self.row_scales[k] = scales[k];
            reflectors[k].store(&mut self.reflectors[k]);
        }
        true
    }
}

impl<const N: usize> Solutions<'_, N> {
    /// The rows scaled to length 1, and their scale factors; `None` if a row is too short or not finite.
    #[inline(always)]
    fn rows<L: Lanes>(&self, lanes: L) -> Option<([L; N], [f64; LANES])> {
        let mut transposed = [[0.0; LANES]; N];
        for (cable, entries) in self.structure_matrix.chunks_exact(N).take(LANES).enumerate() {
            for j in 0..N {
                transposed[j][cable] = entries[j];
            }
        }
        let mut rows = [lanes.constant(0.0); N];
        for j in 0..N {
            rows[j] = lanes.load(&transposed[j]);
        }
        let mut squares = [0.0; LANES];
        for first in (0..N).step_by(4) {
            let mut four = [lanes.constant(0.0); 4];
            for place in 0..4.min(N - first) {
                four[place] = rows[first + place] * rows[first + place];
            }
            squares[first..first + 4].copy_from_slice(&L::sums(four));
        }
        let mut largest = 0.0;
        let mut smallest = f64::INFINITY;
        for j in 0..N {
            largest = if squares[j] > largest { squares[j] } else { largest };
            smallest = if squares[j] > smallest { smallest } else { squares[j] };
        }
        // NaN fails this as well
        if !(smallest > LOST * LOST * largest && largest < f64::INFINITY) {
            return None;
        }
        let scales = (lanes.constant(1.0) / lanes.load(&squares).sqrt()).to_array();
        for j in 0..N {
            rows[j] = rows[j] * lanes.constant(scales[j]);
        }
        Some((rows, scales))
    }
}

/// The combination y of N rows with A y = c, from their factors: the same as
/// [`super::balance::Balance::write_combination`] computes.
pub(super) struct Combination<'a, const N: usize> {
    /// c, one entry per cable.
    pub(super) cables: &'a Block,
    pub(super) row_scales: &'a [f64],
    pub(super) factors: &'a [f64],
    pub(super) reflectors: &'a [Block],
    pub(super) triangle: &'a [f64],
    /// N entries.
    pub(super) y: &'a mut [f64],
}

impl<const N: usize> Kernel for Combination<'_, N> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let (triangle, reflectors) = (&self.triangle[..N * N], &self.reflectors[..N]);
        let mut residual = lanes.load(self.cables);
        for k in 0..N {
            let v = lanes.load(&reflectors[k]);
            residual = residual - lanes.constant(self.factors[k] * (v * residual).sum()) * v;
        }
        let mut y = residual.to_array();
        for place in (0..N).rev() {
            y[place] *= triangle[place * N + place];
            for before in 0..place {
                y[before] -= triangle[place * N + before] * y[place];
            }
        }
        for row in 0..N {
            self.y[row] = y[row] * self.row_scales[row];
        }
    }
}

/// Products of a vector with the rows from `from` on.
#[inline(always)]
fn products<L: Lanes, const N: usize>(lanes: L, vector: L, rows: &[L; N], from: usize) -> [f64; LANES] {
    let mut products = [0.0; LANES];
    for first in (0..N).step_by(4) {
        if first + 4 <= from {
            continue;
        }
        let mut four = [lanes.constant(0.0); 4];
        for place in 0..4.min(N - first) {
            four[place] = rows[first + place] * vector;
        }
        products[first..first + 4].copy_from_slice(&L::sums(four));
    }
    products
}
