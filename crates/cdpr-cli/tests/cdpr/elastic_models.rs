//! `identify`, `evaluate` and `select` with elastic models.

use std::path::Path;

use super::{Run, cdpr_in};

const NOMINAL: &str = "cablerobot-simulator-helicopter";
const SIXTY_TWO: &str = "--free frame-anchor,platform-anchor,compliance,wrench --prior platform-anchor=0.02";

/// A folder with the virtual measurements of the study `twin-measurements` as `twin.csv`.
fn twin() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let study = format!("{}/../../studies/twin-measurements.toml", env!("CARGO_MANIFEST_DIR"));
    assert_eq!(cdpr_in(folder.path(), &format!("simulate {study} --out twin.csv --seed 1")).exit_code, 0);
    folder
}

fn identify(folder: &Path, arguments: &str) -> Run {
    cdpr_in(folder, &format!("identify {NOMINAL} twin.csv --model elastic {arguments} --format json"))
}

/// Replaces the cells of one column from a row on (data rows from 1) by a function of the text.
fn change(folder: &Path, column: &str, from_row: usize, to: impl Fn(&str) -> String) {
    let path = folder.join("twin.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    let at = text.lines().next().unwrap().split(',').position(|name| name == column).unwrap();
    let changed = |(row, line): (usize, &str)| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if row >= from_row.max(1) {
            cells[at] = to(&cells[at]);
        }
        cells.join(",") + "\n"
    };
    std::fs::write(&path, text.lines().enumerate().map(changed).collect::<String>()).unwrap();
}

#[test]
fn the_twin_is_identified_and_its_file_predicts_poses_and_tensions() {
    let folder = twin();
    let run = identify(folder.path(), &format!("{SIXTY_TWO} --out calibrated.toml --report report.html"));
    assert_eq!(run.exit_code, 0, "{}{}", run.stdout, run.stderr);
    let answer = run.json_with(&["starts", "train", "warnings", "rank", "condition", "condition_scaled"]);
    assert_eq!(answer["parameter_count"], 62);
    assert_eq!(answer["starts"]["optima"].as_array().unwrap().len(), 1, "one optimum from all starts");
    let evaluated = cdpr_in(folder.path(), "evaluate calibrated.toml twin.csv --model elastic --format json");
    let evaluated = evaluated.json_with(&["tension_error_N"]);
    for errors in [&answer["train"], &evaluated] {
        let position = errors["position_error_m"]["mean"].as_f64().unwrap();
        let tension = errors["tension_error_N"]["mean_norm"].as_f64().unwrap();
        assert!((0.0015..0.0023).contains(&position) && (130.0..260.0).contains(&tension), "{position} m, {tension} N");
    }
    // the rows of a calibrated file: eight compliances and the load
    let file = std::fs::read_to_string(folder.path().join("calibrated.toml")).unwrap();
    assert_eq!(file.matches("axial_compliance_per_N").count(), 8);
    assert!(file.contains("[external_wrench]"), "{file}");
}

#[test]
fn without_tension_tests_the_answer_names_cables_of_unknown_stiffness() {
    let folder = twin();
    let path = folder.path().join("twin.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    // 75 poses of the grid and 16 turned ones come before the tension tests
    std::fs::write(&path, text.lines().take(92).map(|line| format!("{line}\n")).collect::<String>()).unwrap();
    let answer = identify(folder.path(), SIXTY_TWO).json();
    let words = answer["weak_directions"].to_string();
    assert!(words.contains("the stiffness of cables") && words.contains("tension tests"), "{words}");
}

#[test]
fn rigid_and_elastic_candidates_are_ranked_together_by_position_and_by_tension() {
    let folder = twin();
    let select = |more: &str| {
        let arguments = format!("select {NOMINAL} twin.csv --prior platform-anchor=0.02 --split kfold:5 {more}");
        cdpr_in(folder.path(), &format!("{arguments} --format json"))
    };
    let best = "elastic:frame-anchor,platform-anchor,compliance,wrench";
    let by_position = select("").json_with(&["candidates", "recommended"]);
    assert_eq!(by_position["recommended"], best);
    let by_tension = select("--criterion tension").json();
    assert_eq!(by_tension["recommended"], best);
    assert!(by_tension["reason"].as_str().unwrap().contains(" N"), "{by_tension}");
    let rigid = &by_tension["candidates"][0];
    assert!(rigid["name"] == "standard" && rigid["validation"]["tension_error_N"].is_null(), "{rigid}");
    let run = select("--require tension_mean_norm_N=10");
    assert!(run.exit_code == 1 && run.json()["recommended"].is_null(), "{}", run.stdout);
}

/// What elastic models lack is told by key, column or row, and nothing is written.
#[test]
fn what_elastic_models_lack_is_named() {
    let robot = cdpr_model::robot::Robot::builtin(NOMINAL).unwrap().to_toml();
    let without = |key: &str| -> String {
        robot.lines().filter(|line| !line.starts_with(key)).map(|line| format!("{line}\n")).collect()
    };
    // without its line `includes_gravity` the wrench of the file lacks the weight
    for (key, message) in [("axial_stiffness_EA_N", "axial_stiffness_EA_N"), ("includes_gravity", "mass_kg")] {
        let folder = twin();
        std::fs::write(folder.path().join("robot.toml"), without(key)).unwrap();
        let run =
            cdpr_in(folder.path(), "identify robot.toml twin.csv --model elastic --free frame-anchor --out out.toml");
        assert_eq!(run.exit_code, 2, "{key}: {}{}", run.stdout, run.stderr);
        assert!(run.stderr.contains(message), "{key}: {}", run.stderr);
        assert!(!folder.path().join("out.toml").exists());
    }
    let folder = twin();
    change(folder.path(), "tension_N_3", 100, |_| "-400".to_owned());
    let run = cdpr_in(folder.path(), &format!("identify {NOMINAL} twin.csv --model elastic {SIXTY_TWO}"));
    assert_eq!(run.exit_code, 2, "{}{}", run.stdout, run.stderr);
    assert!(run.stderr.contains("negative") && run.stderr.contains("100"), "{}", run.stderr);
    let folder = twin();
    let path = folder.path().join("twin.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, text.replace("tension_N_", "colour_")).unwrap();
    let run = cdpr_in(folder.path(), &format!("identify {NOMINAL} twin.csv --model elastic {SIXTY_TWO}"));
    assert_eq!(run.exit_code, 2, "{}{}", run.stdout, run.stderr);
    assert!(run.stderr.contains("tension_N_1"), "{}", run.stderr);
}

/// Winches that read 50 mm too much leave no room for stretch: that is a negative answer with its likely cause, and the file is
/// written.
#[test]
fn compliances_that_end_at_zero_are_a_negative_answer_with_the_likely_cause() {
    let folder = twin();
    for cable in 1..=8 {
        let column = format!("cable_length_m_{cable}");
        change(folder.path(), &column, 1, |text| (text.parse::<f64>().unwrap() + 0.05).to_string());
    }
    // anchors and all are right: only the winches' offsets are missing
    let identify = |arguments: &str| {
        let model = "cablerobot-simulator-helicopter-elastostatic-calibrated twin.csv --model elastic";
        cdpr_in(folder.path(), &format!("identify {model} {arguments} --format json"))
    };
    let run = identify("--free compliance,wrench --out calibrated.toml");
    assert_eq!(run.exit_code, 1, "{}{}", run.stdout, run.stderr);
    let answer = run.json_with(&["status", "reason", "train", "parameters"]);
    assert_eq!(answer["status"], "not-predictive");
    let reason = answer["reason"].as_str().unwrap();
    assert!(reason.contains("drives the compliance of cables 1, 2"), "{reason}");
    assert!(reason.contains("offsets of the winches") && reason.contains("`length-offset`"), "{reason}");
    assert_eq!(answer["train"]["answered"], 0);
    assert!(
        answer["train"]["position_error_m"]["mean"].is_null() && answer["train"]["length_error_m"]["rms"].is_number()
    );
    let file = std::fs::read_to_string(folder.path().join("calibrated.toml")).unwrap();
    let is_rigid = |line: &&str| line.starts_with("axial_compliance_per_N") && line.ends_with("= 0.0");
    assert!(file.lines().filter(is_rigid).count() > 6, "{file}");
    // the cause is right: with offsets the same data are explained
    let run = identify("--free compliance,length-offset,wrench");
    assert!(run.json()["status"].as_str().unwrap().starts_with("converged"), "{}", run.stdout);
}
