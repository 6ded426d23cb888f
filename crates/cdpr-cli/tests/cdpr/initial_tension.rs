//! `cdpr initial-tension`: winches set for the poses of a study.

use super::cdpr;

/// The repository's study of this name.
fn study(name: &str) -> String {
    format!("{}/../../studies/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

/// The tensions that the chapter prints follow the middle of the limits almost twice as well as those of the initial pose, and the
/// last stage of the way there reads them.
#[test]
fn a_circle_gets_initial_tensions_of_its_own() {
    let run = cdpr(&format!("initial-tension {} --format json", study("planar-small-circle")));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["initial_tensions_N", "winch_offsets_m", "before", "after", "approach"]);
    let rms = |state: &str| answer[state]["rms_N"].as_f64().unwrap();
    assert!((rms("before") - 450.8).abs() < 0.1 && (rms("after") - 251.9).abs() < 0.1, "{answer}");
    let stages = answer["approach"]["stages"].as_array().unwrap();
    assert_eq!(stages.len(), 5);
    assert_eq!(stages[4]["tensions_N"], answer["initial_tensions_N"]);
    assert_eq!(stages[4]["moves"].as_array().unwrap().len(), 4);
    assert!(answer["after"]["reachable_area_m2"].as_f64().unwrap() > 40.0);
    let words = cdpr(&format!("initial-tension {} --stages 2 --target minimum", study("planar-small-circle")));
    assert!(words.stdout.contains("1000.0 at a limit") && words.stdout.contains("force sensors"), "{}", words.stdout);
}

/// 25 poses that reach the edge of the workspace: some tension breaks its limits whatever the initial ones.
#[test]
fn poses_that_break_the_limits_are_a_negative_answer() {
    let run = cdpr(&format!("initial-tension {} --format json", study("planar-wide-grid")));
    assert_eq!(run.exit_code, 1, "{}", run.stderr);
    let answer = run.json_with(&["status", "reason"]);
    assert!(answer["reason"].as_str().unwrap().contains("of 25 poses"), "{answer}");
}

#[test]
fn targets_that_are_none_are_refused() {
    for (target, code, words) in [("middling", 2, "middling"), ("1000,2000", 2, "2 entries")] {
        let run = cdpr(&format!("initial-tension {} --target {target}", study("planar-small-circle")));
        assert_eq!(run.exit_code, code, "{}", run.stderr);
        assert!(run.stderr.contains(words), "{}", run.stderr);
    }
}
