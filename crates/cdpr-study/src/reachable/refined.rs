//! Censuses of finer and finer grids, until the bound of the size is small.

use super::{Census, Reachable};
use cdpr_workspace::grid::{self, Grid};
use cdpr_workspace::refine::{RegionSearch, step_after};
use cdpr_workspace::{Bounds, Point, Region, WorkspaceError};

/// Search that commands the cells of a grid; each refinement halves them.
pub struct ByCensus<'a> {
    /// Workspace that is measured.
    pub reachable: &'a Reachable,
    /// The same as a region, in one orientation.
    pub region: &'a Region<'a>,
    /// Box that is searched.
    pub bounds: &'a Bounds,
    /// Largest side of a cell at first (m).
    pub step: f64,
}

/// Grid with its census.
#[derive(Clone, Debug, PartialEq)]
pub struct CountedCells {
    /// The cells.
    pub grid: Grid,
    /// Errors and margins at their middles.
    pub census: Census,
    /// One entry per cell: true if it is reached within the requirements.
    pub answers: Vec<bool>,
}

impl RegionSearch for ByCensus<'_> {
    type Found = CountedCells;
    type Error = WorkspaceError;

    fn find(&mut self, refinement: u32) -> Result<CountedCells, WorkspaceError> {
        let grid = Grid::new(self.bounds, step_after(self.step, refinement))?;
        let census = Census::take(self.reachable, self.region, &grid);
        let answers = census.reached(self.reachable.requirements().position_error_max);
        Ok(CountedCells { grid, census, answers })
    }

    fn growth(&self) -> f64 {
        f64::powi(2.0, self.bounds.dimension() as i32)
    }

    fn allows(&self, _refinement: u32) -> bool {
        true
    }

    fn judged(&self, found: &CountedCells) -> (u64, Option<f64>) {
        (found.grid.points(), Some(grid::outcome(&found.grid, &found.answers).size))
    }

    fn contains(&self, found: &CountedCells, points: &[Point], answers: &mut [bool]) {
        points.iter().zip(answers).for_each(|(point, answer)| *answer = found.answers[found.grid.cell_about(point)]);
    }
}
