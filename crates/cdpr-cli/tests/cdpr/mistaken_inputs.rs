//! Measurement files with the mistakes that people make: refused with their place, or named first of all doubts.

use cdpr_model::measurement::{Samples, mix_ups};
use cdpr_model::robot::Robot;

use super::{Run, cdpr_in};

/// The folder of a case beside the project, copied; `None` with a word where it is not here.
#[expect(clippy::print_stderr, reason = "a test that skips says so")]
fn case(name: &str) -> Option<tempfile::TempDir> {
    let source = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/cases").join(name);
    if !source.is_dir() {
        assert!(std::env::var("CI").as_deref() != Ok("true"), "CI must have {}", source.display());
        eprintln!("skipped: {} is not here (cases are no part of the repository)", source.display());
        return None;
    }
    let folder = tempfile::tempdir().unwrap();
    for file in std::fs::read_dir(source).unwrap() {
        let path = file.unwrap().path();
        std::fs::copy(&path, folder.path().join(path.file_name().unwrap())).unwrap();
    }
    Some(folder)
}

fn evaluated(name: &str) -> Option<Run> {
    Some(cdpr_in(case(name)?.path(), "evaluate robot.toml data.csv"))
}

#[test]
fn files_in_another_unit_are_refused_with_the_unit() {
    for (name, place, words) in [
        ("01-metres-in-mm-columns-camera", "data.csv:1:5", "the positions look like metres"),
        ("02-lefthanded-and-0.001-camera", "data.csv:1:5", "the positions look like kilometres with z mirrored"),
        ("03-positions-in-feet-camera", "data.csv:1:5", "the positions look like feet"),
        ("04-positions-in-feet-box", "data.csv:1:5", "the positions look like feet"),
        ("18-inches-in-one-column", "data.csv:1:9", "the column y_m alone looks like inches"),
    ] {
        let Some(run) = evaluated(name) else { return };
        assert_eq!(run.exit_code, 2, "{name}: {}{}", run.stdout, run.stderr);
        for part in ["csv::magnitude", place, words] {
            assert!(run.stderr.contains(part), "{name}: `{part}` is missing in {}", run.stderr);
        }
    }
}

#[test]
fn mistakes_of_tables_are_told_with_their_mending() {
    for (name, code, words) in [
        ("17-cables-from-0", "csv::cable-count", "rename _0 … _3 to _1 … _4"),
        ("28-set-column-other-words", "csv::set", "`train`, and `validation` or `test`"),
    ] {
        let Some(run) = evaluated(name) else { return };
        assert_eq!(run.exit_code, 2, "{name}: {}", run.stderr);
        assert!(run.stderr.contains(code) && run.stderr.contains(words), "{name}: {}", run.stderr);
    }
    let Some(run) = evaluated("19-quoted-header-with-blanks") else { return };
    assert!(run.exit_code < 2, "{}", run.stderr);
}

#[test]
fn mix_ups_are_named_and_clean_data_are_not_accused() {
    for (name, words) in [
        ("06-tensions-in-kgf", "the tensions look like kilograms-force"),
        ("22-mirrored-camera", "x, y, z of the robot fit x, y, −z of the data"),
    ] {
        let Some(run) = evaluated(name) else { return };
        assert!(run.stdout.contains(words) && !run.stdout.contains("permuted"), "{name}: {}", run.stdout);
    }
    let Some(run) = evaluated("20-clean-wall-plotter-false-alarm") else { return };
    assert!(!run.stdout.contains("look"), "{}", run.stdout);
}

#[test]
fn poses_of_a_tracker_are_compared_whatever_its_frame() {
    let Some(folder) = case("tracker-far") else { return };
    let free = "--free length-offset,tracker-frame,marker-frame";
    let sigmas = "--sigma position_m=0.0005,rotation_rad=0.0003,length_m=0.0005";
    let run = cdpr_in(folder.path(), &format!("identify robot.toml data.csv {free} {sigmas}"));
    assert!(run.exit_code < 2 && !run.stdout.contains("look"), "{}{}", run.stdout, run.stderr);
    let Some(folder) = case("tracker-inverse-pose") else { return };
    for (file, words) in [
        ("he-ok", None),
        ("he-wxyz", Some("the scalar came first")),
        ("he-inv", Some("the quaternions look as if they turned the world into the platform")),
        ("he-invpose", Some("the poses look as if they were those of the world in the platform")),
    ] {
        let run = cdpr_in(folder.path(), &format!("identify robot.toml {file}.csv {free}"));
        assert!(run.exit_code < 2, "{file}: {}", run.stderr);
        let told = run.stdout.lines().find(|line| line.contains("look"));
        match words {
            None => assert_eq!(told, None, "{}", run.stdout),
            Some(words) => assert!(told.is_some_and(|line| line.contains(words)), "{file}: {}", run.stdout),
        }
    }
}

#[test]
fn a_calibrated_robot_shows_angles_of_another_order() {
    let Some(folder) = case("16-zyx-euler") else { return };
    let run = cdpr_in(
        folder.path(),
        "identify robot.toml data.csv --free frame-anchor,length-offset --out calibrated.toml --accept-untrusted",
    );
    assert_eq!(run.exit_code, 0, "{}{}", run.stdout, run.stderr);
    let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    let robot = Robot::from_toml_bytes(&read("calibrated.toml"), "calibrated.toml").unwrap();
    let samples = Samples::from_csv(&read("data.csv"), "data.csv", &robot).unwrap().samples;
    let found = mix_ups::with_robot(&robot, &samples).unwrap();
    assert!(found.text.contains("R = Rz Ry Rx (roll–pitch–yaw)"), "{}", found.text);
}
