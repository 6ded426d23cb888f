//! The solutions of the balance at eight poses at once.
//!
//! The first column of a reflection is known to the compiler, so that a row stays in registers; the number of following
//! rows is the robot's. Columns without a cable are zeros and change nothing.

use crate::scalar::{LANES, Lanes};

/// Rows of a structure matrix by cables, at eight poses; zeros for missing rows.
pub(in crate::equilibrium) type Rows<L> = [[L; LANES]; 6];

/// f = f₀ + H λ solves Aᵀ f + w = 0.
pub(super) struct Solutions<L> {
    /// f₀, the minimum-norm solution, per cable (N).
    pub(super) minimum_norm: [L; LANES],
    /// H by columns, orthonormal; the last ones are zero if the redundancy is less than 2.
    pub(super) null_space: [[L; LANES]; 2],
    /// 1 if every row is clearly independent of those before it, 0 if rank may be lost.
    pub(super) has_rank: L,
}

/// Squared sine of the angle between a row and those before it, below which the pose is solved on its own.
pub(in crate::equilibrium) const INDEPENDENT: f64 = 1e-6;

/// Householder reflections of the first `dof` rows, which they overwrite.
struct Reflections<'a, L> {
    dof: usize,
    rows: &'a mut Rows<L>,
    /// 2/vᵀv of each.
    factors: [L; 6],
    /// The rows' lengths, squared.
    squares: [L; 6],
    /// Residual of the load in the rows not yet reached (N, N·m).
    residual: [L; 6],
    /// y of Rᵀ y = −residual; the remaining entries are zero.
    solution: [L; LANES],
    has_rank: L,
}

/// [`Solutions`] for these rows, which are overwritten; `residual` is w. Finds at most two directions of the null
/// space.
#[inline(always)]
pub(super) fn solve<L: Lanes>(
    lanes: L,
    [dof, cables]: [usize; 2],
    rows: &mut Rows<L>,
    residual: [L; 6],
) -> Solutions<L> {
    let (zero, one) = (lanes.constant(0.0), lanes.constant(1.0));
    let mut squares = [zero; 6];
    for row in 0..dof {
        squares[row] = product::<L, 0>(&rows[row], &rows[row]);
    }
    let (factors, solution) = ([zero; 6], [zero; LANES]);
    let mut reflections = Reflections { dof, rows, factors, squares, residual, solution, has_rank: one };
    reflections.find::<0>();
    reflections.find::<1>();
    reflections.find::<2>();
    reflections.find::<3>();
    reflections.find::<4>();
    reflections.find::<5>();
    let mut vectors = [reflections.solution, [zero; LANES], [zero; LANES]];
    let directions = (cables - dof).min(2);
    for direction in 0..directions {
        vectors[1 + direction][dof + direction] = one;
    }
    let found = &mut vectors[..=directions];
    reflections.apply::<5>(found);
    reflections.apply::<4>(found);
    reflections.apply::<3>(found);
    reflections.apply::<2>(found);
    reflections.apply::<1>(found);
    reflections.apply::<0>(found);
    let [minimum_norm, first, second] = vectors;
    Solutions { minimum_norm, null_space: [first, second], has_rank: reflections.has_rank }
}

impl<L: Lanes> Reflections<'_, L> {
    /// The reflection that zeroes row K beyond column K.
    #[inline(always)]
    fn find<const K: usize>(&mut self) {
        if K >= self.dof {
            return;
        }
        let mut v = self.rows[K];
        let (zero, one) = (v[K].constant(0.0), v[K].constant(1.0));
        let tail = product::<L, K>(&v, &v);
        let is_clear = (self.squares[K] * one.constant(INDEPENDENT)).is_less(tail);
        self.has_rank = self.has_rank.select(is_clear, zero);
        let length = tail.sqrt();
        let signed = (-length).select(v[K].is_less(zero), length);
        let head = v[K] + signed;
        v[K] = head;
        // both reciprocals from one division
        let factor = one / (signed * head);
        self.rows[K][K] = head;
        self.factors[K] = factor;
        // R has −signed on its diagonal
        let y = self.residual[K] * (factor * head);
        self.solution[K] = y;
        for row in K + 1..self.dof {
            let target = &mut self.rows[row];
            subtract::<L, K>(target, factor * product::<L, K>(&v, target), &v);
            self.residual[row] = self.residual[row] + target[K] * y;
        }
    }

    /// Applies the reflections to vectors; to be called from the last reflection to the first.
    #[inline(always)]
    fn apply<const K: usize>(&self, vectors: &mut [[L; LANES]]) {
        if K >= self.dof {
            return;
        }
        let (v, factor) = (self.rows[K], self.factors[K]);
        for x in vectors {
            subtract::<L, K>(x, factor * product::<L, K>(&v, x), &v);
        }
    }
}

/// Scalar product from column K on, summed in pairs of pairs: a short chain of additions.
#[inline(always)]
pub(in crate::equilibrium) fn product<L: Lanes, const K: usize>(a: &[L; LANES], b: &[L; LANES]) -> L {
    let mut pairs = [a[0]; LANES / 2];
    for (pair, sum) in pairs.iter_mut().enumerate() {
        let (first, second) = (2 * pair, 2 * pair + 1);
        if first >= K {
            *sum = a[first] * b[first] + a[second] * b[second];
        } else if second >= K {
            *sum = a[second] * b[second];
        }
    }
    let right = pairs[2] + pairs[3];
    match K {
        0 | 1 => (pairs[0] + pairs[1]) + right,
        2 | 3 => pairs[1] + right,
        _ => right,
    }
}

/// x ← x − along v from column K on.
#[inline(always)]
fn subtract<L: Lanes, const K: usize>(x: &mut [L; LANES], along: L, v: &[L; LANES]) {
    for column in K..LANES {
        x[column] = x[column] - along * v[column];
    }
}
