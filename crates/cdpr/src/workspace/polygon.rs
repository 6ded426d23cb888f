//! Areas in the plane of a planar robot.

use super::hull::Hull;

/// A closed outline in the plane (m).
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// Corners in order, without the first one again at the end (m).
    pub vertices: Vec<[f64; 2]>,
}

impl Polygon {
    /// Outline of the hull of a planar region; nothing in space, or where the region is not star-shaped.
    pub fn of(hull: &Hull) -> Option<Self> {
        let vertices = || hull.vertices().iter().map(|point| [point[0], point[1]]).collect();
        (hull.dimension() == 2 && hull.is_star_shaped()).then(|| Self { vertices: vertices() })
    }

    fn edges(&self) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
        let next = self.vertices.iter().cycle().skip(1);
        self.vertices.iter().zip(next).map(|(from, to)| (*from, *to))
    }

    /// Area (m²), positive where the corners go round from the first axis to the second.
    pub fn area(&self) -> f64 {
        self.edges().map(|(p, q)| 0.5 * (p[0] * q[1] - p[1] * q[0])).sum()
    }

    /// Length of the outline (m).
    pub fn perimeter(&self) -> f64 {
        self.edges().map(|(p, q)| (q[0] - p[0]).hypot(q[1] - p[1])).sum()
    }

    /// Centroid of the area (m); nothing without an area.
    pub fn centroid(&self) -> Option<[f64; 2]> {
        // measured from a corner, so that an area far from the origin loses no digits
        let origin = *self.vertices.first()?;
        let (mut area, mut moment) = (0.0, [0.0; 2]);
        for (p, q) in self.edges() {
            let [p, q] = [p, q].map(|point| [point[0] - origin[0], point[1] - origin[1]]);
            let part = 0.5 * (p[0] * q[1] - p[1] * q[0]);
            area += part;
            (0..2).for_each(|axis| moment[axis] += part * (p[axis] + q[axis]) / 3.0);
        }
        (area != 0.0).then(|| [0, 1].map(|axis| origin[axis] + moment[axis] / area))
    }

    /// True for points inside, by the number of edges that a ray from the point crosses.
    pub fn contains(&self, point: [f64; 2]) -> bool {
        let crosses = |(p, q): ([f64; 2], [f64; 2])| {
            let spans = (p[1] > point[1]) != (q[1] > point[1]);
            spans && point[0] < p[0] + (point[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
        };
        self.edges().filter(|edge| crosses(*edge)).count() % 2 == 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An L of three unit squares far from the origin.
    #[test]
    fn an_l_of_three_squares_has_their_area_and_centroid() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        let shape = Polygon { vertices: corners.map(|[x, y]| [x + 1e6, y]).to_vec() };
        assert!((shape.area() - 3.0).abs() < 1e-8); // 1e6² · 2^-53
        assert!((shape.perimeter() - 8.0).abs() < 1e-9);
        let [x, y] = shape.centroid().unwrap();
        assert!((x - 1e6 - 5.0 / 6.0).abs() < 1e-9 && (y - 5.0 / 6.0).abs() < 1e-9, "{x} {y}");
        assert!(shape.contains([1e6 + 0.5, 1.5]) && !shape.contains([1e6 + 1.5, 1.5]));
        assert_eq!(Polygon { vertices: Vec::new() }.centroid(), None);
    }
}
