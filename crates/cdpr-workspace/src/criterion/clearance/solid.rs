//! Distances of convex bodies with few corners from boxes and struts.

use nalgebra::Vector3;

use super::{AxisBox, Segment};

/// Sines and fractions of the size below this are rounding.
const ROUNDING: f64 = 1e-9;

/// The convex hull of points.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    points: Vec<Vector3<f64>>,
    /// Triples of points that span a face.
    faces: Vec<[usize; 3]>,
    /// Pairs of points that include all edges.
    edges: Vec<[usize; 2]>,
    /// Normal of a body in a plane.
    plane_normal: Option<Vector3<f64>>,
}

/// Obstacle that a body keeps away from.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Other {
    Box(AxisBox),
    /// Axis of the strut; the caller adds its radius.
    Strut(Segment),
}

impl Solid {
    /// The hull of these points; `plane_normal` for bodies in a plane.
    pub(crate) fn over(points: Vec<Vector3<f64>>, plane_normal: Option<Vector3<f64>>) -> Self {
        let count = points.len();
        let triples = (0..count).flat_map(|a| (a + 1..count).flat_map(move |b| (b + 1..count).map(move |c| [a, b, c])));
        let faces: Vec<[usize; 3]> = match plane_normal {
            None => triples.filter(|triple| is_face(&points, triple)).collect(),
            Some(_) => Vec::new(),
        };
        let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| [a, b]));
        // points in a plane or on a line have few pairs
        let is_edge =
            |pair: &[usize; 2]| faces.is_empty() || faces.iter().any(|face| pair.iter().all(|end| face.contains(end)));
        let edges = pairs.filter(is_edge).collect();
        Self { points, faces, edges, plane_normal }
    }

    /// The body after a motion of its points.
    pub(crate) fn moved(&self, motion: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Self {
        Self { points: self.points.iter().map(motion).collect(), ..self.clone() }
    }

    /// Distance from the other body (m); if they overlap, minus the shortest translation that parts them.
    ///
    /// Two convex bodies that can be parted are parted along a normal to two of their edges: the depth is the least
    /// overlap along these normals. If they are apart, the nearest points are a corner and a face, or two edges.
    pub(crate) fn distance(&self, other: &Other) -> f64 {
        let size = self.points.iter().map(|point| (point - self.points[0]).norm()).fold(0.0, f64::max);
        match self.depth(other) {
            depth if depth > ROUNDING * size => -depth,
            _ => self.gap(other),
        }
    }

    /// The least overlap along any normal (m); 0 or less as soon as one normal parts the bodies.
    fn depth(&self, other: &Other) -> f64 {
        let mut least = f64::INFINITY;
        self.visit_normals(other, |normal| {
            let ([low, high], [other_low, other_high]) = (self.shadow(normal), other.shadow(normal));
            least = least.min(high - other_low).min(other_high - low);
            least > 0.0
        });
        if least.is_finite() { least } else { 0.0 }
    }

    /// Visits unit normals to two edges, one of which parts the bodies if any direction does, until `visit` returns
    /// false.
    fn visit_normals(&self, other: &Other, mut visit: impl FnMut(&Vector3<f64>) -> bool) {
        let mine = distinct(self.edges.iter().map(|[a, b]| self.points[*b] - self.points[*a]));
        let others = match other {
            Other::Box(solid) => {
                let axes = (0..3).filter(|&axis| solid.half_extent[axis].is_finite());
                axes.map(|axis| Vector3::from_fn(|row, _| f64::from(u8::from(row == axis)))).collect()
            }
            Other::Strut(axis) => distinct([axis.to - axis.from].into_iter()),
        };
        let all: Vec<Vector3<f64>> = mine.into_iter().chain(others).collect();
        let mut goes_on = |normal: Vector3<f64>| !(normal.norm() > ROUNDING) || visit(&normal.normalize());
        match self.plane_normal {
            Some(normal) => {
                // in a plane each edge has one normal
                let _ = all.iter().all(|edge| goes_on(normal.cross(edge)));
            }
            None => {
                let _ = all.iter().enumerate().all(|(index, a)| all[..index].iter().all(|b| goes_on(a.cross(b))));
            }
        }
    }

    /// Least and largest coordinate along a unit normal (m).
    fn shadow(&self, normal: &Vector3<f64>) -> [f64; 2] {
        let along = || self.points.iter().map(|point| normal.dot(point));
        [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// Interval (m) of a translation along a direction of length 1 in which the body overlaps with a box: overlap along
    /// every normal, each of them linear.
    pub(crate) fn overlap_along(&self, other: &Other, direction: &Vector3<f64>) -> [f64; 2] {
        let mut overlap = [f64::NEG_INFINITY, f64::INFINITY];
        self.visit_normals(other, |normal| {
            let ([low, high], [least, largest]) = (self.shadow(normal), other.shadow(normal));
            let speed = normal.dot(direction);
            // high + ρ speed > least and low + ρ speed < largest
            let ends = match speed == 0.0 {
                true if high > least && low < largest => return true,
                true => [f64::INFINITY, f64::NEG_INFINITY],
                false => [(least - high) / speed, (largest - low) / speed],
            };
            let ends = if speed == 0.0 { ends } else { [ends[0].min(ends[1]), ends[0].max(ends[1])] };
            overlap = [overlap[0].max(ends[0]), overlap[1].min(ends[1])];
            overlap[0] < overlap[1]
        });
        overlap
    }

    /// The distance of bodies that do not overlap (m).
    fn gap(&self, other: &Other) -> f64 {
        let edges = self.edges.iter().map(|[a, b]| Segment { from: self.points[*a], to: self.points[*b] });
        let of_edges = edges.map(|edge| match other {
            Other::Box(solid) => solid.distance(&edge).max(0.0),
            Other::Strut(axis) => axis.distance(&edge),
        });
        let corners = match other {
            Other::Box(solid) => solid.corners(),
            Other::Strut(axis) => vec![axis.from, axis.to],
        };
        let of_faces = self.faces.iter().flat_map(|face| {
            let corners = corners.iter();
            corners.filter_map(|corner| above(&face.map(|index| self.points[index]), corner))
        });
        of_edges.chain(of_faces).fold(f64::INFINITY, f64::min)
    }
}

impl Other {
    /// Least and largest coordinate along a unit normal (m).
    fn shadow(&self, normal: &Vector3<f64>) -> [f64; 2] {
        match self {
            Self::Box(solid) => {
                let finite = |axis: &usize| solid.half_extent[*axis].is_finite();
                let reach: f64 = (0..3).filter(finite).map(|axis| normal[axis].abs() * solid.half_extent[axis]).sum();
                let middle = normal.dot(&solid.center);
                [middle - reach, middle + reach]
            }
            Self::Strut(axis) => {
                let [from, to] = [normal.dot(&axis.from), normal.dot(&axis.to)];
                [from.min(to), from.max(to)]
            }
        }
    }
}

/// True if all points lie on one side of the plane through three of them.
fn is_face(points: &[Vector3<f64>], [a, b, c]: &[usize; 3]) -> bool {
    let (u, v) = (points[*b] - points[*a], points[*c] - points[*a]);
    let normal = u.cross(&v);
    let size = points.iter().map(|point| (point - points[*a]).norm()).fold(0.0, f64::max);
    if !(normal.norm() > ROUNDING * u.norm() * v.norm()) {
        return false;
    }
    let heights = || points.iter().map(|point| normal.normalize().dot(&(point - points[*a])));
    heights().all(|height| height <= ROUNDING * size) || heights().all(|height| height >= -ROUNDING * size)
}

/// Height of a point over a triangle (m); `None` if its foot lies outside.
fn above([a, b, c]: &[Vector3<f64>; 3], point: &Vector3<f64>) -> Option<f64> {
    let normal = (b - a).cross(&(c - a));
    let is_within =
        [(a, b), (b, c), (c, a)].iter().all(|(from, to)| normal.dot(&(*to - *from).cross(&(point - *from))) >= 0.0);
    is_within.then(|| normal.normalize().dot(&(point - a)).abs())
}

/// Directions of length 1, where opposite ones count as the same and appear once.
fn distinct(ways: impl Iterator<Item = Vector3<f64>>) -> Vec<Vector3<f64>> {
    let mut known: Vec<Vector3<f64>> = Vec::new();
    for way in ways.filter(|way| way.norm() > 0.0).map(|way| way.normalize()) {
        if known.iter().all(|other| other.cross(&way).norm() > ROUNDING) {
            known.push(way);
        }
    }
    known
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;

    /// The signed distance of convex bodies is the largest gap between their projections on a line: over 3000 lines,
    /// the best of which is turned further by ever smaller steps.
    fn by_shadows(solid: &Solid, other: &Other, rng: &mut ChaCha8Rng) -> f64 {
        let mut random = || Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0));
        let value = |normal: &Vector3<f64>| {
            let ([low, high], [least, largest]) = (solid.shadow(normal), other.shadow(normal));
            (least - high).max(low - largest)
        };
        let mut best = (f64::NEG_INFINITY, Vector3::x());
        for _ in 0..3000 {
            let normal = random().normalize();
            best = if value(&normal) > best.0 { (value(&normal), normal) } else { best };
        }
        for step in 0..3000 {
            let normal = (best.1 + random() * 0.5 * 0.997_f64.powi(step)).normalize();
            best = if value(&normal) > best.0 { (value(&normal), normal) } else { best };
        }
        best.0
    }

    /// The search stops within some 1e-4 of the size below the maximum, where it is slow at edges.
    #[test]
    fn distances_and_depths_are_the_largest_gaps_between_shadows() {
        let mut rng = ChaCha8Rng::seed_from_u64(84);
        let (mut over, mut apart) = (0, 0);
        for case in 0..60 {
            let mut random = |size: f64| Vector3::from_fn(|_, _| rng.random_range(-size..size));
            let flat = if case % 4 == 3 { 0.0 } else { 1.0 };
            let points: Vec<Vector3<f64>> =
                (0..4 + case % 6).map(|_| random(0.5).component_mul(&Vector3::new(1.0, 1.0, flat))).collect();
            let solid = Solid::over(points, None).moved(|point| point + Vector3::new(0.3, 0.0, 0.0));
            let (center, half) = (random(0.8), random(0.4).abs().add_scalar(0.01));
            let other = match case % 2 {
                0 => Other::Box(AxisBox { center, half_extent: half }),
                _ => Other::Strut(Segment { from: center, to: center + half * 2.0 }),
            };
            let (found, shadows) = (solid.distance(&other), by_shadows(&solid, &other, &mut rng));
            assert!(shadows <= found + 1e-9 && found < shadows + 2e-3, "case {case}: {found} {shadows}");
            *(if found < 0.0 { &mut over } else { &mut apart }) += 1;
        }
        assert!(over > 5 && apart > 5, "{over} {apart}");
    }

    #[test]
    fn the_distances_of_a_cube_are_known() {
        let cube =
            || (0..8).map(|k| Vector3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2))).collect();
        let solid = Solid::over(cube(), None);
        let at = |x: f64, y: f64, z: f64| {
            Other::Box(AxisBox { center: Vector3::new(x, y, z), half_extent: Vector3::repeat(0.25) })
        };
        assert!((solid.distance(&at(2.0, 0.5, 0.5)) - 0.75).abs() < 1e-12); // face to face
        assert!((solid.distance(&at(1.55, 1.65, 0.5)) - 0.5).abs() < 1e-12); // edge to edge: 0.3, 0.4
        assert!((solid.distance(&at(0.5, 0.5, 0.6)) + 0.65).abs() < 1e-12); // inside, out through the top
        let strut = Other::Strut(Segment { from: Vector3::new(-1.0, 0.5, 0.9), to: Vector3::new(2.0, 0.5, 0.9) });
        assert!((solid.distance(&strut) + 0.1).abs() < 1e-12);
        let square = cube_in_plane();
        let far = AxisBox { center: Vector3::new(2.0, 0.5, 0.0), half_extent: Vector3::new(0.25, 0.25, f64::INFINITY) };
        assert!((square.distance(&Other::Box(far)) - 0.75).abs() < 1e-12);
        let near = AxisBox { center: Vector3::new(1.0, 0.5, 0.0), ..far };
        assert!((square.distance(&Other::Box(near)) + 0.25).abs() < 1e-12);
    }

    fn cube_in_plane() -> Solid {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Vector3::new(x, y, 0.0));
        Solid::over(corners.to_vec(), Some(Vector3::z()))
    }
}
