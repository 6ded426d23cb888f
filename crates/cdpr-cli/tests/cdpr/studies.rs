//! Studies: `accuracy`, and `simulate` with elastic machines.

use super::{cdpr, cdpr_in, numbers};

/// The repository's study of this name.
fn study(name: &str) -> String {
    format!("{}/../../studies/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

/// The study `twin-nominal` after a change, in a fresh folder.
fn changed(from: &str, to: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(study("twin-nominal")).unwrap();
    assert!(text.contains(from), "{from}");
    std::fs::write(folder.path().join("study.toml"), text.replacen(from, to, 1)).unwrap();
    folder
}

#[test]
fn accuracy_answers_with_the_numbers_of_the_dissertations_machine() {
    let run = cdpr(&format!("accuracy {} --format json", study("twin-nominal")));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let keys =
        ["samples", "position_error_m", "rotation_error_rad", "length_error_m", "tension_min_N", "tension_max_N"];
    let answer = run.json_with(&keys);
    assert_eq!(answer["samples"], 75);
    assert_eq!(answer["statuses"]["converged"], 75);
    for (block, statistic, expected, tolerance) in [
        ("position_error_m", "mean", 0.0388, 0.0003),
        ("rotation_error_rad", "mean", 1.19_f64.to_radians(), 0.02_f64.to_radians()),
        ("length_error_m", "mean_abs", 0.0237, 0.0003),
    ] {
        let found = answer[block][statistic].as_f64().unwrap();
        assert!((found - expected).abs() < tolerance, "{block}: {found}");
    }
    assert_eq!(answer["tension_min_N"], 0.0, "some cables hang slack");
    assert!(cdpr(&format!("accuracy {}", study("twin-nominal"))).stdout.contains("38.83"), "in mm, for people");
}

/// Eq. 6.25 and 6.26, printed 34.5 mm, 1.03° and 2427 N for the real machine, of which the rebuilt one is a model. Found with an
/// independent implementation: 38 mm, 1.09° and 2280 N, in digits that the rounding of eq. 6.24 to a millimetre leaves.
#[test]
fn the_nominal_elastostatic_model_predicts_the_twin_as_badly_as_the_dissertations() {
    let run = cdpr(&format!("accuracy {} --format json", study("twin-elastostatic-nominal")));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["prediction"]);
    let prediction = &answer["prediction"];
    assert_eq!((&prediction["samples"], &prediction["not_converged"]), (&75.into(), &0.into()));
    for (block, statistic, expected, tolerance) in [
        ("position_error_m", "mean", 0.0380, 0.0001),
        ("rotation_error_rad", "mean", 1.09_f64.to_radians(), 0.01_f64.to_radians()),
        ("tension_error_N", "mean_norm", 2280.0, 10.0),
    ] {
        let found = prediction[block][statistic].as_f64().unwrap();
        assert!((found - expected).abs() < tolerance, "{block}: {found}");
    }
    assert!((answer["position_error_m"]["mean"].as_f64().unwrap() - 0.00407).abs() < 5e-5, "the controller of eq. 6.7");
    let words = cdpr(&format!("accuracy {}", study("twin-elastostatic-nominal"))).stdout;
    assert!(words.contains("predicts from the lengths sent") && words.contains("37.966"), "{words}");
}

/// A model that is the machine predicts what the machine does, whatever the controller.
#[test]
fn the_machines_own_model_predicts_it_exactly() {
    let folder = changed(
        "[initial]",
        "[prediction]\nrobot = \"cablerobot-simulator-helicopter-elastostatic-calibrated\"\nmodel = \"elastic\"\n[initial]",
    );
    let answer = cdpr_in(folder.path(), "accuracy study.toml --format json").json_with(&["prediction"]);
    for block in ["position_error_m", "rotation_error_rad"] {
        assert!(answer["prediction"][block]["max"].as_f64().unwrap() < 1e-9, "{answer}");
    }
    assert!(answer["prediction"]["tension_error_N"]["max"].as_f64().unwrap() < 1e-4, "1e-9 m of 0.4 MN/m");
    let folder = changed("[initial]", "[prediction]\nrobot = \"cogiro\"\nmodel = \"stretchy\"\n[initial]");
    let run = cdpr_in(folder.path(), "accuracy study.toml");
    assert_eq!(run.exit_code, 2, "{}", run.stdout);
    assert!(
        run.stderr.contains("`stretchy` is not a model effect") && run.stderr.contains("study.toml:14:"),
        "{}",
        run.stderr
    );
}

/// It is told, and the numbers are still given.
#[test]
fn a_machine_poorer_than_its_control_model_is_told_with_the_effect() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(study("planar-wide-grid")).unwrap();
    let text = text.replacen("model = \"standard\"", "model = \"MACHINE\"", 1).replace("\"elastic\"", "\"standard\"");
    let text = text.replace("MACHINE", "elastic").replace("[limits]", "[limits]\nposition_error_max_m = 0.1");
    std::fs::write(folder.path().join("study.toml"), text).unwrap();
    for command in ["accuracy study.toml", "study study.toml --out out", "reachable study.toml --step 1"] {
        let run = cdpr_in(folder.path(), command);
        assert_eq!(run.exit_code, 0, "{command}: {}", run.stderr);
        assert!(run.stderr.contains("poorer") && run.stderr.contains("lacks the effect `elastic`"), "{}", run.stderr);
    }
    let run = cdpr(&format!("accuracy {}", study("planar-wide-grid")));
    assert!(!run.stderr.contains("poorer"), "{}", run.stderr);
}

#[test]
fn poses_outside_the_reach_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(study("planar-wide-grid")).unwrap();
    let text = text.replace("min = [-4, 0.5]", "min = [20, 20]").replace("max = [4, 6]", "max = [24, 26]");
    std::fs::write(folder.path().join("study.toml"), text).unwrap();
    for command in ["accuracy study.toml", "study study.toml --out out"] {
        let run = cdpr_in(folder.path(), command);
        assert!(run.stderr.contains("outside its reach"), "{command}: {}", run.stderr);
    }
    let text = std::fs::read_to_string(folder.path().join("study.toml")).unwrap();
    let text = text.replace("[poses.grid]", "[poses]\nonly = \"wrench-feasible\"\n[poses.grid]");
    std::fs::write(folder.path().join("study.toml"), text).unwrap();
    let run = cdpr_in(folder.path(), "accuracy study.toml");
    assert_eq!(run.exit_code, 2, "{}", run.stdout);
    assert!(run.stderr.contains("none of the 25 poses of the study is wrench-feasible"), "{}", run.stderr);
}

#[test]
fn winch_offsets_of_the_planar_example_are_told() {
    let run = cdpr(&format!("accuracy {} --format json", study("planar-wide-grid")));
    let answer = run.json_with(&["winch_offsets_m"]);
    assert!(numbers(&answer["winch_offsets_m"]).iter().all(|offset| *offset < 0.0), "cables are drawn in");
    assert!((answer["position_error_m"]["mean"].as_f64().unwrap() - 0.05714).abs() < 2e-5);
}

#[test]
fn measurements_of_an_elastic_machine_have_tensions_and_repeat_to_the_byte() {
    let folder = tempfile::tempdir().unwrap();
    let record = |out: &str, seed: u32| {
        let run = cdpr_in(
            folder.path(),
            &format!("simulate {} --out {out} --seed {seed} --format json", study("twin-measurements")),
        );
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        // 75 poses of the grid, 16 turned ones, 8 cables at 8 poses
        assert_eq!(run.json()["samples"], 155);
        std::fs::read_to_string(folder.path().join(out)).unwrap()
    };
    let first = record("first.csv", 1);
    assert!(first.lines().next().unwrap().contains("tension_N_8"));
    assert_eq!(first, record("again.csv", 1));
    assert_ne!(first, record("other.csv", 2));
    let sidecar = std::fs::read_to_string(folder.path().join("first.meta.toml")).unwrap();
    assert!(sidecar.contains("tension_N = 50"), "{sidecar}");
}

/// The planar example under force control; `choice` is a line of `[control]`.
fn force_control(choice: &str, model: &str) -> String {
    format!(
        "[control]\nrobot = \"planar-example\"\nmodel = \"{model}\"\n{choice}\n[machine]\nrobot = \"planar-example-calibrated\"\n\
         model = \"elastic\"\n[initial]\npose = [0, 5.2]\noffset = \"none\"\n[limits]\ntension_min_N = 1000\ntension_max_N = 8000\n\
         [poses.grid]\nmin = [-1, 4]\nmax = [1, 6]\ncount = [3, 3]\n"
    )
}

#[test]
fn the_control_model_chooses_its_tensions_by_the_method_of_the_study_or_of_the_command() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: String| std::fs::write(folder.path().join(name), text).unwrap();
    write("plain.toml", force_control("", "elastic"));
    write("least.toml", force_control("tension_method = \"minimum\"", "elastic"));
    let answer = |arguments: &str| {
        let run = cdpr_in(folder.path(), &format!("accuracy {arguments} --format json"));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        run.json()
    };
    let (plain, least) = (answer("plain.toml"), answer("least.toml"));
    // the least tensions leave some cables near to their least
    assert!(least["tension_max_N"].as_f64().unwrap() < plain["tension_max_N"].as_f64().unwrap() - 500.0);
    assert_eq!(answer("plain.toml --tension-method minimum"), least);
    assert_eq!(answer("least.toml --tension-method qp"), plain);
    for command in [
        "simulate least.toml --out samples.csv --tension-method",
        "reachable plain.toml --step 1 --tension-method",
        "sensitivity plain.toml --tension-method",
    ] {
        let run = cdpr_in(folder.path(), &format!("{command} centroid --format json"));
        assert_eq!(run.exit_code, 0, "{command}: {}", run.stderr);
    }
    let run = cdpr_in(folder.path(), "accuracy plain.toml --tension-method centre");
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("there is no method `centre`"), "{}", run.stderr);
    write("wrong.toml", force_control("tension_method = \"middle\"", "elastic"));
    let run = cdpr_in(folder.path(), "accuracy wrong.toml");
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("wrong.toml:4") && run.stderr.contains("middle"), "{}", run.stderr);
    write("idle.toml", force_control("tension_method = \"minimum\"", "standard"));
    let run = cdpr_in(folder.path(), "accuracy idle.toml");
    assert!(run.stderr.contains("[control] tension_method without effect"), "{}", run.stderr);
}

#[test]
fn a_study_of_tensions_that_says_something_wrong_is_refused_with_the_place_or_the_key() {
    let offset = "offset = \"none\"";
    for (from, to, message) in [
        (offset, "", "tensions_N or tension_method"),
        (offset, "tension_method = \"centre\"", "centre"),
        (offset, "tensions_N = [1, 2]", "tensions_N has 2 entries; the robot has 8 cables"),
        (offset, "tensions_N = [-1, 1, 1, 1, 1, 1, 1, 1]", "cannot push"),
        (offset, "tensions_N = [0, 0, 0, 0, 0, 0, 0, 0]", "would have to push"),
        (offset, "tension_method = \"qp\"\ntensions_N = [1]", "exclude each other"),
        (offset, "tension_method = \"qp\"\n[limits]\ntension_max_N = 1200", "at the initial pose no tensions balance"),
        (offset, "offset = \"none\"\n[limits]\ntension_min_N = 9\ntension_max_N = 8", "study.toml:16:"),
        (offset, "offset = \"none\"\n[limits]\ntension_min_N = -9", "0 or more"),
        (
            "model = \"elastic\"",
            "model = \"standard\"\n[poses.tension_tests]\nshorten_m = 1\ncount = 1",
            "elastic machine",
        ),
        (offset, "offset = \"none\"\n[poses.tension_tests]\nshorten_m = -1\ncount = 1", "above 0"),
        (
            offset,
            "offset = \"none\"\n[[published]]\nstage = \"drven\"",
            "`drven` is no stage of the chain; there are reference",
        ),
        (
            offset,
            "offset = \"none\"\n[[published]]\nstage = \"driven\"\nposition_mean_m = -1",
            "position_mean_m is a finite number",
        ),
        (
            offset,
            "offset = \"none\"\n[[published]]\nstage = \"driven\"\n[[published]]\nstage = \"driven\"",
            "the stage `driven` stands twice",
        ),
        ("model = \"elastic\"", "model = \"pulley+elastic\"", "pulley_swivel_axis"),
        (
            "robot = \"cablerobot-simulator-helicopter\"\nmodel = \"standard\"",
            "robot = \"ipanema-1\"\nmodel = \"elastic\"",
            "axial_stiffness_EA_N",
        ),
    ] {
        let folder = changed(from, to);
        let run = cdpr_in(folder.path(), "accuracy study.toml");
        assert_eq!(run.exit_code, 2, "{to}: {}{}", run.stdout, run.stderr);
        assert!(run.stderr.contains(message), "{message}: {}", run.stderr);
    }
}

#[test]
fn a_pose_without_an_answer_is_a_negative_answer_with_the_reason() {
    // the platform anchor on the frame anchor: no length, no direction
    let folder = changed("[poses.grid]", "[poses.file]\npath = \"poses.csv\"\n[poses.grid]");
    let text = std::fs::read_to_string(folder.path().join("study.toml")).unwrap();
    let (kept, _) = text.split_at(text.find("[poses.grid]").unwrap());
    std::fs::write(folder.path().join("study.toml"), kept).unwrap();
    let robot = cdpr_model::robot::Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let on_the_anchor = robot.cables[0].frame_anchor - robot.cables[0].platform_anchor;
    let table = format!(
        "x_m,y_m,z_m,qx,qy,qz,qw\n0,0,1.5,0,0,0,1\n{},{},{},0,0,0,1\n",
        on_the_anchor.x, on_the_anchor.y, on_the_anchor.z
    );
    std::fs::write(folder.path().join("poses.csv"), table).unwrap();
    let run = cdpr_in(folder.path(), "accuracy study.toml --format json");
    assert_eq!(run.exit_code, 1, "{}{}", run.stdout, run.stderr);
    let answer = run.json_with(&["status", "reason", "statuses"]);
    assert!(
        answer["reason"].as_str().unwrap().starts_with("1 of 2 poses have no answer, first pose 2"),
        "{}",
        run.stdout
    );
}

/// A folder with everything, the same to the byte on one thread and on two.
#[test]
fn a_study_leaves_its_errors_in_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    let run = |out: &str, threads: u32| {
        let run = cdpr_in(
            folder.path(),
            &format!("study {} --out {out} --threads {threads} --format json", study("planar-wide-grid")),
        );
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        run.json_with(&["position_error_m", "linear_residual_m", "linear_trusted_share", "files"])
    };
    let answer = run("one", 1);
    assert!((answer["position_error_m"]["mean"].as_f64().unwrap() - 0.05714).abs() < 1e-5);
    assert!((answer["relative_position_error"].as_f64().unwrap() - 0.00589).abs() < 1e-5);
    assert_eq!(answer, run("two", 2));
    for file in ["errors.csv", "error-map-xy.svg", "result.json"] {
        let read = |out: &str| std::fs::read(folder.path().join(out).join(file)).unwrap();
        assert_eq!(read("one"), read("two"), "{file}");
    }
    let table = std::fs::read_to_string(folder.path().join("one/errors.csv")).unwrap();
    assert_eq!(table.lines().count(), 26);
    assert!(table.lines().all(|line| line.split(',').count() == 14), "{table}");
    assert!(folder.path().join("one/run.toml").exists());
}

/// A folder with the planar example on cables with hysteresis, `robot.toml`.
pub(crate) fn folder_with_hysteresis() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let robot = include_str!("../../../cdpr-model/robots/planar-example.toml");
    let table = "axial_stiffness_EA_N = 200000.0\n\n[cable.hysteresis]\nstrain = [0.0, 0.02, 0.1]\nloading_N = [0.0, 4500.0, 22000.0]\n\
                 unloading_N = [0.0, 3800.0, 22000.0]\ntransition_strain = [0.002]\n";
    std::fs::write(folder.path().join("robot.toml"), robot.replace("axial_stiffness_EA_N = 200000.0\n", table))
        .unwrap();
    folder
}

/// The planar example on cables with hysteresis: a pose ends elsewhere after coming from another side, farther the longer the way was.
#[test]
fn accuracy_tells_how_far_the_branches_of_a_machine_with_hysteresis_lie_apart() {
    let folder = folder_with_hysteresis();
    let study = "[control]\nrobot = \"robot.toml\"\n[machine]\nrobot = \"robot.toml\"\nmodel = \"hysteresis\"\n\
                 [initial]\npose = [0, 5.2]\ntension_method = \"closed-form\"\n\
                 [poses.grid]\nmin = [-1, 3]\nmax = [1, 5]\ncount = [2, 2]\n";
    std::fs::write(folder.path().join("study.toml"), study).unwrap();
    let spread = |stroke: &str| {
        let run = cdpr_in(folder.path(), &format!("accuracy study.toml --stroke {stroke} --format json"));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        let answer = run.json_with(&["history", "branches"]);
        assert_eq!((&answer["branches"]["samples"], &answer["branches"]["ways"]), (&4.into(), &5.into()));
        answer["branches"]["position_spread_m"]["mean"].as_f64().unwrap()
    };
    let (short, long) = (spread("0.02"), spread("0.2"));
    assert!(1e-6 < short && short < long && long < 0.1, "{short} {long}");
    // a newton more of an initial tension, a millimetre of an anchor: along the path, which is smooth
    let run = cdpr_in(folder.path(), "sensitivity study.toml --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["derivatives", "kinds"]);
    assert_eq!(answer["derivatives"], "analytic");
    let words = cdpr_in(folder.path(), "sensitivity study.toml");
    assert!(words.stdout.contains("the machine remembers: derivatives are exact"), "{}", words.stdout);
    let words = cdpr_in(folder.path(), "accuracy study.toml");
    assert!(words.stdout.contains("branches: 5 ways to each of 4 poses"), "{}", words.stdout);
}

/// A step of the way at which the control model finds no tensions: no derivative leads to the next pose, and the answer says so.
#[test]
fn sensitivity_names_the_poses_with_differences() {
    let folder = folder_with_hysteresis();
    let study = "[control]\nrobot = \"robot.toml\"\nmodel = \"elastic\"\n[machine]\nrobot = \"robot.toml\"\nmodel = \"hysteresis\"\n\
                 [initial]\npose = [0, 5.2]\ntension_method = \"closed-form\"\n[history]\nreach = \"in-order\"\nsub_steps = 2\n\
                 [poses.grid]\nmin = [-40, 3]\nmax = [1, 5]\ncount = [4, 2]\n";
    std::fs::write(folder.path().join("study.toml"), study).unwrap();
    let run = cdpr_in(folder.path(), "sensitivity study.toml --format json");
    assert_eq!(run.exit_code, 1, "{}", run.stderr);
    let answer = run.json_with(&["derivatives", "difference_poses", "difference_error"]);
    assert_eq!((&answer["derivatives"], &answer["unanswered_poses"]), (&"central-differences".into(), &6.into()));
    assert_eq!(answer["difference_poses"][0]["pose"], 7);
    assert!((0.0..1e-6).contains(&answer["difference_error"].as_f64().unwrap()), "{answer}");
    let words = cdpr_in(folder.path(), "sensitivity study.toml");
    assert!(words.stdout.contains("central differences along its path"), "{}", words.stdout);
    assert!(words.stdout.contains("(first pose 7: a step of the way there has no equilibrium"), "{}", words.stdout);
}
