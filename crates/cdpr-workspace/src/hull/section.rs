//! The horizontal section of a hull through its centre.

use super::Hull;
use crate::Point;

/// Rise below which a ray counts as level: rounding errors of a refined icosahedron.
const LEVEL: f64 = 1e-12;

impl Hull {
    /// Section of the surface by the plane through the centre on which the last coordinate is constant: points (m) in
    /// order around the centre; in a plane the corners themselves.
    ///
    /// Hulls along the same rays have as many points, each in the same direction from the centre.
    pub fn section(&self) -> Vec<Point> {
        if self.dimension == 2 {
            return self.vertices();
        }
        let rise = |ray: u32| match self.directions[ray as usize][2] {
            rise if rise.abs() < LEVEL => 0.0,
            rise => rise,
        };
        let sides = self.faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        // two faces share a side, which they run through in opposite senses
        let crossed = sides.filter(|&[a, b]| a < b && rise(a) * rise(b) < 0.0);
        let level = (0..self.radii.len() as u32).filter(|&ray| rise(ray) == 0.0);
        let mut points: Vec<(f64, Point)> =
            level.map(|ray| [ray, ray]).chain(crossed).map(|side| self.crossing(side)).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points.into_iter().map(|(_, point)| point).collect()
    }

    /// Azimuth and position at which the side between two rays, or one level ray, meets the plane.
    fn crossing(&self, [a, b]: [u32; 2]) -> (f64, Point) {
        let [first, second] = [a, b].map(|ray| self.directions[ray as usize]);
        let fraction = |from: f64, to: f64| if from == to { 0.0 } else { from / (from - to) };
        let between = |from: Point, to: Point, fraction: f64| {
            [0, 1, 2].map(|axis| from[axis] + fraction * (to[axis] - from[axis]))
        };
        let direction = between(first, second, fraction(first[2], second[2]));
        let [below, above] = [a, b].map(|ray| self.radii[ray as usize] * self.directions[ray as usize][2]);
        let mut point = between(self.vertex(a as usize), self.vertex(b as usize), fraction(below, above));
        point[2] = self.center[2];
        (direction[1].atan2(direction[0]), point)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Hull;
    use super::super::sphere::icosphere;
    use super::super::tests::hull_of;

    /// A surface about a centre with `length` the length of its ray in each direction.
    fn hull(center: [f64; 3], length: impl Fn([f64; 3]) -> f64) -> Hull {
        Hull { center, ..hull_of(icosphere(3), length) }
    }

    /// 642 rays are 8.9° apart at most, so that their polyhedron lies within 0.5 % of the sphere.
    #[test]
    fn the_section_of_a_sphere_runs_once_around_a_level_circle() {
        let section = hull([1.0, -2.0, 5.0], |_| 3.0).section();
        let mut turned = 0.0;
        for (point, next) in section.iter().zip(section.iter().cycle().skip(1)) {
            let beside = |point: &[f64; 3]| (point[0] - 1.0, point[1] + 2.0);
            let ((x, y), (u, v)) = (beside(point), beside(next));
            assert!((x.hypot(y) / 3.0 - 0.9975).abs() < 0.0026 && point[2] == 5.0, "{point:?}");
            turned += (x * v - y * u).atan2(x * u + y * v);
            assert!((x * v - y * u) > 0.0, "{point:?} {next:?}");
        }
        assert!((turned - std::f64::consts::TAU).abs() < 1e-9);
    }

    #[test]
    fn sections_along_the_same_rays_have_their_points_in_the_same_directions() {
        let [round, dented] = [hull([0.0; 3], |_| 1.0), hull([0.0; 3], |[x, y, z]| 1.0 + 0.3 * x - 0.2 * y * z)];
        let (round, dented) = (round.section(), dented.section());
        assert_eq!(round.len(), dented.len());
        for (a, b) in round.iter().zip(&dented) {
            assert!((a[0] * b[1] - a[1] * b[0]).abs() < 1e-12 && a[0] * b[0] + a[1] * b[1] > 0.0);
        }
    }
}
