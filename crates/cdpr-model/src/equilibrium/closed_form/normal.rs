//! The products AᵀA of the rows of a structure matrix as L D Lᵀ, for one pose or for poses in lanes.

use crate::equilibrium::feasibility::factors::INDEPENDENT;
use crate::scalar::{Real, Select};

/// AᵀA = L D Lᵀ. Missing rows of smaller robots are zeros with 1 on the diagonal, so that all sizes are known to the
/// compiler.
pub(super) struct Normal<T> {
    /// L below the diagonal.
    lower: [[T; 6]; 6],
    /// 1/D.
    inverse: [T; 6],
    /// 1 if every row is clearly independent of those before it, 0 if rank may be lost.
    pub(super) has_rank: T,
}

impl<T: Select> Normal<T> {
    /// Factors of the products of n rows; only the products on and below the diagonal are read.
    #[inline(always)]
    pub(super) fn of(mut lower: [[T; 6]; 6], dof: usize) -> Self {
        let (zero, one) = (lower[0][0].constant(0.0), lower[0][0].constant(1.0));
        let mut squares = [one; 6];
        for k in 0..6 {
            if k < dof {
                squares[k] = lower[k][k];
            }
        }
        let (mut pivots, mut inverse) = (squares, [one; 6]);
        for k in 0..6 {
            inverse[k] = one / pivots[k];
            for i in k + 1..6 {
                let entry = lower[i][k] * inverse[k];
                pivots[i] = pivots[i] - entry * lower[i][k];
                for j in i + 1..6 {
                    lower[j][i] = lower[j][i] - entry * lower[j][k];
                }
                lower[i][k] = entry;
            }
        }
        let mut has_rank = one;
        for k in 0..6 {
            has_rank = has_rank.select((squares[k] * one.constant(INDEPENDENT)).is_less(pivots[k]), zero);
        }
        Self { lower, inverse, has_rank }
    }

    /// Solves AᵀA y = x: the combination of rows that corrects this residual of the balance.
    #[inline(always)]
    pub(super) fn solve(&self, mut x: [T; 6]) -> [T; 6] {
        for k in 0..6 {
            for i in k + 1..6 {
                x[i] = x[i] - self.lower[i][k] * x[k];
            }
        }
        for k in 0..6 {
            x[k] = x[k] * self.inverse[k];
        }
        for k in (0..6).rev() {
            for i in 0..k {
                x[i] = x[i] - self.lower[k][i] * x[k];
            }
        }
        x
    }
}

/// f − A x for one cable.
#[inline(always)]
pub(super) fn moved<T: Real>(f: T, column: [T; 6], x: [T; 6]) -> T {
    let first = column[0] * x[0] + column[1] * x[1];
    let middle = column[2] * x[2] + column[3] * x[3];
    let last = column[4] * x[4] + column[5] * x[5];
    f - ((first + middle) + last)
}
