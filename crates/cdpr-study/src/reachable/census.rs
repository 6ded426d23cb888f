//! Census of a grid of commanded positions, taken once for all thresholds of the error.

use super::{Errors, Forces, Reachable, Requirements, tension_margin};
use cdpr_model::geometry::Pose;
use cdpr_workspace::grid::Grid;
use cdpr_workspace::{Point, Region};

/// Errors and tension margin if the middle of one cell is commanded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Distance between commanded and emerging position (m); infinite if the platform does not come to rest, or if a
    /// slack cable would break its limits, so that no pose was sought.
    pub position_error: f64,
    /// Angle between commanded and emerging orientation (rad); infinite in the same cases.
    pub rotation_error: f64,
    /// Least distance of the tensions from their limits as a fraction of the range; infinite without limits.
    pub tension_margin: f64,
    /// Largest difference between an emerging and its commanded tension (N); 0 if none are commanded, infinite in the
    /// same cases.
    pub tension_error: f64,
}

/// All cells of a grid, slab after slab.
#[derive(Clone, Debug, PartialEq)]
pub struct Census {
    /// One entry per cell.
    pub cells: Vec<Cell>,
    /// Largest rotation error that is allowed (rad).
    rotation_error_max: Option<f64>,
    /// Largest tension error that is allowed (N).
    tension_error_max: Option<f64>,
}

impl Census {
    /// Commands the middle of every cell, in the first orientation of the region.
    pub fn take(reachable: &Reachable, region: &Region<'_>, grid: &Grid) -> Self {
        let rotation = region.orientations().first().copied().unwrap_or_default();
        let slab = |slab: usize| (0..grid.slab_points()).map(move |index| grid.point(slab, index));
        let pose = |point: Point| Pose { position: region.position(&point), rotation };
        let poses: Vec<Pose> = (0..grid.slabs()).flat_map(slab).map(pose).collect();
        let &Requirements { rotation_error_max, tension_error_max, .. } = reachable.requirements();
        // a slack cable breaks its limit, so that the cell is not reached anyway
        let only_taut = reachable.needs_all_taut();
        let cells = reachable.driving().each_share(&poses, |poses| {
            let cells = reachable.of_emerging(poses, only_taut, |commanded, emerging, forces| {
                Cell::of(reachable, commanded, emerging, forces)
            });
            cells.into_iter().map(|cell| cell.unwrap_or(Cell::NOWHERE)).collect()
        });
        Self { rotation_error_max, tension_error_max, cells }
    }

    /// For each cell whether it is reached within the requirements, with this position error (m) instead of the
    /// required one.
    pub fn reached(&self, position_error_max: Option<f64>) -> Vec<bool> {
        let most = position_error_max.unwrap_or(f64::MAX);
        let turn = self.rotation_error_max.unwrap_or(f64::MAX);
        let missed = self.tension_error_max.unwrap_or(f64::MAX);
        let is_accurate = |cell: &Cell| cell.position_error <= most && cell.rotation_error <= turn;
        let is_reached = |cell: &Cell| cell.tension_margin >= 0.0 && is_accurate(cell) && cell.tension_error <= missed;
        self.cells.iter().map(is_reached).collect()
    }
}

impl Cell {
    /// Cell in which the platform does not come to rest within the requirements.
    const NOWHERE: Self = Self {
        position_error: f64::INFINITY,
        rotation_error: f64::INFINITY,
        tension_margin: f64::INFINITY,
        tension_error: f64::INFINITY,
    };

    fn of(reachable: &Reachable, commanded: &Pose, emerging: &Pose, forces: Forces<'_>) -> Self {
        let limits = reachable.requirements().tensions.as_ref().zip(forces.emerging);
        let Errors { position, rotation, tension } = Errors::of(commanded, emerging, forces);
        Self {
            position_error: position,
            rotation_error: rotation,
            tension_margin: limits.map_or(f64::INFINITY, |(limits, tensions)| tension_margin(limits, tensions).0),
            tension_error: tension.map_or(0.0, |(error, _)| error),
        }
    }
}
