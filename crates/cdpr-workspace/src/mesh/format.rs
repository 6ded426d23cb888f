//! The file formats of meshes.

/// File format of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// Binary STL: triangles only, single precision. CAD and 3-D printing read it; it has no fields.
    Stl,
    /// glTF 2.0 in one binary file, y up as glTF requires: single precision, fields as attributes `_MARGIN_N` and so
    /// on.
    Glb,
    /// Stanford polygon file, little-endian: double precision, fields as properties of the vertices.
    Ply,
    /// Legacy VTK polydata, binary: double precision, fields as point data. ParaView reads it.
    Vtk,
    /// A table with a row per vertex: coordinates and fields, no triangles.
    Csv,
}

impl Format {
    /// Every format.
    pub const ALL: [Self; 5] = [Self::Stl, Self::Glb, Self::Ply, Self::Vtk, Self::Csv];

    /// The extension of its files, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Stl => "stl",
            Self::Glb => "glb",
            Self::Ply => "ply",
            Self::Vtk => "vtk",
            Self::Csv => "csv",
        }
    }

    /// The format of a file extension, in upper or lower case and without the dot; `None` if there is none.
    pub fn of_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| extension.eq_ignore_ascii_case(format.extension()))
    }
}
