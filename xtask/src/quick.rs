//! `cargo xtask quick`: what an edit may have broken, in the time that a developer waits.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use crate::outcome::Outcome;
use crate::steps;
use crate::{cargo, format};

/// Gates that take seconds, beside the format of the files that differ.
const GATES: &[&str] = &["layers", "interface", "documents"];

/// Crates whose tests run in the build for release alone.
const RELEASED: &[&str] = &["cdpr-cli", "cdpr-reports"];

/// Runs the gates, clippy, and the tests of the crates that differ from a commit and of those that stand on them.
pub(crate) fn run(root: &Path, since: &str) -> Result<(), String> {
    let start = Instant::now();
    let files = changed(root, since)?;
    let manifests = manifests(root);
    let crates = standing_on(&manifests, crates_of(&files));
    println!("{} files differ from {since}; crates to test: {}", files.len(), listed(&crates));
    let is_there = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "rs") && path.exists();
    let sources: Vec<PathBuf> = files.iter().map(|file| root.join(file)).filter(is_there).collect();
    if !sources.is_empty() {
        format::check_files(root, &sources).into_result()?;
    }
    for gate in GATES {
        steps::pass(root, gate)?;
    }
    if files.iter().any(|file| file.ends_with(".rs") || file.ends_with(".toml")) {
        steps::pass(root, "clippy")?;
    }
    let tested = tests(root, &crates);
    let (passed, failed) = (tested.passed, tested.failed);
    let released: Vec<&str> = RELEASED.iter().copied().filter(|name| crates.contains(*name)).collect();
    if !released.is_empty() {
        println!("left to `cargo xtask test --only command`: the tests of {}", released.join(" and "));
    }
    println!("quick: {passed} tests passed, {failed} failed, {:.0} s", start.elapsed().as_secs_f64());
    tested.into_result()
}

/// Files that differ from a commit, and new ones, by their places in the workspace.
fn changed(root: &Path, since: &str) -> Result<Vec<String>, String> {
    let mut files = git(root, &["diff", "--name-only", since])?;
    files.extend(git(root, &["ls-files", "--others", "--exclude-standard"])?);
    Ok(files)
}

fn git(root: &Path, arguments: &[&str]) -> Result<Vec<String>, String> {
    let output = Command::new("git").current_dir(root).args(arguments).output();
    let output = output.map_err(|error| format!("cannot start git: {error}"))?;
    if !output.status.success() {
        return Err(format!("git {}: {}", arguments.join(" "), String::from_utf8_lossy(&output.stderr).trim()));
    }
    Ok(String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect())
}

/// Names of the packages in which files stand.
fn crates_of(files: &[String]) -> BTreeSet<String> {
    let package = |file: &String| match file.split('/').collect::<Vec<_>>()[..] {
        ["crates", name, ..] => Some(name.to_owned()),
        ["xtask", program @ ("dirty" | "dist" | "golden"), ..] => Some((*program).to_owned()),
        ["xtask", "src", ..] => Some("xtask".to_owned()),
        _ => None,
    };
    files.iter().filter_map(package).collect()
}

/// Names and manifests of the crates.
fn manifests(root: &Path) -> Vec<(String, String)> {
    let entries = std::fs::read_dir(root.join("crates")).into_iter().flatten().filter_map(Result::ok);
    let read = |entry: std::fs::DirEntry| {
        let manifest = std::fs::read_to_string(entry.path().join("Cargo.toml")).ok()?;
        Some((entry.file_name().to_string_lossy().into_owned(), manifest))
    };
    entries.filter_map(read).collect()
}

/// These crates and all that depend on them, for tests too.
fn standing_on(manifests: &[(String, String)], mut crates: BTreeSet<String>) -> BTreeSet<String> {
    loop {
        let depends = |manifest: &str| {
            manifest.lines().any(|line| crates.contains(line.split(['.', '=', ' ']).next().unwrap_or_default()))
        };
        let more: Vec<String> = manifests
            .iter()
            .filter(|(name, manifest)| !crates.contains(name) && depends(manifest))
            .map(|(name, _)| name.clone())
            .collect();
        if more.is_empty() {
            return crates;
        }
        crates.extend(more);
    }
}

fn listed(crates: &BTreeSet<String>) -> String {
    if crates.is_empty() { "none".to_owned() } else { crates.iter().cloned().collect::<Vec<_>>().join(", ") }
}

/// Runs the test programs of these crates out of those of the step `library`, which shares their dependencies.
fn tests(root: &Path, crates: &BTreeSet<String>) -> Outcome {
    if crates.iter().all(|name| RELEASED.contains(&name.as_str())) {
        return Outcome::default();
    }
    let programs = match cargo::test_programs(root, cargo::PORTABLE_TESTS) {
        Ok(programs) => programs,
        Err(complaint) => return Outcome::of(vec![complaint]),
    };
    let mut outcome = Outcome::default();
    for program in programs.iter().filter(|program| crates.contains(&program.package)) {
        outcome.add(cargo::run_tests(program));
    }
    outcome
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crates_that_stand_on_a_changed_one_are_tested_too() {
        let manifests = [
            ("model", "[dependencies]\ncore.workspace = true\n"),
            ("plant", "[dependencies]\nmodel = { workspace = true }\n"),
            ("study", "[dev-dependencies]\nplant.workspace = true\n"),
            ("workspace", "[dependencies]\nmodel.workspace = true\n"),
        ];
        let manifests = manifests.map(|(name, text)| (name.to_owned(), text.to_owned()));
        let of = |name: &str| listed(&standing_on(&manifests, BTreeSet::from([name.to_owned()])));
        assert_eq!(of("core"), "core, model, plant, study, workspace");
        assert_eq!(of("plant"), "plant, study");
        assert_eq!(of("study"), "study");
    }

    #[test]
    fn files_belong_to_the_package_of_their_folder() {
        let files = ["crates/cdpr-plant/src/lib.rs", "xtask/golden/src/main.rs", "xtask/src/main.rs", "README.md"];
        assert_eq!(listed(&crates_of(&files.map(str::to_owned))), "cdpr-plant, golden, xtask");
    }
}
