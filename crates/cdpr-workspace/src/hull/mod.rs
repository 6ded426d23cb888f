//! The boundary of a region as seen from a point in it (Pott 2008): rays in all directions, each bisected.
//!
//! A region that is not star-shaped about the centre has rays that leave it and enter it again. These rays are counted,
//! and the hull then has no volume.

mod center;
mod location;
mod measure;
pub use center::{Center, find_center};
pub use location::Locator;
pub use measure::Measure;
pub use settings::Settings;
mod search;
mod section;
mod settings;
mod sphere;
mod surface;

use sphere::{circle, halvings_for, icosphere};

use super::{Audit, Bounds, Point, Region, WorkspaceError};

/// Outcome: whether the hull bounds the region.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Status {
    /// Rays leave the region once, as far as their probes show, except for slivers within the bound of the error.
    StarShaped,
    /// Rays enter the region again after they have left it: their first ends do not bound all of it.
    NotStarShaped {
        /// Number of such rays.
        rays: usize,
        /// Direction of the ray with the longest part inside after its return.
        direction: Point,
    },
    /// Points drawn at random belong to the region, but lie further outside the hull than the spacing of its rays
    /// explains ([`Hull::doubt`]): parts that no ray meets.
    LeavesOut {
        /// Least size of the part left out (m², m³).
        size: f64,
    },
}

/// The hull of a region.
#[must_use = "check `status` before using the size"]
#[derive(Clone, Debug)]
pub struct Hull {
    /// Centre at which the rays start (m).
    pub center: Point,
    /// Direction of each ray, of length 1.
    pub directions: Vec<Point>,
    /// Length of each ray within the region (m): the point there belongs to it, the point a tolerance further does not.
    pub radii: Vec<f64>,
    /// Faces between the rays, seen from outside in the positive sense; in the plane the third entry repeats the
    /// second.
    pub faces: Vec<[u32; 3]>,
    /// Rays that reach the faces of the box within the region, so that more of it may lie outside.
    pub rays_at_bounds: usize,
    /// Largest distance between the last point within and the first outside (m).
    pub tolerance: f64,
    /// Points judged.
    pub points: u64,
    /// Points that belong to the region.
    pub feasible_points: u64,
    /// Outcome of the search.
    pub status: Status,
    /// Rays that enter the region again after they have left it.
    pub rays_again: usize,
    /// Size of the region that they see after their return, which the hull leaves out (m², m³).
    pub left_out: f64,
    /// Faces between the rays of the refinement before.
    coarse_faces: Vec<[u32; 3]>,
    dimension: usize,
}

/// Looks for the hull of a region about a centre, within a box.
pub fn solve(
    region: &Region<'_>,
    bounds: &Bounds,
    center: &Point,
    settings: &Settings,
) -> Result<Hull, WorkspaceError> {
    check(region, bounds, center, settings)?;
    let sphere = match bounds.dimension() {
        2 => circle(settings.rays),
        _ => icosphere(halvings_for(settings.rays)),
    };
    let lengths: Vec<f64> = sphere.directions.iter().map(|direction| bounds.way_out(center, direction)).collect();
    let rays = search::Rays { region, center, directions: &sphere.directions, lengths: &lengths };
    let found = rays.search(settings);
    let mut hull = Hull {
        center: *center,
        radii: found.radii,
        rays_at_bounds: found.rays_at_bounds,
        points: found.points,
        feasible_points: found.feasible_points,
        status: Status::StarShaped,
        rays_again: found.reentry.rays,
        left_out: found.reentry.size,
        directions: sphere.directions,
        faces: sphere.faces,
        coarse_faces: sphere.coarse_faces,
        tolerance: settings.tolerance,
        dimension: bounds.dimension(),
    };
    let size = hull.measure().map_or(0.0, |measure| measure.size);
    if hull.left_out > SLIVER * size {
        hull.status = Status::NotStarShaped { rays: found.reentry.rays, direction: found.reentry.direction };
    }
    Ok(hull)
}

/// Fraction of the size that may be left out: near an anchor directions change so fast that a ray may leave and return.
const SLIVER: f64 = 1e-3;

fn check(region: &Region<'_>, bounds: &Bounds, center: &Point, settings: &Settings) -> Result<(), WorkspaceError> {
    let least = if bounds.dimension() == 2 { 3 } else { 4 };
    if settings.rays < least || settings.rays > MOST_RAYS {
        return Err(WorkspaceError::Rays { rays: settings.rays, least, most: MOST_RAYS });
    }
    // written so that NaN is refused too
    if !(settings.tolerance > 0.0 && settings.tolerance.is_finite()) {
        return Err(WorkspaceError::Tolerance { tolerance: settings.tolerance });
    }
    let words = || {
        let parts: Vec<String> = center.iter().take(bounds.dimension()).map(|part| part.to_string()).collect();
        parts.join(", ")
    };
    if !bounds.contain(center) {
        return Err(WorkspaceError::CenterOutsideBounds { center: words() });
    }
    match region.judge(center).reason {
        Some(reason) => Err(WorkspaceError::CenterOutside { center: words(), reason }),
        None => Ok(()),
    }
}

/// Most rays: the number after seven halvings of the icosahedron's edges.
pub(crate) const MOST_RAYS: usize = 10 * 4_usize.pow(7) + 2;

impl Hull {
    /// End point of a ray (m).
    pub fn vertex(&self, ray: usize) -> Point {
        [0, 1, 2].map(|axis| self.center[axis] + self.radii[ray] * self.directions[ray][axis])
    }

    /// End points of all rays (m).
    pub fn vertices(&self) -> Vec<Point> {
        (0..self.radii.len()).map(|ray| self.vertex(ray)).collect()
    }

    /// 2 in a plane, 3 in space.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// True if the hull bounds the region.
    pub fn is_star_shaped(&self) -> bool {
        self.status == Status::StarShaped
    }

    /// Changes the status if an audit of the hull has found more of the region outside than rays that miss a boundary
    /// between them explain: more than twice the difference to half as many rays along a line.
    pub fn doubt(&mut self, audit: &Audit) {
        let Some(measure) = self.measure() else { return };
        let size = audit.missed_at_least();
        if size > 2.0 * measure.error_bound + SLIVER * measure.size {
            self.status = Status::LeavesOut { size };
        }
    }

    /// The same rays with other lengths (m).
    pub(crate) fn with_radii(&self, radii: Vec<f64>) -> Self {
        Self { radii, ..self.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::sphere::Directions;
    use super::{Hull, Status};

    /// A surface about the origin with `length` the length of its ray in each direction.
    pub(super) fn hull_of(sphere: Directions, length: impl Fn([f64; 3]) -> f64) -> Hull {
        Hull {
            center: [0.0; 3],
            radii: sphere.directions.iter().map(|direction| length(*direction)).collect(),
            directions: sphere.directions,
            faces: sphere.faces,
            coarse_faces: sphere.coarse_faces,
            rays_at_bounds: 0,
            tolerance: 1e-9,
            points: 0,
            feasible_points: 0,
            status: Status::StarShaped,
            rays_again: 0,
            left_out: 0.0,
            dimension: 3,
        }
    }
}
