//! Builds the book into target/book, with an mdbook of the machine or one that cargo installs into target/tools.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::outcome::Outcome;
use crate::programs::{on_path, run};
use crate::{cargo, documents};

/// The version that CI builds with; the book needs nothing of the search and the server that are left out.
const VERSION: &str = "=0.5.4";

/// Builds the book; installs mdbook where there is none.
pub(crate) fn build(root: &Path) -> Result<(), String> {
    let mdbook = find(root).map_or_else(|| install(root), Ok)?;
    build_with(root, &mdbook)
}

/// Builds the book where there is an mdbook, and in CI, where it is installed.
pub(crate) fn check(root: &Path) -> Outcome {
    let mdbook = match (find(root), std::env::var("CI").as_deref()) {
        (Some(mdbook), _) => Ok(mdbook),
        (None, Ok("true")) => install(root),
        (None, _) => {
            println!("the book is not built: there is no mdbook; `cargo xtask book` installs one into target/tools");
            return Outcome::default();
        }
    };
    Outcome::of(mdbook.and_then(|mdbook| build_with(root, &mdbook)).err().into_iter().collect())
}

/// Sees to it that there is an mdbook in CI; elsewhere nobody asked for one.
pub(crate) fn fetch(root: &Path) -> Result<(), String> {
    match (find(root), std::env::var("CI").as_deref()) {
        (None, Ok("true")) => install(root).map(|_| ()),
        _ => Ok(()),
    }
}

fn find(root: &Path) -> Option<PathBuf> {
    let installed = tools(root).join("bin").join(format!("mdbook{}", std::env::consts::EXE_SUFFIX));
    installed.is_file().then_some(installed).or_else(|| on_path("mdbook"))
}

fn tools(root: &Path) -> PathBuf {
    root.join("target/tools")
}

/// Without optimisation and debug information, for the sake of the time to compile: the book is small.
fn install(root: &Path) -> Result<PathBuf, String> {
    println!("there is no mdbook: cargo installs it into target/tools");
    let folder = tools(root).display().to_string();
    let mut command = cargo::command(root, &["install", "--quiet", "--locked", "--debug", "--no-default-features"]);
    command.args(["--version", VERSION, "--root", &folder, "mdbook"]).env("CARGO_PROFILE_DEV_DEBUG", "0");
    run(command)?;
    find(root).ok_or_else(|| format!("cargo installed no mdbook into {folder}"))
}

/// Warnings are errors: mdbook itself ends well after an include that it did not find.
fn build_with(root: &Path, mdbook: &Path) -> Result<(), String> {
    let target = root.join("target/book");
    let mut command = Command::new(mdbook);
    command.arg("build").arg("--dest-dir").arg(&target).arg(root.join(documents::BOOK_ROOT));
    let output = command.output().map_err(|error| format!("cannot start {}: {error}", mdbook.display()))?;
    let said = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
    let complaints: Vec<&str> = said.lines().filter(|line| is_complaint(line)).collect();
    if output.status.success() && complaints.is_empty() {
        println!("open {}", target.join("index.html").display());
        return Ok(());
    }
    Err(format!("mdbook ended with {}:\n{}", output.status, said.trim_end()))
}

/// Lines of its log begin with the level, those of older versions with the time.
fn is_complaint(line: &str) -> bool {
    line.split_whitespace().take(4).any(|word| ["WARN", "ERROR", "[WARN]", "[ERROR]"].contains(&word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warnings_are_told_from_news() {
        assert!(is_complaint(" WARN Potential incomplete link for `x`"));
        assert!(is_complaint("2026-01-01 10:00:00 [ERROR] (mdbook::preprocess): Error updating"));
        assert!(!is_complaint(" INFO Book building has started"));
    }
}
