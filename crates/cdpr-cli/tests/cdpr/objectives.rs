//! Objectives and costs of `cdpr identify`, and the machine that a calibrated model drives.

use super::{Run, cdpr_in, root};

/// Record of the planar machine without noise, in a folder of its own.
fn recorded() -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let wide = root().join("studies/planar-wide-grid.toml").display().to_string();
    let run = cdpr_in(folder.path(), &format!("simulate {wide} --out wide.csv"));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    (folder, wide)
}

fn identify(folder: &tempfile::TempDir, options: &str) -> Run {
    cdpr_in(folder.path(), &format!("identify planar-example wide.csv --free frame-anchor --starts 1 {options}"))
}

/// Numbers of the requirements (C20).
#[test]
fn every_optimum_is_judged_by_all_others() {
    let (folder, wide) = recorded();
    let options = format!("--objective pose --minimize max --compare-objectives --drive {wide} --format json");
    let run = identify(&folder, &options);
    let answer: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(answer["objective"], "pose");
    assert_eq!(answer["certificate"]["active"].as_array().unwrap().len(), 7);
    let is_near =
        |value: &serde_json::Value, millimetres: f64| (1e3 * value.as_f64().unwrap() - millimetres).abs() < 2e-3;
    assert!(is_near(&answer["predicted"]["position_error_m"]["max"], 64.486));
    let optima = answer["objectives"].as_array().unwrap();
    assert_eq!(optima.len(), 7);
    let squares = optima.iter().find(|one| one["objective"] == "pose" && one["minimize"] == "squares").unwrap();
    assert!(is_near(&squares["driven"]["position_error_m"]["mean"], 26.264));
    assert!(is_near(&squares["pose_norm_m"]["rms"], 38.885));
}

/// The page of a comparison has a dot for each optimum in each panel, with the driven errors; that of a single fit those of both models.
#[test]
fn a_page_shows_the_errors_of_all_optima_side_by_side() {
    let (folder, wide) = recorded();
    let page = |options: &str| {
        let run = identify(&folder, &format!("--drive {wide} --report page.html {options}"));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        std::fs::read_to_string(folder.path().join("page.html")).unwrap()
    };
    let compared = page("--compare-objectives");
    assert!(compared.contains("least driven 26.0 mm (pose mean)"));
    assert!(compared.contains("driven position, mm") && compared.contains("pose mean, error: 26.0"));
    assert_eq!(compared.matches("<title>length squares, error: ").count(), 3, "predicted, driven, length");
    let single = page("");
    assert!(single.contains("<title>calibrated, error: 40.5</title>") && !single.contains("pose mean, error"));
}

/// Lengths and poses in their accuracies; without these refused in words.
#[test]
fn poses_are_unknowns_where_accuracies_are_known() {
    let (folder, _) = recorded();
    let run = identify(&folder, "--objective both");
    assert_eq!(run.exit_code, 2, "{}", run.stdout);
    assert!(run.stderr.contains("data::no-accuracies"), "{}", run.stderr);
    let run =
        identify(&folder, "--objective both --sigma length_m=0.03,position_m=0.03 --compare-objectives --format json");
    let answer: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(answer["objective"], "both");
    assert_eq!(answer["objectives"].as_array().unwrap().len(), 10);
    let run = identify(&folder, "--objective both --sigma length_m=0.03,position_m=0.03");
    assert!(run.stdout.contains("lengths and poses in their accuracies, the poses unknown"), "{}", run.stdout);
}

#[test]
fn costs_that_exclude_each_other_are_refused_in_words() {
    let (folder, _) = recorded();
    for options in
        ["--minimize max --loss huber", "--minimize max --prior frame-anchor=0.1", "--minimize mean --loss cauchy"]
    {
        let run = identify(&folder, options);
        assert_eq!(run.exit_code, 2, "{options}: {}", run.stdout);
        assert!(run.stderr.contains("setting::cost"), "{}", run.stderr);
    }
}

/// A row that is displaced is named and counts less whatever is made small, and the answer says by which loss.
#[test]
fn a_displaced_row_is_named_beside_every_objective() {
    let (folder, _) = recorded();
    let text = std::fs::read_to_string(folder.path().join("wide.csv")).unwrap();
    let column = text.lines().find(|line| line.contains("x_m")).unwrap().split(',').position(|name| name == "x_m");
    let line = 8;
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut cells: Vec<String> = lines[line - 1].split(',').map(str::to_owned).collect();
    let x = &mut cells[column.unwrap()];
    *x = (x.parse::<f64>().unwrap() + 1.0).to_string();
    lines[line - 1] = cells.join(",");
    std::fs::write(folder.path().join("wide.csv"), lines.join("\n")).unwrap();
    for objective in ["--objective pose", "--objective both --sigma length_m=0.03,position_m=0.03"] {
        let run = identify(&folder, objective);
        assert!(run.stdout.contains("sum over samples of the huber loss of"), "{}", run.stdout);
        let answer: serde_json::Value =
            serde_json::from_str(&identify(&folder, &format!("{objective} --format json")).stdout).unwrap();
        assert_eq!((&answer["loss"], &answer["outliers"][0]["line"]), (&"huber".into(), &line.into()), "{objective}");
        assert_eq!(answer["outliers"].as_array().unwrap().len(), 1, "{objective}");
        assert!(answer["warnings"][0].as_str().unwrap().starts_with("outliers: 1 of "), "{}", answer["warnings"]);
    }
}

/// The objective needs `--task` with a table `[task]` that is a box; with one the mean error over all poses is larger than by `--objective pose`.
#[test]
fn poses_count_where_the_task_of_a_study_is() {
    let (folder, wide) = recorded();
    let study = std::fs::read_to_string(&wide).unwrap();
    let task = "\n[task]\nmin = [-1.0, 3.0, 0.0]\nmax = [1.0, 5.0, 0.0]\n";
    std::fs::write(folder.path().join("task.toml"), format!("{study}{task}")).unwrap();
    std::fs::write(folder.path().join("flat.toml"), format!("{study}{}", task.replace("[1.0", "[-2.0"))).unwrap();
    let mean = |options: &str| {
        let run = identify(&folder, &format!("{options} --format json"));
        let answer: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        answer["predicted"]["position_error_m"]["mean"].as_f64().unwrap()
    };
    let (all, in_task) = (mean("--objective pose"), mean("--objective pose-in-task --task task.toml"));
    // the task wins what the rest loses
    assert!(in_task > all * (1.0 + 1e-4), "{in_task} {all}");
    let without = identify(&folder, "--objective pose-in-task");
    assert_eq!(without.exit_code, 2, "{}", without.stdout);
    assert!(without.stderr.contains("objective::no-task") && without.stderr.contains("--task"), "{}", without.stderr);
    let no_table = identify(&folder, &format!("--objective pose-in-task --task {wide}"));
    assert!(no_table.exit_code == 2 && no_table.stderr.contains("[task]"), "{}", no_table.stderr);
    let wrong = identify(&folder, "--objective pose-in-task --task flat.toml");
    assert!(wrong.exit_code == 2 && wrong.stderr.contains("max is above min"), "{}", wrong.stderr);
}
