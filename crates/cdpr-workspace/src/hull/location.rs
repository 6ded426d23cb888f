//! The face of a hull in the direction of a point.

use super::sphere::{cross, dot, icosahedron, unit};
use super::{Hull, Point};

/// Test of whether points lie inside a hull.
pub struct Locator<'a> {
    hull: &'a Hull,
    /// Faces of the icosahedron that the hull's faces refine; empty in a plane.
    coarsest: Vec<[Point; 3]>,
    /// Number of times that these were cut into four.
    halvings: u32,
}

impl<'a> Locator<'a> {
    /// A locator of this hull.
    pub fn new(hull: &'a Hull) -> Self {
        if hull.dimension == 2 {
            return Self { hull, coarsest: Vec::new(), halvings: 0 };
        }
        let sphere = icosahedron();
        let coarsest = sphere.faces.iter().map(|face| face.map(|corner| sphere.directions[corner as usize])).collect();
        let halvings = (hull.faces.len() / sphere.faces.len()).ilog(4);
        Self { hull, coarsest, halvings }
    }

    /// True if the point lies between the centre and a face.
    pub fn contains(&self, point: &Point) -> bool {
        let away = [0, 1, 2].map(|axis| point[axis] - self.hull.center[axis]);
        let Some(face) = self.hull.faces.get(self.face(&away)) else { return false };
        let corner = |ray: u32| self.hull.directions[ray as usize].map(|part| part * self.hull.radii[ray as usize]);
        let [a, b, c] = face.map(corner);
        let (whole, part) = match self.hull.dimension {
            2 => (cross(&a, &b)[2], cross(&away, &b)[2] + cross(&a, &away)[2]),
            _ => {
                let normal = cross(&[0, 1, 2].map(|k| b[k] - a[k]), &[0, 1, 2].map(|k| c[k] - a[k]));
                (dot(&a, &normal), dot(&away, &normal))
            }
        };
        // a face through the centre encloses nothing
        whole > 0.0 && part <= whole
    }

    /// Index of the face in a direction from the centre.
    fn face(&self, away: &Point) -> usize {
        if self.hull.dimension == 2 {
            let turn = away[1].atan2(away[0]).rem_euclid(std::f64::consts::TAU) / std::f64::consts::TAU;
            return ((turn * self.hull.faces.len() as f64) as usize).min(self.hull.faces.len() - 1);
        }
        let inward = |[a, b, c]: &[Point; 3]| {
            let sides = [cross(a, b), cross(b, c), cross(c, a)];
            sides.iter().map(|normal| dot(normal, away)).fold(f64::INFINITY, f64::min)
        };
        let nearest = (0..self.coarsest.len())
            .max_by(|&i, &j| inward(&self.coarsest[i]).total_cmp(&inward(&self.coarsest[j])))
            .unwrap_or(0);
        let (mut index, mut corners) = (nearest, self.coarsest[nearest]);
        for _ in 0..self.halvings {
            let (quarter, smaller) = quarter(&corners, away);
            (index, corners) = (4 * index + quarter, smaller);
        }
        index
    }
}

/// The quarter of a triangle, cut at the middles of its sides, in a direction; numbered as in the refined icosahedron.
fn quarter([a, b, c]: &[Point; 3], away: &Point) -> (usize, [Point; 3]) {
    let middle = |p: &Point, q: &Point| unit([0, 1, 2].map(|axis| p[axis] + q[axis]));
    let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    let is_beyond = |p: &Point, q: &Point| dot(&cross(p, q), away) > 0.0;
    match (is_beyond(&ab, &ca), is_beyond(&bc, &ab), is_beyond(&ca, &bc)) {
        (true, _, _) => (0, [*a, ab, ca]),
        (_, true, _) => (1, [ab, *b, bc]),
        (_, _, true) => (2, [ca, bc, *c]),
        _ => (3, [ab, bc, ca]),
    }
}

#[cfg(test)]
mod tests {
    use super::super::sphere::icosphere;
    use super::*;

    /// The middle of every face, seen from the centre, lies behind that face and no other.
    #[test]
    fn the_middle_of_a_face_lies_behind_it() {
        for halvings in 0..4 {
            let sphere = icosphere(halvings);
            let hull = super::super::tests::hull_of(sphere, |_| 2.0);
            let locator = Locator::new(&hull);
            for (index, face) in hull.faces.iter().enumerate() {
                let corners = face.map(|ray| hull.directions[ray as usize]);
                let middle = [0, 1, 2].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f64>() / 3.0);
                assert_eq!(locator.face(&middle), index, "{halvings}");
                let at = |fraction: f64| [0, 1, 2].map(|axis| hull.center[axis] + fraction * middle[axis]);
                assert!(locator.contains(&at(1.999)) && !locator.contains(&at(2.001)), "{halvings} {index}");
            }
        }
    }
}
