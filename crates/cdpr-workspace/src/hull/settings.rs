//! Settings of a hull.

use crate::Bounds;

/// Number and accuracy of the rays of a hull.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Least number of rays; in space rounded up to the corners of a refined icosahedron: 12, 42, 162, 642, 2562, …
    pub rays: usize,
    /// Length of the bracket at which bisection ends (m).
    pub tolerance: f64,
    /// Points judged along each ray before it is bisected: parts thinner than their distance may be missed.
    pub probes: usize,
}

impl Settings {
    /// 360 rays in a plane, 2562 in space; 48 probes per ray; a millionth of the box.
    pub fn new(bounds: &Bounds) -> Self {
        let longest = (0..bounds.dimension()).map(|axis| bounds.extent(axis)).fold(0.0, f64::max);
        let rays = if bounds.dimension() == 2 { 360 } else { 2562 };
        Self { rays, tolerance: 1e-6 * longest, probes: 48 }
    }

    /// The same with at most `points` points along all rays, but no fewer than 162 rays in space; 360 rays in a plane.
    pub fn within(bounds: &Bounds, points: f64) -> Self {
        let usual = Self::new(bounds);
        let fits = |rays: &usize| (rays * usual.probes) as f64 <= points;
        let rays = if bounds.dimension() == 2 { usual.rays } else { [2562, 642].into_iter().find(fits).unwrap_or(162) };
        Self { rays, ..usual }
    }

    /// Settings after `refinement` refinements: in a plane each doubles the rays, in space each cuts the triangles into
    /// four.
    #[must_use]
    pub(crate) fn refined(&self, bounds: &Bounds, refinement: u32) -> Self {
        let rays = match bounds.dimension() {
            2 => self.rays << refinement,
            _ => (self.rays.saturating_sub(2) << (2 * refinement)) + 2,
        };
        Self { rays: if refinement == 0 { self.rays } else { rays }, ..self.clone() }
    }
}
