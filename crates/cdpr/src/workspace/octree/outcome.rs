//! What the cells of an octree add up to.

use super::{Cell, Tree};
use crate::workspace::Point;

/// What an octree says of a region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Area (m²) or volume (m³): cells at whose corners the criterion holds, and of those cut by the boundary the share of
    /// their corners.
    pub size: f64,
    /// How far that can be from the truth (m², m³), unless parts or gaps hide between the corners of a cell.
    pub error_bound: f64,
    /// Points judged.
    pub points: u64,
    /// Those at which the criterion holds.
    pub feasible_points: u64,
    /// Smallest cells that the boundary passes.
    pub boundary_cells: u64,
    /// Points that a grid with the smallest cells everywhere would judge.
    pub grid_points: u64,
    /// Sides of the start cells (m): what is thinner may be missed.
    pub start_cell: Point,
    /// True where the region reaches the faces of the box, so that more of it may lie outside.
    pub reaches_bounds: bool,
}

impl Tree<'_> {
    /// Adds up all cells that are not cut.
    pub(super) fn outcome(&self) -> Outcome {
        let mut sum = Sum::default();
        let mut open: Vec<Cell> = self.start_cells().collect();
        while let Some(cell) = open.pop() {
            if !self.is_smallest(cell.level) && self.cut[cell.level][self.cut_index(cell.level, cell.node)] {
                let half = self.side(cell.level) / 2;
                open.extend(self.corners(cell.node, half, 2).map(|node| Cell { level: cell.level + 1, node }));
            } else {
                sum.add(self, cell);
            }
        }
        let cells: usize = self.counts[..self.dimension].iter().product();
        let smallest = self.bounds.size() / cells as f64;
        let size = sum.inside + sum.shares;
        let mut start_cell = [0.0; 3];
        for axis in 0..self.dimension {
            start_cell[axis] = self.bounds.extent(axis) / self.counts[axis] as f64 * self.start as f64;
        }
        Outcome {
            size: smallest * size,
            error_bound: smallest * (size - sum.inside).max(sum.inside + sum.mixed as f64 - size),
            points: self.points,
            feasible_points: self.feasible_points,
            boundary_cells: sum.mixed,
            grid_points: cells as u64,
            start_cell,
            reaches_bounds: sum.reaches_bounds,
        }
    }
}

/// Sizes in smallest cells.
#[derive(Default)]
struct Sum {
    inside: f64,
    mixed: u64,
    /// Shares of the mixed cells that count as inside.
    shares: f64,
    reaches_bounds: bool,
}

impl Sum {
    fn add(&mut self, tree: &Tree<'_>, cell: Cell) {
        let side = tree.side(cell.level);
        let (mut holding, mut corners) = (0, 0);
        for corner in tree.corners(cell.node, side, 2) {
            corners += 1;
            if tree.nodes.holds(corner) {
                holding += 1;
                let is_end = |axis: usize| corner[axis] == 0 || corner[axis] == tree.counts[axis];
                self.reaches_bounds |= (0..tree.dimension).any(is_end);
            }
        }
        match holding {
            0 => {}
            _ if holding == corners => self.inside += side.pow(tree.dimension as u32) as f64,
            _ => {
                self.mixed += 1;
                self.shares += f64::from(holding) / f64::from(corners);
            }
        }
    }
}
