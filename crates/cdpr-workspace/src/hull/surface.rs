//! A hull as a surface with values at its vertices.

use super::Hull;
use crate::Region;
use crate::mesh::Mesh;
use crate::surface::fields;

impl Hull {
    /// The faces in the world; in a plane the triangles between centre and outline. Each vertex has the margin of the
    /// criterion and the number of the cable that limits there.
    pub fn mesh(&self, region: &Region<'_>) -> Mesh {
        let mut points = self.vertices();
        let mut triangles = self.faces.clone();
        if self.dimension == 2 {
            let center = points.len() as u32;
            points.push(self.center);
            triangles.iter_mut().for_each(|face| *face = [center, face[0], face[1]]);
        }
        let vertices = points.iter().map(|point| region.position(point).into()).collect();
        Mesh { vertices, triangles, fields: fields(region, &points) }
    }
}
