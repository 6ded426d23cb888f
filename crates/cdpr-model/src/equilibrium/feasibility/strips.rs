//! Test whether strips have a common point, for eight poses at once.

use super::factors::{self, Rows, Solutions};
use crate::scalar::{LANES, Lanes};
use crate::tension::Limits;

/// Fraction of the largest tension below which a verdict is left to the single pose. It is much more than rounding, so
/// that nearly parallel rows of the null space may count as parallel.
const BAND: f64 = 1e-4;
/// The same fraction for sums of products that may be rounding only.
const ROUNDING: f64 = 1e-11;
/// Sum of determinants below which strips are parallel, or do not depend on λ at all: then smaller sets of strips
/// decide, which other determinants test. Such a change of the rows changes tensions by less than `BAND`.
const PARALLEL: f64 = 1e-11;
/// Tensions above this (N) are not calculated with.
const LARGEST: f64 = 1e100;

/// The limits as f_m ± ρ.
pub(super) struct Strips {
    dof: usize,
    cables: usize,
    /// ρ, half the width of each cable's limits (N).
    half: [f64; LANES],
    /// Largest limit by amount (N).
    scale: f64,
}

/// Largest excesses of all tests so far.
struct Margins<L> {
    /// Largest excess less the band: no tensions exist if it is above rounding.
    outside: L,
    /// Largest excess plus the band: tensions exist if it is below −rounding.
    inside: L,
    band: L,
}

impl<L: Lanes> Margins<L> {
    /// Adds one set of strips: the distance by which they miss a common point, the distance that their widths allow,
    /// and the sum of determinants.
    #[inline(always)]
    fn add(&mut self, missed: L, reach: L, size: L) {
        let excess = missed.abs() - reach;
        let band = self.band * size;
        self.outside = (excess - band).max(self.outside);
        let inside = (excess + band).max(self.inside);
        self.inside = self.inside.select(size.is_less(size.constant(PARALLEL)), inside);
    }
}

impl Strips {
    pub(super) fn new(limits: &Limits, dof: usize) -> Self {
        let mut half = [0.0; LANES];
        let ends = limits.minimum().iter().zip(limits.maximum());
        for (half, (least, largest)) in half.iter_mut().zip(ends) {
            *half = 0.5 * (largest - least);
        }
        let all = limits.minimum().iter().chain(limits.maximum());
        let scale = all.fold(0.0, |most: f64, limit| most.max(limit.abs()));
        Self { dof, cables: limits.cable_count(), half, scale }
    }

    /// 1 if tensions exist, −1 if none do, 0 if that is in doubt; `residual` is the residual of the load at the middle
    /// of the limits, and `needs_scalar` is above 0 if the rows are not valid.
    #[inline(always)]
    pub(super) fn verdicts<L: Lanes>(&self, lanes: L, rows: &mut Rows<L>, residual: [L; 6], needs_scalar: L) -> L {
        let (zero, one) = (lanes.constant(0.0), lanes.constant(1.0));
        let solutions = factors::solve(lanes, [self.dof, self.cables], rows, residual);
        let mut scale = lanes.constant(self.scale);
        for cable in 0..self.cables {
            scale = scale + solutions.minimum_norm[cable].abs();
        }
        let none = lanes.constant(f64::NEG_INFINITY);
        let mut margins = Margins { outside: none, inside: none, band: scale * lanes.constant(BAND) };
        let rounding = scale * lanes.constant(ROUNDING);
        // at most poses that have tensions the minimum-norm ones keep the limits
        let mut clear = none;
        for cable in 0..self.cables {
            clear = (solutions.minimum_norm[cable].abs() - lanes.constant(self.half[cable])).max(clear);
        }
        let clear = clear + margins.band;
        let is_open = lanes.any((-rounding).is_less(clear));
        match self.cables - self.dof {
            _ if !is_open => margins.inside = clear,
            0 => self.test_single(lanes, &solutions, &mut margins),
            1 => self.test_pairs(lanes, &solutions, &mut margins),
            _ => self.test_triples(rounding, &solutions, &mut margins),
        }
        let mut verdict = one.select(margins.inside.is_less(-rounding), zero);
        verdict = (-one).select(rounding.is_less(margins.outside), verdict);
        // NaN passes none of these tests
        verdict = verdict.select(zero.is_less(solutions.has_rank), zero);
        verdict = verdict.select(scale.is_less(lanes.constant(LARGEST)), zero);
        verdict.select(needs_scalar.is_less(one), zero)
    }

    #[inline(always)]
    fn test_single<L: Lanes>(&self, lanes: L, solutions: &Solutions<L>, margins: &mut Margins<L>) {
        for i in 0..self.cables {
            margins.add(solutions.minimum_norm[i], lanes.constant(self.half[i]), lanes.constant(1.0));
        }
    }

    #[inline(always)]
    fn test_pairs<L: Lanes>(&self, lanes: L, solutions: &Solutions<L>, margins: &mut Margins<L>) {
        let (f, h) = (&solutions.minimum_norm, &solutions.null_space[0]);
        for i in 0..self.cables {
            for j in i + 1..self.cables {
                let (h_i, h_j) = (h[i].abs(), h[j].abs());
                let reach = h_j * lanes.constant(self.half[i]) + h_i * lanes.constant(self.half[j]);
                margins.add(h[j] * f[i] - h[i] * f[j], reach, h_i + h_j);
            }
        }
    }

    #[inline(always)]
    fn test_triples<L: Lanes>(&self, rounding: L, solutions: &Solutions<L>, margins: &mut Margins<L>) {
        let (lanes, f) = (rounding, &solutions.minimum_norm);
        let [x, y] = &solutions.null_space;
        let mut determinants = [[lanes.constant(0.0); LANES]; LANES];
        for i in 0..self.cables {
            for j in i + 1..self.cables {
                determinants[i][j] = x[i] * y[j] - x[j] * y[i];
            }
        }
        for i in 0..self.cables {
            let half_i = lanes.constant(self.half[i]);
            for j in i + 1..self.cables {
                let (along, half_j) = (determinants[i][j], lanes.constant(self.half[j]));
                let along_size = along.abs();
                for k in j + 1..self.cables {
                    let (first, second) = (determinants[j][k], determinants[i][k]);
                    let (first_size, second_size) = (first.abs(), second.abs());
                    let half_k = lanes.constant(self.half[k]);
                    let reach = first_size * half_i + second_size * half_j + along_size * half_k;
                    let missed = first * f[i] - second * f[j] + along * f[k];
                    margins.add(missed, reach, first_size + second_size + along_size);
                }
            }
            // the remaining tests change nothing if none of the eight poses has tensions
            if !lanes.any(margins.outside.is_less(rounding)) {
                return;
            }
        }
    }
}
