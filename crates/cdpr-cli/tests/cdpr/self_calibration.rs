//! Calibration without measured poses in `cdpr identify`.

use super::{cdpr_in, root};

/// Lengths of the planar example at the poses of a study, without the columns of the poses.
fn lengths() -> (tempfile::TempDir, usize) {
    let folder = tempfile::tempdir().unwrap();
    let study = root().join("studies/planar-wide-grid.toml");
    let run = cdpr_in(folder.path(), &format!("simulate {} --out measured.csv", study.display()));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let text = std::fs::read_to_string(folder.path().join("measured.csv")).unwrap();
    let heading: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let kept: Vec<usize> = (0..heading.len()).filter(|&k| heading[k].starts_with("cable_length")).collect();
    // noise of 0.05 mm, the same in every run
    let noisy = |number: usize, k: usize, field: &str| {
        let noise = 1e-4 * ((7 * number + 3 * k) as f64 * 0.618_033_988_749_895).fract() - 0.5e-4;
        field.parse().map_or(field.to_owned(), |length: f64| (length + noise).to_string())
    };
    let row = |(number, line): (usize, &str)| {
        let fields: Vec<&str> = line.split(',').collect();
        kept.iter().map(|&k| noisy(number, k, fields[k])).collect::<Vec<_>>().join(",") + "\n"
    };
    std::fs::write(folder.path().join("lengths.csv"), text.lines().enumerate().map(row).collect::<String>()).unwrap();
    // every fifth pose is known
    let gaps = |(number, line): (usize, &str)| {
        let fields = line.split(',').enumerate();
        let is_gap = |k: usize| number % 5 != 0 && matches!(heading[k], "x_m" | "y_m");
        fields.map(|(k, field)| if is_gap(k) { "" } else { field }).collect::<Vec<_>>().join(",") + "\n"
    };
    std::fs::write(folder.path().join("gaps.csv"), text.lines().enumerate().map(gaps).collect::<String>()).unwrap();
    (folder, text.lines().count() - 1)
}

#[test]
fn lengths_alone_calibrate_and_the_poses_found_are_data() {
    let (folder, count) = lengths();
    let command = "identify planar-example lengths.csv --free frame-anchor --out-poses found.csv --out calibrated.toml";
    let run = cdpr_in(folder.path(), command);
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let told = "no length changes by: shift along x, shift along y, turn about z";
    assert!(run.stdout.contains(told) && run.stdout.contains("rank 5 of 8"), "{}", run.stdout);
    let answer = cdpr_in(folder.path(), &format!("{command} --format json")).json();
    assert_eq!((answer["parameter_count"].as_u64(), answer["rank"].as_u64()), (Some(8), Some(5)));
    assert_eq!(answer["gauge"]["held"].as_array().unwrap().len(), 3);
    assert_eq!(answer["gauge"]["free"], serde_json::json!(["translation", "rotation", "mirror"]));
    assert_eq!(answer["poses"].as_array().unwrap().len(), count);
    assert_eq!(answer["poses"][0]["position_m"].as_array().unwrap().len(), 2);
    assert_eq!(answer["frame_anchors_m"].as_array().unwrap().len(), 4);
    let cost = answer["cost_m2"].as_f64().unwrap();
    assert!((answer["length_rms_m"].as_f64().unwrap() - (cost / (4 * count) as f64).sqrt()).abs() < 1e-15);
    // at the poses where they fit best, found anew or measured, the lengths have the same errors
    let anew = cdpr_in(folder.path(), "evaluate calibrated.toml lengths.csv --format json").json();
    assert!(
        (anew["length_error_m"]["rms"].as_f64().unwrap() / answer["length_rms_m"].as_f64().unwrap() - 1.0).abs() < 1e-6
    );
    assert!(anew["position_error_m"]["mean"].is_null() && anew["status"] == "converged", "{anew}");
    let again = cdpr_in(folder.path(), "evaluate calibrated.toml found.csv --format json").json();
    let rms = again["length_error_m"]["rms"].as_f64().unwrap();
    assert!((rms / answer["length_rms_m"].as_f64().unwrap() - 1.0).abs() < 1e-6, "{rms}");
}

#[test]
fn poses_that_are_known_fix_the_gauge() {
    let (folder, _) = lengths();
    let run =
        cdpr_in(folder.path(), "identify planar-example gaps.csv --free frame-anchor --skip-invalid --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json();
    assert_eq!((answer["parameter_count"].as_u64(), answer["rank"].as_u64()), (Some(8), Some(8)));
    assert!(answer["gauge"]["motions"].as_array().unwrap().is_empty());
}

#[test]
fn what_needs_poses_is_refused() {
    let (folder, _) = lengths();
    for (command, code) in [
        ("identify planar-example lengths.csv --free frame-anchor --split kfold:3", "data::option-needs-poses"),
        ("identify planar-example lengths.csv --free frame-anchor --report page.html", "data::option-needs-poses"),
        ("identify planar-example measured.csv --free frame-anchor --out-poses found.csv", "data::has-poses"),
        ("identify planar-example lengths.csv --model elastic --free frame-anchor", "setting::cost"),
        ("select planar-example lengths.csv", "csv::no-poses"),
        ("evaluate planar-example lengths.csv --model elastic", "setting::cost"),
    ] {
        let run = cdpr_in(folder.path(), command);
        assert_eq!(run.exit_code, 2, "{command}");
        assert!(run.stderr.contains(code), "{command}: {}", run.stderr);
    }
}
