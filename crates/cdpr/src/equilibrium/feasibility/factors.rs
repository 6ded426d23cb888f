//! The solutions of the balance at eight poses at once.
//!
//! Numbers of rows and cables are those of the robot, not of the compiler: unrolled for each, the code would be fifty times as
//! much and not faster.

use crate::scalar::{LANES, Lanes};

/// Rows of a structure matrix by cables, at eight poses.
pub(in crate::equilibrium) type Rows<L> = [[L; LANES]; 6];

/// f = f₀ + H λ solves Aᵀ f + w = 0.
pub(in crate::equilibrium) struct Solutions<L> {
    /// f₀, the shortest solution, per cable (N).
    pub(in crate::equilibrium) shortest: [L; LANES],
    /// H by columns, orthonormal; the last ones are zero where redundancy is less than 2.
    pub(in crate::equilibrium) null_space: [[L; LANES]; 2],
    /// 1 where every row has a clear part beside those before it, 0 where rank may be lost.
    pub(in crate::equilibrium) has_rank: L,
}

/// Squared sine of the angle between a row and those before it, below which lanes do not trust the rank.
const INDEPENDENT: f64 = 1e-6;

/// Householder factors of the first `dof` rows, whose place they take; `rest` is w. Of the null space this many
/// directions are wanted, two at most.
#[inline(always)]
pub(in crate::equilibrium) fn solve<L: Lanes>(
    lanes: L,
    [dof, cables, directions]: [usize; 3],
    rows: &mut Rows<L>,
    mut rest: [L; 6],
) -> Solutions<L> {
    let (zero, one) = (lanes.constant(0.0), lanes.constant(1.0));
    let mut squares = [zero; 6];
    for row in 0..dof {
        squares[row] = product(&rows[row][..cables], &rows[row][..cables]);
    }
    let mut has_rank = one;
    let mut factors = [zero; 6];
    let mut shortest = [zero; LANES];
    for k in 0..dof {
        let (done, left) = rows[..dof].split_at_mut(k + 1);
        let v = &mut done[k][k..cables];
        let tail = product(v, v);
        has_rank = has_rank.select((squares[k] * lanes.constant(INDEPENDENT)).is_less(tail), zero);
        let length = tail.sqrt();
        let signed = (-length).select(v[0].is_less(zero), length);
        let head = v[0] + signed;
        v[0] = head;
        // both reciprocals of one division
        let factor = one / (signed * head);
        factors[k] = factor;
        // R has −signed on its diagonal, and Rᵀ y = −rest
        let y = rest[k] * (factor * head);
        shortest[k] = y;
        for (row, rest) in left.iter_mut().zip(&mut rest[k + 1..]) {
            let row = &mut row[k..cables];
            subtract(row, factor * product(v, row), v);
            *rest = *rest + row[0] * y;
        }
    }
    let mut null_space = [[zero; LANES]; 2];
    for (column, entries) in null_space.iter_mut().enumerate().take((cables - dof).min(directions)) {
        entries[dof + column] = one;
    }
    for k in (0..dof).rev() {
        let v = &rows[k][k..cables];
        let x = &mut shortest[k..cables];
        subtract(x, factors[k] * product(v, x), v);
        for x in &mut null_space[..directions] {
            let x = &mut x[k..cables];
            subtract(x, factors[k] * product(v, x), v);
        }
    }
    Solutions { shortest, null_space, has_rank }
}

#[inline(always)]
fn product<L: Lanes>(a: &[L], b: &[L]) -> L {
    let mut sum = a[0] * b[0];
    for (a, b) in a[1..].iter().zip(&b[1..]) {
        sum = sum + *a * *b;
    }
    sum
}

/// x ← x − along v
#[inline(always)]
fn subtract<L: Lanes>(x: &mut [L], along: L, v: &[L]) {
    for (x, v) in x.iter_mut().zip(v) {
        *x = *x - along * *v;
    }
}
