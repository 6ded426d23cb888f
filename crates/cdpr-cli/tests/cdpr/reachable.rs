//! `cdpr reachable`: workspaces of a control model on a machine.

use super::{cdpr, cdpr_in, numbers};

/// The repository's study of this name.
pub(super) fn study(name: &str) -> String {
    format!("{}/../../studies/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

/// Cells of 10 cm in the box of the example: the areas of maths.md, sec. 4, to the bound that the answer states.
#[test]
fn the_planar_example_reaches_the_areas_of_the_dissertation() {
    let run = cdpr(&format!(
        "reachable {} --bounds=-6,6,-1,9 --step 0.1 --accuracy 0.005,0.02 --format json",
        study("planar-wide-grid")
    ));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["reachable_area_m2", "physical_area_m2", "share", "parts", "by_accuracy"]);
    let number = |key: &str| answer[key].as_f64().unwrap();
    let bound = number("error_bound");
    assert!((number("reachable_area_m2") - 51.8).abs() < bound.min(0.4), "{answer}");
    assert!((number("physical_area_m2") - 71.15).abs() < 0.4);
    assert!((number("share") - 0.728).abs() < 0.005);
    assert_eq!(number("model_area_m2"), number("physical_area_m2"), "the same robot and limits");
    assert!((number("emerging_area_m2") - number("reachable_area_m2")).abs() > 0.01);
    let parts = answer["parts"].as_array().unwrap();
    let sum: f64 = parts.iter().map(|part| part["area_m2"].as_f64().unwrap()).sum();
    assert!((sum - number("reachable_area_m2")).abs() < 1e-9);
    let by_accuracy = answer["by_accuracy"].as_array().unwrap();
    let area = |index: usize| by_accuracy[index]["reachable_area_m2"].as_f64().unwrap();
    assert!(0.0 < area(0) && area(0) < area(1) && area(1) < number("reachable_area_m2"));
}

/// Without a step cells are halved and points drawn until the size is known to 1 %; finer cells have a size within that bound.
#[test]
fn without_a_step_the_size_is_known_to_a_hundredth() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(cdpr_in(folder.path(), "new suspended-camera --out .").exit_code, 0);
    let keys = ["reachable_volume_m3", "emerging_volume_m3", "error_bound"];
    let answer =
        |more: &str| cdpr_in(folder.path(), &format!("reachable study.toml{more} --format json")).json_with(&keys);
    let (refined, fine) = (answer(""), answer(" --step 0.12"));
    let [volume, emerging, bound] = keys.map(|key| refined[key].as_f64().unwrap());
    assert!(bound < 0.01 * volume, "{bound} {volume}");
    assert_eq!((&refined["confidence"], fine.get("confidence")), (&0.999.into(), None));
    let [finer, finer_emerging, _] = keys.map(|key| fine[key].as_f64().unwrap());
    assert!((finer - volume).abs() < bound && (finer_emerging - emerging).abs() < bound, "{refined} {fine}");
}

/// maths.md: 36 rays give 51.0 m².
#[test]
fn a_hull_of_36_rays_gives_the_area_that_the_dissertation_prints() {
    let run = cdpr(&format!("reachable {} --method hull --rays 36 --format json", study("planar-wide-grid")));
    let answer = run.json_with(&["reachable_area_m2", "physical_area_m2", "emerging_area_m2"]);
    assert!((answer["reachable_area_m2"].as_f64().unwrap() - 51.0).abs() < 0.05, "{answer}");
    assert!((answer["physical_area_m2"].as_f64().unwrap() - 69.6).abs() < 0.05, "{answer}");
    assert_eq!(numbers(&answer["winch_offsets_m"]).len(), 4);
}

/// The box of the robot ends at the floor and cuts all three; without a remark their sizes would be taken for whole.
#[test]
fn workspaces_that_the_box_cuts_are_named() {
    let asked = format!("reachable {} --method hull", study("planar-stiff"));
    let answer =
        cdpr(&format!("{asked} --format json")).json_with(&["at_bounds", "reaches_bounds", "physical_area_m2"]);
    assert_eq!(answer["at_bounds"], serde_json::json!(["physical", "model", "reachable"]), "{answer}");
    assert_eq!(answer["reaches_bounds"], true);
    let words = cdpr(&asked).stdout;
    assert!(
        words.contains("the physical, the model and the reachable workspace reach the faces of the box"),
        "{words}"
    );
    let whole =
        cdpr(&format!("{asked} --bounds=-6,6,-1,9 --format json")).json_with(&["at_bounds", "physical_area_m2"]);
    assert_eq!(whole["at_bounds"], serde_json::json!([]));
    assert!(whole["physical_area_m2"].as_f64().unwrap() > answer["physical_area_m2"].as_f64().unwrap() + 1.0);
}

#[test]
fn what_nothing_reaches_is_a_negative_answer_with_its_reason() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(study("planar-wide-grid")).unwrap();
    let write = |text: String| std::fs::write(folder.path().join("study.toml"), text).unwrap();
    write(
        text.replace("tension_max_N = 8000", "tension_max_N = 1001")
            .replace("tension_method", "tension_limits_N = [1000, 8000]\ntension_method"),
    );
    let run = cdpr_in(folder.path(), "reachable study.toml --step 1");
    assert_eq!(run.exit_code, 1, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("none of") && run.stdout.contains("cable"), "{}", run.stdout);
    // a rigid machine has no tensions to judge
    write(text.replace("model = \"elastic\"", "model = \"standard\""));
    let run = cdpr_in(folder.path(), "reachable study.toml");
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("position_error_max_m"), "{}", run.stderr);
    let run = cdpr_in(folder.path(), "reachable study.toml --accuracy 0.01,-1");
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("-1 m is no largest error"), "{}", run.stderr);
}

/// A rigid machine has no tensions that break a limit, so that it reaches more than it could hold: the answer says why.
#[test]
fn shares_above_the_whole_are_explained() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(study("planar-wide-grid")).unwrap();
    let text = text
        .replace("model = \"elastic\"", "model = \"standard\"")
        .replace("[limits]", "[limits]\nposition_error_max_m = 0.1");
    std::fs::write(folder.path().join("study.toml"), text).unwrap();
    std::fs::write(folder.path().join("sweep.toml"), "study = \"study.toml\"\nbounds_m = [-6, 6, -1, 9]\nstep_m = 1\n[[parameter]]\nkey = \"study.initial.pose[1]\"\nvalues = [0]\n").unwrap();
    for command in ["reachable study.toml --bounds=-6,6,-1,9 --step 1", "sweep all sweep.toml --out out"] {
        let run = cdpr_in(folder.path(), command);
        assert_eq!(run.exit_code, 0, "{command}: {}", run.stderr);
        assert!(run.stdout.contains("more than 100 % of the physical workspace"), "{command}: {}", run.stdout);
        let answer = cdpr_in(folder.path(), &format!("{command} --format json")).json();
        assert!(answer["remark"].as_str().unwrap().contains("rigid machine"), "{answer}");
    }
}

/// The platform of the twin turns by more than a degree at most poses: half a degree keeps less than two.
#[test]
fn a_largest_rotation_error_counts_too() {
    let study = std::fs::read_to_string(study("twin-nominal")).unwrap();
    let volume = |limit: &str| {
        let text = format!("{study}\n[limits]\nrotation_error_max_rad = {limit}\n");
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("study.toml"), text).unwrap();
        let run = cdpr_in(folder.path(), "reachable study.toml --step 1 --bounds=-2,2,-2,2,0,3 --format json");
        run.json_with(&["reachable_volume_m3"])["reachable_volume_m3"].as_f64().unwrap()
    };
    let (narrow, wide) = (volume("0.0087"), volume("0.035"));
    assert!(narrow < 0.9 * wide && wide > 1.0, "{narrow} {wide}");
}

/// The rate of the area by an anchor of the controller tells the area found anew with that change; a tenth of the change is the
/// second order of 1 cm. Surfaces and outlines hold the same areas.
#[test]
fn the_differential_hull_tells_what_a_change_does_and_surfaces_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = study("planar-wide-grid");
    let run = cdpr_in(
        folder.path(),
        &format!("reachable {path} --method hull --rays 36 --mesh hull.csv --emerging-mesh rest.stl --format json"),
    );
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["reachable_area_m2", "outline_m", "emerging_outline_m"]);
    let area = |outline: &serde_json::Value| {
        let points: Vec<[f64; 2]> = serde_json::from_value(outline.clone()).unwrap();
        let next = points.iter().cycle().skip(1);
        0.5 * points.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>()
    };
    assert!((area(&answer["outline_m"]) - answer["reachable_area_m2"].as_f64().unwrap()).abs() < 1e-9);
    assert!((area(&answer["emerging_outline_m"]) - answer["emerging_area_m2"].as_f64().unwrap()).abs() < 1e-9);
    assert!(folder.path().join("hull.csv").exists() && folder.path().join("rest.stl").exists());

    let vary = |name: &str, more: &str| {
        let mut command = assert_cmd::Command::cargo_bin("cdpr").unwrap();
        command.args(["reachable", &path, "--vary", name, "--change", "0.01", "--format", "json"]);
        command.args(more.split_whitespace());
        let output = command.output().unwrap();
        (output.status.code().unwrap(), output.stdout, String::from_utf8(output.stderr).unwrap())
    };
    let (code, stdout, stderr) = vary("control frame-anchor[1].x", "--method hull --rays 36");
    assert_eq!(code, 0, "{stderr}");
    let answer: serde_json::Value = serde_json::from_slice(&stdout).unwrap();
    let number = |key: &str| answer["differential"][key].as_f64().unwrap();
    let nominal = answer["reachable_area_m2"].as_f64().unwrap();
    let change = number("recomputed_area_m2") - nominal;
    assert!(change.abs() > 0.5, "{change}");
    assert!((number("first_order_area_m2") - nominal - change).abs() < 0.15 * change.abs(), "{answer}");

    let (code, _, stderr) = vary("control frame-anchor[1].z", "--method hull");
    assert!(code == 2 && stderr.contains("did you mean \"control frame-anchor[1]."), "{stderr}");
    let (code, _, stderr) = vary("control frame-anchor[1].x", "");
    assert!(code == 2 && stderr.contains("--method hull"), "{stderr}");
    let (code, _, stderr) = vary("winches initial-tension[1]", "--method hull");
    assert!(code == 2 && stderr.contains("winch-offset"), "{stderr}");
}

/// Fig. 3.9 of the dissertation: the outline of what is reached, where the change of an anchor moves it to first order, and the one
/// found anew. The first order misses the change by less than the change itself.
#[test]
fn the_differential_hull_is_drawn_with_its_sizes_and_a_spatial_one_as_a_section() {
    let folder = tempfile::tempdir().unwrap();
    let draw = |study: &str, more: &str| {
        let mut command = assert_cmd::Command::cargo_bin("cdpr").unwrap();
        command.current_dir(folder.path()).args(["reachable", study, "--svg", "hull.svg"]);
        let output = command.args(more.split(' ').map(|word| word.replace('_', " "))).output().unwrap();
        (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    let svg = || std::fs::read_to_string(folder.path().join("hull.svg")).unwrap();
    let vary = "--method hull --vary control_frame-anchor[1].x --change 0.05";
    let (code, stderr) = draw(&study("planar-wide-grid"), &format!("{vary} --rays 180 --center 0,3"));
    assert_eq!(code, 0, "{stderr}");
    let planar = svg();
    for words in [
        "control frame-anchor[1].x changed by 0.05 m",
        "reached: 51.77 m²",
        "changed, to first order: 48.65 m²",
        "changed, found anew: 47.03 m²",
        "physical: 71.10 m²",
        ">x in m<",
        "center of the rays, (0, 3) m",
    ] {
        assert!(planar.contains(words), "{words}: {planar}");
    }
    assert!(planar.matches("arrow-head").count() > 40, "{planar}");
    let figure = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/book/src/figures/dissertation-differential-hull.svg");
    assert!(planar == std::fs::read_to_string(figure).unwrap(), "draw the figure of the chapter again");

    let (code, stderr) = draw(&study("twin-nominal"), &format!("{} --rays 162", vary.replace("0.05", "0.01")));
    assert_eq!(code, 0, "{stderr}");
    let spatial = svg();
    assert!(spatial.contains("section at z = 1.5 m of the surface of 162 rays"), "{spatial}");
    assert!(spatial.contains(" m³") && !spatial.contains("m²"), "{spatial}");

    let (code, _) = draw(&study("planar-wide-grid"), "--method hull --rays 36");
    assert!(code == 0 && svg().contains("by emerging poses: 49.61 m²"), "{}", svg());
    let (code, stderr) = draw(&study("planar-wide-grid"), "--method grid");
    assert!(code == 2 && stderr.contains("--svg needs the rays of a hull"), "{stderr}");
}
