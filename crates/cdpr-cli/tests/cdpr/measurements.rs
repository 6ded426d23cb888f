//! `identify` and `evaluate`.

use std::fmt::Write;

use super::{Run, SQUARE, cdpr_in, file_with};

/// Samples of the square robot on a 5 × 5 grid whose winches read `offset` metres too much.
fn samples_with(offset: f64) -> String {
    let anchors: [[f64; 2]; 4] = [[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]];
    let mut text = "x_m,z_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4,set\n".to_owned();
    for row in 0..25 {
        let (x, z): (f64, f64) = (2.0 + 1.5 * f64::from(row % 5), 2.0 + f64::from(row / 5));
        write!(text, "{x},{z}").unwrap();
        for [a_x, a_z] in anchors {
            write!(text, ",{}", (x - a_x).hypot(z - a_z) + offset).unwrap();
        }
        text.push_str(if row % 5 == 4 { ",validation\n" } else { ",train\n" });
    }
    text
}

/// Runs `cdpr` beside `square.toml` and `data.csv`, whose winches read 0.1 m too much.
fn with_data(arguments: &str) -> (tempfile::TempDir, Run) {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    std::fs::write(folder.path().join("data.csv"), samples_with(0.1)).unwrap();
    let run = cdpr_in(folder.path(), arguments);
    (folder, run)
}

const KEYS: [&str; 12] = [
    "status",
    "reason",
    "iterations",
    "parameter_count",
    "rank",
    "condition",
    "condition_scaled",
    "weak_directions",
    "correlations",
    "parameters",
    "train",
    "warnings",
];

#[test]
fn identified_offsets_are_those_of_the_data_and_the_calibrated_robot_predicts_them() {
    let (folder, run) = with_data("identify square.toml data.csv --free length-offset --out out.toml --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stdout);
    let answer = run.json_with(&KEYS);
    assert_eq!((answer["status"].as_str(), answer["parameter_count"].as_u64()), (Some("converged"), Some(4)));
    for parameter in answer["parameters"].as_array().unwrap() {
        assert!((parameter["value"].as_f64().unwrap() - 0.1).abs() < 1e-9, "{parameter}");
    }
    for block in ["position_error_m", "rotation_error_rad"] {
        ["mean", "rms", "median", "p95", "max"].iter().for_each(|key| assert!(answer["train"][block][key].is_number()));
    }
    ["mean_abs", "rms", "p95", "max"]
        .iter()
        .for_each(|key| assert!(answer["train"]["length_error_m"][key].is_number()));
    let evaluated = cdpr_in(folder.path(), "evaluate out.toml data.csv --out-errors errors.csv --format json");
    let evaluated =
        evaluated.json_with(&["samples", "position_error_m", "rotation_error_rad", "length_error_m", "not_converged"]);
    assert_eq!(evaluated["samples"], 25);
    assert!(evaluated["length_error_m"]["max"].as_f64().unwrap() < 1e-9);
    let errors = std::fs::read_to_string(folder.path().join("errors.csv")).unwrap();
    assert_eq!(errors.lines().count(), 26);
}

/// Poses in a frame 0.3 m aside on a robot of 12.8 m: no model is so wrong, and the answer says so as `select` does.
#[test]
fn errors_that_no_model_makes_are_not_trusted() {
    let exact = samples_with(0.0);
    let aside: String = exact
        .lines()
        .map(|line| match line.split_once(',') {
            Some((x, rest)) if x.parse::<f64>().is_ok() => format!("{},{rest}\n", x.parse::<f64>().unwrap() + 0.3),
            _ => format!("{line}\n"),
        })
        .collect();
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    for (name, text, trusted) in [("exact.csv", exact, true), ("aside.csv", aside, false)] {
        std::fs::write(folder.path().join(name), text).unwrap();
        let answer = cdpr_in(folder.path(), &format!("evaluate square.toml {name} --format json")).json();
        let words = cdpr_in(folder.path(), &format!("evaluate square.toml {name}")).stdout;
        let told = answer["warnings"].as_array().unwrap().iter().filter(|warning| {
            warning.as_str().unwrap().contains("is above 1 % of the diagonal of the sampled positions")
        });
        assert_eq!((&answer["trusted"], told.count()), (&trusted.into(), usize::from(!trusted)), "{answer}");
        assert_eq!(words.contains("caution: not to be trusted"), !trusted, "{words}");
    }
}

#[test]
fn every_minimizer_finds_the_same_offsets_and_others_are_refused() {
    for minimizer in ["levenberg-marquardt", "gauss-newton", "dogleg", "trust-region"] {
        let command =
            format!("identify square.toml data.csv --free length-offset --minimizer {minimizer} --format json");
        let (_folder, run) = with_data(&command);
        for parameter in run.json()["parameters"].as_array().unwrap() {
            assert!((parameter["value"].as_f64().unwrap() - 0.1).abs() < 1e-9, "{minimizer}: {parameter}");
        }
    }
    let (_folder, run) = with_data("identify square.toml data.csv --free length-offset --minimizer newton");
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("dogleg"), "{}", run.stderr);
}

#[test]
fn held_out_samples_are_judged_apart() {
    let (_folder, run) = with_data("identify square.toml data.csv --free length-offset --split column --format json");
    let answer = run.json_with(&["validation", "validation_before"]);
    assert_eq!((answer["train"]["samples"].as_u64(), answer["validation"]["samples"].as_u64()), (Some(20), Some(5)));
    let (_folder, run) = with_data("identify square.toml data.csv --free length-offset --split blocks:5 --format json");
    assert_eq!(run.json()["validation"]["samples"], 25);
    let (_folder, run) =
        with_data("identify square.toml data.csv --free length-offset --validation data.csv --format json");
    assert_eq!((run.exit_code, &run.json()["code"]), (2, &"data::validation-is-training".into()));
}

/// On a point platform, moving both anchors of a cable together changes nothing.
#[test]
fn what_the_data_do_not_determine_is_exit_code_1_and_the_file_is_written_all_the_same() {
    let arguments = "identify square.toml data.csv --free frame-anchor,platform-anchor --out out.toml --format json";
    let (folder, run) = with_data(arguments);
    assert_eq!(run.exit_code, 1);
    let answer = run.json_with(&KEYS);
    assert_eq!(answer["status"], "not-identifiable");
    assert_eq!((answer["rank"].as_u64(), answer["parameter_count"].as_u64()), (Some(8), Some(16)));
    assert!(answer["condition"].is_null(), "infinite is null");
    let words = answer["weak_directions"][0].as_str().unwrap();
    assert!(words.contains("all frame anchors and all platform anchors together along x"), "{words}");
    assert_eq!(cdpr_in(folder.path(), "check out.toml").exit_code, 0);
}

#[test]
fn a_prior_and_held_parameters_restore_the_rank() {
    for option in ["--prior platform-anchor=0.02", "--hold platform-anchor"] {
        let (_folder, run) = with_data(&format!(
            "identify square.toml data.csv --free frame-anchor,platform-anchor {option} --format json"
        ));
        assert_eq!(run.exit_code, 0, "{option}: {}", run.stdout);
    }
}

#[test]
fn sensor_accuracies_come_from_the_sidecar_and_the_command_line() {
    let (folder, run) = with_data("identify square.toml data.csv --free length-offset --format json");
    let warned = |run: &Run| run.json()["warnings"].to_string().contains("no sensor accuracy is known");
    assert!(warned(&run));
    let arguments = "identify square.toml data.csv --free length-offset --format json";
    let told = cdpr_in(folder.path(), &format!("{arguments} --sigma position_m=0.001,length_m=0.0002"));
    assert!(!warned(&told));
    let sidecar = "layout_version = 1\n[sigmas]\nposition_m = 0.001\nlength_m = 0.0002\n";
    std::fs::write(folder.path().join("data.meta.toml"), sidecar).unwrap();
    assert_eq!(told.stdout, cdpr_in(folder.path(), arguments).stdout);
}

#[test]
fn the_same_run_gives_the_same_bytes() {
    let arguments =
        "identify square.toml data.csv --free frame-anchor,length-offset --split kfold:3 --seed 7 --format json";
    assert_eq!(with_data(arguments).1.stdout, with_data(arguments).1.stdout);
}

#[test]
fn ignored_columns_are_told_on_stderr_and_stdout_stays_json() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    std::fs::write(folder.path().join("data.csv"), samples_with(0.0).replace(",set", ",colour")).unwrap();
    let run = cdpr_in(folder.path(), "evaluate square.toml data.csv --format json");
    assert!(run.stderr.contains("colour"), "{}", run.stderr);
    assert_eq!(run.json()["samples"], 25);
}

#[test]
fn data_that_no_fit_can_use_are_exit_code_2_and_leave_no_file() {
    let rows =
        |count: usize| samples_with(0.1).lines().take(count + 1).map(|line| format!("{line}\n")).collect::<String>();
    let mut equal = rows(1);
    (0..9).for_each(|_| equal.push_str(rows(1).lines().nth(1).map(|line| format!("{line}\n")).unwrap().as_str()));
    for (data, free, reason) in [
        (rows(2), "frame-anchor,length-offset", "there are only 2 samples"),
        (equal, "length-offset", "are equal"),
        (rows(9), "frame-anchor[5]", "cables 1 to 4"),
        (rows(9), "frame-anchr", "not a parameter"),
        (rows(9), "compliance", "choose a model with the effect `elastic`"),
        (rows(9), "pulley-radius", "pulley"),
    ] {
        let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
        std::fs::write(folder.path().join("data.csv"), data).unwrap();
        let run = cdpr_in(folder.path(), &format!("identify square.toml data.csv --free {free} --out out.toml"));
        assert_eq!(run.exit_code, 2, "{free}: {}", run.stderr);
        assert!(run.stderr.contains(reason), "{reason}: {}", run.stderr);
        assert!(!folder.path().join("out.toml").exists(), "{reason}");
    }
}

/// Gigabytes by accident are refused by their size, before a byte is read: with memory for a few megabytes alone.
#[cfg(target_os = "linux")]
#[test]
fn a_file_of_gigabytes_is_refused_before_it_is_read() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    for name in ["data.csv", "huge.toml"] {
        // no blocks on the disk
        std::fs::File::create(folder.path().join(name)).unwrap().set_len(3 << 30).unwrap();
    }
    for (arguments, limit) in [("evaluate square.toml data.csv", "256 MiB"), ("check huge.toml", "16 MiB")] {
        let script = format!("ulimit -v 2000000; exec {} {arguments}", env!("CARGO_BIN_EXE_cdpr"));
        let run = super::run(assert_cmd::Command::new("sh").current_dir(folder.path()).args(["-c", &script]));
        assert_eq!(run.exit_code, 2, "{arguments}: {}", run.stderr);
        assert!(run.stderr.contains("file::too-large") && run.stderr.contains(limit), "{}", run.stderr);
    }
}

/// A measured data set copied to a folder of the test with a sidecar beside it; `None` with a word where it is not here.
#[expect(clippy::print_stderr, reason = "a test that skips says so")]
fn copied(set: &str, robot: &str, sidecar: &str) -> Option<tempfile::TempDir> {
    let shared = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let samples = shared.join("measurements").join(set).join("samples.csv");
    if !samples.is_file() {
        assert!(std::env::var("CI").as_deref() != Ok("true"), "CI must have {}", samples.display());
        eprintln!("skipped: {} is not here (its licence forbids a copy in the repository)", samples.display());
        return None;
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(samples, folder.path().join("data.csv")).unwrap();
    std::fs::copy(shared.join("robots").join(format!("{robot}.toml")), folder.path().join("robot.toml")).unwrap();
    std::fs::write(folder.path().join("data.meta.toml"), format!("layout_version = 1\n{sidecar}")).unwrap();
    Some(folder)
}

#[test]
fn the_georgia_tech_data_are_read_as_they_are_with_a_sidecar_that_names_the_time() {
    let sidecar = "[columns]\nt_s = \"t_log_s\"\n";
    let Some(folder) = copied("gtcable-concentric-diamonds", "gtcable-planar", sidecar) else { return };
    let free = "--free frame-anchor,length-offset,length-scale";
    let run = cdpr_in(folder.path(), &format!("identify robot.toml data.csv {free} --format json"));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    // the README of the data: 1.84 mm over all rows
    let rms = run.json()["train"]["length_error_m"]["rms"].as_f64().unwrap();
    assert!((rms / 0.00184 - 1.0).abs() < 0.01, "{rms}");
    assert!(!run.stderr.contains("t_log_s"), "{}", run.stderr);
    // the robot pauses between its strokes, and moves at 1 m/s otherwise
    let at_rest = cdpr_in(folder.path(), "evaluate robot.toml data.csv --static --format json").json();
    let words = at_rest["warnings"].to_string();
    assert!(words.contains("poses are held") || words.contains("quasi-static samples"), "{words}");
    assert!(at_rest["samples"].as_u64().unwrap() < 1000, "{}", at_rest["samples"]);
}

/// A platform that swings on locked winches: lengths that never change cannot tell where anchors are, and the answer says so.
#[test]
fn the_swinging_irma4u_is_read_as_it_is_and_gets_an_honest_answer() {
    let columns: String = (1..=4).map(|k| format!("cable_length_m_{k} = \"cable_length_change_m_{k}\"\n")).collect();
    let sigmas = "[sigmas]\nposition_m = 0.0003\nrotation_rad = 0.001\nlength_m = 0.00002\n";
    let sidecar = format!("[columns]\n{columns}{sigmas}");
    let Some(folder) = copied("irma4u-freemotion-vicon", "irma4u-lab3", &sidecar) else { return };
    let free = "--free frame-anchor,platform-anchor,length-offset";
    let run = cdpr_in(folder.path(), &format!("identify robot.toml data.csv {free} --format json"));
    let answer = run.json();
    assert_eq!(answer["samples"], 4942, "{}", run.stderr);
    // centimetres where the tracker is right to a third of a millimetre
    assert_eq!((run.exit_code, &answer["trusted"]), (1, &serde_json::Value::Bool(false)));
    let first = answer["warnings"][0].as_str().unwrap();
    assert!(first.starts_with("not to be trusted: the frame anchor of cable"), "{first}");
    assert!(answer["warnings"].to_string().contains("not to be trusted: the mean position error"), "{answer}");
    assert!(answer["reason"].as_str().unwrap().contains("weakly"), "{}", answer["reason"]);
    // anchor and offset of each cable, which most starts carry away without end
    assert!(answer["weak_directions"].as_array().unwrap().len() >= 3);
}

/// Whatever reads measurements takes the same options.
#[test]
fn every_command_that_reads_measurements_takes_the_options_of_dirty_files() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    let text = samples_with(0.1).replace("x_m,", "X,").replacen("2,2,", "2,,", 1);
    std::fs::write(folder.path().join("data.csv"), text).unwrap();
    for command in ["evaluate square.toml", "identify square.toml", "select square.toml"] {
        let free = if command.starts_with("identify") { "--free length-offset" } else { "" };
        let run =
            cdpr_in(folder.path(), &format!("{command} data.csv {free} --columns x_m=X --skip-invalid --format json"));
        assert_eq!(run.exit_code, 0, "{command}: {}", run.stderr);
        let warnings = run.json()["warnings"].to_string();
        assert!(warnings.contains("data.csv: 1 of 25 rows are left out: 1 such as line 2"), "{warnings}");
        let refused = cdpr_in(folder.path(), &format!("{command} data.csv {free} --columns x_m=X"));
        assert!(refused.exit_code == 2 && refused.stderr.contains("--> data.csv:2:3"), "{}", refused.stderr);
    }
}

/// Lengths of one log, poses of another on the same clock, half as often.
#[test]
fn a_log_without_poses_is_merged_with_that_of_a_tracker_and_refused_where_poses_are_needed() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    let (mut log, mut track) = ("t_s,L1,L2,L3,L4\n".to_owned(), "t_s;x_m;z_m\n".to_owned());
    for (k, line) in samples_with(0.1).lines().skip(1).enumerate() {
        let fields: Vec<&str> = line.split(',').collect();
        writeln!(log, "{k},{}", fields[2..6].join(",")).unwrap();
        track += &format!("{k};{};{}\n", fields[0], fields[1]);
    }
    std::fs::write(folder.path().join("log.csv"), log).unwrap();
    std::fs::write(folder.path().join("tracker.csv"), track).unwrap();
    let columns = "--columns cable_length_m_1=L1,cable_length_m_2=L2,cable_length_m_3=L3,cable_length_m_4=L4";
    let refused = cdpr_in(folder.path(), &format!("compensate square.toml log.csv --out map {columns}"));
    assert_eq!(refused.exit_code, 2, "{}", refused.stderr);
    assert!(refused.stderr.contains("csv::no-poses") && refused.stderr.contains("--merge"), "{}", refused.stderr);
    let run = cdpr_in(
        folder.path(),
        &format!("identify square.toml log.csv --merge tracker.csv --free length-offset {columns} --format json"),
    );
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    for parameter in run.json()["parameters"].as_array().unwrap() {
        assert!((parameter["value"].as_f64().unwrap() - 0.1).abs() < 1e-9, "{parameter}");
    }
}

/// Poses that no model of the list explains: text, JSON and page say so before the good news, and the exit code is 1.
#[test]
fn what_is_wrong_by_more_than_a_hundredth_of_the_robot_is_never_announced_as_good() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    // every other row of the grid is written down 0.5 m too far right: about 0.25 m in the mean, 1.9 % of the diagonal
    let shifted = |line: &str| match line.split_once(',') {
        Some((x, rest)) if rest.starts_with(['3', '5']) => format!("{},{rest}\n", x.parse::<f64>().unwrap() + 0.5),
        _ => format!("{line}\n"),
    };
    let text: String = samples_with(0.1).lines().map(shifted).collect();
    std::fs::write(folder.path().join("data.csv"), text).unwrap();
    let candidates = "--candidates standard;standard:length-offset";
    let run = cdpr_in(folder.path(), &format!("select square.toml data.csv {candidates} --out result --format json"));
    let answer = run.json_with(&["recommended", "trusted", "warnings"]);
    assert_eq!((run.exit_code, answer["status"].as_str()), (1, Some("not-trusted")), "{answer}");
    assert!(answer["warnings"][0].as_str().unwrap().contains("is above 1 % of the diagonal"), "{answer}");
    let recommended = answer["candidates"].as_array().unwrap().iter().find(|one| one["name"] == answer["recommended"]);
    assert_eq!(recommended.unwrap()["trusted"], false);
    let page = std::fs::read_to_string(folder.path().join("result/report.html")).unwrap();
    assert!(page.contains("verdict bad") && page.contains("not to be trusted"));
    let text = cdpr_in(folder.path(), &format!("select square.toml data.csv {candidates}")).stdout;
    assert!(!text.contains("recommended:") && text.contains("not to be trusted: rigid · as given"), "{text}");
    let run = cdpr_in(folder.path(), "identify square.toml data.csv --free length-offset");
    assert!(
        run.exit_code == 1
            && run.stdout.contains("not to be trusted: rigid · offsets (4)\ncaution: the mean position error"),
        "{}",
        run.stdout
    );
    // clean data as before
    std::fs::write(folder.path().join("data.csv"), samples_with(0.1)).unwrap();
    let run = cdpr_in(folder.path(), &format!("select square.toml data.csv {candidates} --format json"));
    assert_eq!((run.exit_code, run.json()["trusted"].as_bool()), (0, Some(true)), "{}", run.stderr);
}
