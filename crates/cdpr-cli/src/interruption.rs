//! Ctrl-C, and a polite kill: the run ends without leaving a temporary file.

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

/// Exit code that a shell gives to commands that SIGINT ended: 128 + 2.
const INTERRUPTED: i32 = 130;

/// Temporary files that exist now.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Words for the part of the work that an interruption leaves, and how to go on; empty where nothing is kept.
static KEPT: Mutex<String> = Mutex::new(String::new());

/// From now on an interruption leaves this, in words that say how to go on.
pub(crate) fn keeps(words: String) {
    // words are whole whatever panicked
    *KEPT.lock().unwrap_or_else(PoisonError::into_inner) = words;
}

fn pending() -> MutexGuard<'static, Vec<PathBuf>> {
    // a list of paths is whole whatever panicked
    PENDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on SIGINT, SIGTERM and SIGHUP (Ctrl-C on other systems) remove temporary files and end the run.
///
/// Whoever started the program with one of them ignored, as `nohup` does, keeps it so.
pub fn watch() {
    // without a handler the system ends the run; targets are whole all the same
    let _ = ctrlc::try_set_handler(|| {
        let pending = pending();
        for path in pending.iter() {
            // what is gone already needs no removing
            let _ = fs::remove_file(path);
        }
        let mut stderr = io::stderr();
        if !is_quiet() {
            // over the line of progress, if there is one
            let over = if stderr.is_terminal() { "\r\x1b[K" } else { "" };
            let kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
            let kept = if kept.is_empty() { "nothing of its work is kept" } else { kept.as_str() };
            let _ = writeln!(stderr, "{over}interrupted; no file is left half-written; {kept}");
        }
        // the lock is held until the end: no other temporary file can appear
        process::exit(INTERRUPTED);
    });
}

/// True if the words of the process ask for nothing but the answer.
fn is_quiet() -> bool {
    std::env::args_os().any(|word| word == "--quiet" || word == "-q")
}

/// Makes a temporary file that goes with an interruption.
pub(crate) fn temporary(make: impl FnOnce() -> io::Result<NamedTempFile>) -> io::Result<NamedTempFile> {
    let mut pending = pending();
    let file = make()?;
    pending.push(file.path().to_owned());
    Ok(file)
}

/// Does what an interruption has to wait for.
pub(crate) fn undisturbed<T>(work: impl FnOnce() -> T) -> T {
    let _waits = pending();
    work()
}

/// These files have their place, or are removed.
pub(crate) fn forget(paths: &[&Path]) {
    pending().retain(|path| !paths.contains(&path.as_path()));
}
