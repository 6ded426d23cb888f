//! `workspace`: sizes, negative answers, mistakes, surfaces and interrupted counts.

use super::{SQUARE, cdpr, cdpr_in, file_with, numbers};

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

/// `Model::workspace(&load).wrench_feasible().volume()` says of itself that it is this number.
#[test]
fn the_library_answers_the_command_s_question_in_one_line() {
    for (name, key) in [("planar-example", "area_m2"), ("cogiro", "volume_m3")] {
        let answer = cdpr(&format!("workspace {name} --format json")).json();
        let robot = cdpr_model::robot::Robot::builtin(name).unwrap();
        let load = cdpr_model::statics::Load::of(&robot).unwrap();
        let model = cdpr_model::model::Model::new(robot, "standard".parse().unwrap()).unwrap();
        let found = cdpr_workspace::Workspace::of(&model, &load).wrench_feasible().volume().unwrap();
        assert_eq!(answer[key].as_f64(), Some(found.size), "{name}");
        assert_eq!(answer["error_bound"].as_f64(), Some(found.error_bound), "{name}");
        assert_eq!(answer["reaches_bounds"].as_bool(), Some(found.reaches_bounds), "{name}");
    }
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

/// Few orientations that stand for all leave out the one that the platform mostly has, unless it counts besides.
#[test]
fn the_constant_orientation_lies_in_the_maximal_and_holds_the_dextrous_which_are_bounds() {
    let found = |options: &str| {
        let run = cdpr(&format!("workspace cablerobot-simulator-icosahedron --step 1 --format json {options}"));
        let answer = run.json();
        (answer["volume_m3"].as_f64().unwrap(), answer["size_is"].as_str().unwrap().to_owned())
    };
    let (plain, exact) = found("--rotation 0.1,0,0");
    let (maximal, least) = found("--rotation 0.1,0,0 --archetype maximal --orientations 3");
    let (dextrous, most) = found("--rotation 0.1,0,0 --archetype dextrous --orientations 3");
    assert!(plain > 0.0 && maximal >= plain && dextrous <= plain, "{plain} {maximal} {dextrous}");
    assert_eq!([exact, least, most], ["value", "lower bound", "upper bound"]);
    let words = cdpr("workspace cablerobot-simulator-icosahedron --step 1 --archetype maximal --orientations 3").stdout;
    assert!(words.contains("volume at least that of the 4 orientations judged"), "{words}");
}

/// Within a bound of 1 %, in a box that is wider than the frame only where the workspace is.
#[test]
fn without_a_step_the_bound_of_the_error_is_below_one_percent() {
    for robot in ["planar-example", "cablerobot-simulator-icosahedron"] {
        for method in ["grid", "octree", "hull"] {
            let answer = cdpr(&format!("workspace {robot} --method {method} --max 8000 --format json")).json();
            let key = if robot.starts_with("planar") { "area_m2" } else { "volume_m3" };
            let [size, bound] = [key, "error_bound"].map(|key| answer[key].as_f64().unwrap());
            assert!(
                bound <= 0.01 * size && answer.get("bound_limited_by").is_none(),
                "{robot} {method}: {size} ± {bound}"
            );
            if robot.starts_with("cable") {
                let ends = numbers(&answer["bounds_m"]);
                assert!(ends[..4] == [-5.461, 5.218, -6.509, 7.677], "{answer}");
                assert!(ends[4] > -3.0 && ends[4] < -1.242 && ends[5] < 7.0, "{answer}");
            }
        }
    }
    // what is asked for is kept, and says so
    let coarse = cdpr("workspace planar-example --step 1 --format json").json();
    assert!(coarse["error_bound"].as_f64().unwrap() > 0.01 * coarse["area_m2"].as_f64().unwrap(), "{coarse}");
    assert!(coarse["bound_limited_by"].as_str().unwrap().contains("--step"), "{coarse}");
}

#[test]
fn nothing_found_is_bounded_in_json_by_what_random_points_leave_open() {
    for method in ["grid", "octree", "hull"] {
        let answer =
            cdpr(&format!("workspace planar-example --wrench 0,-60000 --method {method} --format json")).json();
        assert_eq!((answer["status"].as_str(), answer["area_m2"].as_f64()), (Some("empty"), Some(0.0)), "{answer}");
        let bound = answer["error_bound"].as_f64().unwrap();
        assert!(bound > 0.0 && bound < 0.1, "{answer}"); // of 107 m²
        assert!(!answer["reason"].as_str().unwrap().contains("none of 0 poses"), "{answer}");
    }
}

/// Eight cables at two points of the platform cannot turn it about the line through them.
#[test]
fn a_workspace_in_which_no_cable_acts_about_a_line_is_told() {
    let mut file = "layout_version = 1\nname = \"spindle\"\nmotion_pattern = \"3R3T\"\n".to_owned();
    for corner in 0..8 {
        let [x, y, z] = [corner & 1, corner >> 1 & 1, corner >> 2].map(|side| 4 * side);
        let end = if corner & 1 == 1 { 0.3 } else { -0.3 };
        file.push_str(&format!(
            "[[cable]]\nname = \"c{corner}\"\nframe_anchor_m = [{x}.0, {y}.0, {z}.0]\nplatform_anchor_m = [{end}, 0.0, 0.0]\n"
        ));
    }
    let (folder, _) = file_with("spindle.toml", file.as_bytes());
    let asked = "workspace spindle.toml --wrench 0,0,-100,0,0,0 --min 1 --max 1000 --step 0.5";
    let answer = cdpr_in(folder.path(), &format!("{asked} --format json")).json();
    assert!(answer["volume_m3"].as_f64().unwrap() > 1.0, "{answer}");
    assert_eq!(
        (answer["singular"]["rank"].as_u64(), answer["singular"]["degrees_of_freedom"].as_u64()),
        (Some(5), Some(6))
    );
    let run = cdpr_in(folder.path(), asked);
    assert!(run.stderr.contains("rank 5 of 6"), "{}", run.stderr);
    assert!(cdpr("workspace cablerobot-simulator-icosahedron --step 2 --format json").json().get("singular").is_none());
}
