//! Golden corpus: answers of the command to some thousand calls, compared with the committed ones by the program `golden`.

use std::path::Path;

use crate::cargo;
use crate::outcome::Outcome;

/// The part that takes less than 40 s, with the command as users get it.
pub(crate) fn check_part(root: &Path) -> Outcome {
    let part = cargo::the_command(root).map(|command| start(root, &command, &["--part"]));
    part.unwrap_or_else(|complaint| Outcome::of(vec![complaint]))
}

/// The whole corpus.
pub(crate) fn check_whole(root: &Path, command: &Path) -> Result<(), String> {
    start(root, command, &[]).into_result()
}

/// As the words say; another command than that of the build for release if they name one.
pub(crate) fn run(root: &Path, words: &[&str]) -> Result<(), String> {
    let outcome = match words.contains(&"--command") {
        true => cargo::succeed(root, &[PROGRAM, words].concat()),
        false => start(root, &cargo::the_command(root)?, words),
    };
    outcome.into_result()
}

const PROGRAM: &[&str] = &["run", "--quiet", "-p", "golden", "--"];

fn start(root: &Path, command: &Path, words: &[&str]) -> Outcome {
    let path = command.to_string_lossy();
    cargo::succeed(root, &[PROGRAM, words, &["--command", &path]].concat())
}
