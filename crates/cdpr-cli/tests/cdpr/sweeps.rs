//! `cdpr sweep`: workspaces over parameters of a study.

use super::reachable::study;
use super::{cdpr, cdpr_in};

#[test]
fn a_box_outside_the_reach_is_named_as_the_reason() {
    let run = cdpr(&format!("reachable {} --bounds=20,30,20,30 --step 1", study("planar-wide-grid")));
    assert_eq!(run.exit_code, 1);
    for words in ["the box lies outside the robot's reach", "in its middle: cable", "--bounds"] {
        assert!(run.stdout.contains(words), "{words}: {}", run.stdout);
    }
    // the initial pose is reached to a micrometre, the middles of the cells are not
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(study("planar-wide-grid")).unwrap();
    std::fs::write(folder.path().join("study.toml"), text.replace("[limits]", "[limits]\nposition_error_max_m = 1e-6"))
        .unwrap();
    let run = cdpr_in(folder.path(), "reachable study.toml --step 1");
    assert!(run.exit_code == 1 && run.stdout.contains("smaller --step"), "{}", run.stdout);
    let folder = sweep();
    let text = SWEEP.replace("[-6, 6, -1, 9]", "[20, 30, 20, 30]");
    std::fs::write(folder.path().join("sweep.toml"), text).unwrap();
    let run = cdpr_in(folder.path(), "sweep all sweep.toml --out out");
    assert!(run.exit_code == 1 && run.stdout.contains("box 20, 30, 20, 30 lies outside"), "{}", run.stdout);
}

const SWEEP: &str = r#"
study = "study.toml"
position_error_max_m = [0.01]
bounds_m = [-6, 6, -1, 9]
step_m = 0.5
[[parameter]]
key = "study.initial.tension_limits_N[2]"
values = [5000, 6000, 8000]
"#;

/// A folder with a sweep of the planar example.
fn sweep() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(study("planar-initial-tension"), folder.path().join("study.toml")).unwrap();
    std::fs::write(folder.path().join("sweep.toml"), SWEEP).unwrap();
    folder
}

#[test]
fn shards_and_threads_do_not_change_a_sweep() {
    let folder = sweep();
    let run = |arguments: &str| {
        let run = cdpr_in(folder.path(), &format!("sweep {arguments}"));
        assert_eq!(run.exit_code, 0, "{arguments}: {}", run.stderr);
        run
    };
    let result = |out: &str| std::fs::read(folder.path().join(out).join("result.json")).unwrap();
    run("plan sweep.toml --out whole");
    run("run whole --threads 1");
    assert!(run("merge whole").stdout.contains("6000"));
    run("plan sweep.toml --out parts");
    run("run parts --shard 2/2");
    let early = cdpr_in(folder.path(), "sweep merge parts");
    assert_eq!(early.exit_code, 2);
    assert!(early.stderr.contains("2 of 3 points are not computed"), "{}", early.stderr);
    run("run parts --shard 1/2 --threads 2");
    assert!(run("run parts").stdout.contains("0 computed, 3 already there"));
    run("merge parts");
    assert_eq!(result("whole"), result("parts"));
    assert!(run("all sweep.toml --out once").stdout.contains("6000"));
    assert_eq!(result("whole"), result("once"));
    let csv = std::fs::read_to_string(folder.path().join("whole/result.csv")).unwrap();
    assert_eq!(csv.lines().count(), 4, "{csv}");
    assert!(folder.path().join("whole/result.svg").exists());
}

/// One study says one thing: the sweep over a parameter at its own value reaches what `reachable` does, and a hull after no change is
/// the hull before, on a machine whose cables remember too, whatever the study says of its history.
#[test]
fn sweeps_and_hulls_of_machines_that_remember_agree_with_what_is_reached() {
    let folder = tempfile::tempdir().unwrap();
    let robot = include_str!("../../../cdpr-model/robots/planar-example.toml");
    let table = "axial_stiffness_EA_N = 200000.0\n\n[cable.hysteresis]\nstrain = [0.0, 0.02, 0.1]\nloading_N = [0.0, 4500.0, 22000.0]\n\
                 unloading_N = [0.0, 3800.0, 22000.0]\ntransition_strain = [0.002]\n";
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("robot.toml", &robot.replace("axial_stiffness_EA_N = 200000.0\n", table));
    write(
        "sweep.toml",
        "study = \"study.toml\"\nbounds_m = [-6, 6, -1, 9]\nstep_m = 1\n[[parameter]]\nkey = \"study.initial.pose[1]\"\nvalues = [0]\n",
    );
    for history in ["", "[history]\nsub_steps = 4\n"] {
        let study = "[control]\nrobot = \"robot.toml\"\n[machine]\nrobot = \"robot.toml\"\nmodel = \"hysteresis\"\n\
                     [initial]\npose = [0, 5.2]\ntension_method = \"closed-form\"\n\
                     [limits]\ntension_min_N = 1000\ntension_max_N = 8000\n";
        write("study.toml", &format!("{study}{history}"));
        let reached = cdpr_in(folder.path(), "reachable study.toml --bounds=-6,6,-1,9 --step 1 --format json");
        let reached = reached.json_with(&["reachable_area_m2"])["reachable_area_m2"].as_f64().unwrap();
        let _ = std::fs::remove_dir_all(folder.path().join("out"));
        let swept = cdpr_in(folder.path(), "sweep all sweep.toml --out out --format json");
        let swept = swept.json_with(&["rows"])["rows"][0]["reachable_area_m2"].as_f64().unwrap();
        assert!(reached > 10.0 && reached == swept, "{history:?}: {reached} {swept}");
    }
    let mut command = assert_cmd::Command::cargo_bin("cdpr").unwrap();
    command.current_dir(folder.path()).args([
        "reachable",
        "study.toml",
        "--method",
        "hull",
        "--rays",
        "24",
        "--format",
        "json",
    ]);
    let output = command.args(["--vary", "machine frame-anchor[1].x", "--change", "0"]).output().unwrap();
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(answer["differential"]["recomputed_area_m2"], answer["reachable_area_m2"], "{answer}");
}

#[test]
fn a_sweep_chooses_the_tensions_of_its_control_model() {
    let rows = |in_study: &str, in_sweep: &str| {
        let folder = sweep();
        let path = folder.path().join("study.toml");
        let text = std::fs::read_to_string(&path).unwrap();
        let (head, tail) = text.split_once("[machine]").unwrap();
        assert!(head.contains("[control]"), "{head}");
        let control = format!("[control]\nrobot = \"planar-example\"\nmodel = \"elastic\"\n{in_study}\n");
        std::fs::write(&path, format!("{control}[machine]{tail}")).unwrap();
        let text = SWEEP.replace("values = [5000, 6000, 8000]", "values = [6000]");
        std::fs::write(folder.path().join("sweep.toml"), format!("{in_sweep}\n{text}")).unwrap();
        let run = cdpr_in(folder.path(), "sweep all sweep.toml --out out --format json");
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        run.json()["rows"][0]["reachable_area_m2"].as_f64().unwrap()
    };
    let method = "tension_method = \"improved-closed-form\"";
    let (nearest, improved) = (rows("", ""), rows("", method));
    // a method that misses tensions commands less of the workspace
    assert!(nearest > 0.0 && improved > 0.0 && improved <= nearest, "{nearest} {improved}");
    assert!(rows("", "tension_method = \"closed-form\"") < nearest);
    assert_eq!(rows(method, ""), improved);
    assert_eq!(rows("tension_method = \"closed-form\"", method), improved);
}

/// Spaced values have digits that come back from a file only when they are read to the last bit: 24.400000000000002.
#[test]
fn a_sweep_accepts_the_plan_that_it_wrote() {
    let folder = sweep();
    let text = SWEEP.replace(
        "key = \"study.initial.tension_limits_N[2]\"\nvalues = [5000, 6000, 8000]",
        "key = \"both.external_wrench.force_N[1]\"\nfrom = 2\nto = 30\ncount = 6",
    );
    std::fs::write(folder.path().join("sweep.toml"), text.replace("step_m = 0.5", "step_m = 2")).unwrap();
    let run = cdpr_in(folder.path(), "sweep all sweep.toml --out out --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let rows = run.json()["rows"].as_array().unwrap().clone();
    let values: Vec<f64> = rows.iter().map(|row| row["values"][0].as_f64().unwrap()).collect();
    assert_eq!(values, [2.0, 7.6000000000000005, 13.200000000000001, 18.8, 24.400000000000002, 30.0]);
    // what is merged again is what was merged
    let before = std::fs::read(folder.path().join("out/result.json")).unwrap();
    assert_eq!(cdpr_in(folder.path(), "sweep merge out").exit_code, 0);
    assert_eq!(std::fs::read(folder.path().join("out/result.json")).unwrap(), before);
}

/// Keys, boxes and axes that are none are told before anything is computed, and leave no folder behind that keeps the mended sweep out.
#[test]
fn a_sweep_that_cannot_be_set_up_is_refused_before_it_computes() {
    let folder = sweep();
    let key = "key = \"study.initial.tension_limits_N[2]\"\nvalues = [5000, 6000, 8000]";
    let other = |key: &str, values: &str| format!("key = \"{key}\"\nvalues = [{values}]");
    for (from, to, words) in [
        (key, other("both.cable[*].axial_stifness_EA_N", "2e5, 3e5"), "did you mean `axial_stiffness_EA_N`"),
        (key, other("machine.cable[5].axial_stiffness_EA_N", "2e5"), "there are 4 entries, not 5"),
        (key, other("machine.cabel[1].axial_stiffness_EA_N", "2e5"), "there is no `cabel`"),
        (key, other("machine.cable[*].axial_stiffness_EA_N", "-1, -2"), "axial_stiffness_EA_N"),
        (key, other("placed_pulley_radius_m", "0.1, 0.2"), "swivel_axis"),
        ("bounds_m = [-6, 6, -1, 9]", "bounds_m = [-6, 6, -1]".to_owned(), "sweep.toml"),
        ("step_m = 0.5", "step_m = -1".to_owned(), "sweep.toml"),
    ] {
        std::fs::write(folder.path().join("sweep.toml"), SWEEP.replace(from, &to)).unwrap();
        let run = cdpr_in(folder.path(), "sweep all sweep.toml --out out");
        assert_eq!(run.exit_code, 2, "{to}: {}{}", run.stdout, run.stderr);
        assert!(run.stderr.contains(words), "{to}: {}", run.stderr);
        assert!(!folder.path().join("out").exists(), "{to}");
    }
    // one value that cannot be is a row with its reason
    let text = SWEEP
        .replace(key, &other("both.cable[*].axial_stiffness_EA_N", "-1, 2e5"))
        .replace("step_m = 0.5", "step_m = 2");
    std::fs::write(folder.path().join("sweep.toml"), text).unwrap();
    let run = cdpr_in(folder.path(), "sweep all sweep.toml --out out --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let rows = run.json()["rows"].clone();
    assert!(
        rows[0]["reason"].as_str().unwrap().contains("axial_stiffness_EA_N") && rows[1]["reason"].is_null(),
        "{rows}"
    );
}

#[test]
fn a_plan_that_changed_between_shards_is_refused() {
    let folder = sweep();
    let cdpr = |arguments: &str| cdpr_in(folder.path(), &format!("sweep {arguments}"));
    assert_eq!(cdpr("plan sweep.toml --out part").exit_code, 0);
    assert_eq!(cdpr("run part --shard 1/2").exit_code, 0);
    std::fs::write(folder.path().join("sweep.toml"), SWEEP.replace("8000", "9000")).unwrap();
    let run = cdpr("plan sweep.toml --out part");
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("holds rows of another plan"), "{}", run.stderr);
    // another plan's rows carried over by hand
    assert_eq!(cdpr("plan sweep.toml --out other").exit_code, 0);
    assert_eq!(cdpr("run other").exit_code, 0);
    for row in std::fs::read_dir(folder.path().join("part/rows")).unwrap() {
        let row = row.unwrap();
        std::fs::copy(row.path(), folder.path().join("other/rows").join(row.file_name())).unwrap();
    }
    let run = cdpr("merge other");
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("sweep::plan-changed"), "{}", run.stderr);
    let run = cdpr("run other --shard 3/2");
    assert!(run.exit_code == 2 && run.stderr.contains("3/2"), "{}", run.stderr);
}
