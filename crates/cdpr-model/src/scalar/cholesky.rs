//! Factors of symmetric positive definite matrices of any size, rows in lanes.

use super::{Kernel, LANES, Lanes, Line, dispatch};

/// Number of columns that are computed side by side.
const PANEL: usize = 4;

/// Lower triangle of a symmetric matrix by columns, after factorization its Cholesky factor L with the inverse of its
/// diagonal.
#[derive(Clone, Debug)]
pub struct LowerTriangle {
    count: usize,
    /// Column by column, with rows rounded up to whole lanes; entries above the diagonal are arbitrary.
    lines: Vec<Line>,
}

impl LowerTriangle {
    /// A matrix of zeros.
    pub fn new(count: usize) -> Self {
        Self { count, lines: vec![Line::default(); count * count.div_ceil(LANES)] }
    }

    /// Number of lines per column.
    pub fn groups(&self) -> usize {
        self.count.div_ceil(LANES)
    }

    pub(crate) fn get(&self, row: usize, column: usize) -> f64 {
        self.lines[column * self.groups() + row / LANES].0[row % LANES]
    }

    /// Sets every entry to that of a symmetric matrix: `columns` gives for a column the function from row to entry.
    #[inline]
    pub fn fill<C: Fn(usize) -> f64>(&mut self, columns: impl Fn(usize) -> C) {
        let (count, groups) = (self.count, self.groups());
        for (column, lines) in self.lines.chunks_exact_mut(groups).enumerate() {
            let (block, entry) = (column / LANES, columns(column));
            for (first, line) in (block * LANES..).step_by(LANES).zip(&mut lines[block..]) {
                for (row, number) in (first..count).zip(&mut line.0) {
                    *number = entry(row);
                }
            }
        }
    }

    /// All lines, column by column, for kernels.
    pub fn lines_mut(&mut self) -> &mut [Line] {
        &mut self.lines
    }

    /// Replaces the matrix by its factor; `None` if it is not positive definite.
    pub fn factorize(&mut self) -> Option<()> {
        dispatch(Factorize { triangle: self }).then_some(())
    }

    /// Smallest entry on the diagonal of the factor.
    pub fn smallest(&self) -> f64 {
        1.0 / (0..self.count).map(|k| self.get(k, k)).fold(0.0, f64::max)
    }

    /// Solves L Lᵀ x = right in place.
    pub fn solve(&self, right: &mut [f64]) {
        let mut lines = vec![Line::default(); self.groups()];
        for (line, right) in lines.iter_mut().zip(right.chunks(LANES)) {
            line.0[..right.len()].copy_from_slice(right);
        }
        dispatch(Solve { triangle: self, right: &mut lines });
        for (line, right) in lines.iter().zip(right.chunks_mut(LANES)) {
            right.copy_from_slice(&line.0[..right.len()]);
        }
    }
}

struct Factorize<'a> {
    triangle: &'a mut LowerTriangle,
}

impl Kernel for Factorize<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> bool {
        factorize(l, self.triangle.count, &mut self.triangle.lines)
    }
}

struct Solve<'a> {
    triangle: &'a LowerTriangle,
    right: &'a mut [Line],
}

impl Kernel for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        let Self { triangle, right } = self;
        let groups = right.len();
        let columns = || triangle.lines.chunks_exact(groups).enumerate();
        for (column, lines) in columns() {
            let (block, lane) = (column / LANES, column % LANES);
            let own = right[block].0[lane] * lines[block].0[lane];
            right[block].0[lane] = own;
            for below in lane + 1..LANES {
                right[block].0[below] -= own * lines[block].0[below];
            }
            for group in block + 1..groups {
                let rest = l.load(&right[group].0) - l.constant(own) * l.load(&lines[group].0);
                rest.store(&mut right[group].0);
            }
        }
        for (column, lines) in columns().rev() {
            let (block, lane) = (column / LANES, column % LANES);
            let mut sum = l.constant(0.0);
            for group in block + 1..groups {
                sum = sum + l.load(&right[group].0) * l.load(&lines[group].0);
            }
            let mut rest = right[block].0[lane] - sum.sum();
            for below in lane + 1..LANES {
                rest -= right[block].0[below] * lines[block].0[below];
            }
            right[block].0[lane] = rest * lines[block].0[lane];
        }
    }
}

/// [`LowerTriangle::factorize`] within a kernel, for the lines of a triangle with `count` columns. False if it is not
/// positive definite.
#[inline(always)]
pub fn factorize<L: Lanes>(l: L, count: usize, lines: &mut [Line]) -> bool {
    let groups = count.div_ceil(LANES);
    for first in (0..count).step_by(PANEL) {
        let width = PANEL.min(count - first);
        subtract_before(l, (first, width, groups), lines);
        for column in first..first + width {
            let (before, others) = lines.split_at_mut((column + 1) * groups);
            let own = &mut before[column * groups..];
            let pivot = own[column / LANES].0[column % LANES];
            // written so that NaN is refused too
            if !(pivot > 0.0 && pivot < f64::INFINITY) {
                return false;
            }
            let inverse = 1.0 / pivot.sqrt();
            for line in &mut own[column / LANES..] {
                (l.load(&line.0) * l.constant(inverse)).store(&mut line.0);
            }
            own[column / LANES].0[column % LANES] = inverse;
            for (other, target) in (column + 1..first + width).zip(others.chunks_exact_mut(groups)) {
                let factor = l.constant(own[other / LANES].0[other % LANES]);
                for group in other / LANES..groups {
                    let product = factor * l.load(&own[group].0);
                    (l.load(&target[group].0) - product).store(&mut target[group].0);
                }
            }
        }
    }
    true
}

/// Subtracts the products of all columns before a panel from the panel.
#[inline(always)]
fn subtract_before<L: Lanes>(l: L, (first, width, groups): (usize, usize, usize), lines: &mut [Line]) {
    let (before, panel) = lines.split_at_mut(first * groups);
    let block = first / LANES;
    for group in block..groups {
        let mut sums = [l.constant(0.0); PANEL];
        for column in before.chunks_exact(groups) {
            let (factors, own) = (&column[block].0[first % LANES..][..PANEL], l.load(&column[group].0));
            for k in 0..PANEL {
                sums[k] = sums[k] + l.constant(factors[k]) * own;
            }
        }
        for k in 0..width {
            let target = &mut panel[k * groups + group].0;
            (l.load(target) - sums[k]).store(target);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Cholesky, DMatrix, DVector};

    /// Whole lanes and parts of one, whole panels and parts of one: the solution equals that of nalgebra to rounding,
    /// and indefinite matrices have none.
    #[test]
    fn the_factor_solves_as_another_one_does() {
        for count in [1, 3, 4, 6, 8, 14, 24, 31, 62] {
            let root = &DMatrix::from_fn(count, count, |i, j| ((3 * i + 5 * j * j + 1) as f64).sin());
            let matrix = &(root * root.transpose() + DMatrix::identity(count, count));
            let mut triangle = LowerTriangle::new(count);
            triangle.fill(|j| move |i| matrix[(i, j)]);
            triangle.factorize().unwrap();
            let other = Cholesky::new(matrix.clone()).unwrap();
            let right = DVector::from_fn(count, |k, _| (k as f64).cos());
            let (mut found, expected) = (right.clone(), other.solve(&right));
            triangle.solve(found.as_mut_slice());
            assert!((&found - &expected).amax() < 1e-11 * expected.amax(), "{count}");
            assert!((triangle.smallest() / other.l().diagonal().min() - 1.0).abs() < 1e-11, "{count}");
            for bad in [f64::NAN, -1e3] {
                let last = count - 1;
                triangle.fill(|j| move |i| if (i, j) == (last, last) { bad } else { matrix[(i, j)] });
                assert!(triangle.factorize().is_none(), "{count}");
            }
        }
    }
}
