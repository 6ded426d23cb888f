//! Feasible cells of a grid, from which its surface is drawn.

use super::{Lattice, of};
use crate::grid::Grid;
use crate::mesh::Mesh;
use crate::{Region, WorkspaceError};

/// One bit for each cell of a grid, set if the criterion holds at its middle.
#[derive(Clone, Debug)]
pub struct Cells {
    grid: Grid,
    bits: Vec<u64>,
}

/// Most cells; more need more than 2 GB.
const MOST_CELLS: u64 = 16_000_000_000;

impl Cells {
    /// Cells of a grid, none feasible yet; an error if they are too many for memory.
    pub fn new(grid: &Grid) -> Result<Self, WorkspaceError> {
        if grid.points() > MOST_CELLS {
            let (bounds, counts) = (grid.bounds(), grid.counts());
            let step = bounds.extent(0) / counts[0] as f64;
            return Err(WorkspaceError::StepTooFine { step, extent: bounds.extent(0) });
        }
        Ok(Self { grid: *grid, bits: vec![0; grid.points().div_ceil(64) as usize] })
    }

    /// Records the answers of a slab, as passed by [`Count::advance`](crate::grid::Count::advance).
    pub fn see(&mut self, slab: usize, answers: &[bool]) {
        let first = slab * self.grid.slab_points();
        for index in (0..answers.len()).filter(|&index| answers[index]) {
            self.bits[(first + index) / 64] |= 1 << ((first + index) % 64);
        }
    }

    /// The boundary between feasible and infeasible cells, through the middles at which they were judged; in a plane
    /// the area.
    ///
    /// The surface is closed, each part of the region has its own, and all vertices between a feasible and an
    /// infeasible cell lie in the region, less than a thousandth of the distance of two middles from the boundary.
    pub fn surface(&self, region: &Region<'_>) -> Mesh {
        let counts = self.grid.counts();
        let holds = |[x, y, z]: [usize; 3]| {
            let index = (z * counts[1] + y) * counts[0] + x;
            self.bits[index / 64] >> (index % 64) & 1 == 1
        };
        let lattice = Lattice { region, bounds: self.grid.bounds(), counts, inset: 0.5, holds: &holds };
        of(&lattice, lattice.cubes())
    }
}
