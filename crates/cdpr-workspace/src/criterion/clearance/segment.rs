//! Straight lines between two points.

use nalgebra::Vector3;

/// The straight line between two points (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Segment {
    pub(crate) from: Vector3<f64>,
    pub(crate) to: Vector3<f64>,
}

impl Segment {
    /// The point at the fraction `part` of the segment, 0 to 1.
    pub(super) fn at(&self, part: f64) -> Vector3<f64> {
        self.from + (self.to - self.from) * part
    }

    /// Distance of a point (m).
    pub(crate) fn distance_to_point(&self, point: &Vector3<f64>) -> f64 {
        let way = self.to - self.from;
        let square = way.norm_squared();
        let part = if square > 0.0 { (way.dot(&(point - self.from)) / square).clamp(0.0, 1.0) } else { 0.0 };
        (self.at(part) - point).norm()
    }

    /// Distance of another segment (m).
    ///
    /// The nearest points are an end of one segment, or the feet of the common perpendicular of the two lines.
    pub(crate) fn distance(&self, other: &Self) -> f64 {
        self.perpendicular(other).map_or(f64::INFINITY, |(_, length)| length).min(self.distance_of_ends(other))
    }

    /// Distance of a segment in the same plane (m). If they cross, minus the least length by which one has to be moved
    /// along itself or along the other one to part them: continuous through the crossing.
    pub(crate) fn distance_in_plane(&self, other: &Self) -> f64 {
        let ends = self.distance_of_ends(other);
        if self.perpendicular(other).is_some() { -ends } else { ends }
    }

    /// Least distance of an end to the other segment (m).
    fn distance_of_ends(&self, other: &Self) -> f64 {
        let mine = self.distance_to_point(&other.from).min(self.distance_to_point(&other.to));
        mine.min(other.distance_to_point(&self.from)).min(other.distance_to_point(&self.to))
    }

    /// Position of the foot of the common perpendicular on this segment (0 to 1), and its length (m); `None` if it does
    /// not meet both.
    fn perpendicular(&self, other: &Self) -> Option<(f64, f64)> {
        let (u, v, between) = (self.to - self.from, other.to - other.from, other.from - self.from);
        let normal = u.cross(&v);
        let square = normal.norm_squared();
        // for parallel segments an end is among the nearest points
        if !(square > 1e-24 * u.norm_squared() * v.norm_squared()) {
            return None;
        }
        let part = between.cross(&v).dot(&normal) / square;
        let other_part = between.cross(&u).dot(&normal) / square;
        let within = |part: f64| (0.0..=1.0).contains(&part);
        (within(part) && within(other_part)).then(|| (part, between.dot(&normal).abs() / square.sqrt()))
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;

    fn random(rng: &mut ChaCha8Rng) -> Vector3<f64> {
        Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0))
    }

    /// 400 × 400 points: off by at most half a step of 3.5/400 m at the nearest points, on either segment.
    #[test]
    fn distances_are_those_of_densely_sampled_points() {
        let mut rng = ChaCha8Rng::seed_from_u64(81);
        for case in 0..60 {
            let mut segment = || Segment { from: random(&mut rng), to: random(&mut rng) };
            let (a, mut b) = (segment(), segment());
            if case % 5 == 0 {
                b.to = b.from + (a.to - a.from) * 0.7; // parallel
            }
            let parts = || (0..=400).map(|step| f64::from(step) / 400.0);
            let sampled = parts().map(|part| b.distance_to_point(&a.at(part))).fold(f64::INFINITY, f64::min);
            assert!(a.distance(&b) <= sampled + 1e-12 && sampled < a.distance(&b) + 0.005, "case {case}");
            let point = b.from;
            let sampled = parts().map(|part| (a.at(part) - point).norm()).fold(f64::INFINITY, f64::min);
            assert!(a.distance_to_point(&point) <= sampled + 1e-12 && sampled < a.distance_to_point(&point) + 0.005);
            assert!((a.distance(&b) - b.distance(&a)).abs() < 1e-12);
        }
    }

    #[test]
    fn segments_that_cross_in_a_plane_are_apart_by_less_than_nothing() {
        let line = |x: f64, y: f64, to: [f64; 2]| Segment {
            from: Vector3::new(x, y, 0.0),
            to: Vector3::new(to[0], to[1], 0.0),
        };
        let (level, upright) = (line(0.0, 0.0, [4.0, 0.0]), |foot: f64| line(1.0, foot, [1.0, 2.0]));
        for (foot, distance) in [(0.5, 0.5), (0.0, 0.0), (-0.25, -0.25), (-3.0, -1.0)] {
            assert!((level.distance_in_plane(&upright(foot)) - distance).abs() < 1e-12, "{foot}");
        }
        let point = Segment { from: Vector3::zeros(), to: Vector3::zeros() };
        assert_eq!(point.distance(&point), 0.0);
    }
}
