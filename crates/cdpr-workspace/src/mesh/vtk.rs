//! Legacy VTK file, version 3.0, binary (big-endian by definition): polydata with point data.

use std::io::{self, Write};

use super::Mesh;

pub(super) fn write(mesh: &Mesh, into: &mut dyn Write) -> io::Result<()> {
    writeln!(
        into,
        "# vtk DataFile Version 3.0\nsurface, coordinates in metres, world frame\nBINARY\nDATASET POLYDATA"
    )?;
    writeln!(into, "POINTS {} double", mesh.vertices.len())?;
    for number in mesh.vertices.iter().flatten() {
        into.write_all(&number.to_be_bytes())?;
    }
    writeln!(into, "\nPOLYGONS {} {}", mesh.triangles.len(), 4 * mesh.triangles.len())?;
    for triangle in &mesh.triangles {
        into.write_all(&3_u32.to_be_bytes())?;
        for corner in triangle {
            into.write_all(&corner.to_be_bytes())?;
        }
    }
    if !mesh.fields.is_empty() {
        writeln!(into, "\nPOINT_DATA {}", mesh.vertices.len())?;
    }
    for field in &mesh.fields {
        writeln!(into, "SCALARS {} double 1\nLOOKUP_TABLE default", field.column())?;
        for value in &field.values {
            into.write_all(&value.to_be_bytes())?;
        }
        writeln!(into)?;
    }
    Ok(())
}
