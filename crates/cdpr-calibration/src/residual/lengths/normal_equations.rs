//! Normal equations of one cable, and the sums over samples that make them.

use cdpr_model::scalar::Lanes;

/// Columns of a Jacobian, sample by sample.
pub(crate) type Columns = Vec<Vec<f64>>;

/// Sizes up to this are the number of parameters, known to the compiler; larger ones are room for as many at most.
const EXACT: usize = 8;

/// Number of parameters where there is room for P: P itself where that is exact.
#[inline]
pub(crate) fn exact<const P: usize>(count: usize) -> usize {
    if P <= EXACT { P } else { count }
}

/// JᵀWJ (lower triangle), JᵀWρ and ρᵀWρ of the parameters of one block, with room for P of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NormalEquations<const P: usize> {
    /// Number of parameters.
    pub(crate) count: usize,
    pub(crate) cost: f64,
    pub(crate) gradient: [f64; P],
    pub(crate) matrix: [[f64; P]; P],
}

impl<const P: usize> NormalEquations<P> {
    /// Of no rows, so that any cost is less.
    pub(crate) fn empty(count: usize) -> Self {
        Self { count, cost: f64::INFINITY, gradient: [0.0; P], matrix: [[0.0; P]; P] }
    }

    /// Of weighted residuals and columns, padding included.
    pub(crate) fn of_columns(residuals: &[f64], columns: &Columns) -> Self {
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let count = columns.len();
        let mut sums = Self { count, cost: product(residuals, residuals), gradient: [0.0; P], matrix: [[0.0; P]; P] };
        for i in 0..count {
            sums.gradient[i] = product(&columns[i], residuals);
            for j in 0..=i {
                sums.matrix[i][j] = product(&columns[i], &columns[j]);
            }
        }
        sums
    }
}

/// Sums in lanes.
pub(crate) struct Sums<L, const P: usize> {
    count: usize,
    cost: L,
    gradient: [L; P],
    matrix: [[L; P]; P],
}

impl<L: Lanes, const P: usize> Sums<L, P> {
    #[inline(always)]
    pub(crate) fn new(l: L, count: usize) -> Self {
        let zero = l.constant(0.0);
        Self { count, cost: zero, gradient: [zero; P], matrix: [[zero; P]; P] }
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, residual: L, entries: &[L; P]) {
        self.cost = self.cost + residual * residual;
        for i in 0..exact::<P>(self.count) {
            self.gradient[i] = self.gradient[i] + entries[i] * residual;
            for j in 0..=i {
                self.matrix[i][j] = self.matrix[i][j] + entries[i] * entries[j];
            }
        }
    }

    #[inline(always)]
    pub(crate) fn total(self) -> NormalEquations<P> {
        let count = exact::<P>(self.count);
        let mut sums = NormalEquations { count, cost: self.cost.sum(), gradient: [0.0; P], matrix: [[0.0; P]; P] };
        for i in 0..count {
            sums.gradient[i] = self.gradient[i].sum();
            for j in 0..=i {
                sums.matrix[i][j] = self.matrix[i][j].sum();
            }
        }
        sums
    }
}
