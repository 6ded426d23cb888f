//! Ctrl-C: exit code 130, old files untouched, no temporary file left.

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::{SQUARE, cdpr_in};

/// Long enough for a loaded machine; a healthy run takes a fraction of a second.
const PATIENCE: Duration = Duration::from_secs(60);

/// True where whoever started the tests has them ignore SIGHUP, SIGINT or SIGTERM, as a shell does with background jobs:
/// the command would rightly go on ignoring them.
fn signals_are_ignored() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok()).unwrap_or(0);
    [1, 2, 15].iter().any(|signal| mask & (1 << (signal - 1)) != 0)
}

fn start(folder: &Path, arguments: &str) -> Child {
    program(folder, arguments).stderr(Stdio::null()).spawn().unwrap()
}

/// The same with its messages.
fn start_told(folder: &Path, arguments: &str) -> Child {
    program(folder, arguments).stderr(Stdio::piped()).spawn().unwrap()
}

fn program(folder: &Path, arguments: &str) -> Command {
    let program = assert_cmd::cargo::cargo_bin("cdpr");
    let mut command = match signals_are_ignored() {
        true => Command::new("env"),
        false => Command::new(&program),
    };
    if signals_are_ignored() {
        command.arg("--default-signal=HUP,INT,TERM").arg(&program);
    }
    command.current_dir(folder).args(arguments.split_whitespace());
    command.stdin(Stdio::null()).stdout(Stdio::null());
    command
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort_unstable();
    names
}

/// Waits for something to be so.
fn until(mut holds: impl FnMut() -> bool, what: &str) {
    let start = Instant::now();
    while !holds() {
        assert!(start.elapsed() < PATIENCE, "{what} takes too long");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// Sends the signal and gives the exit code.
fn interrupted(mut child: Child, signal: &str) -> Option<i32> {
    let sent = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let mut status = None;
    until(
        || {
            status = child.try_wait().unwrap();
            status.is_some()
        },
        "ending",
    );
    status.and_then(|status| status.code())
}

/// A robot, data, an old result, and a pipe that nobody reads, at which writing the second file waits for ever.
fn folder_with_a_pipe() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), SQUARE).unwrap();
    let mut data = "x_m,z_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4\n".to_owned();
    for (x, y) in [(5.0, 4.0), (4.0, 3.0), (6.0, 5.0), (3.0, 5.0), (7.0, 2.0)] {
        let length = |a: f64, b: f64| f64::hypot(x - a, y - b);
        let lengths = [length(0.0, 0.0), length(10.0, 0.0), length(10.0, 8.0), length(0.0, 8.0)];
        data.push_str(&format!("{x},{y},{}\n", super::listed(&lengths)));
    }
    std::fs::write(folder.path().join("data.csv"), data).unwrap();
    std::fs::write(folder.path().join("calibrated.toml"), "the old result").unwrap();
    assert!(Command::new("mkfifo").arg(folder.path().join("pipe")).status().unwrap().success());
    folder
}

const IDENTIFY: &str = "identify robot.toml data.csv --free length-offset --out calibrated.toml --report pipe";

#[test]
fn an_interruption_while_writing_leaves_the_old_file_and_no_temporary_one() {
    for signal in ["-INT", "-TERM", "-HUP"] {
        let folder = folder_with_a_pipe();
        let before = names(folder.path());
        let child = start(folder.path(), IDENTIFY);
        until(|| names(folder.path()).iter().any(|name| name.starts_with(".cdpr-")), "writing");
        assert_eq!(interrupted(child, signal), Some(130), "{signal}");
        assert_eq!(names(folder.path()), before, "{signal}");
        assert_eq!(std::fs::read_to_string(folder.path().join("calibrated.toml")).unwrap(), "the old result");
    }
}

#[test]
fn an_interruption_while_reading_leaves_nothing() {
    let folder = folder_with_a_pipe();
    let before = names(folder.path());
    let waiting = start(folder.path(), "evaluate robot.toml pipe --out-errors errors.csv");
    // opening waits until the command has opened the other end, and by then it listens to signals
    let pipe = std::fs::OpenOptions::new().write(true).open(folder.path().join("pipe")).unwrap();
    assert_eq!(interrupted(waiting, "-INT"), Some(130));
    drop(pipe);
    assert_eq!(names(folder.path()), before);
}

/// Ctrl-C in the middle of a sweep says how many points are there, and the command that it names computes the others.
#[test]
fn an_interrupted_sweep_says_what_is_kept_and_how_to_go_on() {
    let folder = tempfile::tempdir().unwrap();
    let sweep = super::root().join("studies/sweep-planar-stiffness.toml");
    let mut child = start_told(folder.path(), &format!("sweep all {} --out points", sweep.display()));
    let rows = || std::fs::read_dir(folder.path().join("points/rows")).map_or(0, Iterator::count);
    until(|| rows() > 0 || child.try_wait().unwrap().is_some(), "the first point");
    let stderr = child.stderr.take().unwrap();
    if interrupted(child, "-INT") != Some(130) {
        return; // a fast machine was through before
    }
    let told = std::io::read_to_string(stderr).unwrap();
    assert!(told.contains("interrupted; no file is left half-written; "), "{told}");
    assert!(told.contains("points are kept in points; `cdpr sweep run points` goes on"), "{told}");
    let rest = cdpr_in(folder.path(), "sweep run points");
    assert_eq!(rest.exit_code, 0, "{}", rest.stderr);
    assert!(!rest.stdout.contains(" 0 already there"), "{}", rest.stdout);
}

/// When the second file cannot be written, the first one keeps its old content.
#[test]
fn files_that_belong_together_are_written_all_or_none() {
    let folder = folder_with_a_pipe();
    let run = cdpr_in(folder.path(), &IDENTIFY.replace("pipe", "nowhere/report.html"));
    assert_eq!(run.exit_code, 4, "{}", run.stderr);
    assert_eq!(std::fs::read_to_string(folder.path().join("calibrated.toml")).unwrap(), "the old result");
    assert!(names(folder.path()).iter().all(|name| !name.starts_with(".cdpr-")));
    assert_eq!(cdpr_in(folder.path(), &IDENTIFY.replace("pipe", "report.html")).exit_code, 0);
    assert!(std::fs::read_to_string(folder.path().join("calibrated.toml")).unwrap().contains("length_offset_m"));
}
