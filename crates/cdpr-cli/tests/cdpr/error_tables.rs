//! Error tables of planar robots: columns have the names of the plane.

use std::path::Path;

use super::{SQUARE, cdpr_in, file_with};

const ANCHORS: [[f64; 2]; 4] = [[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]];

/// Poses of the square with lengths that are 5 mm wrong at every third one.
fn samples() -> String {
    let mut text = "x_m,z_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4,set\n".to_owned();
    for row in 0..25 {
        let (x, z) = (2.0 + 1.5 * f64::from(row % 5), 2.0 + f64::from(row / 5));
        let error = if row % 3 == 0 { 0.005 } else { 0.0 };
        let lengths = ANCHORS.map(|[a_x, a_z]: [f64; 2]| (f64::hypot(x - a_x, z - a_z) + error).to_string());
        let set = if row % 5 == 4 { "validation" } else { "train" };
        text.push_str(&format!("{x},{z},{},{set}\n", lengths.join(",")));
    }
    text
}

fn heading(file: &Path) -> String {
    let text = std::fs::read_to_string(file).unwrap();
    text.lines().next().unwrap().to_owned()
}

/// A robot with `axes = "xz"` stands in x and z; its tables used to have a column y.
#[test]
fn error_tables_of_planar_robots_have_the_names_of_the_plane() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    std::fs::write(folder.path().join("data.csv"), samples()).unwrap();
    let done = |arguments: &str| {
        let run = cdpr_in(folder.path(), arguments);
        assert_eq!(run.exit_code, 0, "{arguments}: {}{}", run.stdout, run.stderr);
    };
    let lengths = "length_error_m_1,length_error_m_2,length_error_m_3,length_error_m_4";
    done("evaluate square.toml data.csv --out-errors errors.csv");
    let evaluated = format!("sample,position_error_m,error_x_m,error_z_m,rotation_error_rad,{lengths},converged");
    assert_eq!(heading(&folder.path().join("errors.csv")), evaluated);

    done("select square.toml data.csv --candidates standard;standard:length-offset --out result");
    let selected = format!("sample,x_m,z_m,position_error_m,dx_m,dz_m,rotation_error_rad,{lengths}");
    assert_eq!(heading(&folder.path().join("result/validation-errors.csv")), selected);
    let text = std::fs::read_to_string(folder.path().join("result/validation-errors.csv")).unwrap();
    // the fifth sample is the first of the validation data, at x = 8 m, z = 2 m
    assert!(text.lines().nth(1).unwrap().starts_with("5,8,2,"), "{text}");
    done("export csv result --out tables");
    let exported = "sample,x_m,z_m,position_error_m,dx_m,dz_m,rotation_error_rad";
    assert_eq!(heading(&folder.path().join("tables/pose-errors.csv")), exported);
    done("export svg result --out figures");
    assert!(folder.path().join("figures/error-map-xz.svg").exists());

    let study = "[control]\nrobot = \"square.toml\"\n[machine]\nrobot = \"square.toml\"\n[initial]\npose = [5, 4]\n\
                 [poses.grid]\nmin = [4, 3]\nmax = [6, 5]\ncount = [2, 2]\n";
    std::fs::write(folder.path().join("study.toml"), study).unwrap();
    done("study study.toml --out studied");
    let studied = "pose,status,x_m,z_m,dx_m,dz_m,linear_dx_m,linear_dz_m";
    assert!(heading(&folder.path().join("studied/errors.csv")).starts_with(studied));
    let text = std::fs::read_to_string(folder.path().join("studied/errors.csv")).unwrap();
    assert!(text.lines().nth(1).unwrap().contains(",4,3,"), "{text}");
}
