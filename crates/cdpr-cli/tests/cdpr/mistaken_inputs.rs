//! Measurement files with the mistakes that people make: refused with their place, or named first of all doubts.

use cdpr_model::measurement::{Samples, mix_ups};
use cdpr_model::robot::Robot;

use super::{Run, cdpr_in};

/// The folder of a case beside the project, copied; `None` with a word where it is not here.
#[expect(clippy::print_stderr, reason = "a test that skips says so")]
pub(super) fn case(name: &str) -> Option<tempfile::TempDir> {
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

/// One recorded answer of `select`: the folder, further options, exit code, status, and kind, cable (from 1), line and words of the first finding.
struct Told {
    case: &'static str,
    options: &'static str,
    exit_code: i32,
    status: &'static str,
    kind: &'static str,
    cable: Option<u64>,
    line: Option<u64>,
    words: &'static str,
}

const fn told(
    case: &'static str,
    exit_code: i32,
    status: &'static str,
    kind: &'static str,
    words: &'static str,
) -> Told {
    Told { case, options: "", exit_code, status, kind, cable: None, line: None, words }
}

/// Findings of dirty records stand first, with their place, and decide status and exit code.
#[test]
fn answers_that_data_and_statics_deny_say_so() {
    let other = "--validation validation.csv";
    let (caution, distrust) = ("recommended-with-caution", "not-trusted");
    for expected in [
        told("06-tensions-in-kgf", 1, distrust, "unit", "a newton is 0.102 kgf"),
        told("08-file-pasted-twice", 0, "recommended", "repeat", "200 of 240 rows repeat others exactly"),
        Told {
            cable: Some(3),
            line: Some(52),
            ..told("10-cable-reclamped", 1, distrust, "step", "cable 3: +20.3 mm from line 52 on")
        },
        Told {
            options: other,
            ..told("11-payload-tripled-in-validation", 1, distrust, "load", "balance 147 N, those of the fit 49.0 N")
        },
        Told {
            options: other,
            line: Some(2),
            ..told(
                "12-other-day-offsets-10mm",
                1,
                distrust,
                "offset",
                "a constant each, 10.0 mm rms, in the validation data",
            )
        },
        told("13-corner", 0, caution, "coverage", "the samples span 0.1 % of the workspace of the robot file"),
        Told {
            cable: Some(4),
            line: Some(42),
            ..told("15-encoder-stuck", 0, caution, "stuck", "from line 42 to line 71")
        },
        told("16-zyx-euler", 0, caution, "rotation-convention", "roll–pitch–yaw"),
        told("22-mirrored-camera", 1, distrust, "mirror", "x, y, −z of the data"),
        Told { cable: Some(6), ..told("26-cable-never-taut", 1, distrust, "slack", "does it hang slack") },
    ] {
        let Some(folder) = case(expected.case) else { return };
        let run = cdpr_in(folder.path(), &format!("select robot.toml data.csv {} --format json", expected.options));
        let answer = run.json();
        let first = &answer["findings"][0];
        assert_eq!(
            (run.exit_code, &answer["status"]),
            (expected.exit_code, &expected.status.into()),
            "{}: {first}",
            expected.case
        );
        assert_eq!(
            (&first["kind"], first["cable"].as_u64()),
            (&expected.kind.into(), expected.cable),
            "{}: {first}",
            expected.case
        );
        assert!(
            expected.line.is_none_or(|line| first["line"].as_u64().unwrap().abs_diff(line) <= 2),
            "{}: {first}",
            expected.case
        );
        assert!(first["text"].as_str().unwrap().contains(expected.words), "{}: {first}", expected.case);
        assert!(answer["warnings"].as_array().unwrap().contains(&first["text"]), "{}", expected.case);
    }
}

/// Frees the step that a finding names: the fit converges, to the size that the generator gave the step.
#[test]
fn a_step_is_taken_up_by_the_offset_that_its_finding_names() {
    let Some(folder) = case("10-cable-reclamped") else { return };
    let told = cdpr_in(folder.path(), "select robot.toml data-with-accuracies.csv");
    assert!(told.exit_code == 1 && told.stdout.contains("`length-offset[3]@52` free takes it up"), "{}", told.stdout);
    let free = "frame-anchor,length-offset,length-offset[3]@52";
    let run = cdpr_in(
        folder.path(),
        &format!("identify robot.toml data-with-accuracies.csv --free {free} --format json --out fit.toml"),
    );
    let answer = run.json();
    assert_eq!((run.exit_code, &answer["status"]), (0, &"converged".into()), "{}", answer["warnings"]);
    let shift = &answer["length_shifts"][0];
    let number = |key: &str| shift[key].as_f64().unwrap();
    assert!((number("change_m") - 0.02).abs() < 4.0 * number("sigma_m") && number("sigma_m") < 5e-4, "{shift}");
    assert!((number("length_offset_after_m") - number("length_offset_before_m") - number("change_m")).abs() < 1e-12);
    assert_eq!(
        (&shift["parameter"], &shift["line"], &shift["cable"]),
        (&"length-offset[3]@52".into(), &52.into(), &3.into())
    );
    // the written robot is the machine of today
    let written = std::fs::read_to_string(folder.path().join("fit.toml")).unwrap();
    let third = written.split("[[cable]]").nth(3).unwrap();
    let line = third.lines().find_map(|line| line.strip_prefix("length_offset_m = ")).unwrap();
    assert!((line.parse::<f64>().unwrap() - number("length_offset_after_m")).abs() < 1e-9, "{line} {shift}");
    // as a candidate it wins, with its change beside it
    let both = format!("standard:frame-anchor,length-offset;standard:{free}");
    let run = cdpr_in(
        folder.path(),
        &format!("select robot.toml data-with-accuracies.csv --candidates {both} --format json"),
    );
    let answer = run.json();
    assert_eq!(answer["recommended"], format!("standard:{free}"), "{}", answer["reason"]);
    assert_eq!(answer["length_shifts"].as_array().unwrap().len(), 1);
}

/// A wrong center of mass leaves lengths as they are; poses of a hanging platform show it.
#[test]
fn a_center_of_mass_that_is_elsewhere_is_named() {
    let Some(folder) = case("23-underconstrained-clean-false-alarm") else { return };
    let path = folder.path().join("robot.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let told = "center_of_mass_m = [0.0, 0.0, -0.1]";
    assert!(text.contains(told));
    for (center, severity) in [("0.06, -0.03, -0.1", "caution"), ("0.3, 0.0, -0.1", "distrust")] {
        std::fs::write(&path, text.replace(told, &format!("center_of_mass_m = [{center}]"))).unwrap();
        let run = cdpr_in(folder.path(), "select robot.toml data.csv --validation validation.csv --format json");
        let (answer, first) = (run.json(), run.json()["findings"][0].clone());
        assert_eq!((&first["kind"], run.exit_code), (&"load".into(), 1), "{}", answer["findings"]);
        assert!(first["severity"] == severity || answer["trusted"] == false, "{first}");
        let words = first["text"].as_str().unwrap();
        assert!(words.contains("center of mass at (") && first["explains"].as_f64().unwrap() > 0.9, "{first}");
    }
}

/// Clean data raise nothing, candidates are compared on the same samples, and the error of a prediction is held against what lengths and tracker allow.
#[test]
fn clean_and_noisy_data_get_the_right_model() {
    let anchors_and_offsets = "standard:frame-anchor,length-offset";
    for (name, options, recommended) in [
        ("20-clean-wall-plotter-false-alarm", "", anchors_and_offsets),
        ("23-underconstrained-clean-false-alarm", "--validation validation.csv", "standard:frame-anchor"),
        ("25-noisy-tracker-underfit", "", anchors_and_offsets),
        ("29-frame-anchor-sigma", "--validation validation.csv", anchors_and_offsets),
    ] {
        let Some(folder) = case(name) else { return };
        let run = cdpr_in(folder.path(), &format!("select robot.toml data.csv {options} --format json"));
        let answer = run.json();
        assert_eq!((run.exit_code, &answer["status"]), (0, &"recommended".into()), "{name}: {}", answer["warnings"]);
        assert_eq!(answer["recommended"], recommended, "{name}: {}", answer["reason"]);
        assert_eq!(answer["findings"], serde_json::json!([]), "{name}");
    }
    let Some(folder) = case("27-validation-is-training") else { return };
    let run = cdpr_in(folder.path(), "select robot.toml data.csv --validation data.csv");
    assert!(run.exit_code == 2 && run.stderr.contains("the validation file is the training file"), "{}", run.stderr);
    // what offsets would explain is taken up by anchors, whose deviations are then too small
    let Some(folder) = case("29-frame-anchor-sigma") else { return };
    let fit = cdpr_in(folder.path(), "identify robot.toml data.csv --free frame-anchor --format json").json();
    assert_eq!(
        (&fit["status"], &fit["findings"][0]["kind"]),
        (&"converged-with-caution".into(), &"lack-of-fit".into()),
        "{}",
        fit["warnings"]
    );
}
