//! The middles of the cells of a grid, judged slab by slab.

use serde::{Deserialize, Serialize};

use super::{Bounds, Point, Region, WorkspaceError};

/// A box cut into cells; each cell is judged at its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    bounds: Bounds,
    counts: [usize; 3],
}

/// Most cells along one side; a larger number is taken for a typing error.
const MOST_CELLS: f64 = 1e6;

/// Number of cells of at most this size along a side.
pub(super) fn cell_count(bounds: &Bounds, axis: usize, step: f64) -> Result<usize, WorkspaceError> {
    if !(step > 0.0 && step.is_finite()) {
        return Err(WorkspaceError::Step { step });
    }
    // a side of a whole number of steps may miss it by rounding
    let count = (bounds.extent(axis) / step - 1e-9).ceil().max(1.0);
    match count <= MOST_CELLS {
        true => Ok(count as usize),
        false => Err(WorkspaceError::StepTooFine { step, extent: bounds.extent(axis) }),
    }
}

impl Grid {
    /// Cells that fill the box, at most `step` (m) long along each axis.
    pub fn new(bounds: &Bounds, step: f64) -> Result<Self, WorkspaceError> {
        let mut counts = [1; 3];
        for (axis, count) in counts.iter_mut().enumerate().take(bounds.dimension()) {
            *count = cell_count(bounds, axis, step)?;
        }
        Ok(Self { bounds: *bounds, counts })
    }

    /// Writes for points of the box whether they count as part of the region: the answers at the middles of their
    /// cells.
    pub fn contains(&self, region: &Region<'_>, points: &[Point], answers: &mut [bool]) {
        let middles: Vec<Point> = points.iter().map(|point| self.middle_about(point)).collect();
        region.holds_all(&middles, answers);
    }

    /// Middle of the cell in which a point of the box lies (m).
    fn middle_about(&self, point: &Point) -> Point {
        let mut middle = [0.0; 3];
        for axis in 0..self.bounds.dimension() {
            let (from, extent) = (self.bounds.least()[axis], self.bounds.extent(axis));
            middle[axis] = from + (self.place(point, axis) as f64 + 0.5) / self.counts[axis] as f64 * extent;
        }
        middle
    }

    /// Index of the cell in which a point of the box lies, slab after slab.
    pub fn cell_about(&self, point: &Point) -> usize {
        let axes = (0..self.bounds.dimension()).rev();
        axes.fold(0, |index, axis| index * self.counts[axis] + self.place(point, axis))
    }

    /// Place along an axis of the cell in which a point lies.
    fn place(&self, point: &Point, axis: usize) -> usize {
        let (from, extent) = (self.bounds.least()[axis], self.bounds.extent(axis));
        let count = self.counts[axis];
        (((point[axis] - from) / extent * count as f64).max(0.0) as usize).min(count - 1)
    }

    /// Number of cells along each axis.
    pub fn counts(&self) -> [usize; 3] {
        self.counts
    }

    /// The box.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// Number of cells.
    pub fn points(&self) -> u64 {
        self.counts.iter().map(|&count| count as u64).product()
    }

    /// Area (m²) or volume (m³) of a cell.
    pub fn cell_size(&self) -> f64 {
        self.bounds.size() / self.points() as f64
    }

    /// Number of slabs: layers of cells across the last axis.
    pub fn slabs(&self) -> usize {
        self.counts[self.bounds.dimension() - 1]
    }

    /// Cells of a slab along its two axes: rows along the first axis, one row in a plane.
    fn slab_counts(&self) -> [usize; 2] {
        [self.counts[0], if self.bounds.dimension() == 3 { self.counts[1] } else { 1 }]
    }

    /// Number of cells in a slab.
    pub fn slab_points(&self) -> usize {
        self.slab_counts().iter().product()
    }

    /// Middle of a cell of a slab (m).
    pub fn point(&self, slab: usize, index: usize) -> Point {
        let row = self.counts[0];
        let cell = match self.bounds.dimension() {
            3 => [index % row, index / row, slab],
            _ => [index, slab, 0],
        };
        let mut point = [0.0; 3];
        for axis in 0..self.bounds.dimension() {
            let fraction = (cell[axis] as f64 + 0.5) / self.counts[axis] as f64;
            point[axis] = self.bounds.least()[axis] + fraction * self.bounds.extent(axis);
        }
        point
    }
}

/// A count of cells in progress, with all data needed to continue it, also after reading it back from a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Count {
    /// Slabs judged so far, from the lower end of the last axis.
    pub slabs: usize,
    /// Cells judged so far.
    pub points: u64,
    /// Cells at whose middle the criterion holds.
    pub feasible_points: u64,
    /// Feasible cells that share a face with a cell at which the criterion fails.
    boundary_inside: u64,
    /// Infeasible cells that share a face with a cell at which it holds.
    boundary_outside: u64,
    /// Feasible cells at the faces of the box.
    at_bounds: u64,
    /// Sum of the coordinates of the feasible cells (m).
    moment: [f64; 3],
    /// The last two slabs, the earlier one first, as runs of equal answers that start with failures.
    last: [Vec<u32>; 2],
}

/// Outcome of counting the cells of a grid: size of a region and its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Area (m²) or volume (m³) of the cells at whose middle the criterion holds.
    pub size: f64,
    /// Bound of the error of the size (m², m³), unless the region or a gap in it is thinner than a cell.
    ///
    /// Only cells that share a face with a cell of the other kind can be cut by the boundary.
    pub error_bound: f64,
    /// Centroid of the feasible cells (m); the middle of the box if there are none.
    pub centroid: Point,
    /// True if the region reaches the faces of the box, so that more of it may lie outside.
    pub reaches_bounds: bool,
}

/// Cells judged between two reports.
const BLOCK: usize = 1 << 15;

impl Count {
    /// A count that has not begun.
    pub fn new() -> Self {
        Self {
            slabs: 0,
            points: 0,
            feasible_points: 0,
            boundary_inside: 0,
            boundary_outside: 0,
            at_bounds: 0,
            moment: [0.0; 3],
            last: [Vec::new(), Vec::new()],
        }
    }

    /// True if this can be a count of that grid, as far as its numbers show.
    pub fn fits(&self, grid: &Grid) -> bool {
        let size = grid.slab_points() as u64;
        let held = |lengths: &[u32]| lengths.iter().map(|&length| u64::from(length)).sum::<u64>();
        let [before, previous] = [0, 1].map(|slab| held(&self.last[slab]));
        self.slabs <= grid.slabs()
            && self.points == self.slabs as u64 * size
            && self.feasible_points <= self.points
            && previous == if self.slabs > 0 { size } else { 0 }
            && before == if self.slabs > 1 { size } else { 0 }
    }

    /// Judges the next slabs, some ten thousand cells at once, and passes each slab with its answers to `seen`; false
    /// if none is left.
    ///
    /// Memory is that of these cells, independent of the size of the grid.
    pub fn advance(&mut self, region: &Region<'_>, grid: &Grid, seen: &mut dyn FnMut(usize, &[bool])) -> bool {
        let size = grid.slab_points();
        let until = (self.slabs + BLOCK.div_ceil(size)).min(grid.slabs());
        let points: Vec<Point> =
            (self.slabs..until).flat_map(|slab| (0..size).map(move |index| grid.point(slab, index))).collect();
        let mut answers = vec![false; points.len()];
        region.holds_all(&points, &mut answers);
        let [mut before, mut previous] = [0, 1].map(|slab| expanded(&self.last[slab]));
        for (slab, current) in (self.slabs..until).zip(answers.chunks_exact(size)) {
            self.add(grid, slab, current);
            self.count_boundary(grid, [&before, &previous, current]);
            (before, previous) = (previous, current.to_vec());
            seen(slab, current);
        }
        if until == grid.slabs() && self.slabs < until {
            self.count_boundary(grid, [&before, &previous, &[]]);
        }
        self.slabs = until;
        self.last = [runs(&before), runs(&previous)];
        self.slabs < grid.slabs()
    }

    /// Adds the cells of a slab to the count.
    fn add(&mut self, grid: &Grid, slab: usize, answers: &[bool]) {
        let [row, rows] = grid.slab_counts();
        let is_end_slab = slab == 0 || slab + 1 == grid.slabs();
        self.points += answers.len() as u64;
        for index in (0..answers.len()).filter(|&index| answers[index]) {
            let (column, line) = (index % row, index / row);
            let is_end_line = rows > 1 && (line == 0 || line + 1 == rows);
            let is_end_column = column == 0 || column + 1 == row;
            self.feasible_points += 1;
            self.at_bounds += u64::from(is_end_slab || is_end_line || is_end_column);
            let point = grid.point(slab, index);
            (0..3).for_each(|axis| self.moment[axis] += point[axis]);
        }
    }

    /// Counts the cells of the middle slab that have a neighbour with the other answer; a slab outside the box is
    /// empty.
    fn count_boundary(&mut self, grid: &Grid, [before, middle, after]: [&[bool]; 3]) {
        let [row, _] = grid.slab_counts();
        for (index, &answer) in middle.iter().enumerate() {
            let differs = |neighbour: Option<&bool>| neighbour.is_some_and(|&other| other != answer);
            let column = index % row;
            let is_boundary = differs(before.get(index))
                || differs(after.get(index))
                || (column > 0 && differs(middle.get(index - 1)))
                || (column + 1 < row && differs(middle.get(index + 1)))
                || (index >= row && differs(middle.get(index - row)))
                || differs(middle.get(index + row));
            self.boundary_inside += u64::from(is_boundary && answer);
            self.boundary_outside += u64::from(is_boundary && !answer);
        }
    }

    /// Outcome of the cells judged so far.
    pub fn outcome(&self, grid: &Grid) -> Outcome {
        let cell = grid.cell_size();
        let centroid = match self.feasible_points {
            0 => grid.bounds.middle(),
            count => self.moment.map(|sum| sum / count as f64),
        };
        Outcome {
            size: cell * self.feasible_points as f64,
            error_bound: cell * self.boundary_inside.max(self.boundary_outside) as f64,
            centroid,
            reaches_bounds: self.at_bounds > 0,
        }
    }
}

impl Default for Count {
    fn default() -> Self {
        Self::new()
    }
}

/// Lengths of runs of equal answers, starting with failures.
fn runs(answers: &[bool]) -> Vec<u32> {
    let mut lengths = Vec::new();
    let (mut value, mut length) = (false, 0);
    for &answer in answers {
        if answer != value {
            lengths.push(length);
            (value, length) = (answer, 0);
        }
        length += 1;
    }
    lengths.push(length);
    lengths
}

fn expanded(lengths: &[u32]) -> Vec<bool> {
    let runs = lengths.iter().enumerate();
    runs.flat_map(|(index, &length)| std::iter::repeat_n(index % 2 == 1, length as usize)).collect()
}

/// Outcome of the answers for all cells, slab after slab; panics if there is not one per cell.
pub fn outcome(grid: &Grid, answers: &[bool]) -> Outcome {
    assert_eq!(answers.len() as u64, grid.points(), "one answer per cell");
    let mut count = Count::new();
    let slabs: Vec<&[bool]> = answers.chunks_exact(grid.slab_points()).collect();
    let at = |slab: Option<usize>| slab.and_then(|slab| slabs.get(slab).copied()).unwrap_or(&[]);
    for (slab, current) in slabs.iter().enumerate() {
        count.add(grid, slab, current);
        count.count_boundary(grid, [at(slab.checked_sub(1)), current, at(Some(slab + 1))]);
    }
    count.outcome(grid)
}

/// Judges every cell of a grid.
pub fn count(region: &Region<'_>, grid: &Grid) -> Count {
    let mut count = Count::new();
    while count.advance(region, grid, &mut |_, _| {}) {}
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In plane and space alike; a point outside counts with the nearest cell.
    #[test]
    fn a_point_lies_in_the_cell_about_whose_middle_it_is() {
        for ends in [&[-1.0, 2.0, 0.0, 1.0][..], &[-1.0, 2.0, 0.0, 1.0, 5.0, 5.7]] {
            let grid = Grid::new(&Bounds::new(ends.len() / 2, ends).unwrap(), 0.3).unwrap();
            for slab in 0..grid.slabs() {
                for index in 0..grid.slab_points() {
                    let middle = grid.point(slab, index);
                    assert_eq!(grid.cell_about(&middle), slab * grid.slab_points() + index);
                    assert_eq!(grid.middle_about(&middle), middle);
                }
            }
            assert_eq!(grid.cell_about(&[-9.0; 3]), 0);
            assert_eq!(grid.cell_about(&[9.0; 3]) as u64, grid.points() - 1);
        }
    }
}
