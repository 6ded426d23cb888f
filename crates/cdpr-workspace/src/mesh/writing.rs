//! Files of meshes.

use std::io;

use super::{Field, Format, Mesh, csv, glb, ply, stl, vtk};

impl Mesh {
    /// Writes the mesh in this format.
    ///
    /// A mesh that no file can hold (a triangle without its vertex, a field of another length, numbers that are not
    /// finite) is an error of the kind [`io::ErrorKind::InvalidInput`], and nothing is written.
    pub fn write(&self, format: Format, into: &mut dyn io::Write) -> io::Result<()> {
        self.check()?;
        match format {
            Format::Stl => stl::write(self, into),
            Format::Glb => glb::write(self, into),
            Format::Ply => ply::write(self, into),
            Format::Vtk => vtk::write(self, into),
            Format::Csv => csv::write(self, into),
        }
    }

    fn check(&self) -> io::Result<()> {
        let count = self.vertices.len();
        let refuse = |reason: String| Err(io::Error::new(io::ErrorKind::InvalidInput, reason));
        if u32::try_from(count.max(self.triangles.len())).is_err() {
            return refuse("a mesh of more than 4 294 967 295 vertices or triangles has no file format".to_owned());
        }
        if let Some(vertex) = self.vertices.iter().position(|vertex| !vertex.iter().all(|x| fits(*x))) {
            return refuse(format!("vertex {vertex} of the mesh is no place: {:?} m", self.vertices[vertex]));
        }
        for (triangle, corners) in self.triangles.iter().enumerate() {
            if let Some(corner) = corners.iter().find(|&&corner| corner as usize >= count) {
                return refuse(format!("triangle {triangle} names vertex {corner}, but the mesh has {count} vertices"));
            }
        }
        for Field { name, values, .. } in &self.fields {
            if values.len() != count {
                return refuse(format!("the field \"{name}\" has {} values for {count} vertices", values.len()));
            }
            if let Some(vertex) = values.iter().position(|value| !value.is_finite()) {
                return refuse(format!("the field \"{name}\" is {} at vertex {vertex}", values[vertex]));
            }
        }
        Ok(())
    }
}

/// True if single precision can hold the coordinate too.
fn fits(number: f64) -> bool {
    (number as f32).is_finite()
}
