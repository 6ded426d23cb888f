//! Edges of compensation maps through the commands: lengths and poses go on, tables and readers agree, and the verdict names its rules.

use std::fmt::Write;

use super::{cdpr_in, numbers, root};

/// Columns of a table: the first seven are the pose.
fn rows(path: &std::path::Path) -> Vec<Vec<f64>> {
    let table = std::fs::read_to_string(path).unwrap();
    table.lines().skip(1).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect()
}

/// Largest change from row to row of the differences of two tables in these columns.
fn largest_step(with: &[Vec<f64>], without: &[Vec<f64>], columns: std::ops::Range<usize>) -> f64 {
    let of = |row: usize, column: usize| with[row][column] - without[row][column];
    let step = |row: usize| columns.clone().map(move |column| (of(row + 1, column) - of(row, column)).abs());
    (0..with.len() - 1).flat_map(step).fold(0.0, f64::max)
}

/// The twin of chapter 6 is driven along lines out of the samples of its map, whose box ends 1.54 m from the middle and whose margin is 0.154 m wide: lengths jumped by up to 12.2 mm
/// and the pose by up to 8.5 mm at its end; they change by less than 0.5 mm within 2.5 mm now, and nothing is corrected behind it.
#[test]
fn lengths_and_poses_go_on_at_the_edge_of_a_map() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(root().join("studies/twin-compensated.toml")).unwrap();
    let maps = root().join("studies/maps").display().to_string();
    let (study, _) = text.split_once("[poses.grid]").unwrap();
    let study = format!("{}[poses.file]\npath = \"line.csv\"\n", study.replace("\"maps/", &format!("\"{maps}/")));
    std::fs::write(folder.path().join("own.toml"), &study).unwrap();
    std::fs::write(folder.path().join("alone.toml"), study.replace("compensation", "# compensation")).unwrap();
    for (x, y, z) in [(1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.7, 0.7, 0.1)] {
        let mut line = "x_m,y_m,z_m,qx,qy,qz,qw\n".to_owned();
        for k in 0..=120 {
            let way = (1.45 + 2.5e-3 * f64::from(k)) / f64::max(f64::max(x, f64::abs(y)), 1e-9);
            writeln!(line, "{},{},{},0,0,0,1", way * x, way * y, 1.6 + way * z).unwrap();
        }
        std::fs::write(folder.path().join("line.csv"), line).unwrap();
        let [(own, answer), (alone, _)] = ["own", "alone"].map(|name| {
            let run = cdpr_in(folder.path(), &format!("simulate {name}.toml --out {name}.csv --format json"));
            assert_eq!(run.exit_code, 0, "{}", run.stderr);
            (rows(&folder.path().join(name).with_extension("csv")), run.json())
        });
        let (lengths, pose) = (largest_step(&own, &alone, 7..15), largest_step(&own, &alone, 0..3));
        assert!(lengths < 0.5e-3, "lengths jump by {lengths} m");
        assert!(pose < 0.5e-3, "the pose jumps by {pose} m");
        let corrected =
            |row: usize| (7..15).map(|column| (own[row][column] - alone[row][column]).abs()).fold(0.0, f64::max);
        assert!(corrected(0) > 1e-3 && corrected(120) == 0.0, "{} {}", corrected(0), corrected(120));
        let warnings = answer["warnings"].to_string();
        assert!(warnings.contains("lie beyond") && warnings.contains("lie in the margin"), "{warnings}");
    }
}

/// A table with poses in the margin of a map has the lengths of `ik`, warns of the margin, and leads back to the poses.
#[test]
fn tables_in_the_margin_lead_back() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("smooth.csv", &super::compensation::samples(true));
    let run = |arguments: &str| cdpr_in(folder.path(), &format!("{arguments} --format json"));
    let made = run("compensate planar-example smooth.csv --out map.toml");
    assert_eq!(made.exit_code, 0, "{}", made.stderr);
    // samples end at ±3 m, and 5 % of 6 m are the margin
    let x = &made.json()["region"]["coordinates"][0];
    let near = |key: &str, place: usize| numbers(&x[key])[place];
    assert!((near("ends", 1) - 3.0).abs() < 1e-9 && (x["margin"].as_f64().unwrap() - 0.3).abs() < 1e-9, "{x}");
    write("poses.csv", "x_m,y_m\n0.5,4\n3.1,4\n3.15,5.1\n-3.2,3.1\n");
    let table = run("export lengths planar-example --poses poses.csv --compensation map.toml --out table.csv");
    let told = "3 of 4 poses lie in the margin around the samples of map.toml: its correction fades there";
    assert!(table.exit_code == 0 && table.json()["warnings"].to_string().contains(told), "{}", table.stdout);
    let ik = run("ik planar-example --pose 3.15,5.1 --compensation map.toml").json();
    assert_eq!(table.json()["cable_lengths_m"][2], ik["corrected_lengths_m"]);
    assert!((ik["correction_share"].as_f64().unwrap() - 0.5).abs() < 1e-9, "{ik}");
    assert!(ik["warnings"].to_string().contains("50 % of its correction are left"), "{ik}");
    let words = cdpr_in(folder.path(), "ik planar-example --pose 3.15,5.1 --compensation map.toml").stdout;
    assert!(words.contains("caution: the pose lies in the margin around the samples of the map (x is 3.15"), "{words}");
    let read = run("evaluate planar-example table.csv --compensation map.toml").json();
    let error = |key: &str| read[key]["max"].as_f64().unwrap();
    assert!(error("position_error_m") < 1e-9 && error("length_error_m") < 1e-12, "{read}");
    assert_eq!((&read["compensation"]["outside"], &read["compensation"]["fading"]), (&0.into(), &3.into()));
    let beyond = run("ik planar-example --pose 3.31,4 --compensation map.toml");
    assert_eq!((beyond.exit_code, beyond.json()["code"].as_str()), (2, Some("compensation::outside")));
}

/// The verdict on a map names its three rules with what was found and what is asked, whether they hold or not, in text and JSON.
#[test]
fn a_map_helps_by_rules_that_are_told() {
    let folder = tempfile::tempdir().unwrap();
    for (name, is_smooth) in [("smooth", true), ("noise", false)] {
        std::fs::write(folder.path().join(name).with_extension("csv"), super::compensation::samples(is_smooth))
            .unwrap();
        let run = cdpr_in(folder.path(), &format!("compensate planar-example {name}.csv --format json"));
        let answer = run.json();
        assert_eq!(run.exit_code, i32::from(!is_smooth), "{}", run.stderr);
        let reason = answer["reason"].as_str().unwrap();
        let words = cdpr_in(folder.path(), &format!("compensate planar-example {name}.csv")).prose();
        assert!(words.contains(reason), "{words}");
        for part in ["standard errors", "95 %", "position errors are"] {
            assert!(reason.contains(part), "{reason}");
        }
        assert_eq!(reason.contains("the map helps, by every rule"), is_smooth, "{reason}");
    }
}
