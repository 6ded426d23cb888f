//! The cone of directions from a point into a convex body.

use nalgebra::Vector3;

/// Lengths and sines below this are rounding.
const ROUNDING: f64 = 1e-9;

/// The cone of directions from an apex to the points of a convex body, by the outward normals of its sides.
///
/// It is all of space, without sides, if the apex lies inside the body.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cone {
    sides: Vec<Vector3<f64>>,
}

impl Cone {
    /// The cone from `apex` over the convex hull of the points; `plane_normal` for bodies in a plane.
    ///
    /// Each side contains two edges (directions to points) and has all others on one side: every pair is tried. A body
    /// without volume has a flat cone, whose sides are both orientations of its plane and those across its edges.
    pub(crate) fn over(apex: &Vector3<f64>, points: &[Vector3<f64>], plane_normal: Option<Vector3<f64>>) -> Self {
        let size = points.iter().map(|point| (point - apex).norm()).fold(0.0, f64::max);
        let far = points.iter().map(|point| point - apex).filter(|way| way.norm() > ROUNDING * size);
        let edges: Vec<Vector3<f64>> = far.map(|way| way.normalize()).collect();
        let mut cone = Self { sides: Vec::new() };
        if let Some(normal) = plane_normal {
            edges.iter().for_each(|edge| cone.try_side(&normal.cross(edge), &edges));
            return cone;
        }
        for (index, first) in edges.iter().enumerate() {
            edges[index + 1..].iter().for_each(|second| cone.try_side(&first.cross(second), &edges));
        }
        cone.add_edges_of_flat(&edges);
        cone
    }

    /// Keeps ±normal as a side if no edge lies beyond it.
    fn try_side(&mut self, normal: &Vector3<f64>, edges: &[Vector3<f64>]) {
        let length = normal.norm();
        if length < ROUNDING {
            return;
        }
        for side in [normal / length, -normal / length] {
            let is_outermost = edges.iter().all(|edge| side.dot(edge) <= ROUNDING);
            if is_outermost && self.sides.iter().all(|known| (known - side).norm() > ROUNDING) {
                self.sides.push(side);
            }
        }
    }

    /// A cone between two opposite sides is flat and needs the sides across its edges too.
    fn add_edges_of_flat(&mut self, edges: &[Vector3<f64>]) {
        let flat = self.sides.iter().find(|side| self.sides.iter().any(|other| (*side + other).norm() < ROUNDING));
        if let Some(normal) = flat.copied() {
            edges.iter().for_each(|edge| self.try_side(&normal.cross(edge), edges));
        }
    }

    /// True if the apex lies inside the body.
    pub(crate) fn is_everything(&self) -> bool {
        self.sides.is_empty()
    }

    /// Angle between a unit direction and the nearest side (rad). Outside it is positive, at most the angle to the cone
    /// and equal to it beside a side; inside it is negative and exact. −π/2 if the cone is all of space.
    pub(crate) fn angle(&self, direction: &Vector3<f64>) -> f64 {
        let sine = self.sides.iter().map(|side| side.dot(direction)).fold(-1.0, f64::max);
        sine.clamp(-1.0, 1.0).asin()
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;

    fn cube() -> Vec<Vector3<f64>> {
        (0..8).map(|k| Vector3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2))).collect()
    }

    /// From a corner of a cube the cone is an octant, from the middle of a face a half-space, from inside all of space.
    #[test]
    fn the_cones_of_a_cube_are_known() {
        let diagonal = Vector3::repeat(1.0).normalize();
        let corner = Cone::over(&Vector3::zeros(), &cube(), None);
        assert_eq!(corner.sides.len(), 3);
        assert!((corner.angle(&diagonal) + (1.0 / 3_f64.sqrt()).asin()).abs() < 1e-12);
        assert!((corner.angle(&-Vector3::x()) - std::f64::consts::FRAC_PI_2).abs() < 1e-7);
        let face = Cone::over(&Vector3::new(0.5, 0.5, 1.0), &cube(), None);
        assert!((face.angle(&Vector3::new(0.6, 0.0, 0.8)) - 0.8_f64.asin()).abs() < 1e-12);
        assert!((face.angle(&Vector3::new(0.6, 0.0, -0.8)) + 0.8_f64.asin()).abs() < 1e-12);
        assert!(Cone::over(&Vector3::repeat(0.5), &cube(), None).is_everything());
    }

    /// A direction is inside the cone exactly when a ray meets the hull: sampled by random points of the hull.
    #[test]
    fn rays_that_hit_the_body_are_inside_the_cone() {
        let mut rng = ChaCha8Rng::seed_from_u64(83);
        for case in 0..200 {
            let points: Vec<Vector3<f64>> =
                (0..rng.random_range(4..12)).map(|_| Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0))).collect();
            let apex = match case % 2 {
                0 => Vector3::from_fn(|_, _| rng.random_range(1.5..3.0)),
                _ => points[0],
            };
            let cone = Cone::over(&apex, &points, None);
            if cone.is_everything() {
                continue; // the first point may lie inside the others' hull
            }
            for _ in 0..20 {
                let weights: Vec<f64> = points.iter().map(|_| rng.random_range(0.0..1.0)).collect();
                let sum: f64 = weights.iter().sum();
                let within = points.iter().zip(&weights).map(|(point, weight)| point * *weight).sum::<Vector3<f64>>();
                let direction = (within / sum - apex).normalize();
                assert!(cone.angle(&direction) < 1e-9, "case {case}");
                assert!(cone.angle(&-direction) > 0.0, "case {case}");
            }
        }
    }

    #[test]
    fn a_plate_is_touched_only_in_its_plane_and_a_planar_body_in_its_corner() {
        let plate: Vec<Vector3<f64>> = cube().into_iter().filter(|point| point.z == 0.0).collect();
        let cone = Cone::over(&Vector3::zeros(), &plate, None);
        assert!((cone.angle(&Vector3::new(0.6, 0.0, 0.8)) - 0.8_f64.asin()).abs() < 1e-12);
        assert!(cone.angle(&Vector3::new(0.6, 0.8, 0.0)).abs() < 1e-12);
        assert!((cone.angle(&Vector3::new(0.8, -0.6, 0.0)) - 0.6_f64.asin()).abs() < 1e-12);
        let planar = Cone::over(&Vector3::zeros(), &plate, Some(Vector3::z()));
        assert!((planar.angle(&Vector3::new(0.8, 0.6, 0.0)) + 0.6_f64.asin()).abs() < 1e-12);
        assert!((planar.angle(&Vector3::new(0.8, -0.6, 0.0)) - 0.6_f64.asin()).abs() < 1e-12);
    }
}
