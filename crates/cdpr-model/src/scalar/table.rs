//! Numbers of many items, eight items side by side, so that a vector register loads the same number of eight items at
//! once.

use super::LANES;

/// Eight numbers on one cache line: no load or store crosses two.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub struct Line(pub [f64; LANES]);

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

    /// All lines, group by group, to be divided among threads.
    pub(crate) fn lines_mut(&mut self) -> &mut [Line] {
        &mut self.lines
    }
}
