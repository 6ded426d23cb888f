//! What goes wrong while files are written: no space, no permission, a killed process, two processes at once.
#![cfg(unix)]

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use super::{SQUARE, cdpr_in, run};

const PROGRAM: &str = env!("CARGO_BIN_EXE_cdpr");

/// Everything in a folder but what stood there before.
fn new_files(folder: &Path, before: &[&str]) -> Vec<String> {
    let names = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names.filter(|name| !before.contains(&name.as_str())).collect()
}

fn start(folder: &Path, arguments: &str) -> Child {
    let mut command = Command::new(PROGRAM);
    command.current_dir(folder).args(arguments.split_whitespace());
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// The twin's study with a grid of many poses, so that its file takes a while to write.
fn large_study(folder: &Path) {
    let path = format!("{}/../../studies/twin-measurements.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let text = text.replacen("count = [5, 5, 3, 1, 1, 1]", "count = [12, 12, 10, 1, 1, 1]", 1);
    std::fs::write(folder.join("study.toml"), text).unwrap();
}

/// A file size limit of the shell stands for a full disk: writing beyond it fails as it does without space.
#[test]
fn a_disk_that_is_full_leaves_no_part_of_a_file() {
    let folder = tempfile::tempdir().unwrap();
    large_study(folder.path());
    // 512 bytes a block: far less than the samples need
    let script = format!("trap '' XFSZ; ulimit -f 8; exec {PROGRAM} simulate study.toml --out data.csv");
    let ended = run(assert_cmd::Command::new("sh").current_dir(folder.path()).args(["-c", &script]));
    assert_eq!(ended.exit_code, 4, "{}{}", ended.stdout, ended.stderr);
    assert!(ended.stderr.contains("cannot write data.csv"), "{}", ended.stderr);
    // not even the sidecar, which would fit
    assert_eq!(new_files(folder.path(), &["study.toml"]), [""; 0]);
    let script = format!("trap '' XFSZ; ulimit -f 40; exec {PROGRAM} demo --out result");
    let ended = run(assert_cmd::Command::new("sh").current_dir(folder.path()).args(["-c", &script]));
    assert_eq!(ended.exit_code, 4, "{}{}", ended.stdout, ended.stderr);
    let left = new_files(&folder.path().join("result"), &[]);
    assert!(!left.contains(&"result.json".to_owned()), "a folder with a result.json is complete: {left:?}");
    assert!(left.iter().all(|name| !name.starts_with(".cdpr-")), "{left:?}");
}

#[test]
fn a_device_that_is_full_is_told() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("square.toml"), SQUARE).unwrap();
    if !Path::new("/dev/full").exists() {
        return;
    }
    let arguments = "place-pulleys square.toml --radius 0.1 --axis 0,0,1 --out /dev/full";
    let ended = cdpr_in(folder.path(), arguments);
    assert_eq!(ended.exit_code, 4, "{}{}", ended.stdout, ended.stderr);
    assert!(ended.stderr.contains("/dev/full"), "{}", ended.stderr);
}

#[test]
fn a_place_where_nothing_may_be_written_is_named() {
    let folder = tempfile::tempdir().unwrap();
    large_study(folder.path());
    // nobody, not even root, makes files below a file, or in /proc
    std::fs::write(folder.path().join("file"), "").unwrap();
    for place in ["file/data.csv", "missing/data.csv", "/proc/data.csv"] {
        let ended = cdpr_in(folder.path(), &format!("simulate study.toml --out {place}"));
        assert_eq!(ended.exit_code, 4, "{place}: {}{}", ended.stdout, ended.stderr);
        let name = place.trim_end_matches("data.csv");
        assert!(ended.stderr.contains("cannot write") && ended.stderr.contains(name), "{place}: {}", ended.stderr);
    }
    let ended = cdpr_in(folder.path(), "demo --out file");
    assert_eq!(ended.exit_code, 4, "{}{}", ended.stdout, ended.stderr);
    assert_eq!(new_files(folder.path(), &["file", "study.toml"]), [""; 0]);
}

/// Killed at any moment: the file is the old one, or the new one, whole.
#[test]
fn a_killed_process_leaves_the_old_file_or_the_new_one() {
    let folder = tempfile::tempdir().unwrap();
    large_study(folder.path());
    let path = folder.path().join("data.csv");
    assert_eq!(cdpr_in(folder.path(), "simulate study.toml --out data.csv --seed 1").exit_code, 0);
    let whole = [1, 2].map(|seed| {
        let name = format!("whole-{seed}.csv");
        cdpr_in(folder.path(), &format!("simulate study.toml --out {name} --seed {seed}"));
        std::fs::read(folder.path().join(name)).unwrap()
    });
    assert!(whole[0] != whole[1]);
    for delay in 0..40 {
        let mut child = start(folder.path(), "simulate study.toml --out data.csv --seed 2");
        std::thread::sleep(Duration::from_millis(delay));
        child.kill().unwrap();
        child.wait().unwrap();
        let left = std::fs::read(&path).unwrap();
        assert!(whole.contains(&left), "{} bytes after {delay} ms", left.len());
        std::fs::write(&path, &whole[0]).unwrap();
    }
}

/// Two results written into one folder at the same time: afterwards all files are of one of them.
#[test]
fn two_processes_do_not_mix_their_results_in_one_folder() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(cdpr_in(folder.path(), "demo --out data").exit_code, 0);
    for round in 0..6 {
        let seeds = [10 + round, 20 + round];
        let children = seeds.map(|seed| {
            let more = if seed < 20 { "" } else { "--candidates standard:frame-anchor" };
            let data = "data/robot.toml data/training.csv --validation data/validation.csv";
            start(folder.path(), &format!("select {data} --seed {seed} {more} --accept-untrusted --out result"))
        });
        for mut child in children {
            assert!(child.wait().unwrap().success());
        }
        let read = |name: &str| std::fs::read_to_string(folder.path().join("result").join(name)).unwrap();
        let run = read("run.toml");
        let result: serde_json::Value = serde_json::from_str(&read("result.json")).unwrap();
        let candidates = result["candidates"].as_array().unwrap().len();
        let is_first = run.contains(&format!("seed = {}\n", seeds[0]));
        assert!(is_first || run.contains(&format!("seed = {}\n", seeds[1])), "{run}");
        assert_eq!(
            is_first,
            candidates > 1,
            "{candidates} candidates in result.json, run.toml is of another run: {run}"
        );
        assert_eq!(read("candidates.csv").lines().count(), candidates + 1);
    }
}
