//! `select`, `simulate` and `demo`.

use std::collections::BTreeMap;
use std::path::Path;

use super::{SQUARE, cdpr_in, file_with, run};

/// Files of a folder and its subfolders with their bytes, but for the wall times of `result.json`.
pub(super) fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
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
    // the verdict compares with what the robot runs today
    let of_candidate = |name: &str| mean(name) / mean(answer["recommended"].as_str().unwrap());
    assert_eq!(answer["as_given"]["name"], "standard");
    let ratio = answer["as_given"]["ratio"].as_f64().unwrap();
    assert!((ratio / of_candidate("standard") - 1.0).abs() < 1e-12, "{ratio}");
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
    assert_eq!(again.json()["recommended"], "elastic:frame-anchor,platform-anchor,length-offset,compliance,wrench");
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

/// A folder tells of one result: the calibrated robots of the one before go, whatever else lies there stays.
#[test]
fn a_folder_holds_the_calibrated_robots_of_its_own_result_alone() {
    let folder = tempfile::tempdir().unwrap();
    cdpr_in(folder.path(), "demo --out data");
    let calibrated = || -> Vec<String> {
        let entries = std::fs::read_dir(folder.path().join("result/calibrated")).unwrap();
        let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    };
    let select = |arguments: &str| {
        cdpr_in(folder.path(), &format!("select data/robot.toml data/training.csv --out result {arguments}"))
    };
    select("--candidates standard;standard:frame-anchor");
    assert_eq!(calibrated(), ["01-standard.toml", "02-standard_frame-anchor.toml"]);
    std::fs::write(folder.path().join("result/calibrated/mine.toml"), "").unwrap();
    assert!(folder.path().join("result/calibrated.toml").exists());
    let run = select("--candidates standard --require position_mean_m=0.000001");
    assert_eq!(run.exit_code, 1, "{}", run.stderr);
    assert_eq!(calibrated(), ["01-standard.toml", "mine.toml"]);
    assert!(!folder.path().join("result/calibrated.toml").exists(), "nothing is recommended");
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
    // rigid cables err by seven times the accuracy of the poses
    assert_eq!(run.exit_code, 1, "{}", run.stderr);
    let page = std::fs::read_to_string(folder.path().join("r.html")).unwrap();
    assert!(page.contains("all 24 parameters are determined"), "the reason in words");
    assert!(
        page.contains("Identified control model") && !page.contains("Recommended control model"),
        "nobody asked which to take"
    );
}

/// Poses in a spot of a millimetre tell directions of cables badly, and lengths far below the real ones drive scales to their
/// bound: a candidate says so wherever it is named.
#[test]
fn weak_directions_and_bounds_are_told_wherever_a_candidate_is_named() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    let anchors = [[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]];
    let write = |name: &str, size: f64, factor: f64| {
        let mut text = "x_m,y_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4\n".to_owned();
        for row in 0..40 {
            let t = f64::from(row);
            let (x, z) = (4.0 + size * (1.7 * t).sin(), 3.0 + size * (2.3 * t).cos());
            text += &format!("{x},{z}");
            for (cable, [a_x, a_z]) in anchors.into_iter().enumerate() {
                let noise = 1e-4 * (3.1 * t + cable as f64).sin();
                text += &format!(",{}", factor * (x - a_x).hypot(z - a_z) + noise);
            }
            text.push('\n');
        }
        std::fs::write(folder.path().join(name), text).unwrap();
    };
    write("spot.csv", 0.001, 1.0);
    let arguments =
        "select square.toml spot.csv --sigma length_m=0.0001 --candidates standard:frame-anchor --criterion length";
    let run = cdpr_in(folder.path(), &format!("{arguments} --out result"));
    let line = run.stdout.lines().find(|line| line.starts_with("→")).unwrap();
    assert!(line.contains("weak directions, σ up to"), "the table: {}", run.stdout);
    let before = run.stdout.find("caution: ").unwrap();
    assert!(before < run.stdout.find("candidates by ").unwrap(), "doubts beside the verdict: {}", run.stdout);
    let answer = cdpr_in(folder.path(), &format!("{arguments} --format json")).json();
    let own = &answer["candidates"][0];
    assert!(own["weak_direction_count"].as_u64().unwrap() >= 4, "{own}");
    assert!(own["weak_direction_deviation_m"].as_f64().unwrap() > 0.1, "{own}");
    assert!(own["cautions"].to_string().contains("condition"), "{own}");
    assert!(answer["warnings"].to_string().contains("weak directions: σ up to"), "{answer}");
    let page = std::fs::read_to_string(folder.path().join("result/report.html")).unwrap();
    assert!(page.contains("class=\"verdict warned\"") && page.contains("weak directions, σ up to"));

    write("short.csv", 2.0, 2e-4);
    let arguments = "select square.toml short.csv --candidates standard:length-scale --criterion length";
    let run = cdpr_in(folder.path(), arguments);
    assert!(
        run.stdout.contains("4 at a bound") && run.stdout.contains("4 parameters lie at a bound"),
        "{}",
        run.stdout
    );
    let run = cdpr_in(folder.path(), "identify square.toml short.csv --free length-scale --format json");
    let answer = run.json();
    let at_bound = |parameter: &serde_json::Value| parameter["at_bound"] == true;
    assert!(answer["parameters"].as_array().unwrap().iter().all(at_bound), "{}", answer["parameters"]);
    assert!(answer["reason"].as_str().unwrap().contains("at a bound"), "{}", answer["reason"]);
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

/// Rows of a measurement file that are displaced by 0.2 m, with their lines.
fn with_displaced_rows(csv: &str, lines: &[usize]) -> String {
    let column = csv.lines().next().unwrap().split(',').position(|name| name == "x_m").unwrap();
    let changed = |(index, text): (usize, &str)| {
        let mut cells: Vec<String> = text.split(',').map(str::to_owned).collect();
        if lines.contains(&(index + 1)) {
            cells[column] = (cells[column].parse::<f64>().unwrap() + 0.2).to_string();
        }
        cells.join(",") + "\n"
    };
    csv.lines().enumerate().map(changed).collect()
}

/// Text, JSON, tables and page name the same rows, before they tell the good news.
#[test]
fn outliers_are_told_before_the_good_news_everywhere() {
    const LINES: [usize; 3] = [12, 40, 77];
    let folder = tempfile::tempdir().unwrap();
    cdpr_in(folder.path(), "demo --out data");
    let clean = std::fs::read_to_string(folder.path().join("data/training.csv")).unwrap();
    std::fs::write(folder.path().join("dirty.csv"), with_displaced_rows(&clean, &LINES)).unwrap();
    std::fs::copy(folder.path().join("data/training.meta.toml"), folder.path().join("dirty.meta.toml")).ok();
    let arguments = "--candidates standard;standard:frame-anchor,length-offset,length-scale --split blocks:5 --seed 1";
    let run = cdpr_in(folder.path(), &format!("select data/robot.toml dirty.csv --out result {arguments}"));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let place = |text: &str, words: &str| text.find(words).unwrap_or_else(|| panic!("`{words}` is not in {text}"));
    assert!(place(&run.stdout, "recommended with caution:") < place(&run.stdout, "caution: outliers: 3 of"));
    let lines = |outliers: &serde_json::Value| -> Vec<u64> {
        let keys = |outlier: &serde_json::Value| {
            assert!(outlier["residual_m"].as_f64().unwrap() > 0.05 && outlier["weight"].as_f64().unwrap() < 0.5);
            assert!(outlier["reason"].as_str().unwrap().contains("robust standard deviations"));
            assert_eq!(outlier["sample"].as_u64().unwrap() + 1, outlier["line"].as_u64().unwrap());
            outlier["line"].as_u64().unwrap()
        };
        outliers.as_array().unwrap().iter().map(keys).collect()
    };
    let files = contents(&folder.path().join("result"));
    let result: serde_json::Value = serde_json::from_slice(&files["result.json"]).unwrap();
    assert_eq!(lines(&result["outliers"]), LINES.map(|line| line as u64));
    assert!(result["warnings"][0].as_str().unwrap().starts_with("outliers: 3 of"), "{}", result["warnings"]);
    let table = String::from_utf8(files["outliers.csv"].clone()).unwrap();
    assert_eq!(table.lines().count(), 1 + LINES.len(), "{table}");
    let page = String::from_utf8(files["report.html"].clone()).unwrap();
    assert!(place(&page, "<li>outliers: 3 of") < place(&page, "Recommended control model, to be used"));

    let identify = "identify data/robot.toml dirty.csv --free frame-anchor,length-offset,length-scale";
    let told = cdpr_in(folder.path(), identify).stdout;
    assert!(place(&told, "converged, to be used") < place(&told, "caution: outliers: 3 of"));
    let answer =
        cdpr_in(folder.path(), &format!("{identify} --format json")).json_with(&["outliers", "loss_threshold"]);
    assert_eq!(
        (lines(&answer["outliers"]), &answer["loss"]),
        (LINES.map(|line| line as u64).to_vec(), &"huber".into())
    );
    let squared = cdpr_in(folder.path(), &format!("{identify} --loss squared --format json")).json();
    assert_eq!((&squared["loss"], &squared["outliers"][0]["weight"]), (&"squared".into(), &1.0.into()));
}

/// The list of candidates is no more than that: its end, what is not on it, and what got worse are told in text, JSON and page.
#[test]
fn what_the_ladder_leaves_out_and_what_got_worse_are_told() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    let anchors = [[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]];
    let mut text = "x_m,y_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4\n".to_owned();
    for row in 0..60 {
        let t = f64::from(row);
        let (x, z) = (5.0 + 2.0 * (1.7 * t).sin(), 4.0 + 2.0 * (2.3 * t).cos());
        // one sample in five has the offsets of the others with the other sign: offsets mend the mean and harm these
        let offset = if row % 5 == 0 { -0.03 } else { 0.03 };
        text += &format!("{x},{z}");
        for (cable, [a_x, a_z]) in anchors.into_iter().enumerate() {
            text += &format!(",{}", (x - a_x).hypot(z - a_z) + if cable % 3 == 0 { offset } else { -offset });
        }
        text.push('\n');
    }
    std::fs::write(folder.path().join("samples.csv"), text).unwrap();
    let arguments = "select square.toml samples.csv --candidates standard;standard:length-offset --loss squared";
    let answer = cdpr_in(folder.path(), &format!("{arguments} --format json --out result")).json();
    assert_eq!(answer["recommended"], "standard:length-offset");
    assert!(answer["reason"].as_str().unwrap().contains("the list of candidates ends here"), "{answer}");
    let words = |key: &str| answer[key].as_array().unwrap().iter().map(|one| one.as_str().unwrap().to_owned());
    let untried: Vec<String> = words("untried").collect();
    assert!(untried.iter().any(|words| words.starts_with("pulleys (")), "{untried:?}");
    assert!(untried.iter().any(|words| words.contains("`frame-anchor`")), "{untried:?}");
    let worse = words("warnings").find(|words| words.starts_with("worse than with `standard` as given")).unwrap();
    assert!(worse.contains("largest position error"), "{worse}");
    let text = cdpr_in(folder.path(), &format!("{arguments} --verbose")).prose();
    assert!(text.contains("not among the candidates: pulleys (") && text.contains(&worse), "{text}");
    let page = std::fs::read_to_string(folder.path().join("result/report.html")).unwrap();
    assert!(page.contains("Not among the candidates: pulleys") && page.contains("worse than with"));
    assert!(page.contains("class=\"verdict warned\""));
}
