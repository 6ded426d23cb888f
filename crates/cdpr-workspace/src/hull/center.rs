//! A point from which rays for a hull start, if none is given.

use crate::grid::{Count, Grid};
use crate::{Audit, Bounds, Point, Region, WorkspaceError};

/// Cells of the coarse grid along the longest side of the box.
const CELLS: f64 = 24.0;
/// Seed of the points that are drawn if the grid finds none.
const SEED: u64 = 0xce27;

/// Outcome of the search for a centre.
#[derive(Clone, Debug, PartialEq)]
pub enum Center {
    /// Centre found (m).
    At(Point),
    /// No centre: no point of a coarse grid belongs to the region, nor any of those that the audit drew.
    Nowhere(Audit),
}

/// The point of a coarse grid in the region that is nearest to the centroid of all such points; if there is none, the
/// same for `points` points drawn at random.
pub fn find_center(region: &Region<'_>, bounds: &Bounds, points: u64) -> Result<Center, WorkspaceError> {
    let longest = (0..bounds.dimension()).map(|axis| bounds.extent(axis)).fold(0.0, f64::max);
    let grid = Grid::new(bounds, longest / CELLS)?;
    let (mut count, mut inside) = (Count::new(), Vec::new());
    let mut collect = |slab: usize, answers: &[bool]| {
        inside.extend((0..answers.len()).filter(|&index| answers[index]).map(|index| grid.point(slab, index)));
    };
    while count.advance(region, &grid, &mut collect) {}
    if let Some(point) = middle_of(&inside) {
        return Ok(Center::At(point));
    }
    let audit = Audit::of(region, bounds, [points, SEED], &mut |_, answers| answers.fill(false));
    Ok(middle_of(&audit.inside).map_or(Center::Nowhere(audit), Center::At))
}

/// The point nearest to the centroid of all.
fn middle_of(points: &[Point]) -> Option<Point> {
    let centroid = [0, 1, 2].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / points.len() as f64);
    let away = |point: &Point| (0..3).map(|axis| (point[axis] - centroid[axis]).powi(2)).sum::<f64>();
    points.iter().copied().min_by(|a, b| away(a).total_cmp(&away(b)))
}
