//! What a region of commanded positions becomes where the platform comes to rest.

use super::Reachable;
use crate::geometry::Pose;
use crate::workspace::grid::Grid;
use crate::workspace::hull::Hull;
use crate::workspace::{Point, Region};

/// Size (m², m³) of the region of emerging positions that belongs to cells of commanded ones.
///
/// Each cell counts with the determinant of ∂x̂/∂x, by differences over half a cell: what is reached twice counts twice.
/// `cells` are slab and index of the cells that are reached, as [`Grid::point`] takes them.
pub fn emerging_size(reachable: &Reachable<'_>, region: &Region<'_>, grid: &Grid, cells: &[(usize, usize)]) -> f64 {
    let size = |&(slab, index): &(usize, usize)| stretch(reachable, region, grid, &grid.point(slab, index));
    // all sizes are there before they are added: the order of a sum decides its last digits
    grid.cell_size() * reachable.driving().each(cells, size).iter().sum::<f64>()
}

/// |det ∂x̂/∂x| at a commanded position; 1 where a neighbour has no answer.
fn stretch(reachable: &Reachable<'_>, region: &Region<'_>, grid: &Grid, point: &Point) -> f64 {
    let dimension = region.dimension();
    let mut jacobian = nalgebra::Matrix3::identity();
    for axis in 0..dimension {
        let half = 0.25 * grid.bounds().extent(axis) / grid.counts()[axis] as f64;
        let beside = |way: f64| {
            let mut point = *point;
            point[axis] += way;
            emerging(reachable, region, &point)
        };
        let (Some(before), Some(behind)) = (beside(-half), beside(half)) else { return 1.0 };
        for row in 0..dimension {
            jacobian[(row, axis)] = (behind[row] - before[row]) / (2.0 * half);
        }
    }
    jacobian.determinant().abs()
}

fn emerging(reachable: &Reachable<'_>, region: &Region<'_>, point: &Point) -> Option<Point> {
    let rotation = *region.orientations().first()?;
    reachable.emerging_position(region, &Pose { position: region.position(point), rotation })
}

/// A hull of commanded positions where the platform comes to rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// The emerging position of each corner of the hull (m).
    pub vertices: Vec<Point>,
    /// Area (m²) or volume (m³) within.
    pub size: f64,
}

/// The image of a hull; nothing where a corner has no answer.
pub fn image_of(reachable: &Reachable<'_>, region: &Region<'_>, hull: &Hull) -> Option<Image> {
    let vertices: Vec<Point> =
        hull.vertices().iter().map(|corner| emerging(reachable, region, corner)).collect::<Option<_>>()?;
    // measured from a point within, so that a hull far from the origin loses no digits
    let beside = |corner: u32| {
        let vertex = vertices[corner as usize];
        nalgebra::Vector3::from([0, 1, 2].map(|axis| vertex[axis] - hull.center[axis]))
    };
    let part = |face: &[u32; 3]| {
        let [a, b, c] = face.map(beside);
        match hull.dimension() {
            2 => 0.5 * (a.x * b.y - a.y * b.x),
            _ => a.dot(&b.cross(&c)) / 6.0,
        }
    };
    let size: f64 = hull.faces.iter().map(part).sum();
    Some(Image { size: size.abs(), vertices })
}
