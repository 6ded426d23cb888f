//! Image of a region of commanded positions: the positions at which the platform comes to rest.

use super::Reachable;
use cdpr_model::geometry::Pose;
use cdpr_workspace::grid::Grid;
use cdpr_workspace::hull::Hull;
use cdpr_workspace::{Point, Region};

/// Size (m², m³) of the image of cells of commanded positions: the region of emerging positions.
///
/// Each cell counts with the determinant of ∂x̂/∂x, from differences over half a cell; a position reached twice counts
/// twice. `cells` are slab and index of the reached cells, as in [`Grid::point`].
pub fn emerging_size(reachable: &Reachable, region: &Region<'_>, grid: &Grid, cells: &[(usize, usize)]) -> f64 {
    let sizes = |cells: &[(usize, usize)]| {
        let middles: Vec<Point> = cells.iter().map(|&(slab, index)| grid.point(slab, index)).collect();
        stretches(reachable, region, grid, &middles)
    };
    // all sizes are computed before they are added: the order of a sum affects its last digits
    grid.cell_size() * reachable.driving().each_share(cells, sizes).iter().sum::<f64>()
}

/// |det ∂x̂/∂x| at commanded positions; 1 where a neighbour has no answer.
fn stretches(reachable: &Reachable, region: &Region<'_>, grid: &Grid, points: &[Point]) -> Vec<f64> {
    let dimension = region.dimension();
    let half = |axis: usize| 0.25 * grid.bounds().extent(axis) / grid.counts()[axis] as f64;
    let beside = |point: &Point, axis: usize, way: f64| {
        let mut point = *point;
        point[axis] += way;
        point
    };
    let around = |point: &Point| {
        let pair = |axis: usize| [-half(axis), half(axis)].map(|way| beside(point, axis, way));
        (0..dimension).flat_map(pair).collect::<Vec<_>>()
    };
    let neighbours: Vec<Point> = points.iter().flat_map(around).collect();
    let found = emerging(reachable, region, &neighbours);
    let determinant = |ends: &[Option<Point>]| {
        let mut jacobian = nalgebra::Matrix3::identity();
        for (axis, pair) in ends.chunks(2).enumerate() {
            let [Some(before), Some(behind)] = pair else { return 1.0 };
            for row in 0..dimension {
                jacobian[(row, axis)] = (behind[row] - before[row]) / (2.0 * half(axis));
            }
        }
        jacobian.determinant().abs()
    };
    found.chunks(2 * dimension).map(determinant).collect()
}

/// Positions at which the platform comes to rest when these are commanded, in the first orientation of the region.
fn emerging(reachable: &Reachable, region: &Region<'_>, points: &[Point]) -> Vec<Option<Point>> {
    let Some(&rotation) = region.orientations().first() else { return vec![None; points.len()] };
    let poses: Vec<Pose> = points.iter().map(|point| Pose { position: region.position(point), rotation }).collect();
    reachable.emerging_positions(region, &poses)
}

/// The image of a hull of commanded positions: the positions at which the platform comes to rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// The emerging position of each corner of the hull (m).
    pub vertices: Vec<Point>,
    /// Area (m²) or volume (m³) inside.
    pub size: f64,
}

/// The image of a hull; `None` if a corner has no answer.
pub fn image_of(reachable: &Reachable, region: &Region<'_>, hull: &Hull) -> Option<Image> {
    let ends = reachable.driving().each_share(&hull.vertices(), |corners| emerging(reachable, region, corners));
    let vertices: Vec<Point> = ends.into_iter().collect::<Option<_>>()?;
    // measured from a point inside, so that a hull far from the origin loses no digits
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
