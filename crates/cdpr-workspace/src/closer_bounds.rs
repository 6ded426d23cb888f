//! The box of a region: at least its frame, and wide enough for the region.

use super::bounds::frame_of;
use super::grid::{Count, Grid};
use super::refine::Goal;
use super::{Bounds, Region, WorkspaceError};
use cdpr_model::model::Model;

/// Cells of a coarse grid along the longest side of a box.
const COARSE: f64 = 24.0;

/// Fraction of the poses of a goal that may be spent on the box.
const SHARE: f64 = 0.25;

impl Bounds {
    /// The box of frame anchors, travel and home position, widened where a region reaches out of it, or so near to its
    /// faces that a coarse grid over the box [around](Self::around) the robot cannot decide (one and a half of its
    /// cells).
    ///
    /// Returns the box around the robot if no point of the grid belongs to the region, or if the grid has more points
    /// than a quarter of those that the goal allows.
    pub fn about(region: &Region<'_>, model: &Model, goal: &Goal) -> Result<Self, WorkspaceError> {
        let around = Self::around(model)?;
        let grid = Grid::new(&around, around.longest() / COARSE)?;
        if grid.points() as f64 > SHARE * goal.poses(region) {
            return Ok(around);
        }
        let (mut count, mut ends) = (Count::new(), frame_of(model));
        let mut widen = |slab: usize, answers: &[bool]| {
            for index in (0..answers.len()).filter(|&index| answers[index]) {
                let point = grid.point(slab, index);
                for (axis, [least, largest]) in ends.iter_mut().enumerate() {
                    let cells = 1.5 * around.extent(axis) / grid.counts()[axis] as f64;
                    *least = least.min((point[axis] - cells).max(around.least()[axis]));
                    *largest = largest.max((point[axis] + cells).min(around.largest()[axis]));
                }
            }
        };
        while count.advance(region, &grid, &mut widen) {}
        match count.feasible_points {
            0 => Ok(around),
            _ => Self::new(ends.len(), ends.as_flattened()),
        }
    }
}
