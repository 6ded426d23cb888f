//! Stanford polygon file, binary little-endian, version 1.0.

use std::io::{self, Write};

use super::Mesh;

pub(super) fn write(mesh: &Mesh, into: &mut dyn Write) -> io::Result<()> {
    writeln!(into, "ply\nformat binary_little_endian 1.0\ncomment coordinates in metres, world frame")?;
    writeln!(into, "element vertex {}", mesh.vertices.len())?;
    for axis in ["x", "y", "z"] {
        writeln!(into, "property double {axis}")?;
    }
    for field in &mesh.fields {
        writeln!(into, "property double {}", field.column())?;
    }
    writeln!(into, "element face {}", mesh.triangles.len())?;
    writeln!(into, "property list uchar uint vertex_indices\nend_header")?;
    for (index, vertex) in mesh.vertices.iter().enumerate() {
        let fields = mesh.fields.iter().map(|field| &field.values[index]);
        for number in vertex.iter().chain(fields) {
            into.write_all(&number.to_le_bytes())?;
        }
    }
    for triangle in &mesh.triangles {
        into.write_all(&[3])?;
        for corner in triangle {
            into.write_all(&corner.to_le_bytes())?;
        }
    }
    Ok(())
}
