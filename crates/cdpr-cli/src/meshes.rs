//! Surfaces as files.

use std::path::Path;

use cdpr_workspace::mesh::{Format, Mesh};

use crate::failure::Failure;
use crate::files;

/// Refuses a file whose ending names no format of meshes.
pub(crate) fn check_mesh_file(option: &str, path: &Path) -> Result<(), Failure> {
    if format_of(path).is_some() {
        return Ok(());
    }
    let endings: Vec<String> = Format::ALL.iter().map(|format| format!(".{}", format.extension())).collect();
    let message = format!("{option} {}: the ending names no format of meshes", path.display());
    Err(Failure::input("workspace::mesh", message, format!("let the name end in {}", endings.join(", "))))
}

/// Writes a mesh in the format that the ending names.
pub(crate) fn write_mesh(path: &Path, mesh: &Mesh) -> Result<(), Failure> {
    let Some(format) = format_of(path) else { return Ok(()) };
    let mut bytes = Vec::new();
    let written = mesh.write(format, &mut bytes);
    written.map_err(|error| Failure::io("write", &path.display().to_string(), &error))?;
    files::write(path, &bytes)
}

fn format_of(path: &Path) -> Option<Format> {
    Format::of_extension(path.extension()?.to_str()?)
}
