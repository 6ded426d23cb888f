//! Motion of the boundary of a region with a parameter, to first order (Pott 2018b, Sec. 3.5).
//!
//! On a ray the boundary lies where the margin m(ρ, p) is zero, so that it moves by dρ/dp = −(∂m/∂p)/(∂m/∂ρ). Margins
//! are piecewise smooth: the rate is that of the piece on which the ray ends.

use super::hull::Hull;
use super::{Point, Region};

/// Rates at which the ends of the rays move with a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// dρ/dp of each ray (m per unit of the parameter); `None` if the margin gives no rate, such as at the faces of the
    /// box.
    pub rates: Vec<Option<f64>>,
}

/// Steps of the differences that give the rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Differences {
    /// Change of the parameter from the hull's region to each of the two neighbouring regions (its unit).
    pub parameter: f64,
    /// Distance before and behind the end of a ray at which margins are compared (m).
    pub radius: f64,
}

/// The motion of a hull if a parameter of its criterion changes.
///
/// `below` and `above` are the region of the hull with the parameter changed down and up by `differences.parameter`.
pub fn motion(hull: &Hull, region: &Region<'_>, [below, above]: [&Region<'_>; 2], differences: Differences) -> Motion {
    let rate = |ray: usize| {
        // the boundary itself, not the last point within
        let end = hull.radii[ray] + 0.5 * hull.tolerance;
        let at =
            |radius: f64| -> Point { [0, 1, 2].map(|axis| hull.center[axis] + radius * hull.directions[ray][axis]) };
        let outwards =
            region.judge(&at(end + differences.radius)).margin - region.judge(&at(end - differences.radius)).margin;
        let by_parameter = above.judge(&at(end)).margin - below.judge(&at(end)).margin;
        let rate = -(by_parameter / differences.parameter) / (outwards / differences.radius);
        // a margin that grows outwards marks no boundary: the box cut the ray
        (outwards < 0.0 && rate.is_finite()).then_some(rate)
    };
    Motion { rates: (0..hull.radii.len()).map(rate).collect() }
}

impl Motion {
    /// The hull after a change of the parameter (its unit), to first order; rays without a rate stay.
    pub fn moved(&self, hull: &Hull, change: f64) -> Hull {
        let moved = hull.radii.iter().zip(&self.rates);
        hull.with_radii(moved.map(|(radius, rate)| (radius + rate.unwrap_or(0.0) * change).max(0.0)).collect())
    }

    /// Rate of the area (m² per unit) or volume (m³ per unit) inside the hull with the parameter.
    pub fn size_rate(&self, hull: &Hull) -> f64 {
        let by_face = hull.faces.iter().map(|face| {
            let rays = if hull.dimension() == 2 { &face[..2] } else { &face[..] };
            let relative = |&ray: &u32| self.rates[ray as usize].unwrap_or(0.0) / hull.radii[ray as usize];
            // a face encloses a size proportional to the product of the radii of its corners
            hull.face_size(face) * rays.iter().map(relative).sum::<f64>()
        });
        by_face.sum()
    }
}
