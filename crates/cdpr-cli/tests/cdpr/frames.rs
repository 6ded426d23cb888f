//! Poses in the world of a tracker: told where they are not freed, found where they are.

use std::path::Path;

use super::{cdpr_in, root};

/// The table with its poses as a tracker tells them whose world is turned by a right angle about z and lies at (1, 2, 0.5) m.
fn by_tracker(table: &str) -> String {
    let mut lines = table.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let at = |name: &str| header.iter().position(|column| *column == name).unwrap();
    let position = ["x_m", "y_m", "z_m"].map(at);
    let rotation = ["qx", "qy", "qz", "qw"].map(at);
    let mut text = format!("{}\n", header.join(","));
    for line in lines {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        let number = |place: usize| cells[place].parse::<f64>().unwrap();
        let [x, y, z] = position.map(number);
        let [i, j, k, w] = rotation.map(number);
        let s = 0.5_f64.sqrt();
        let told = [y - 2.0, 1.0 - x, z - 0.5, s * (i + j), s * (j - i), s * (k - w), s * (w + k)];
        for (place, value) in position.into_iter().chain(rotation).zip(told) {
            cells[place] = value.to_string();
        }
        text.push_str(&format!("{}\n", cells.join(",")));
    }
    text
}

fn recorded(folder: &Path) {
    let study = root().join("studies/twin-kinematic-measurements.toml");
    let run = cdpr_in(folder, &format!("simulate {} --out straight.csv", study.display()));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let table = std::fs::read_to_string(folder.join("straight.csv")).unwrap();
    std::fs::write(folder.join("turned.csv"), by_tracker(&table)).unwrap();
    std::fs::copy(folder.join("straight.meta.toml"), folder.join("turned.meta.toml")).unwrap();
}

/// The doubts that an answer tells before anything else but its subject.
fn doubts(answer: &str) -> Vec<String> {
    let mut doubts: Vec<String> = Vec::new();
    let mut goes_on = false;
    for line in answer.lines() {
        match line.strip_prefix("caution: ") {
            Some(doubt) => doubts.push(doubt.to_owned()),
            // lines below a doubt that begin further right are folded from it
            None if goes_on && line.starts_with("  ") => {
                doubts.last_mut().unwrap().push_str(&format!(" {}", line.trim_start()));
            }
            None => {}
        }
        goes_on = line.starts_with("caution: ") || (goes_on && line.starts_with("  "));
    }
    doubts
}

/// True for an answer that doubts poses that need the frame of a tracker, before it distrusts what came of them.
fn needs_frame(answer: &str) -> bool {
    let doubts = doubts(answer);
    let place =
        doubts.iter().position(|doubt| doubt.starts_with("frames: ") && doubt.contains("let `tracker-frame` be free"));
    let distrust = doubts.iter().position(|doubt| doubt.starts_with("not to be trusted"));
    place.is_some_and(|place| distrust.is_none_or(|distrust| place < distrust))
}

const IDENTIFY: &str = "identify cablerobot-simulator-helicopter turned.csv --model standard --split blocks:4";

#[test]
fn frames_are_told_where_they_are_held_and_found_where_they_are_free() {
    let folder = tempfile::tempdir().unwrap();
    recorded(folder.path());
    let held = cdpr_in(folder.path(), &format!("{IDENTIFY} --free length-offset"));
    assert_eq!(held.exit_code, 1, "{}", held.stdout);
    assert!(needs_frame(&held.stdout), "{}", held.stdout);
    // anchors that are free follow the tracker's world, which leaves no error and a file in another frame
    let followed = cdpr_in(folder.path(), &format!("{IDENTIFY} --free frame-anchor"));
    // rigid cables turn the platform by six times the accuracy of its orientation
    assert_eq!(followed.exit_code, 1, "{}", followed.stdout);
    assert!(needs_frame(&followed.stdout), "{}", followed.stdout);

    let free = "--free frame-anchor,tracker-frame";
    let words = cdpr_in(folder.path(), &format!("{IDENTIFY} {free} --out calibrated.toml"));
    assert_eq!(words.exit_code, 1, "{}{}", words.stdout, words.stderr);
    assert!(
        words.stdout.contains("tracker frame: world of the tracker in the robot's frame, at ("),
        "{}",
        words.stdout
    );
    assert!(words.stdout.contains("gauge: the data leave translation and rotation free (6 directions)"));
    let answer = cdpr_in(folder.path(), &format!("{IDENTIFY} {free} --format json"));
    let answer = answer.json_with(&["tracker_frame", "gauge", "validation"]);
    assert!(answer["marker_frame"].is_null());
    let numbers = |key: &str| -> Vec<f64> {
        answer["tracker_frame"][key].as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()
    };
    // anchors of the machine and of the file are centimetres apart, and with them the frame that lays one on the other
    for (found, true_one) in numbers("position_m").iter().zip([1.0, 2.0, 0.5]) {
        assert!((found - true_one).abs() < 0.1, "{found} {true_one}");
    }
    assert!((numbers("rotation_rad")[2] - std::f64::consts::FRAC_PI_2).abs() < 0.04);
    assert!(numbers("sigma_position_m").iter().all(|sigma| (1e-5..1e-2).contains(sigma)));
    assert_eq!(answer["gauge"]["kind"], "least-change");
    assert_eq!(answer["gauge"]["free"], serde_json::json!(["translation", "rotation"]));

    // as good as without a tracker's world, and in the frame of the file
    let straight = IDENTIFY.replace("turned", "straight");
    let straight = cdpr_in(folder.path(), &format!("{straight} --free frame-anchor --format json"));
    let mean = |answer: &serde_json::Value| answer["validation"]["position_error_m"]["mean"].as_f64().unwrap();
    let ratio = mean(&answer) / mean(&straight.json_with(&["validation"]));
    assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
    let check = cdpr_in(folder.path(), "check calibrated.toml");
    assert_eq!(check.exit_code, 0, "{}", check.stderr);
}

#[test]
fn select_frees_the_frame_that_poses_need_and_says_so_first() {
    let folder = tempfile::tempdir().unwrap();
    recorded(folder.path());
    let select = "select cablerobot-simulator-helicopter turned.csv --split blocks:4 --candidates standard;standard:frame-anchor";
    let run = cdpr_in(folder.path(), select);
    assert_eq!(run.exit_code, 1, "{}{}", run.stdout, run.stderr);
    let place = |words: &str| run.stdout.find(words).unwrap_or_else(|| panic!("no `{words}` in {}", run.stdout));
    assert!(place("caution: frames: the poses fit the robot only with `tracker-frame`") < place("candidate "));
    assert!(run.stdout.contains("not to be trusted: rigid · frame anchors, tracker frame (24)"), "{}", run.stdout);
    // what a right angle makes of a symmetric robot is no permutation
    assert!(!run.stdout.contains("permuted"), "{}", run.stdout);
    let held = cdpr_in(folder.path(), &format!("{select} --hold tracker-frame,marker-frame --format json"));
    let names = held.json_with(&["candidates"])["candidates"].clone();
    assert_eq!(names[1]["name"], "standard:frame-anchor");
}

/// Columns of two cables swapped: every answer says so first, and so does the first screen of a page.
#[test]
fn a_mix_up_is_the_first_doubt_of_every_answer() {
    let folder = tempfile::tempdir().unwrap();
    recorded(folder.path());
    let table = std::fs::read_to_string(folder.path().join("straight.csv")).unwrap();
    let swapped = table.replacen("cable_length_m_2", "other", 1).replacen("cable_length_m_5", "cable_length_m_2", 1);
    std::fs::write(folder.path().join("swapped.csv"), swapped.replacen("other", "cable_length_m_5", 1)).unwrap();
    std::fs::copy(folder.path().join("straight.meta.toml"), folder.path().join("swapped.meta.toml")).unwrap();
    let data = "cablerobot-simulator-helicopter swapped.csv";
    let identify =
        format!("identify {data} --model standard --free length-offset --split blocks:4 --report report.html");
    let select = format!("select {data} --split blocks:4 --candidates standard;standard:frame-anchor --out result");
    for command in [&identify, &select, &format!("evaluate {data} --model standard")] {
        let words = cdpr_in(folder.path(), command).stdout;
        let first = &doubts(&words)[0];
        assert!(first.starts_with("swapped.csv: the cables look permuted"), "{command}: {words}");
        let answer = cdpr_in(folder.path(), &format!("{command} --format json")).json();
        let warnings = answer["warnings"].as_array().unwrap();
        let told: Vec<usize> =
            (0..warnings.len()).filter(|&k| warnings[k].as_str().unwrap().contains("look permuted")).collect();
        assert_eq!((told, &answer["trusted"]), (vec![0], &serde_json::json!(false)), "{command}: {warnings:?}");
    }
    for page in ["report.html", "result/report.html"] {
        let html = std::fs::read_to_string(folder.path().join(page)).unwrap();
        let list = &html[html.find("id=\"warnings\"").unwrap()..];
        let first = &list[list.find("<li").unwrap()..list.find("</li>").unwrap()];
        assert!(first.contains("look permuted"), "{page}: {first}");
    }
}
