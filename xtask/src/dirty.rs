//! Spoilt measurement files: whether the command notices, judged by the program `dirty`.

use std::path::Path;

use crate::cargo;
use crate::outcome::Outcome;

const PROGRAM: &[&str] = &["run", "--quiet", "-p", "dirty", "--"];

/// The forty cells of the test, with the command as users get it.
pub(crate) fn check_fixed(root: &Path, command: &Path) -> Outcome {
    start(root, &["--fixed", "--command", &command.to_string_lossy()])
}

/// The table as the words say; another command than that of the build for release if they name one.
pub(crate) fn run(root: &Path, words: &[&str]) -> Result<(), String> {
    let outcome = match words.contains(&"--command") {
        true => start(root, words),
        false => {
            let command = cargo::the_command(root)?;
            start(root, &[words, &["--command", &command.to_string_lossy()]].concat())
        }
    };
    outcome.into_result()
}

fn start(root: &Path, words: &[&str]) -> Outcome {
    cargo::succeed(root, &[PROGRAM, words].concat())
}
