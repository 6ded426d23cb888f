//! Grid, octree and hull as searches that can be refined.

use super::RegionSearch;
use crate::grid::{self, Count, Grid};
use crate::hull::{self, Hull, Locator};
use crate::octree::{self, Octree};
use crate::{Bounds, Point, Region, WorkspaceError};

/// A search that counts the cells of a grid.
#[derive(Clone, Copy)]
pub struct ByGrid<'a> {
    /// Region to be measured.
    pub region: &'a Region<'a>,
    /// Box that is searched.
    pub bounds: &'a Bounds,
    /// Largest side of a cell at first (m); each refinement halves it.
    pub step: f64,
}

/// A search that refines cells at the boundary.
#[derive(Clone, Copy)]
pub struct ByOctree<'a> {
    /// Region to be measured.
    pub region: &'a Region<'a>,
    /// Box that is searched.
    pub bounds: &'a Bounds,
    /// Largest side of a smallest cell at first (m); each refinement halves it.
    pub step: f64,
}

/// A search along rays from a centre.
#[derive(Clone)]
pub struct ByHull<'a> {
    /// Region to be measured.
    pub region: &'a Region<'a>,
    /// Box that is searched.
    pub bounds: &'a Bounds,
    /// Point from which rays start (m).
    pub center: Point,
    /// Settings at first; each refinement halves the distance of rays.
    pub settings: hull::Settings,
}

/// Most cells of an octree, whose answers take some 100 MB.
const MOST_CELLS: f64 = 3e8;

/// The step after `refinement` refinements (m).
pub fn step_after(step: f64, refinement: u32) -> f64 {
    step / f64::powi(2.0, refinement as i32)
}

impl RegionSearch for ByGrid<'_> {
    type Found = (Grid, Count);
    type Error = WorkspaceError;

    fn find(&mut self, refinement: u32) -> Result<Self::Found, WorkspaceError> {
        let cells = Grid::new(self.bounds, step_after(self.step, refinement))?;
        Ok((cells, grid::count(self.region, &cells)))
    }

    fn growth(&self) -> f64 {
        f64::powi(2.0, self.bounds.dimension() as i32)
    }

    fn allows(&self, _refinement: u32) -> bool {
        true
    }

    fn judged(&self, (cells, count): &Self::Found) -> (u64, Option<f64>) {
        (count.points, Some(count.outcome(cells).size))
    }

    fn contains(&self, (cells, _): &Self::Found, points: &[Point], answers: &mut [bool]) {
        cells.contains(self.region, points, answers);
    }
}

impl<'a> RegionSearch for ByOctree<'a> {
    type Found = Octree<'a>;
    type Error = WorkspaceError;

    fn find(&mut self, refinement: u32) -> Result<Octree<'a>, WorkspaceError> {
        octree::search(self.region, self.bounds, &octree::Settings::new(step_after(self.step, refinement)))
    }

    fn growth(&self) -> f64 {
        f64::powi(2.0, self.bounds.dimension() as i32 - 1)
    }

    fn allows(&self, refinement: u32) -> bool {
        let step = step_after(self.step, refinement);
        let cells: f64 = (0..self.bounds.dimension()).map(|axis| self.bounds.extent(axis) / step).product();
        cells <= MOST_CELLS
    }

    fn judged(&self, found: &Octree<'a>) -> (u64, Option<f64>) {
        let outcome = found.outcome();
        (outcome.points, Some(outcome.size))
    }

    fn contains(&self, found: &Octree<'a>, points: &[Point], answers: &mut [bool]) {
        points.iter().zip(answers).for_each(|(point, answer)| *answer = found.contains(point));
    }
}

impl RegionSearch for ByHull<'_> {
    type Found = Hull;
    type Error = WorkspaceError;

    fn find(&mut self, refinement: u32) -> Result<Hull, WorkspaceError> {
        let settings = self.settings.refined(self.bounds, refinement);
        hull::solve(self.region, self.bounds, &self.center, &settings)
    }

    fn growth(&self) -> f64 {
        f64::powi(2.0, self.bounds.dimension() as i32 - 1)
    }

    fn allows(&self, refinement: u32) -> bool {
        self.settings.refined(self.bounds, refinement).rays <= hull::MOST_RAYS
    }

    fn judged(&self, found: &Hull) -> (u64, Option<f64>) {
        (found.points, found.measure().map(|measure| measure.size))
    }

    fn contains(&self, found: &Hull, points: &[Point], answers: &mut [bool]) {
        let locator = Locator::new(found);
        points.iter().zip(answers).for_each(|(point, answer)| *answer = locator.contains(point));
    }
}
