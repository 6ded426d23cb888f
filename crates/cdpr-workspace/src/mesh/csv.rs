//! A row per vertex: `x_m,y_m,z_m`, then the fields with their units in the heading.

use std::io::{self, Write};

use super::Mesh;

pub(super) fn write(mesh: &Mesh, into: &mut dyn Write) -> io::Result<()> {
    let columns = mesh.fields.iter().map(|field| field.column());
    let heading = ["x_m", "y_m", "z_m"].into_iter().map(str::to_owned).chain(columns);
    writeln!(into, "{}", heading.collect::<Vec<_>>().join(","))?;
    for (index, vertex) in mesh.vertices.iter().enumerate() {
        let fields = mesh.fields.iter().map(|field| &field.values[index]);
        // the shortest text that reads back as the same number
        let row: Vec<String> = vertex.iter().chain(fields).map(f64::to_string).collect();
        writeln!(into, "{}", row.join(","))?;
    }
    Ok(())
}
