//! Sums over the cells of an octree.

use super::{Octree, Settings, search};
use crate::{Bounds, Point, Region, WorkspaceError};

/// Outcome of an octree: size of a region and its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Area (m²) or volume (m³): the cells at whose corners the criterion holds, and of each cell cut by the boundary
    /// the fraction of its corners at which it holds.
    pub size: f64,
    /// Bound of the error of the size (m², m³), unless parts or gaps hide between the corners of a cell.
    pub error_bound: f64,
    /// Points judged.
    pub points: u64,
    /// Points at which the criterion holds.
    pub feasible_points: u64,
    /// Smallest cells that the boundary passes.
    pub boundary_cells: u64,
    /// Points that a grid with the smallest cells everywhere would judge.
    pub grid_points: u64,
    /// Sides of the start cells (m): thinner parts may be missed.
    pub start_cell: Point,
    /// True if the region reaches the faces of the box, so that more of it may lie outside.
    pub reaches_bounds: bool,
}

/// Measures a region in a box.
pub fn solve(region: &Region<'_>, bounds: &Bounds, settings: &Settings) -> Result<Outcome, WorkspaceError> {
    Ok(search(region, bounds, settings)?.outcome())
}

impl Octree<'_> {
    /// Sums over the cells of the octree.
    pub fn outcome(&self) -> Outcome {
        let (mixed, corners) = (self.cells.len() as f64, (1 << self.dimension) as f64);
        let fractions: f64 = self.cells.iter().map(|cell| f64::from(cell.corners.count_ones()) / corners).sum();
        let mixed_above = self.cells.iter().filter(|cell| cell.corners & 1 == 1).count();
        // a cell whose lower corner holds is all inside, or the boundary passes it
        let inside = (self.holding_lower_corners() - mixed_above as i64) as f64;
        let cells: usize = self.counts[..self.dimension].iter().product();
        let smallest = self.bounds.size() / cells as f64;
        let size = inside + fractions;
        let mut start_cell = [0.0; 3];
        for axis in 0..self.dimension {
            start_cell[axis] = self.bounds.extent(axis) / self.counts[axis] as f64 * self.start as f64;
        }
        Outcome {
            size: smallest * size,
            error_bound: smallest * (size - inside).max(inside + mixed - size),
            points: self.points,
            feasible_points: self.feasible_points,
            boundary_cells: self.cells.len() as u64,
            grid_points: cells as u64,
            start_cell,
            reaches_bounds: self.reaches_bounds(),
        }
    }

    /// Number of feasible lower corners of cells, counted from the boundary alone: in a row of corners, those before an
    /// edge at which feasibility ends, minus those before an edge at which it begins, plus all of them if the end of
    /// the row is feasible. The ends of rows form a plane, whose rows are counted the same way, and their ends form a
    /// line.
    fn holding_lower_corners(&self) -> i64 {
        let (mut count, mut factor) = (0, 1);
        for axis in 0..self.dimension {
            let (from, to) = ((1 << axis) - 1, (2 << axis) - 1);
            let is_at_ends = |node: &[usize; 3]| (0..axis).all(|before| node[before] + 1 == self.counts[before]);
            for cell in self.cells.iter().filter(|cell| is_at_ends(&cell.node)) {
                let [from, to] = [from, to].map(|corner| i64::from(cell.corners >> corner & 1));
                count += factor * (from - to) * (cell.node[axis] as i64 + 1);
            }
            factor *= self.counts[axis] as i64;
        }
        let mut last = [0; 3];
        last[..self.dimension].copy_from_slice(&self.counts[..self.dimension]);
        count + factor * i64::from(self.nodes.holds(last))
    }

    /// True if a corner on the faces of the box is feasible: of a start cell, or of a cell that the boundary passes.
    fn reaches_bounds(&self) -> bool {
        let is_at_a_face =
            |node: &[usize; 3]| (0..self.dimension).any(|axis| node[axis] == 0 || node[axis] == self.counts[axis]);
        let corner = |node: &[usize; 3], corner: usize| [0, 1, 2].map(|axis| node[axis] + (corner >> axis & 1));
        let reaches = |cell: &super::Cell| {
            (0..1 << self.dimension).any(|k| cell.corners >> k & 1 == 1 && is_at_a_face(&corner(&cell.node, k)))
        };
        self.start_corners().any(|node| is_at_a_face(&node) && self.nodes.holds(node)) || self.cells.iter().any(reaches)
    }
}
