//! Runs inside another program: files in memory, progress, an end before the end.

use std::ffi::OsString;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use cdpr_cli::{Files, Host, Observer, run_in};

fn words(line: &str) -> Vec<OsString> {
    ["cdpr"].into_iter().chain(line.split_whitespace()).map(Into::into).collect()
}

fn run(line: &str, files: &mut Files, observe: Observer) -> (ExitCode, String, String) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let mut host = Host::with_files(std::mem::take(files));
    host.observe = Some(observe);
    let exit = run_in(words(line), &mut host, &mut out, &mut err);
    *files = host.files;
    (exit, String::from_utf8(out).unwrap(), String::from_utf8(err).unwrap())
}

fn unobserved() -> Observer {
    Arc::new(|_| ControlFlow::Continue(()))
}

#[test]
fn files_are_read_from_memory_and_written_there_alone() {
    let mut files = Files::new();
    let (exit, _, err) = run("new suspended-camera --out nowhere-on-disk", &mut files, unobserved());
    assert_eq!(exit, ExitCode::SUCCESS, "{err}");
    assert!(files.contains_key(Path::new("nowhere-on-disk/robot.toml")), "{:?}", files.keys());
    assert!(!Path::new("nowhere-on-disk").exists());
    let (exit, out, err) = run("check nowhere-on-disk/robot.toml --format json", &mut files, unobserved());
    assert_eq!(exit, ExitCode::SUCCESS, "{err}");
    assert!(out.contains("\"cable_count\":4"), "{out}");
    let (exit, _, err) = run("check nowhere-on-disk/robot.toml", &mut Files::new(), unobserved());
    assert_eq!(exit, ExitCode::from(4), "{err}");
}

#[test]
fn progress_is_told_and_a_break_ends_the_run() {
    let line = "workspace planar-example --method grid --step 0.05 --format json";
    let count = Arc::new(AtomicUsize::new(0));
    let counted = Arc::clone(&count);
    let observe: Observer = Arc::new(move |work| {
        assert!(!work.name.is_empty());
        counted.fetch_add(1, Ordering::Relaxed);
        ControlFlow::Continue(())
    });
    let (exit, whole, _) = run(line, &mut Files::new(), observe);
    assert_eq!(exit, ExitCode::SUCCESS);
    assert!(count.load(Ordering::Relaxed) > 1);
    let (exit, out, _) = run(line, &mut Files::new(), Arc::new(|_| ControlFlow::Break(())));
    assert_eq!((exit, out.as_str()), (ExitCode::from(130), ""));
    let (_, again, _) = run(line, &mut Files::new(), unobserved());
    assert_eq!(whole, again);
}
