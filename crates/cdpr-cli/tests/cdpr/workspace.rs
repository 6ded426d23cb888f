//! `workspace`: sizes, negative answers, mistakes, surfaces and interrupted counts.

use super::{SQUARE, cdpr, cdpr_in, file_with};

const PLANAR: &str = "workspace planar-example --bounds -6.4,5.5,-0.5,8.5 --format json";

#[test]
fn the_three_methods_give_the_area_of_the_planar_example_within_their_bounds() {
    for (options, key) in
        [("--step 0.1", "cell_m"), ("--method octree --step 0.05", "grid_points"), ("--method hull", "rays")]
    {
        let run = cdpr(&format!("{PLANAR} {options}"));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        let answer = run.json_with(&["area_m2", "error_bound", "points", "feasible_points", "status", key]);
        let [area, bound] = ["area_m2", "error_bound"].map(|key| answer[key].as_f64().unwrap());
        assert!((area - 71.15).abs() < bound + 0.005 && bound < 4.0, "{area} ± {bound}");
        assert!(answer["feasible_points"].as_u64() < answer["points"].as_u64());
        assert!(answer.get("volume_m3").is_none());
    }
    let few = cdpr(&format!("{PLANAR} --method hull --rays 36 --center 0,5.2")).json();
    assert!((few["area_m2"].as_f64().unwrap() - 69.6).abs() < 0.05, "{few}");
}

#[test]
fn a_load_too_heavy_leaves_nothing_and_the_reason_is_told() {
    let run = cdpr("workspace planar-example --wrench 0,-60000 --format json");
    assert_eq!(run.exit_code, 1, "{}", run.stdout);
    let answer = run.json();
    assert_eq!((answer["status"].as_str(), answer["area_m2"].as_f64()), (Some("empty"), Some(0.0)));
    let reason = answer["reason"].as_str().unwrap();
    assert!(reason.contains("at (0, 5.2") && reason.contains("would need"), "{reason}");
    let hull = cdpr("workspace planar-example --wrench 0,-60000 --method hull --format json");
    assert_eq!((hull.exit_code, hull.json()["status"].as_str()), (1, Some("empty")));
}

#[test]
fn what_is_missing_or_wrong_is_named_with_its_code() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    for (arguments, faults) in [
        ("square.toml", vec!["gravity_m_s2", "--wrench"]),
        ("square.toml --wrench 0,-10", vec!["cable 2", "tension_min_N", "--min"]),
        ("planar-example --step 0", vec!["workspace::step", "0 m"]),
        ("planar-example --step 1e-9", vec!["workspace::step", "larger"]),
        ("planar-example --bounds 1,0,0,1", vec!["workspace::bounds", "axis 1", "from 1 m to 0 m"]),
        ("planar-example --bounds 0,1,0,1,0,1", vec!["workspace::bounds", "expected 4"]),
        ("planar-example --method hull --center 0,20", vec!["workspace::center-outside", "0, 20"]),
        ("planar-example --method hull --center 0,9.5", vec!["workspace::center-outside", "cable"]),
        ("planar-example --method hull --rays 2", vec!["workspace::rays", "between 3"]),
        ("planar-example --method hull --tolerance 0", vec!["workspace::tolerance"]),
        ("planar-example --criterion wrench-feasable", vec!["workspace::criterion", "did you mean `wrench-feasible`"]),
        ("planar-example --criterion wrench-closure:least=1", vec!["workspace::setting", "takes none"]),
        ("planar-example --rotation 0.1", vec!["workspace::orientations", "2T"]),
        ("planar-example --archetype dextrous", vec!["workspace::orientations", "does not turn"]),
        ("ipanema-1 --archetype total-orientation --angles 0,1,2", vec!["workspace::orientations", "9 numbers"]),
        ("ipanema-1 --archetype total-orientation --angles 1,0,2,0,0,1,0,0,1", vec!["reversed"]),
        ("planar-example --mesh hull.stl --resume state.json", vec!["workspace::resume", "--method octree"]),
        ("planar-example --method hull --mesh hull.obj", vec!["workspace::mesh", ".stl"]),
        ("planar-example --method hull --resume state.json", vec!["workspace::resume", "--method grid"]),
    ] {
        let run = cdpr_in(folder.path(), &format!("workspace {arguments}"));
        assert_eq!(run.exit_code, 2, "{arguments}: {}", run.stdout);
        for fault in faults {
            assert!(run.stderr.contains(fault), "{arguments}: {}", run.stderr);
        }
    }
}

#[test]
fn a_hull_is_written_in_every_format_of_meshes() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["hull.stl", "hull.GLB", "hull.ply", "hull.vtk", "hull.csv"] {
        let run = cdpr_in(
            folder.path(),
            &format!("workspace cablerobot-simulator-icosahedron --method hull --rays 42 --mesh {name} --format json"),
        );
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        assert_eq!(run.json()["mesh"], name);
        assert!(std::fs::metadata(folder.path().join(name)).unwrap().len() > 1000, "{name}");
    }
    let table = std::fs::read_to_string(folder.path().join("hull.csv")).unwrap();
    assert_eq!(table.lines().count(), 43, "{table}");
}

#[test]
fn grid_and_octree_write_the_surface_of_what_they_found() {
    let folder = tempfile::tempdir().unwrap();
    for method in ["grid", "octree"] {
        for (robot, name) in [("cablerobot-simulator-icosahedron", "space.ply"), ("planar-example", "plane.vtk")] {
            let options = format!("--method {method} --step 0.8 --mesh {name} --format json");
            let run = cdpr_in(folder.path(), &format!("workspace {robot} {options}"));
            assert_eq!(run.exit_code, 0, "{}", run.stderr);
            assert_eq!(run.json()["mesh"], name);
            assert_eq!(run.json().get("surface_m2").is_some(), robot.starts_with("cable"), "{}", run.stdout);
            let bytes = std::fs::read(folder.path().join(name)).unwrap();
            assert!(bytes.len() > 1000 && String::from_utf8_lossy(&bytes).contains("limiting_cable"), "{name}");
        }
    }
}

/// The state of a finished count answers at once; that of another question is refused.
#[test]
fn a_count_goes_on_from_its_state_and_from_no_other() {
    let folder = tempfile::tempdir().unwrap();
    let first = cdpr_in(folder.path(), &format!("{PLANAR} --step 0.1 --resume state.json"));
    assert_eq!(first.exit_code, 0, "{}", first.stderr);
    let again = cdpr_in(folder.path(), &format!("{PLANAR} --step 0.1 --resume state.json"));
    assert_eq!(again.stdout, first.stdout);
    let other = cdpr_in(folder.path(), &format!("{PLANAR} --step 0.2 --resume state.json"));
    assert_eq!(other.exit_code, 2);
    assert!(other.stderr.contains("state of another count"), "{}", other.stderr);
    std::fs::write(folder.path().join("state.json"), "{}").unwrap();
    let none = cdpr_in(folder.path(), &format!("{PLANAR} --step 0.1 --resume state.json"));
    assert!(none.exit_code == 2 && none.stderr.contains("no state of a count"), "{}", none.stderr);
}

#[test]
fn sets_of_orientations_and_several_criteria_shrink_the_volume() {
    let volume = |options: &str| {
        let run = cdpr(&format!("workspace cablerobot-simulator-icosahedron --step 1 --format json {options}"));
        assert_eq!(run.exit_code, 0, "{options}: {}", run.stderr);
        run.json()["volume_m3"].as_f64().unwrap()
    };
    let plain = volume("");
    let total = volume("--archetype total-orientation --angles -0.3,0.3,2,0,0,1,0,0,1");
    let inclusion = volume("--archetype inclusion-orientation --angles -0.3,0.3,3,0,0,1,0,0,1");
    let both = volume("--criterion wrench-feasible --criterion wrench-closure");
    assert!(total < plain && plain <= inclusion && both <= plain, "{total} {plain} {inclusion} {both}");
}
