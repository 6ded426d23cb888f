//! Binary STL: 80 bytes of header, the number of triangles, then normal and corners of each.

use std::io::{self, Write};

use super::Mesh;

/// Header; it must not start with "solid", which marks the text form.
const HEADER: &[u8] = b"binary STL, coordinates in metres, world frame";

pub(super) fn write(mesh: &Mesh, into: &mut dyn Write) -> io::Result<()> {
    let mut header = [b' '; 80];
    header[..HEADER.len()].copy_from_slice(HEADER);
    into.write_all(&header)?;
    into.write_all(&(mesh.triangles.len() as u32).to_le_bytes())?;
    for (normal, corners) in mesh.normals().zip(mesh.corners()) {
        let mut record = [0; 50];
        let numbers = normal.iter().chain(corners.iter().flatten());
        for (place, number) in record.chunks_exact_mut(4).zip(numbers) {
            place.copy_from_slice(&(*number as f32).to_le_bytes());
        }
        into.write_all(&record)?;
    }
    Ok(())
}
