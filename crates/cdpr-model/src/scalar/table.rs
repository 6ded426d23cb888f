//! Numbers of many items, eight items side by side, so that a vector register loads the same number of eight items at
//! once.

use super::line::Line;
use super::transposed::{FromItems, ToItems};
use super::{LANES, dispatch};

/// A table with the same rows for every item (mostly a pose), with the items in groups of eight.
///
/// ```
/// use cdpr::scalar::LaneTable;
///
/// let mut lengths = LaneTable::new(2);
/// lengths.resize(3);
/// lengths.write(1, &[4.0, 5.0]);
/// assert_eq!(lengths.get(0, 1), 4.0);
/// assert_eq!(lengths.row(1).collect::<Vec<_>>(), [0.0, 5.0, 0.0]);
/// ```
#[derive(Clone, Debug, Default)]
pub struct LaneTable {
    rows: usize,
    len: usize,
    /// Lines row by row within a group, group by group.
    lines: Vec<Line>,
}

/// Tables are equal if they have equal numbers for equal items; padding of the last group is not compared.
impl PartialEq for LaneTable {
    fn eq(&self, other: &Self) -> bool {
        let same_size = (self.rows, self.len) == (other.rows, other.len);
        same_size && (0..self.rows).all(|row| self.row(row).eq(other.row(row)))
    }
}

impl LaneTable {
    /// A table of this many rows without items.
    pub fn new(rows: usize) -> Self {
        Self { rows, len: 0, lines: Vec::new() }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of items.
    pub fn len(&self) -> usize {
        self.len
    }

    /// True if there are no items.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Changes the number of items; new ones are zeros. Memory that was claimed before is kept.
    pub fn resize(&mut self, len: usize) {
        self.lines.resize(len.div_ceil(LANES) * self.rows, Line::default());
        self.len = len;
    }

    /// Changes the numbers of rows and of items; the numbers in the table are then arbitrary.
    pub fn reshape(&mut self, rows: usize, len: usize) {
        self.rows = rows;
        self.resize(len);
    }

    /// One number; panics if there is no such row or item.
    pub fn get(&self, row: usize, item: usize) -> f64 {
        self.line(row, item).0[item % LANES]
    }

    /// All numbers of one row, item by item; panics if there is no such row.
    pub fn row(&self, row: usize) -> impl Iterator<Item = f64> + '_ {
        (0..self.len).map(move |item| self.get(row, item))
    }

    /// Copies the numbers of one item to `numbers`; panics unless it has one place per row, or if there is no such
    /// item.
    pub fn read(&self, item: usize, numbers: &mut [f64]) {
        assert_eq!(numbers.len(), self.rows, "one place per row");
        for (row, number) in numbers.iter_mut().enumerate() {
            *number = self.get(row, item);
        }
    }

    /// Sets the numbers of one item; panics unless there is one per row, or if there is no such item.
    pub fn write(&mut self, item: usize, numbers: &[f64]) {
        assert_eq!(numbers.len(), self.rows, "one number per row");
        assert!(item < self.len, "item {item} of {}", self.len);
        let lines = &mut self.lines[item / LANES * self.rows..];
        for (line, number) in lines.iter_mut().zip(numbers) {
            line.0[item % LANES] = *number;
        }
    }

    /// Takes the numbers of an array, item by item with one number per row each; memory that was claimed once is kept.
    ///
    /// Panics unless whole items are given.
    ///
    /// ```
    /// use cdpr::scalar::LaneTable;
    ///
    /// let mut table = LaneTable::new(2);
    /// table.fill_rows(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    /// assert_eq!((table.len(), table.get(1, 2)), (3, 6.0));
    /// let mut numbers = [0.0; 6];
    /// table.read_rows(&mut numbers);
    /// assert_eq!(numbers, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    /// ```
    pub fn fill_rows(&mut self, numbers: &[f64]) {
        let rows = self.rows.max(1);
        assert!(numbers.len().is_multiple_of(rows), "{} numbers in items of {}", numbers.len(), self.rows);
        self.resize(numbers.len() / rows);
        dispatch(FromItems { numbers, rows, lines: &mut self.lines });
    }

    /// Writes all numbers into an array, item by item with one number per row each; panics unless it has room for as many.
    pub fn read_rows(&self, numbers: &mut [f64]) {
        assert_eq!(numbers.len(), self.len * self.rows, "{} items of {} numbers", self.len, self.rows);
        dispatch(ToItems { lines: &self.lines, rows: self.rows.max(1), numbers });
    }

    fn line(&self, row: usize, item: usize) -> &Line {
        assert!(row < self.rows && item < self.len, "row {row} of {}, item {item} of {}", self.rows, self.len);
        &self.lines[item / LANES * self.rows + row]
    }

    /// Number of groups of eight items; the last one may be partly filled.
    pub fn groups(&self) -> usize {
        self.len.div_ceil(LANES)
    }

    /// The rows of one group of eight items.
    #[inline]
    pub fn group(&self, group: usize) -> &[Line] {
        &self.lines[group * self.rows..(group + 1) * self.rows]
    }

    /// The rows of one group of eight items, mutable.
    #[inline]
    pub fn group_mut(&mut self, group: usize) -> &mut [Line] {
        &mut self.lines[group * self.rows..(group + 1) * self.rows]
    }

    /// All lines, group by group.
    pub(crate) fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// All lines, group by group, to be divided among threads.
    pub(crate) fn lines_mut(&mut self) -> &mut [Line] {
        &mut self.lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_that_go_in_come_out_for_any_number_of_rows_and_items() {
        for rows in 1..12 {
            for len in [0, 1, 7, 8, 9, 64, 67] {
                let numbers: Vec<f64> = (0..rows * len).map(|k| k as f64).collect();
                let mut table = LaneTable::new(rows);
                table.fill_rows(&numbers);
                let mut expected = LaneTable::new(rows);
                expected.resize(len);
                numbers.chunks(rows).enumerate().for_each(|(item, numbers)| expected.write(item, numbers));
                assert_eq!(table, expected, "{rows} rows, {len} items");
                let mut again = vec![f64::NAN; rows * len];
                table.read_rows(&mut again);
                assert_eq!(again, numbers);
            }
        }
    }
}
