//! Counts of cells, finer with every refinement, with signs of life and a state that outlives an interruption.

use std::path::Path;

use cdpr_workspace::grid::{Count, Grid};
use cdpr_workspace::refine::{RegionSearch, step_after};
use cdpr_workspace::{Cells, Point, Region};

use super::counting;
use super::question::Question;
use crate::failure::Failure;
use crate::progress::Progress;

/// Cells of a box, counted.
pub(super) struct CellSearch<'a> {
    question: &'a Question<'a>,
    region: &'a Region<'a>,
    resume: Option<&'a Path>,
    is_shown: bool,
    /// Tells that points are compared, between two counts.
    comparing: Option<Progress>,
}

/// Result of a count of cells.
pub(super) struct Counted {
    pub(super) grid: Grid,
    pub(super) count: Count,
    /// Cells that hold, where their surface shall be shown.
    pub(super) cells: Option<Cells>,
}

impl<'a> CellSearch<'a> {
    pub(super) fn new(
        question: &'a Question<'a>,
        region: &'a Region<'a>,
        resume: Option<&'a Path>,
        is_shown: bool,
    ) -> Self {
        Self { question, region, resume, is_shown: is_shown && resume.is_none(), comparing: None }
    }
}

impl RegionSearch for CellSearch<'_> {
    type Found = Counted;
    type Error = Failure;

    fn find(&mut self, refinement: u32) -> Result<Counted, Failure> {
        self.comparing = None;
        let refused = |error| Failure::refused("--step", &error);
        let grid = Grid::new(&self.question.bounds, step_after(self.question.step, refinement)).map_err(refused)?;
        let mut cells = self.is_shown.then(|| Cells::new(&grid)).transpose().map_err(refused)?;
        let count = counting::count(self.region, &grid, self.question, self.resume, cells.as_mut())?;
        self.comparing = Some(Progress::spinner("comparing with points drawn at random"));
        Ok(Counted { grid, count, cells })
    }

    fn growth(&self) -> f64 {
        f64::powi(2.0, self.region.dimension() as i32)
    }

    fn allows(&self, _refinement: u32) -> bool {
        true
    }

    fn judged(&self, found: &Counted) -> (u64, Option<f64>) {
        (found.count.points, Some(found.count.outcome(&found.grid).size))
    }

    fn contains(&self, found: &Counted, points: &[Point], answers: &mut [bool]) {
        found.grid.contains(self.region, points, answers);
    }
}
