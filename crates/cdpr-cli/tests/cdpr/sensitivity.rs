//! `cdpr sensitivity`: derivatives, drawn robots, allowed tolerances.

use super::{cdpr, cdpr_in};

const PLANAR: &str = "\
[control]
robot = \"planar-example\"

[machine]
robot = \"planar-example\"
model = \"elastic\"

[initial]
pose = [0, 5.2]
tension_method = \"closed-form\"

[limits]
tension_min_N = 1000
tension_max_N = 8000

[poses.grid]
min = [-2, 4]
max = [2, 6]
count = [3, 3]

[tolerances]
robots = 300
accuracy_m = 0.2

[tolerances.machine]
frame_anchor_m = 0.002
axial_stiffness_relative = 0.03
";

/// The planar study after a change, in a fresh folder.
fn changed(from: &str, to: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    assert!(PLANAR.contains(from), "{from}");
    std::fs::write(folder.path().join("study.toml"), PLANAR.replacen(from, to, 1)).unwrap();
    folder
}

#[test]
fn numbers_are_ranked_drawn_and_allowed() {
    let folder = changed("", "");
    let run = cdpr_in(folder.path(), "sensitivity study.toml --csv maps.csv --poses-csv poses.csv --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["samples", "kinds", "parameters", "tolerance", "allowed", "offsets", "seed"]);
    assert_eq!((answer["samples"].as_u64(), answer["offsets"].as_str()), (Some(9), Some("kept")));
    let parameters = answer["parameters"].as_array().unwrap();
    let anchor = parameters.iter().find(|one| one["name"] == "machine frame-anchor[1].x").unwrap();
    // two degrees of freedom on four cables: an anchor takes the platform along, but never as far as it moves itself
    let mean = anchor["position_mean_m_per_unit"].as_f64().unwrap();
    assert!(mean > 0.1 && mean < 1.0, "{mean}");
    let drawn = &answer["tolerance"]["drawn"];
    assert_eq!((drawn["robots"].as_u64(), drawn["unanswered"].as_u64()), (Some(300), Some(0)));
    let (found, linear) = (
        drawn["deviation_m"]["rms"].as_f64().unwrap(),
        answer["tolerance"]["linear"]["deviation_rms_m"].as_f64().unwrap(),
    );
    // 300 robots: a few percent
    assert!((found / linear - 1.0).abs() < 0.15, "{found} {linear}");
    let allowed = answer["allowed"]["kinds"].as_array().unwrap();
    let stiffness = |key: &str| {
        let own = allowed.iter().find(|kind| kind["side"] == "machine" && kind["kind"] == "axial-stiffness");
        own.unwrap()[key].as_f64().unwrap()
    };
    assert!(stiffness("sigma_joint") < stiffness("sigma_alone"));
    let maps = std::fs::read_to_string(folder.path().join("maps.csv")).unwrap();
    assert_eq!(maps.lines().count(), 1 + 9 * parameters.len());
    let poses = std::fs::read_to_string(folder.path().join("poses.csv")).unwrap();
    let fields: Vec<usize> = poses.lines().map(|line| line.split(',').count()).collect();
    assert_eq!(fields, vec![fields[0]; 10]);
    let text = cdpr_in(folder.path(), "sensitivity study.toml");
    for words in ["machine frame-anchor ", "300 robots drawn", "for 200 mm of the position", "winch offsets are kept"] {
        assert!(text.stdout.contains(words), "{words}: {}", text.stdout);
    }
}

/// An anchor beside the one of the file is one error, whether the machine or the file is said to deviate. Where nobody states what deviates,
/// what is jointly allowed is the same as where every error is named once.
#[test]
fn without_tolerances_an_error_of_two_names_counts_once() {
    let start = PLANAR.find("[tolerances]").unwrap();
    let folder = changed(&PLANAR[start..], "");
    let asked = "sensitivity study.toml --accuracy 0.2 --robots 0";
    let nothing_named =
        cdpr_in(folder.path(), &format!("{asked} --format json")).json_with(&["same_errors", "allowed"]);
    let same = nothing_named["same_errors"].as_array().unwrap();
    for (name, counted_as) in [
        ("control frame-anchor", "machine frame-anchor"),
        ("control length-offset", "machine length-offset"),
        ("winches winch-offset", "machine length-offset"),
    ] {
        assert!(same.iter().any(|one| one["name"] == name && one["counted_as"] == counted_as), "{name}: {same:?}");
    }
    let once = "[tolerances.machine]\nframe_anchor_m = 1e-3\nlength_offset_m = 1e-3\nlength_scale_relative = 1e-3\n\
                axial_stiffness_relative = 0.01\nhidden_length_m = 1e-3\nforce_N = 1\n[tolerances.winches]\ninitial_tension_N = 1\n";
    let named = changed(&PLANAR[start..], once);
    let named = cdpr_in(named.path(), &format!("{asked} --format json")).json_with(&["allowed"]);
    assert_eq!(named.get("same_errors"), None, "who states what deviates is believed");
    let of = |answer: &serde_json::Value, side: &str, kind: &str| {
        let kinds = answer["allowed"]["kinds"].as_array().unwrap();
        kinds.iter().find(|one| one["side"] == side && one["kind"] == kind).and_then(|one| one["sigma_joint"].as_f64())
    };
    for kind in ["frame-anchor", "length-offset", "length-scale", "axial-stiffness", "hidden-length"] {
        assert!(of(&named, "machine", kind).is_some(), "{kind}");
        assert_eq!(of(&nothing_named, "machine", kind), of(&named, "machine", kind), "{kind}");
        assert_eq!(of(&nothing_named, "control", kind), None, "{kind}");
    }
    let text = cdpr_in(folder.path(), asked).stdout;
    assert!(text.contains("machine length-offset (control length-offset, winches winch-offset)"), "{text}");
    assert!(!text.contains("\ncontrol length-offset"), "{text}");
}

/// Fig. 3.9 of the dissertation: how the planar example moves with an anchor of its controller. The largest number of the map
/// is that of the table.
#[test]
fn a_map_shows_how_one_number_moves_the_platform() {
    let folder = tempfile::tempdir().unwrap();
    let root = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let draw = |study: &str, name: &str| {
        let mut command = assert_cmd::Command::cargo_bin("cdpr").unwrap();
        command.current_dir(folder.path()).arg("sensitivity").arg(root.join(format!("studies/{study}.toml")));
        let output = command.args(["--robots", "0", "--map", name, "--svg", "map.svg"]).output().unwrap();
        (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    let svg = || std::fs::read_to_string(folder.path().join("map.svg")).unwrap();
    let (code, stderr) = draw("planar-validation", "control frame-anchor[1].x");
    assert!(code < 2, "{stderr}");
    let planar = svg();
    for words in ["control frame-anchor[1].x changed by 1 mm", ">longest arrow 0.833 mm<", ">mm by 1 mm<", ">x in m<"] {
        assert!(planar.contains(words), "{words}");
    }
    assert!(planar.matches("arrow-head").count() > 60);
    let figure = root.join("docs/book/src/figures/dissertation-sensitivity.svg");
    assert!(planar == std::fs::read_to_string(figure).unwrap(), "draw the figure of the chapter again");

    let (code, stderr) = draw("twin-nominal", "machine frame-anchor[1].x");
    assert!(code < 2 && svg().contains(">y in m<"), "{stderr}");
    let (code, stderr) = draw("planar-validation", "control frame-anchor[1].z");
    assert!(code == 2 && stderr.contains("--map: ") && stderr.contains("did you mean"), "{stderr}");
    let run = cdpr_in(root, "sensitivity studies/planar-validation.toml --svg alone.svg");
    assert!(run.exit_code == 2 && run.stderr.contains("--map"), "{}", run.stderr);
}

#[test]
fn the_answer_is_the_same_on_any_number_of_threads() {
    let folder = changed("", "");
    let one = cdpr_in(folder.path(), "sensitivity study.toml --threads 1 --seed 7 --format json");
    let three = cdpr_in(folder.path(), "sensitivity study.toml --threads 3 --seed 7 --format json");
    assert_eq!(one.exit_code, 0, "{}", one.stderr);
    assert_eq!(one.stdout, three.stdout);
    assert_ne!(one.stdout, cdpr_in(folder.path(), "sensitivity study.toml --seed 8 --format json").stdout);
}

/// Winches that are set again take up what deviations do at the initial pose.
#[test]
fn winches_set_anew_take_up_a_part() {
    let folder = changed("", "");
    let rms = |rule: &str| {
        let run = cdpr_in(folder.path(), &format!("sensitivity study.toml --robots 0 --offsets {rule} --format json"));
        let answer = run.json_with(&["tolerance"]);
        assert!(answer["tolerance"]["drawn"].is_null());
        answer["tolerance"]["linear"]["deviation_rms_m"].as_f64().unwrap()
    };
    assert!(rms("set-anew") < 0.8 * rms("kept"), "{} {}", rms("set-anew"), rms("kept"));
}

#[test]
fn an_accuracy_that_the_control_model_misses_is_a_negative_answer() {
    let folder = changed("accuracy_m = 0.2", "accuracy_m = 0.001");
    let run = cdpr_in(folder.path(), "sensitivity study.toml --engine linear --format json");
    assert_eq!(run.exit_code, 1);
    let answer = run.json_with(&["status", "reason"]);
    assert_eq!(answer["status"], "accuracy-missed");
    assert!(answer["reason"].as_str().unwrap().contains("accuracy_of"));
    let folder = changed("accuracy_m = 0.2", "accuracy_m = 0.001\naccuracy_of = \"deviation\"");
    assert_eq!(cdpr_in(folder.path(), "sensitivity study.toml --engine linear").exit_code, 0);
}

#[test]
fn what_is_wrong_with_tolerances_is_shown_where_it_stands() {
    for (from, to, place, code) in [
        ("frame_anchor_m = 0.002", "frame_anchor_m = -0.002", "study.toml:26:18", "study::value"),
        ("frame_anchor_m = 0.002", "frame_ancor_m = 0.002", "study.toml:26:1", "toml::unknown-key"),
        ("robots = 300", "robots = 0", "study.toml:22:10", "study::value"),
        ("accuracy_m = 0.2", "accuracy_m = 0", "study.toml:23:14", "study::value"),
        ("robots = 300", "robots = 300\nsigmas = 0", "study.toml:23:10", "study::value"),
    ] {
        let folder = changed(from, to);
        let run = cdpr_in(folder.path(), "sensitivity study.toml --format json");
        assert_eq!(run.exit_code, 2, "{to}: {}", run.stderr);
        assert_eq!(run.json()["code"], code, "{to}: {}", run.stderr);
        assert!(run.stderr.contains(place), "{to}: {}", run.stderr);
    }
    assert_eq!(cdpr("sensitivity nowhere.toml --accuracy 0").exit_code, 2);
    let folder = changed("frame_anchor_m = 0.002", "frame_anchor_m = 0.002\npulley_radius_m = 0.001");
    let run = cdpr_in(folder.path(), "sensitivity study.toml --robots 0");
    assert!(run.stderr.contains("[tolerances.machine] pulley_radius_m without effect"), "{}", run.stderr);
}
