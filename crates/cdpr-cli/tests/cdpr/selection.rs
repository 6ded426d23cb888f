//! `select`, `simulate` and `demo`.

use std::collections::BTreeMap;
use std::path::Path;

use super::{cdpr_in, run};

/// Files of a folder and its subfolders with their bytes, but for the wall times of `result.json`.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        if entry.path().is_dir() {
            files.extend(contents(&entry.path()).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
            continue;
        }
        let mut bytes = std::fs::read(entry.path()).unwrap();
        if name == "result.json" {
            let mut json: serde_json::Value = serde_json::from_slice(&bytes).unwrap();
            assert!(json.as_object_mut().unwrap().remove("timing").is_some());
            bytes = json.to_string().into_bytes();
        }
        files.insert(name, bytes);
    }
    files
}

#[test]
fn the_demo_recommends_the_machines_model_and_writes_everything_a_result_has() {
    let folder = tempfile::tempdir().unwrap();
    let run = cdpr_in(folder.path(), "demo --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["candidates", "recommended", "reason", "timing"]);
    assert_eq!(answer["recommended"], "elastic:frame-anchor,platform-anchor,length-offset,compliance,wrench");
    // 30 mm before; the sensors' noise alone makes 1.8 mm in the mean
    let mean = |name: &str| {
        let one = answer["candidates"].as_array().unwrap().iter().find(|one| one["name"] == name).unwrap();
        one["validation"]["position_error_m"]["mean"].as_f64().unwrap()
    };
    assert!(mean("standard") > 0.025 && mean(answer["recommended"].as_str().unwrap()) < 0.003);
    let keys =
        ["name", "model", "free", "parameter_count", "train", "validation", "standard_error", "rank", "condition"];
    for candidate in answer["candidates"].as_array().unwrap().iter().filter(|one| one["failure"].is_null()) {
        keys.iter().for_each(|key| assert!(!candidate[key].is_null(), "{key} in {candidate}"));
    }
    let files = contents(&folder.path().join("cdpr-demo"));
    for name in [
        "result.json",
        "run.toml",
        "candidates.csv",
        "parameters.csv",
        "validation-errors.csv",
        "singular-values.csv",
        "convergence.csv",
        "correlations.csv",
        "report.html",
        "calibrated.toml",
        "calibrated/04-standard_frame-anchor.toml",
        "robot.toml",
        "machine.toml",
        "training.csv",
        "validation.csv",
    ] {
        assert!(files.contains_key(name), "{name} is missing");
    }
    let report = String::from_utf8(files["report.html"].clone()).unwrap();
    assert!(
        report.contains("standard:frame-anchor,length-offset")
            && !report.contains("src=\"http")
            && !report.contains("href=\"http")
    );
}

/// The same inputs and seed give the same bytes, on one thread and on several; the folder's own files say how to repeat it.
#[test]
fn results_are_the_same_bytes_on_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let on_threads = |threads: &str, out: &str| {
        let mut command = assert_cmd::Command::cargo_bin("cdpr").unwrap();
        command.current_dir(folder.path()).args(["demo", "--threads", threads, "--quiet", "--out", out]);
        assert_eq!(run(&mut command).exit_code, 0);
        contents(&folder.path().join(out))
    };
    let first = on_threads("1", "one");
    assert_eq!(first, on_threads("4", "four"));
    let again =
        cdpr_in(&folder.path().join("one"), "select robot.toml training.csv --validation validation.csv --format json");
    assert_eq!(again.json()["recommended"], "standard:frame-anchor,length-offset,length-scale");
    for set in ["training", "validation"] {
        let seed = if set == "training" { 1 } else { 2 };
        let run =
            cdpr_in(&folder.path().join("one"), &format!("simulate {set}-study.toml --out again.csv --seed {seed}"));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        let again = std::fs::read(folder.path().join("one/again.csv")).unwrap();
        assert_eq!(again, first[&format!("{set}.csv")], "{set}");
    }
}

#[test]
fn a_limit_that_nobody_keeps_is_a_negative_answer() {
    let folder = tempfile::tempdir().unwrap();
    let run = cdpr_in(folder.path(), "demo --require position_mean_m=0.0001 --format json");
    assert_eq!(run.exit_code, 1);
    let answer = run.json();
    assert!(answer["recommended"].is_null());
    assert!(answer["reason"].as_str().unwrap().contains("position_mean_m"), "{}", answer["reason"]);
}

#[test]
fn what_cannot_be_compared_is_refused_before_anything_is_written() {
    let folder = tempfile::tempdir().unwrap();
    cdpr_in(folder.path(), "demo --out data");
    for (arguments, message) in [
        ("--candidates standart", "standart"),
        ("--candidates pulley", "pulley_swivel_axis"),
        ("--candidates standard:pulley-radius", "pulley-radius"),
        ("--require speed=1", "speed"),
        ("--split thirds", "thirds"),
        ("--split blocks:500", "500"),
        ("--criterion force", "force"),
        ("--prior platform-anchor=-1", "platform-anchor=-1"),
    ] {
        let run = cdpr_in(folder.path(), &format!("select data/robot.toml data/training.csv --out result {arguments}"));
        assert_eq!(run.exit_code, 2, "{arguments}: {}{}", run.stdout, run.stderr);
        assert!(run.stderr.contains(message), "{arguments}: {}", run.stderr);
        assert!(!folder.path().join("result").exists(), "{arguments}");
    }
}

#[test]
fn a_study_that_says_something_wrong_is_placed() {
    let study = include_str!("../../src/commands/demo/training.toml");
    for (from, to, place, message) in [
        ("\"standard\"", "\"standart\"", "study.toml:6:9", "standart"),
        ("[initial]", "[initial]\noffset = \"zero\"", "study.toml:13:10", "none"),
        ("count = 16", "cuont = 16", "study.toml:", "cuont"),
        ("max = [1.5", "max = [-2.5", "study.toml:", "above max"),
        ("position_m = 0.001155", "position_m = nan", "study.toml:", "nan"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("study.toml"), study.replacen(from, to, 1)).unwrap();
        let run = cdpr_in(folder.path(), "simulate study.toml --out data.csv");
        assert_eq!(run.exit_code, 2, "{message}: {}", run.stderr);
        assert!(run.stderr.contains(place) && run.stderr.contains(message), "{place} {message}: {}", run.stderr);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is written");
    }
}

#[test]
fn identify_writes_a_report() {
    let folder = tempfile::tempdir().unwrap();
    cdpr_in(folder.path(), "demo --out data");
    let run = cdpr_in(
        folder.path(),
        "identify data/robot.toml data/training.csv --free frame-anchor --validation data/validation.csv --report r.html",
    );
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let page = std::fs::read_to_string(folder.path().join("r.html")).unwrap();
    assert!(page.contains("all 24 parameters are determined"), "the reason in words");
    assert!(
        page.contains("Identified control model") && !page.contains("Recommended control model"),
        "nobody asked which to take"
    );
}

/// Poses may come from a file with the pose columns of measurements; other columns are ignored.
#[test]
fn a_study_takes_its_poses_from_a_file() {
    let folder = tempfile::tempdir().unwrap();
    cdpr_in(folder.path(), "demo --out data");
    let study = "[control]\nrobot = \"cablerobot-simulator-helicopter\"\n[machine]\nrobot = \"data/calibrated.toml\"\n\
                 [initial]\npose = [0, 0, 1.5, 0, 0, 0]\noffset = \"none\"\n[poses.file]\npath = \"data/validation.csv\"\nset = \"train\"\n";
    std::fs::write(folder.path().join("study.toml"), study).unwrap();
    let run = cdpr_in(folder.path(), "simulate study.toml --out again.csv --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    assert_eq!(run.json()["samples"], 60);
    // without noise the machine's own model explains the samples to the tolerance of forward kinematics
    let run = cdpr_in(folder.path(), "evaluate data/calibrated.toml again.csv --format json");
    assert!(run.json()["position_error_m"]["max"].as_f64().unwrap() < 1e-9, "{}", run.stdout);
}
