//! Measures against simple solids, and files read back byte by byte.

use std::io;

use super::*;

/// A box from one corner to the other with outward faces and two fields.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Mesh {
    let corner = |k: usize| [0, 1, 2].map(|axis| if k >> axis & 1 == 1 { high[axis] } else { low[axis] });
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    Mesh {
        vertices: (0..8).map(corner).collect(),
        triangles: faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
        fields: vec![
            Field { name: "margin".to_owned(), unit: "N".to_owned(), values: (0..8).map(|k| 0.1 * k as f64).collect() },
            Field { name: "limiting cable".to_owned(), unit: String::new(), values: vec![1.0; 8] },
        ],
    }
}

fn written(mesh: &Mesh, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    mesh.write(format, &mut bytes).unwrap();
    bytes
}

fn f32_at(bytes: &[u8], at: usize) -> f32 {
    f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

#[test]
fn a_box_far_from_the_origin_has_its_volume_area_and_centre() {
    let mesh = cuboid([1e4, -2.0, 3.0], [1e4 + 1.0, 0.0, 6.0]);
    // sums of products of coordinates up to 3 m, measured from a corner: rounding only
    assert!((mesh.volume() - 6.0).abs() < 1e-10);
    assert!((mesh.area() - 22.0).abs() < 1e-10);
    let centre = mesh.centroid().unwrap();
    for (found, expected) in centre.iter().zip([1e4 + 0.5, -1.0, 4.5]) {
        assert!((found - expected).abs() < 1e-10 * 1e4, "{centre:?}");
    }
}

#[test]
fn clockwise_corners_make_the_volume_negative_and_leave_the_centre() {
    let mut mesh = cuboid([0.0; 3], [1.0, 2.0, 3.0]);
    let centre = mesh.centroid();
    mesh.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    assert!((mesh.volume() + 6.0).abs() < 1e-12);
    assert_eq!(mesh.centroid(), centre);
    assert!(mesh.is_closed(), "it is closed all the same");
}

#[test]
fn a_hole_and_a_turned_triangle_are_both_seen() {
    let mesh = cuboid([0.0; 3], [1.0; 3]);
    assert!(mesh.is_closed());
    let hole = Mesh { triangles: mesh.triangles[1..].to_vec(), ..mesh.clone() };
    assert!(!hole.is_closed());
    let mut turned = mesh;
    turned.triangles[4].swap(0, 1);
    assert!(!turned.is_closed());
    assert!(!Mesh::default().is_closed(), "nothing encloses nothing");
}

#[test]
fn flat_and_empty_surfaces_have_no_centre_of_volume() {
    assert_eq!(Mesh::default().centroid(), None);
    assert_eq!(Mesh::default().volume(), 0.0);
    assert_eq!(cuboid([0.0; 3], [1.0, 1.0, 0.0]).centroid(), None);
}

#[test]
fn what_no_file_can_hold_is_refused_before_a_byte_is_written() {
    let sound = cuboid([0.0; 3], [1.0; 3]);
    let with = |change: &dyn Fn(&mut Mesh)| {
        let mut mesh = sound.clone();
        change(&mut mesh);
        mesh
    };
    let broken = [
        (with(&|mesh| mesh.triangles[3][1] = 8), "triangle 3 names vertex 8"),
        (with(&|mesh| mesh.vertices[2][0] = f64::NAN), "vertex 2"),
        (with(&|mesh| mesh.vertices[2][0] = 1e300), "vertex 2"),
        (with(&|mesh| mesh.fields[0].values[7] = f64::INFINITY), "\"margin\" is inf at vertex 7"),
        (with(&|mesh| mesh.fields[1].values.truncate(3)), "has 3 values for 8 vertices"),
    ];
    for (mesh, reason) in &broken {
        for format in Format::ALL {
            let mut bytes = Vec::new();
            let error = mesh.write(format, &mut bytes).unwrap_err();
            assert_eq!((error.kind(), bytes.len()), (io::ErrorKind::InvalidInput, 0));
            assert!(error.to_string().contains(reason), "{error}");
        }
    }
    assert!(broken[0].0.volume().is_nan(), "and nothing panics");
}

#[test]
fn stl_holds_every_triangle_with_its_outward_normal() {
    let mesh = cuboid([-1.0, 0.0, 0.25], [1.0, 2.0, 4.0]);
    let bytes = written(&mesh, Format::Stl);
    assert_eq!(bytes.len(), 84 + 12 * 50);
    assert!(!bytes.starts_with(b"solid"));
    assert_eq!(u32_at(&bytes, 80), 12);
    for (index, triangle) in mesh.triangles.iter().enumerate() {
        let record = &bytes[84 + 50 * index..][..50];
        for (corner, &vertex) in triangle.iter().enumerate() {
            for axis in 0..3 {
                let expected = mesh.vertices[vertex as usize][axis] as f32;
                assert_eq!(f32_at(record, 12 + 12 * corner + 4 * axis), expected);
            }
        }
        // outwards: the normal points away from the box's centre (0, 1, 2.125)
        let normal = [0, 1, 2].map(|axis| f64::from(f32_at(record, 4 * axis)));
        let corner = mesh.vertices[triangle[0] as usize];
        let away: f64 = (0..3).map(|axis| normal[axis] * (corner[axis] - [0.0, 1.0, 2.125][axis])).sum();
        assert!(away > 0.9, "triangle {index}: {normal:?}");
        assert_eq!(record[48..], [0, 0]);
    }
}

#[test]
fn csv_reads_back_to_the_last_digit() {
    let mesh = cuboid([0.1, 1.0 / 3.0, -1e-7], [1.0, 2.0, 3.0]);
    let text = String::from_utf8(written(&mesh, Format::Csv)).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("x_m,y_m,z_m,margin_N,limiting_cable"));
    for (index, line) in lines.enumerate() {
        let numbers: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        assert_eq!(numbers[..3], mesh.vertices[index]);
        assert_eq!(numbers[3..], [mesh.fields[0].values[index], 1.0]);
    }
}

#[test]
fn ply_reads_back_to_the_last_bit() {
    let mesh = cuboid([0.1, 1.0 / 3.0, -1e-7], [1.0, 2.0, 3.0]);
    let bytes = written(&mesh, Format::Ply);
    let mark = b"end_header\n";
    let end = bytes.windows(mark.len()).position(|window| window == mark).unwrap() + mark.len();
    let header = std::str::from_utf8(&bytes[..end]).unwrap();
    assert!(header.contains("element vertex 8\nproperty double x\n") && header.contains("element face 12\n"));
    assert!(header.contains("property double margin_N\nproperty double limiting_cable\n"));
    let body = &bytes[end..];
    assert_eq!(body.len(), 8 * 5 * 8 + 12 * 13);
    for (index, row) in body[..320].chunks_exact(40).enumerate() {
        let numbers: Vec<f64> = row.chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect();
        assert_eq!(numbers[..3], mesh.vertices[index]);
        assert_eq!(numbers[3], mesh.fields[0].values[index]);
    }
    for (index, face) in body[320..].chunks_exact(13).enumerate() {
        assert_eq!(face[0], 3);
        assert_eq!([1, 5, 9].map(|at| u32_at(face, at)), mesh.triangles[index]);
    }
}

#[test]
fn vtk_reads_back_to_the_last_bit() {
    let mesh = cuboid([0.1, 1.0 / 3.0, -1e-7], [1.0, 2.0, 3.0]);
    let bytes = written(&mesh, Format::Vtk);
    let after = |mark: &str| {
        let mark = mark.as_bytes();
        bytes.windows(mark.len()).position(|window| window == mark).unwrap() + mark.len()
    };
    let doubles = |at: usize, count: usize| -> Vec<f64> {
        bytes[at..at + 8 * count].chunks_exact(8).map(|b| f64::from_be_bytes(b.try_into().unwrap())).collect()
    };
    assert!(bytes.starts_with(b"# vtk DataFile Version 3.0\n"));
    assert_eq!(doubles(after("POINTS 8 double\n"), 24), mesh.vertices.concat());
    let polygons = after("\nPOLYGONS 12 48\n");
    let whole: Vec<u32> =
        bytes[polygons..polygons + 192].chunks_exact(4).map(|b| u32::from_be_bytes(b.try_into().unwrap())).collect();
    for (polygon, triangle) in whole.chunks_exact(4).zip(&mesh.triangles) {
        assert_eq!((polygon[0], &polygon[1..]), (3, triangle.as_slice()));
    }
    let margin = after("\nPOINT_DATA 8\nSCALARS margin_N double 1\nLOOKUP_TABLE default\n");
    assert_eq!(doubles(margin, 8), mesh.fields[0].values);
    assert_eq!(doubles(after("SCALARS limiting_cable double 1\nLOOKUP_TABLE default\n"), 8), [1.0; 8]);
}

#[test]
fn glb_is_a_valid_container_whose_accessors_give_the_mesh_back() {
    let mesh = cuboid([-1.0, 0.1, 0.25], [1.0, 2.0, 4.0]);
    let bytes = written(&mesh, Format::Glb);
    assert_eq!((&bytes[..4], u32_at(&bytes, 4), u32_at(&bytes, 8) as usize), (&b"glTF"[..], 2, bytes.len()));
    let json_length = u32_at(&bytes, 12) as usize;
    assert_eq!((&bytes[16..20], json_length % 4), (&b"JSON"[..], 0));
    let json: serde_json::Value = serde_json::from_slice(&bytes[20..20 + json_length]).unwrap();
    let chunk = 20 + json_length;
    assert_eq!(&bytes[chunk + 4..chunk + 8], b"BIN\0");
    let binary = &bytes[chunk + 8..];
    assert_eq!(u32_at(&bytes, chunk) as usize, binary.len());
    assert_eq!(json["buffers"][0]["byteLength"], binary.len());
    let primitive = &json["meshes"][0]["primitives"][0];
    let part = |accessor: &serde_json::Value| {
        let accessor = &json["accessors"][accessor.as_u64().unwrap() as usize];
        let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let (start, length) = (view["byteOffset"].as_u64().unwrap() as usize, view["byteLength"].as_u64().unwrap());
        (accessor.clone(), &binary[start..start + length as usize])
    };
    let (position, places) = part(&primitive["attributes"]["POSITION"]);
    let expected: Vec<f32> = mesh.vertices.iter().flatten().map(|x| *x as f32).collect();
    assert_eq!(places.chunks_exact(4).map(|b| f32_at(b, 0)).collect::<Vec<_>>(), expected);
    assert_eq!(position["min"], serde_json::json!([-1, 0.1, 0.25]));
    assert_eq!(position["max"], serde_json::json!([1, 2, 4]));
    let (margin, values) = part(&primitive["attributes"]["_MARGIN_N"]);
    assert_eq!((margin["count"].as_u64(), values.len()), (Some(8), 32));
    assert_eq!(f32_at(values, 28), 0.7);
    assert_eq!(json["meshes"][0]["extras"]["_LIMITING_CABLE"], "limiting cable (number)");
    let mut endless = mesh.clone();
    endless.fields[0].values[7] = -f64::MAX;
    let bytes = written(&endless, Format::Glb);
    let last = bytes.len() - binary.len() + 4 * (3 * 8 + 7);
    assert_eq!(f32_at(&bytes, last), f32::MIN, "glTF has no infinity");
    let (_, indices) = part(&primitive["indices"]);
    let expected: Vec<u32> = mesh.triangles.concat();
    assert_eq!(indices.chunks_exact(4).map(|b| u32_at(b, 0)).collect::<Vec<_>>(), expected);
}

#[test]
fn names_with_quotes_and_a_mesh_without_triangles_still_make_files() {
    let mut mesh = cuboid([0.0; 3], [1.0; 3]);
    mesh.fields[0].name = "the \"margin\"\n, \\".to_owned();
    let bytes = written(&mesh, Format::Glb);
    let length = u32_at(&bytes, 12) as usize;
    let json: serde_json::Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    assert_eq!(json["meshes"][0]["extras"]["_THE__MARGIN______N"], "the \"margin\"\n, \\ (N)");
    let heading = String::from_utf8(written(&mesh, Format::Csv)).unwrap();
    assert!(heading.starts_with("x_m,y_m,z_m,the__margin______N,limiting_cable\n"), "{heading}");
    for format in Format::ALL {
        let bytes = written(&Mesh::default(), format);
        assert!(!bytes.is_empty(), "{format:?}");
    }
}

#[test]
fn endings_name_their_format_whatever_their_case() {
    for format in Format::ALL {
        assert_eq!(Format::of_extension(format.extension()), Some(format));
        assert_eq!(Format::of_extension(&format.extension().to_uppercase()), Some(format));
    }
    assert_eq!(Format::of_extension("step"), None);
}
