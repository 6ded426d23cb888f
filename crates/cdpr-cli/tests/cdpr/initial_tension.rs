//! `cdpr initial-tension`: winches set for the poses of a study.

use super::{cdpr, cdpr_in};

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

/// Where a target of one's own, brought into balance, would let a cable push there is none: the answer names the poses. What they
/// leave counts.
#[test]
fn poses_without_a_target_are_named() {
    let run =
        |more: &str| cdpr(&format!("initial-tension {} --target 200,200,4000,4000 {more}", study("planar-wide-grid")));
    let answer = run("--format json").json_with(&["poses_without_target", "no_target", "starts", "starts_agreeing"]);
    let missing = answer["poses_without_target"].as_array().unwrap();
    let counted = answer["after"]["poses"].as_u64().unwrap() as usize;
    assert!(!missing.is_empty() && counted + missing.len() == 25, "{answer}");
    assert!(answer["no_target"].as_str().unwrap().contains("push"), "{answer}");
    let words = run("").stdout;
    assert!(words.contains(&format!("{} of 25 poses have no target and do not count", missing.len())), "{words}");
}

/// At the initial pose alone the winches cannot be set better than by the target itself; random poses in a box of their own need no grid.
#[test]
fn nothing_to_gain_is_said_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(study("planar-wide-grid")).unwrap();
    let head = text.split("[poses").next().unwrap();
    let write = |poses: &str| std::fs::write(folder.path().join("study.toml"), format!("{head}{poses}")).unwrap();
    write("[poses.random]\nmin = [0, 5.2]\nmax = [0, 5.2]\ncount = 2\n");
    let run = cdpr_in(folder.path(), "initial-tension study.toml");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    assert!(
        run.stdout.starts_with("nothing to gain") && run.stdout.lines().skip(1).all(|line| line.starts_with(' ')),
        "{}",
        run.stdout
    );
    let answer = cdpr_in(folder.path(), "initial-tension study.toml --format json").json();
    assert_eq!((answer["status"].as_str(), answer["poses"].as_u64()), (Some("nothing-to-gain"), Some(2)), "{answer}");
    for (poses, words) in [
        ("[poses.random]\ncount = 2\n", "add min and max here, or [poses.grid]"),
        ("[poses.random]\nmin = [0, 5.2]\ncount = 2\n", "a box has two corners"),
        ("[poses.random]\nmin = [0, 6]\nmax = [0, 5]\ncount = 2\n", "above max"),
    ] {
        write(poses);
        let run = cdpr_in(folder.path(), "initial-tension study.toml");
        assert!(run.exit_code == 2 && run.stderr.contains(words), "{words}: {}", run.stderr);
    }
}
