//! Paths of penalties and smaller models of `cdpr identify`.

use super::{Run, cdpr_in, root};

const ROBOT: &str = "cablerobot-simulator-helicopter";

/// Record of the chapter on penalties: 91 poses of the rebuilt machine, in a folder of its own.
fn recorded() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let study = root().join("studies/twin-kinematic-measurements.toml");
    let run = cdpr_in(folder.path(), &format!("simulate {} --seed 1 --out samples.csv", study.display()));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    folder
}

fn identify(folder: &tempfile::TempDir, options: &str) -> Run {
    let anchors = "--free frame-anchor,platform-anchor --starts 1";
    cdpr_in(folder.path(), &format!("identify {ROBOT} samples.csv {anchors} {options}"))
}

/// The same record, every pose with the orientation of the start (sec. 6.3).
fn without_turns(folder: &tempfile::TempDir) {
    let file = folder.path().join("samples.csv");
    let text = std::fs::read_to_string(&file).unwrap();
    let mut lines = text.lines();
    let heading = lines.next().unwrap();
    let names: Vec<&str> = heading.split(',').collect();
    let row = |line: &str| {
        let value = |(name, value): (&&str, &str)| match *name {
            "qx" | "qy" | "qz" => "0".to_owned(),
            "qw" => "1".to_owned(),
            _ => value.to_owned(),
        };
        names.iter().zip(line.split(',')).map(value).collect::<Vec<_>>().join(",")
    };
    // the grid of one orientation comes first
    let rows: Vec<String> = lines.take(75).map(row).collect();
    std::fs::write(&file, format!("{heading}\n{}\n", rows.join("\n"))).unwrap();
}

/// What stands in the chapter: 48 anchors fit noise, and a lasso holds 14 of them back.
#[test]
fn the_chapter_on_penalties_is_true() {
    let folder = recorded();
    let answer = identify(&folder, "--path lasso --path-figure path.svg --out-path sparse.toml --format json").json();
    let path = answer["path"].as_array().unwrap();
    assert_eq!(
        (path.len(), path[0]["parameter_count"].as_u64(), path[50]["lambda"].as_f64()),
        (51, Some(0), Some(0.0))
    );
    assert!(path.iter().all(|point| point["converged"] == true));
    let at = |lambda: &serde_json::Value| path.iter().find(|point| point["lambda"] == *lambda).unwrap();
    let (best, chosen) = (at(&answer["path_choice"]["best_lambda"]), at(&answer["path_choice"]["chosen_lambda"]));
    let millimetres = |point: &serde_json::Value| 1e3 * point["validation"].as_f64().unwrap();
    let near = |value: f64, expected: f64| assert!((value - expected).abs() < 0.051, "{value}, told {expected}");
    near(millimetres(&path[50]), 14.2);
    near(millimetres(best), 3.9);
    near(millimetres(chosen), 3.9);
    assert_eq!(chosen["parameter_count"], 34);
    assert_eq!(answer["path_choice"]["left"].as_array().unwrap().len(), 14);
    let figure = root().join("docs/book/src/figures/lasso-path.svg");
    let drawn = std::fs::read_to_string(folder.path().join("path.svg")).unwrap();
    assert!(drawn == std::fs::read_to_string(figure).unwrap(), "draw the figure of the chapter again");
    let judged = cdpr_in(folder.path(), "evaluate sparse.toml samples.csv --format json").json();
    assert!(judged["position_error_m"]["mean"].as_f64().unwrap() < 0.0035, "{}", judged["position_error_m"]["mean"]);
}

/// Sec. 6.3: the program proposes 24 instead of 48 parameters and writes the robot as a point; it predicts within a percent of the full model.
#[test]
fn one_orientation_proposes_a_point_and_writes_it() {
    let folder = recorded();
    without_turns(&folder);
    let run = identify(&folder, "--out-reduced point.toml --split kfold:5");
    assert!(run.stdout.contains("smaller model: 48 → 24 parameters, motion pattern 3R3T → 3T"), "{}", run.stdout);
    assert!(run.prose().contains("the rank is 24 of 48"), "{}", run.stdout);
    let text = identify(&folder, "--split kfold:5 --format json").stdout;
    let answer: serde_json::Value = serde_json::from_str(&text).unwrap();
    let reduction = &answer["reduction"];
    assert_eq!((&reduction["evidence"], &reduction["patterns"][1]), (&"rank".into(), &"3T".into()));
    let [full, reduced] = [0, 1].map(|k| reduction["position_mean_m"][k].as_f64().unwrap());
    assert!(reduced <= 1.01 * full, "{reduced} {full}");
    let judged = cdpr_in(folder.path(), "evaluate point.toml samples.csv --format json").json();
    // 4.2 mm by hand for 75 poses with another noise (C25.3)
    let mean = 1e3 * judged["position_error_m"]["mean"].as_f64().unwrap();
    assert!((mean - 4.0).abs() < 0.3, "{mean}");
}

#[test]
fn a_path_of_another_cost_is_refused_and_nothing_smaller_is_told() {
    let folder = recorded();
    for options in ["--path lasso --loss huber", "--path ridge --objective pose", "--towards zero"] {
        let run = identify(&folder, options);
        assert_eq!(run.exit_code, 2, "{options}: {}", run.stdout);
    }
    let run = identify(&folder, "--out-reduced point.toml");
    assert!(run.prose().contains("point.toml is not written"), "{}", run.stdout);
    assert!(!folder.path().join("point.toml").exists());
}
