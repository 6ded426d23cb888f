//! The triangular factor R of tall matrices, computed from some rows at a time.

use nalgebra::DMatrix;

use super::{Kernel, LANES, Lanes, dispatch};

/// Number of rows that are added to the factor together: few enough that they stay in the fastest memory.
const ROWS: usize = 32;

/// Upper triangular R with RᵀR = JᵀJ for all rows J so far, by Householder reflections; the signs of its rows are
/// arbitrary.
#[derive(Clone, Debug)]
pub struct TriangularFactor {
    columns: usize,
    /// Row-major, rows rounded up to whole lanes; zeros below the diagonal.
    entries: Vec<[f64; LANES]>,
    /// Rows that are not yet part of the factor; the remaining rows are zeros.
    waiting: Vec<[f64; LANES]>,
    waiting_rows: usize,
}

impl TriangularFactor {
    /// A factor without rows.
    pub fn new(columns: usize) -> Self {
        let blocks = columns.div_ceil(LANES);
        let zeros = |rows: usize| vec![[0.0; LANES]; rows * blocks];
        Self { columns, entries: zeros(columns), waiting: zeros(ROWS), waiting_rows: 0 }
    }

    /// The factor of all rows of a matrix.
    pub fn of(matrix: &DMatrix<f64>) -> Self {
        let mut factor = Self::new(matrix.ncols());
        matrix.row_iter().for_each(|row| factor.push(row.iter().copied()));
        factor
    }

    /// Adds a row.
    pub fn push(&mut self, row: impl Iterator<Item = f64>) {
        let stride = self.columns.next_multiple_of(LANES);
        let own = &mut self.waiting.as_flattened_mut()[self.waiting_rows * stride..][..self.columns];
        own.iter_mut().zip(row).for_each(|(own, entry)| *own = entry);
        self.waiting_rows += 1;
        if self.waiting_rows == ROWS {
            self.join();
        }
    }

    /// Adds the rows of a diagonal matrix with entries other than zero.
    pub fn push_diagonal(&mut self, diagonal: impl Iterator<Item = f64>) {
        for (place, entry) in diagonal.enumerate().filter(|(_, entry)| *entry != 0.0) {
            self.push((0..self.columns).map(|column| if column == place { entry } else { 0.0 }));
        }
    }

    /// Returns R.
    pub fn into_matrix(mut self) -> DMatrix<f64> {
        self.join();
        let stride = self.columns.next_multiple_of(LANES);
        let entries = self.entries.as_flattened();
        DMatrix::from_fn(self.columns, self.columns, |row, column| entries[row * stride + column])
    }

    fn join(&mut self) {
        if self.waiting_rows > 0 {
            dispatch(Join { factor: self });
            self.waiting_rows = 0;
        }
    }
}

struct Join<'a> {
    factor: &'a mut TriangularFactor,
}

impl Kernel for Join<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        let TriangularFactor { columns, entries, waiting, waiting_rows } = self.factor;
        let blocks = columns.div_ceil(LANES);
        let joining = &mut waiting[..*waiting_rows * blocks];
        for column in 0..*columns {
            let own = &mut entries[column * blocks..][..blocks];
            if let Some(reflection) = Reflection::of(own, joining, column) {
                reflection.apply(l, own, joining, column / LANES);
                reflection.clear(own, joining, column);
            }
        }
    }
}

/// Householder reflection that moves a column of the added rows to the diagonal of the factor.
struct Reflection {
    /// Direction: the entry in the factor's row, then those in the added rows.
    head: f64,
    tail: [f64; ROWS],
    /// 2 divided by the squared length of the direction.
    scale: f64,
    diagonal: f64,
}

impl Reflection {
    /// `None` if the column of the added rows is zero.
    #[inline]
    fn of(own: &[[f64; LANES]], joining: &[[f64; LANES]], column: usize) -> Option<Self> {
        let (block, lane) = (column / LANES, column % LANES);
        let mut tail = [0.0; ROWS];
        for (entry, row) in tail.iter_mut().zip(joining.chunks_exact(own.len())) {
            *entry = row[block][lane];
        }
        let squares: f64 = tail.iter().map(|entry| entry * entry).sum();
        if squares == 0.0 {
            return None;
        }
        let before = own[block][lane];
        let diagonal = -(before * before + squares).sqrt().copysign(before);
        let head = before - diagonal;
        Some(Self { head, tail, scale: 2.0 / (head * head + squares), diagonal })
    }

    #[inline(always)]
    fn apply<L: Lanes>(&self, l: L, own: &mut [[f64; LANES]], joining: &mut [[f64; LANES]], first: usize) {
        let mut block = first;
        while block < own.len() {
            block += match own.len() - block {
                4.. => self.apply_to::<L, 4>(l, own, joining, block),
                2.. => self.apply_to::<L, 2>(l, own, joining, block),
                _ => self.apply_to::<L, 1>(l, own, joining, block),
            };
        }
    }

    /// Reflects several blocks of columns side by side, since each sum waits for its own earlier rows.
    #[inline(always)]
    fn apply_to<L: Lanes, const B: usize>(
        &self,
        l: L,
        own: &mut [[f64; LANES]],
        joining: &mut [[f64; LANES]],
        first: usize,
    ) -> usize {
        let (blocks, head) = (own.len(), l.constant(self.head));
        let mut sums = [l.constant(0.0); B];
        for b in 0..B {
            sums[b] = head * l.load(&own[first + b]);
        }
        for (row, entry) in joining.chunks_exact(blocks).zip(&self.tail) {
            let entry = l.constant(*entry);
            for b in 0..B {
                sums[b] = sums[b] + entry * l.load(&row[first + b]);
            }
        }
        for b in 0..B {
            sums[b] = sums[b] * l.constant(self.scale);
            (l.load(&own[first + b]) - head * sums[b]).store(&mut own[first + b]);
        }
        for (row, entry) in joining.chunks_exact_mut(blocks).zip(&self.tail) {
            let entry = l.constant(*entry);
            for b in 0..B {
                (l.load(&row[first + b]) - entry * sums[b]).store(&mut row[first + b]);
            }
        }
        B
    }

    /// Sets its own column to the exact result of the reflection, without rounding.
    #[inline]
    fn clear(&self, own: &mut [[f64; LANES]], joining: &mut [[f64; LANES]], column: usize) {
        let (block, lane) = (column / LANES, column % LANES);
        own[block][lane] = self.diagonal;
        for row in joining.chunks_exact_mut(own.len()) {
            row[block][lane] = 0.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// More and fewer rows than columns, columns that are zero or repeat others, whole lanes and parts of one: RᵀR =
    /// JᵀJ to rounding.
    #[test]
    fn the_factor_has_the_products_of_all_rows() {
        for (rows, columns) in [(1, 1), (3, 8), (40, 7), (64, 9), (100, 31), (150, 62)] {
            let mut matrix = DMatrix::from_fn(rows, columns, |i, j| ((3 * i + 5 * j * j + 1) as f64).sin());
            if columns > 6 {
                matrix.column_mut(4).fill(0.0);
                let first = matrix.column(0).into_owned();
                matrix.set_column(5, &first);
            }
            let mut factor = TriangularFactor::of(&matrix);
            factor.push_diagonal((0..columns).map(|column| (column % 3) as f64));
            let upper = factor.into_matrix();
            let more = DMatrix::from_fn(columns, columns, |i, j| if i == j { (i % 3 * (i % 3)) as f64 } else { 0.0 });
            let wanted = matrix.transpose() * &matrix + more;
            let error = (upper.transpose() * &upper - &wanted).amax() / wanted.amax();
            assert!(error < 1e-14 * rows as f64, "{rows} × {columns}: {error:e}");
            assert_eq!(upper.clone(), upper.upper_triangle(), "{rows} × {columns}");
        }
    }

    #[test]
    fn numbers_that_are_none_stay_visible() {
        let matrix = DMatrix::from_fn(5, 3, |i, j| if (i, j) == (2, 1) { f64::NAN } else { (i + j) as f64 });
        assert!(TriangularFactor::of(&matrix).into_matrix().iter().any(|entry| entry.is_nan()));
    }
}
