//! Area, volume, centroid and surface of a hull.

use super::sphere::{cross, dot};
use super::{Hull, Point};

/// Size, centroid and surface of the region inside a hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// Area (m²) or volume (m³) between centre and faces.
    pub size: f64,
    /// Difference to the size of the refinement before, plus the size that the hull leaves out (m², m³).
    ///
    /// With twice as many rays along a line the error of a smooth boundary falls to a quarter, at edges to a half at
    /// least: the true size is nearer than the refinement before.
    pub error_bound: f64,
    /// Centroid (m).
    pub centroid: Point,
    /// Length of the outline (m) or area of the surface (m²).
    pub surface: f64,
}

impl Hull {
    /// Measure of the space that the faces enclose; `None` if the region is not star-shaped about the centre.
    pub fn measure(&self) -> Option<Measure> {
        if !self.is_star_shaped() {
            return None;
        }
        let (mut size, mut surface, mut moment) = (0.0, 0.0, [0.0; 3]);
        for face in &self.faces {
            let (part, edge) = self.part(face);
            size += part;
            surface += edge;
            // the centroid of a triangle or tetrahedron is the mean of its corners, one of them the centre
            let corners = if self.dimension == 2 { &face[..2] } else { &face[..] };
            for &ray in corners {
                for (axis, sum) in moment.iter_mut().enumerate() {
                    let away = self.radii[ray as usize] * self.directions[ray as usize][axis];
                    *sum += part * away / (corners.len() + 1) as f64;
                }
            }
        }
        let coarse: f64 = self.coarse_faces.iter().map(|face| self.part(face).0).sum();
        let centroid = [0, 1, 2].map(|axis| self.center[axis] + if size > 0.0 { moment[axis] / size } else { 0.0 });
        Some(Measure { size, error_bound: (size - coarse).abs() + self.left_out, centroid, surface })
    }

    /// Area (m²) or volume (m³) between the centre and a face.
    pub(crate) fn face_size(&self, face: &[u32; 3]) -> f64 {
        self.part(face).0
    }

    /// Area (m²) or volume (m³) between the centre and a face, and the size of the face.
    fn part(&self, face: &[u32; 3]) -> (f64, f64) {
        let [a, b, c] = face.map(|ray| self.directions[ray as usize].map(|part| part * self.radii[ray as usize]));
        let (to_b, to_c) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
        match self.dimension {
            2 => (0.5 * cross(&a, &b)[2], dot(&to_b, &to_b).sqrt()),
            _ => {
                let normal = cross(&to_b, &to_c);
                (dot(&a, &cross(&b, &c)) / 6.0, 0.5 * dot(&normal, &normal).sqrt())
            }
        }
    }
}
