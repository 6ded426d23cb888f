//! Surfaces of triangles, such as the hull of a workspace, with values at their vertices, and the files that show them.
//!
//! Corners run counter-clockwise seen from outside, so that normals point outwards and a closed surface has a positive
//! volume. Coordinates are world, m. Every writer gives the same bytes for the same mesh.

mod csv;
mod format;
mod glb;
mod ply;
mod stl;
#[cfg(test)]
mod tests;
mod vtk;
mod writing;

use std::collections::HashMap;

use nalgebra::Vector3;

pub use format::Format;

/// A surface of triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners of the triangles (world, m).
    pub vertices: Vec<[f64; 3]>,
    /// Vertices of each triangle by their index, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Quantities known at the vertices.
    pub fields: Vec<Field>,
}

/// A quantity with a value at every vertex, such as the margin of a criterion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Field {
    /// Name in words: "margin", "limiting cable".
    pub name: String,
    /// Unit; empty for a number such as that of a cable, `1` for a ratio.
    pub unit: String,
    /// One finite value per vertex. Numbers of cables count from 1; 0 stands for none.
    pub values: Vec<f64>,
}

impl Mesh {
    /// Volume inside the surface (m³), V = ⅙ Σ a · (b × c) over triangles (divergence theorem).
    ///
    /// It is meaningful for a closed surface ([`Mesh::is_closed`]) and negative if corners run clockwise seen from
    /// outside. NaN if a triangle names a vertex that does not exist.
    pub fn volume(&self) -> f64 {
        let origin = self.origin();
        self.corners().map(|corners| tetrahedron(origin, corners)).sum()
    }

    /// Area of all triangles (m²); NaN if a triangle names a vertex that does not exist.
    pub fn area(&self) -> f64 {
        self.corners().map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm()).sum()
    }

    /// Centre of the volume inside the surface (world, m); `None` if the surface encloses no volume.
    pub fn centroid(&self) -> Option<[f64; 3]> {
        let origin = self.origin();
        let (mut volume, mut moment, mut size) = (0.0, Vector3::zeros(), 0.0);
        for corners in self.corners() {
            let part = tetrahedron(origin, corners);
            volume += part;
            size += part.abs();
            moment += 0.25 * part * corners.iter().map(|corner| corner - origin).sum::<Vector3<f64>>();
        }
        // below this the volume is the rounding of its parts; NaN gives `None` too
        let holds = volume.abs() > 1e-13 * size;
        holds.then(|| (origin + moment / volume).into())
    }

    /// True if every edge joins two triangles that run along it in opposite directions: the surface has no hole and one
    /// outside.
    ///
    pub fn is_closed(&self) -> bool {
        let mut open: HashMap<(u32, u32), u32> = HashMap::with_capacity(3 * self.triangles.len());
        for &[a, b, c] in &self.triangles {
            for edge in [(a, b), (b, c), (c, a)] {
                *open.entry(edge).or_default() += 1;
            }
        }
        !open.is_empty() && open.iter().all(|(&(from, to), &count)| count == 1 && open.contains_key(&(to, from)))
    }

    /// A point near the surface; products of coordinates relative to a distant point would lose digits.
    fn origin(&self) -> Vector3<f64> {
        self.vertices.first().map_or_else(Vector3::zeros, |vertex| Vector3::from(*vertex))
    }

    fn corners(&self) -> impl Iterator<Item = [Vector3<f64>; 3]> {
        let at = |index: u32| self.vertices.get(index as usize).map_or([f64::NAN; 3], |vertex| *vertex);
        self.triangles.iter().map(move |triangle| triangle.map(|index| Vector3::from(at(index))))
    }

    /// The unit normal of each triangle; zero if it has no area.
    fn normals(&self) -> impl Iterator<Item = Vector3<f64>> {
        self.corners().map(|[a, b, c]| (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or_default())
    }
}

impl Field {
    /// The name of a column: lower-case words joined by `_`, then the unit, e.g. `limiting_cable`, `margin_N`.
    fn column(&self) -> String {
        let joined = |text: &str| -> String {
            text.trim().chars().map(|c| if c.is_ascii_alphanumeric() || c == '_' { c } else { '_' }).collect()
        };
        match self.unit.as_str() {
            "" | "1" => joined(&self.name.to_lowercase()),
            unit => format!("{}_{}", joined(&self.name.to_lowercase()), joined(unit)),
        }
    }
}

/// Signed volume of the tetrahedron that a triangle spans with the origin (m³).
fn tetrahedron(origin: Vector3<f64>, [a, b, c]: [Vector3<f64>; 3]) -> f64 {
    (a - origin).dot(&(b - origin).cross(&(c - origin))) / 6.0
}
