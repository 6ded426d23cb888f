//! The closed form at one pose, a cable per lane: structure matrix, products and tensions, all in registers.

use super::normal::{Normal, moved};
use crate::cable::wrench::wrench;
use crate::geometry::Twist;
use crate::model::{CableGroup, in_pattern};
use crate::scalar::{Kernel, LANES, Lanes};

/// Sizes of load and tensions (N, N·m) from which on the general code is needed.
const LARGEST: f64 = 1e100;

/// Tensions of a robot with at most eight cables and no fewer than degrees of freedom: the formulas of
/// [`super::solve_batch`], with one correction for rounding of the products.
pub(in crate::equilibrium) struct OnePose<'a> {
    pub(in crate::equilibrium) cables: &'a CableGroup,
    pub(in crate::equilibrium) basis: &'a [Twist],
    pub(in crate::equilibrium) position: [f64; 3],
    pub(in crate::equilibrium) rotation: &'a [[f64; 3]; 3],
    /// Load in the pattern's rows; the remaining entries are zero.
    pub(in crate::equilibrium) wrench: [f64; 6],
    /// Middle of each cable's limits (N); the remaining entries are zero.
    pub(in crate::equilibrium) middle: &'a [f64; LANES],
}

/// Tensions in closed form at one pose.
pub(in crate::equilibrium) struct ClosedFormTensions {
    /// Tension per cable (N).
    pub(in crate::equilibrium) tensions: [f64; LANES],
    /// Aᵀ f + w in the pattern's rows (N, N·m).
    pub(in crate::equilibrium) residual: [f64; 6],
    /// Sum of the amounts of its terms, row by row (N, N·m).
    pub(in crate::equilibrium) sizes: [f64; 6],
}

impl Kernel for OnePose<'_> {
    /// `None` if the general code is needed: a cable may have no path, rows may depend on each other, numbers may not
    /// be finite.
    type Output = Option<ClosedFormTensions>;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Option<ClosedFormTensions> {
        let (zero, middle) = (lanes.constant(0.0), lanes.load(self.middle));
        let (rows, needs_scalar) = self.rows(lanes);
        let residual = plus(self.wrench, over_cables(&rows, middle));
        let normal = Normal::of(products(&rows), self.basis.len());
        let mut change = move_along(zero, &rows, normal.solve(residual));
        let left = plus(residual, over_cables(&rows, change));
        change = move_along(change, &rows, normal.solve(left));
        let tensions = middle + change;
        let mut terms = [zero; 6];
        let mut amounts = [zero; 6];
        for k in 0..6 {
            terms[k] = rows[k] * tensions;
            amounts[k] = terms[k].abs();
        }
        let residual = plus(self.wrench, sums(&terms));
        let sizes = plus(self.wrench.map(f64::abs), sums(&amounts));
        let is_sure =
            normal.has_rank == 1.0 && !lanes.any(zero.is_less(needs_scalar)) && sizes.iter().sum::<f64>() < LARGEST;
        is_sure.then(|| ClosedFormTensions { tensions: tensions.to_array(), residual, sizes })
    }
}

impl OnePose<'_> {
    /// Rows of the structure matrix by cables, zeros for missing rows and cables; the second number is above 0 if a
    /// cable may have no path.
    #[inline(always)]
    fn rows<L: Lanes>(&self, lanes: L) -> ([L; 6], L) {
        let found = self.cables.checked_paths(lanes, self.position, self.rotation);
        let mut rows = in_pattern(self.basis, wrench(found.moment_arm, found.path.direction));
        let weight = lanes.load(&self.cables.weight);
        for k in 0..6 {
            rows[k] = rows[k] * weight;
        }
        (rows, found.needs_scalar)
    }
}

/// Sums over cables, one per row.
#[inline(always)]
fn sums<L: Lanes>(terms: &[L; 6]) -> [f64; 6] {
    let [a, b, c, d] = L::sums([terms[0], terms[1], terms[2], terms[3]]);
    let [e, f, _, _] = L::sums([terms[4], terms[5], terms[4], terms[5]]);
    [a, b, c, d, e, f]
}

/// Sums over cables of every row times a number per cable.
#[inline(always)]
fn over_cables<L: Lanes>(rows: &[L; 6], x: L) -> [f64; 6] {
    sums(&[rows[0] * x, rows[1] * x, rows[2] * x, rows[3] * x, rows[4] * x, rows[5] * x])
}

/// AᵀA on and below the diagonal.
#[inline(always)]
fn products<L: Lanes>(rows: &[L; 6]) -> [[f64; 6]; 6] {
    let [a, b, c, d, e, f] = *rows;
    let mut products = [[0.0; 6]; 6];
    for i in 0..6 {
        products[i][..4].copy_from_slice(&L::sums([rows[i] * a, rows[i] * b, rows[i] * c, rows[i] * d]));
    }
    [products[4][4], products[5][4], products[5][5], _] = L::sums([e * e, f * e, f * f, f * f]);
    products
}

#[inline]
fn plus(a: [f64; 6], b: [f64; 6]) -> [f64; 6] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3], a[4] + b[4], a[5] + b[5]]
}

/// f − A x.
#[inline(always)]
fn move_along<L: Lanes>(f: L, rows: &[L; 6], x: [f64; 6]) -> L {
    let mut factors = *rows;
    for k in 0..6 {
        factors[k] = f.constant(x[k]);
    }
    moved(f, *rows, factors)
}
