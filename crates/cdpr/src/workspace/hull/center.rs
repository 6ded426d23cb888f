//! A point from which to look for a hull, where none is given.

use crate::workspace::grid::{Count, Grid};
use crate::workspace::{Bounds, Point, Region, WorkspaceError};

/// Cells of the coarse grid along the longest side of the box.
const CELLS: f64 = 24.0;

/// Of the points of a coarse grid that belong to the region the one nearest to their centroid; nothing where none does.
pub fn find_center(region: &Region<'_>, bounds: &Bounds) -> Result<Option<Point>, WorkspaceError> {
    let longest = (0..bounds.dimension()).map(|axis| bounds.extent(axis)).fold(0.0, f64::max);
    let grid = Grid::new(bounds, longest / CELLS)?;
    let (mut count, mut inside) = (Count::new(), Vec::new());
    let mut collect = |slab: usize, answers: &[bool]| {
        inside.extend((0..answers.len()).filter(|&index| answers[index]).map(|index| grid.point(slab, index)));
    };
    while count.advance(region, &grid, &mut collect) {}
    let centroid = count.outcome(&grid).centroid;
    let away = |point: &Point| (0..3).map(|axis| (point[axis] - centroid[axis]).powi(2)).sum::<f64>();
    Ok(inside.into_iter().min_by(|a, b| away(a).total_cmp(&away(b))))
}
