//! glTF 2.0 in its binary container: a JSON chunk that describes the buffer, and the buffer.

use std::fmt::Write as _;
use std::io::{self, Write};

use super::{Field, Mesh};

const MAGIC: u32 = 0x4654_6C67;
const JSON: u32 = 0x4E4F_534A;
const BINARY: u32 = 0x004E_4942;
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

pub(super) fn write(mesh: &Mesh, into: &mut dyn Write) -> io::Result<()> {
    let mut json = description(mesh).into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let binary = buffer(mesh);
    let total = 12 + 8 + json.len() + 8 + binary.len();
    let length = |bytes: usize| {
        u32::try_from(bytes).map_err(|_| io::Error::new(io::ErrorKind::InvalidInput, "a GLB file holds at most 4 GiB"))
    };
    for number in [MAGIC, 2, length(total)?, length(json.len())?, JSON] {
        into.write_all(&number.to_le_bytes())?;
    }
    into.write_all(&json)?;
    for number in [length(binary.len())?, BINARY] {
        into.write_all(&number.to_le_bytes())?;
    }
    into.write_all(&binary)
}

/// Positions, fields, indices: each of four bytes per number, so that every part is aligned.
fn buffer(mesh: &Mesh) -> Vec<u8> {
    let numbers = mesh.vertices.iter().flatten().chain(mesh.fields.iter().flat_map(|field| &field.values));
    let indices = mesh.triangles.iter().flatten();
    // glTF has no infinity: a margin of −∞ becomes the lowest number
    let single = |number: &f64| (*number as f32).clamp(f32::MIN, f32::MAX);
    numbers.flat_map(|number| single(number).to_le_bytes()).chain(indices.flat_map(|i| i.to_le_bytes())).collect()
}

/// The JSON chunk. A mesh without triangles has no primitive, as glTF has no empty accessor.
fn description(mesh: &Mesh) -> String {
    let mut parts = Parts::default();
    let mut attributes = String::new();
    let mut names = String::new();
    if !mesh.triangles.is_empty() {
        let count = mesh.vertices.len();
        let position = parts.add(count, 3, (FLOAT, "VEC3", ARRAY_BUFFER), &bounds(mesh));
        let _ = write!(attributes, "\"POSITION\":{position}");
        for field in &mesh.fields {
            let accessor = parts.add(count, 1, (FLOAT, "SCALAR", ARRAY_BUFFER), "");
            let _ = write!(attributes, ",{}:{accessor}", text(&attribute(field)));
            let comma = if names.is_empty() { "" } else { "," };
            let words = format!("{} ({})", field.name, if field.unit.is_empty() { "number" } else { &field.unit });
            let _ = write!(names, "{comma}{}:{}", text(&attribute(field)), text(&words));
        }
    }
    let asset = r#""asset":{"version":"2.0","generator":"cdpr"},"scene":0"#;
    if mesh.triangles.is_empty() {
        return format!("{{{asset},\"scenes\":[{{}}]}}");
    }
    let indices = parts.add(3 * mesh.triangles.len(), 1, (UNSIGNED_INT, "SCALAR", ELEMENT_ARRAY_BUFFER), "");
    let Parts { views, accessors, length } = parts;
    // glTF has y up: a quarter turn about x stands z up
    format!(
        "{{{asset},\"scenes\":[{{\"nodes\":[0]}}],\
         \"nodes\":[{{\"mesh\":0,\"rotation\":[-0.7071067811865476,0,0,0.7071067811865476]}}],\
         \"meshes\":[{{\"primitives\":[{{\"attributes\":{{{attributes}}},\"indices\":{indices},\"material\":0}}],\
         \"extras\":{{{names}}}}}],\
         \"materials\":[{{\"doubleSided\":true,\"pbrMetallicRoughness\":\
         {{\"baseColorFactor\":[0.1,0.4,0.7,1],\"metallicFactor\":0,\"roughnessFactor\":0.9}}}}],\
         \"accessors\":[{accessors}],\"bufferViews\":[{views}],\"buffers\":[{{\"byteLength\":{length}}}]}}"
    )
}

/// Parts of the buffer, one after the other.
#[derive(Default)]
struct Parts {
    views: String,
    accessors: String,
    length: usize,
}

impl Parts {
    /// Describes the next part and returns its index; `more` is appended to its accessor.
    fn add(&mut self, count: usize, width: usize, (kind, shape, target): (u32, &str, u32), more: &str) -> usize {
        let number = self.views.matches("\"buffer\"").count();
        let comma = if number == 0 { "" } else { "," };
        let bytes = 4 * count * width;
        let offset = self.length;
        let _ = write!(
            self.views,
            "{comma}{{\"buffer\":0,\"byteOffset\":{offset},\"byteLength\":{bytes},\"target\":{target}}}"
        );
        let _ = write!(
            self.accessors,
            "{comma}{{\"bufferView\":{number},\"componentType\":{kind},\"count\":{count},\"type\":\"{shape}\"{more}}}"
        );
        self.length += bytes;
        number
    }
}

/// Least and largest coordinates in single precision, which readers require of positions.
fn bounds(mesh: &Mesh) -> String {
    let of = |choose: fn(f32, f32) -> f32, start: f32| {
        let corner = |axis: usize| mesh.vertices.iter().map(|vertex| vertex[axis] as f32).fold(start, choose);
        format!("[{},{},{}]", corner(0), corner(1), corner(2))
    };
    format!(",\"min\":{},\"max\":{}", of(f32::min, f32::INFINITY), of(f32::max, f32::NEG_INFINITY))
}

/// Name of an application-defined attribute: it starts with `_`.
fn attribute(field: &Field) -> String {
    format!("_{}", field.column().to_uppercase())
}

/// A JSON string.
fn text(words: &str) -> String {
    let mut text = String::from('"');
    for c in words.chars() {
        match c {
            '"' | '\\' => text.extend(['\\', c]),
            c if (c as u32) < 0x20 => {
                let _ = write!(text, "\\u{:04x}", c as u32);
            }
            c => text.push(c),
        }
    }
    text.push('"');
    text
}
