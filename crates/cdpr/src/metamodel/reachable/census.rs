//! What a grid of commanded positions says, once for any threshold of the error.

use super::{Reachable, tension_margin};
use crate::geometry::Pose;
use crate::metamodel::operate::Status;
use crate::workspace::grid::Grid;
use crate::workspace::{Point, Region};

/// What emerged at the middle of one cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Distance between commanded and emerging position (m); infinite where the platform comes to no rest.
    pub position_error: f64,
    /// Angle between commanded and emerging orientation (rad); infinite likewise.
    pub rotation_error: f64,
    /// Least distance of the tensions from their limits as a share of the range; infinite without limits.
    pub tension_margin: f64,
}

/// All cells of a grid, slab after slab.
#[derive(Clone, Debug, PartialEq)]
pub struct Census {
    /// One entry per cell.
    pub cells: Vec<Cell>,
    /// The largest angle that was required (rad).
    rotation_error_max: Option<f64>,
}

impl Census {
    /// Commands the middle of every cell, in the first orientation of the region.
    pub fn take(reachable: &Reachable<'_>, region: &Region<'_>, grid: &Grid) -> Self {
        let rotation = region.orientations().first().copied().unwrap_or_default();
        let slab = |slab: usize| (0..grid.slab_points()).map(move |index| grid.point(slab, index));
        let pose = |point: Point| Pose { position: region.position(&point), rotation };
        let poses: Vec<Pose> = (0..grid.slabs()).flat_map(slab).map(pose).collect();
        let rotation_error_max = reachable.requirements().rotation_error_max;
        Self { rotation_error_max, cells: reachable.driving().each(&poses, |pose| Cell::of(reachable, pose)) }
    }

    /// Which cells are reached as required, with a position error of at most this (m) in place of the required one.
    pub fn reached(&self, position_error_max: Option<f64>) -> Vec<bool> {
        let most = position_error_max.unwrap_or(f64::MAX);
        let turn = self.rotation_error_max.unwrap_or(f64::MAX);
        let is_reached =
            |cell: &Cell| cell.tension_margin >= 0.0 && cell.position_error <= most && cell.rotation_error <= turn;
        self.cells.iter().map(is_reached).collect()
    }
}

impl Cell {
    fn of(reachable: &Reachable<'_>, commanded: &Pose) -> Self {
        let outcome = reachable.driving().outcome(commanded);
        if outcome.status != Status::Converged {
            let none = f64::INFINITY;
            return Self { position_error: none, rotation_error: none, tension_margin: none };
        }
        let limits = reachable.requirements().tensions.as_ref().zip(outcome.tensions.as_ref());
        Self {
            position_error: (outcome.pose.position - commanded.position).norm(),
            rotation_error: outcome.pose.angle_to(commanded),
            tension_margin: limits.map_or(f64::INFINITY, |(limits, tensions)| tension_margin(limits, tensions).0),
        }
    }
}
