//! Settings of a hull.

use crate::Bounds;

/// How many rays, and how exact.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Rays at least; in space as many as a refined icosahedron has corners: 12, 42, 162, 642, 2562, …
    pub rays: usize,
    /// A ray is bisected until its boundary is known to this (m).
    pub tolerance: f64,
    /// Points judged along each ray before it is bisected: what is thinner than their distance may be missed.
    pub probes: usize,
}

impl Settings {
    /// 360 rays in a plane, 2562 in space; probes at every 48th part of a ray; a millionth of the box.
    pub fn new(bounds: &Bounds) -> Self {
        let longest = (0..bounds.dimension()).map(|axis| bounds.extent(axis)).fold(0.0, f64::max);
        let rays = if bounds.dimension() == 2 { 360 } else { 2562 };
        Self { rays, tolerance: 1e-6 * longest, probes: 48 }
    }

    /// The same with so many points along all rays at most, as far as 162 rays allow; in a plane 360 rays are never too many.
    pub fn within(bounds: &Bounds, points: f64) -> Self {
        let usual = Self::new(bounds);
        let fits = |rays: &usize| (rays * usual.probes) as f64 <= points;
        let rays = if bounds.dimension() == 2 { usual.rays } else { [2562, 642].into_iter().find(fits).unwrap_or(162) };
        Self { rays, ..usual }
    }

    /// As after so many refinements: in a plane twice the rays with each, in space the corners of triangles cut into four.
    #[must_use]
    pub(crate) fn refined(&self, bounds: &Bounds, refinement: u32) -> Self {
        let rays = match bounds.dimension() {
            2 => self.rays << refinement,
            _ => (self.rays.saturating_sub(2) << (2 * refinement)) + 2,
        };
        Self { rays: if refinement == 0 { self.rays } else { rays }, ..self.clone() }
    }
}
