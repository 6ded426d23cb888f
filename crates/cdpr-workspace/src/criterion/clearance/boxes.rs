//! Distances between segments and boxes.

use nalgebra::Vector3;

use super::Segment;

/// A box along the world's axes (m); an infinite half extent leaves the box unbounded along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AxisBox {
    pub(crate) center: Vector3<f64>,
    pub(crate) half_extent: Vector3<f64>,
}

impl AxisBox {
    /// Distance of a segment from the box (m); if it passes through, minus the depth of its deepest point below the
    /// nearest face.
    pub(crate) fn distance(&self, segment: &Segment) -> f64 {
        let outside = self.outside(segment);
        if outside > 0.0 { outside } else { self.depth(segment).min(0.0) }
    }

    /// Corners of the box (m), or of a cross-section if an axis is unbounded.
    pub(crate) fn corners(&self) -> Vec<Vector3<f64>> {
        let half = self.half_extent.map(|half| if half.is_finite() { half } else { 0.0 });
        let sign = |corner: usize, axis: usize| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 };
        (0..8).map(|corner| self.center + Vector3::from_fn(|axis, _| sign(corner, axis) * half[axis])).collect()
    }

    /// The squared distance is convex along the segment, and a quadratic between the faces that it passes.
    fn outside(&self, segment: &Segment) -> f64 {
        let (start, way) = (segment.from - self.center, segment.to - segment.from);
        let mut parts = vec![0.0, 1.0];
        for axis in 0..3 {
            for side in [-self.half_extent[axis], self.half_extent[axis]] {
                let part = (side - start[axis]) / way[axis];
                if part > 0.0 && part < 1.0 {
                    parts.push(part);
                }
            }
        }
        parts.sort_by(f64::total_cmp);
        let mut nearest = f64::INFINITY;
        for pair in parts.windows(2) {
            let middle = 0.5 * (pair[0] + pair[1]);
            let (mut slope, mut curvature) = (0.0, 0.0);
            for axis in 0..3 {
                let place = start[axis] + middle * way[axis];
                if place.abs() > self.half_extent[axis] {
                    let beyond = start[axis] - self.half_extent[axis].copysign(place);
                    slope += beyond * way[axis];
                    curvature += way[axis] * way[axis];
                }
            }
            let best = if curvature > 0.0 { (-slope / curvature).clamp(pair[0], pair[1]) } else { middle };
            for part in [pair[0], best, pair[1]] {
                nearest = nearest.min(self.distance_of_point(&(start + way * part)));
            }
        }
        nearest
    }

    /// Distance of a point, relative to the centre, from the box; 0 inside.
    fn distance_of_point(&self, point: &Vector3<f64>) -> f64 {
        Vector3::from_fn(|axis, _| (point[axis].abs() - self.half_extent[axis]).max(0.0)).norm()
    }

    /// min over the segment of the max over faces of the distance to leave through them: the least value of a maximum
    /// of lines lies where two of them meet, or at an end.
    fn depth(&self, segment: &Segment) -> f64 {
        let (start, way) = (segment.from - self.center, segment.to - segment.from);
        let axes: Vec<usize> = (0..3).filter(|&axis| self.half_extent[axis].is_finite()).collect();
        let lines: Vec<(f64, f64)> = axes
            .iter()
            .flat_map(|&axis| [1.0, -1.0].map(|side| (side * start[axis] - self.half_extent[axis], side * way[axis])))
            .collect();
        let highest = |part: f64| lines.iter().map(|(at, slope)| at + part * slope).fold(f64::NEG_INFINITY, f64::max);
        let mut least = highest(0.0).min(highest(1.0));
        for (index, (at, slope)) in lines.iter().enumerate() {
            for (other_at, other_slope) in &lines[index + 1..] {
                let part = (other_at - at) / (slope - other_slope);
                if part > 0.0 && part < 1.0 {
                    least = least.min(highest(part));
                }
            }
        }
        least
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;

    /// Against 2000 points of the segment, at most 2 mm apart.
    #[test]
    fn distances_and_depths_are_those_of_densely_sampled_points() {
        let mut rng = ChaCha8Rng::seed_from_u64(82);
        let (mut through, mut past) = (0, 0);
        for case in 0..400 {
            let mut random = |size: f64| Vector3::from_fn(|_, _| rng.random_range(-size..size));
            let solid = AxisBox { center: random(0.3), half_extent: random(0.5).abs() };
            let mut segment = Segment { from: random(1.0), to: random(1.0) };
            if case % 5 == 0 {
                segment.to.x = segment.from.x; // along a face
            }
            let signed = |part: f64| {
                let place = (segment.at(part) - solid.center).abs() - solid.half_extent;
                let outside = place.map(|x| x.max(0.0)).norm();
                if outside > 0.0 { outside } else { place.max() }
            };
            let sampled = (0..=2000).map(|step| signed(f64::from(step) / 2000.0)).fold(f64::INFINITY, f64::min);
            let found = solid.distance(&segment);
            assert!(found <= sampled + 1e-12 && sampled < found + 2e-3, "case {case}: {found} {sampled}");
            *(if found < 0.0 { &mut through } else { &mut past }) += 1;
        }
        assert!(through > 50 && past > 50, "{through} {past}");
    }

    #[test]
    fn a_box_without_an_axis_is_as_deep_as_you_like() {
        let solid = AxisBox { center: Vector3::zeros(), half_extent: Vector3::new(1.0, f64::INFINITY, 2.0) };
        let past = Segment { from: Vector3::new(3.0, 7.0, -5.0), to: Vector3::new(3.0, 7.0, 5.0) };
        assert_eq!(solid.distance(&past), 2.0);
        let through = Segment { from: Vector3::new(0.5, 7.0, -5.0), to: Vector3::new(0.5, 7.0, 5.0) };
        assert_eq!(solid.distance(&through), -0.5);
    }
}
