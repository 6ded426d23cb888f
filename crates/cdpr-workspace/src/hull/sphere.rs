//! Directions spread evenly over the circle and the sphere; each refinement contains the one before.

use std::collections::HashMap;

use crate::Point;

/// Directions of length 1 and the faces between them: triangles in space, pairs in the plane.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Directions {
    pub(super) directions: Vec<Point>,
    /// Faces between neighbours, seen from outside in the positive sense; in the plane the third entry repeats the
    /// second.
    pub(super) faces: Vec<[u32; 3]>,
    /// Faces between the directions of the refinement before; empty if there is none.
    pub(super) coarse_faces: Vec<[u32; 3]>,
}

/// Evenly spread directions in the plane, starting at the first axis; every second one is the refinement before.
pub(super) fn circle(count: usize) -> Directions {
    let at = |index: usize| {
        let (sin, cos) = (std::f64::consts::TAU * index as f64 / count as f64).sin_cos();
        [cos, sin, 0.0]
    };
    let closed = |step: usize| -> Vec<[u32; 3]> {
        let indices: Vec<u32> = (0..count as u32).step_by(step).collect();
        let next = indices.iter().cycle().skip(1);
        indices.iter().zip(next).map(|(&from, &to)| [from, to, to]).collect()
    };
    Directions { directions: (0..count).map(at).collect(), faces: closed(1), coarse_faces: closed(2) }
}

/// Eight halvings make more than half a million directions.
const MOST_HALVINGS: u32 = 8;

/// Fewest halvings of the icosahedron's edges that give at least `count` directions: 12, 42, 162, 642, 2562, …
pub(super) fn halvings_for(count: usize) -> u32 {
    (0..MOST_HALVINGS).find(|halvings| 10 * 4_usize.pow(*halvings) + 2 >= count).unwrap_or(MOST_HALVINGS)
}

/// The corners of an icosahedron after `halvings` halvings of its edges, projected to the sphere.
pub(super) fn icosphere(halvings: u32) -> Directions {
    let mut sphere = icosahedron();
    for _ in 0..halvings {
        sphere = halved(sphere);
    }
    sphere
}

pub(super) fn icosahedron() -> Directions {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut directions = Vec::with_capacity(12);
    for axis in 0..3 {
        for [short, long] in [[-1.0, golden], [1.0, golden], [-1.0, -golden], [1.0, -golden]] {
            let mut corner = [0.0; 3];
            (corner[axis], corner[(axis + 1) % 3]) = (short, long);
            directions.push(unit(corner));
        }
    }
    // three corners make a face where each two are neighbours: at an angle with cosine 1/√5
    let near = |a: usize, b: usize| dot(&directions[a], &directions[b]) > 0.4;
    let mut faces = Vec::with_capacity(20);
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    let is_positive = dot(&directions[a], &cross(&directions[b], &directions[c])) > 0.0;
                    faces.push(if is_positive { [a, b, c] } else { [a, c, b] }.map(|corner| corner as u32));
                }
            }
        }
    }
    Directions { directions, faces, coarse_faces: Vec::new() }
}

/// Cuts each face into four at the middles of its edges.
fn halved(sphere: Directions) -> Directions {
    let Directions { mut directions, faces: coarse_faces, .. } = sphere;
    let mut middles: HashMap<(u32, u32), u32> = HashMap::new();
    let mut faces = Vec::with_capacity(4 * coarse_faces.len());
    for &[a, b, c] in &coarse_faces {
        let mut middle = |from: u32, to: u32| {
            *middles.entry((from.min(to), from.max(to))).or_insert_with(|| {
                let (p, q) = (directions[from as usize], directions[to as usize]);
                directions.push(unit([0, 1, 2].map(|axis| p[axis] + q[axis])));
                directions.len() as u32 - 1
            })
        };
        let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
        faces.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    Directions { directions, faces, coarse_faces }
}

pub(super) fn dot(a: &Point, b: &Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: &Point, b: &Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn unit(vector: Point) -> Point {
    let length = dot(&vector, &vector).sqrt();
    vector.map(|part| part / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refined_icosahedra_have_the_known_numbers_of_corners_and_contain_each_other() {
        for (halvings, corners) in [(0, 12), (1, 42), (2, 162), (3, 642), (4, 2562)] {
            let sphere = icosphere(halvings);
            assert_eq!((sphere.directions.len(), sphere.faces.len()), (corners, 2 * corners - 4)); // Euler
            assert_eq!(halvings_for(corners), halvings);
            if halvings > 0 {
                let coarse = icosphere(halvings - 1);
                assert_eq!(sphere.directions[..coarse.directions.len()], coarse.directions[..]);
                assert_eq!(sphere.coarse_faces, coarse.faces);
            }
        }
        assert_eq!(halvings_for(643), 4);
    }

    /// Faces of the unit sphere are seen from outside: each adds volume, and the sum tends to 4π/3.
    #[test]
    fn the_volume_of_refined_spheres_tends_to_that_of_the_sphere() {
        let volume = |halvings: u32| -> f64 {
            let Directions { directions, faces, .. } = icosphere(halvings);
            let parts = faces.iter().map(|face| {
                let [a, b, c] = face.map(|corner| directions[corner as usize]);
                dot(&a, &cross(&b, &c)) / 6.0
            });
            parts.inspect(|part| assert!(*part > 0.0)).sum()
        };
        let exact = 4.0 / 3.0 * std::f64::consts::PI;
        let [third, fourth] = [3, 4].map(|halvings| exact - volume(halvings));
        // the error of a polyhedron with its corners on the sphere falls with the square of the edge
        assert!(third > 0.0 && (third / fourth - 4.0).abs() < 0.1, "{third} {fourth}");
    }
}
