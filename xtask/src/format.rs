//! Every Rust file is formatted: also those that `cargo fmt` does not find because a macro declares their module.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::outcome::Outcome;

/// Folders with Rust files.
const FOLDERS: [&str; 5] = ["benches", "crates", "examples", "fuzz", "xtask"];

/// Complains where `rustfmt` would change a file.
pub(crate) fn check(root: &Path) -> Outcome {
    let mut files = Vec::new();
    for folder in FOLDERS {
        collect(&root.join(folder), &mut files);
    }
    files.sort_unstable();
    if files.is_empty() {
        return Outcome::of(vec!["there are no Rust files".to_owned()]);
    }
    check_files(root, &files)
}

/// Complains where `rustfmt` would change one of these files.
pub(crate) fn check_files(root: &Path, files: &[PathBuf]) -> Outcome {
    println!("$ rustfmt --check --edition 2024 ({} files)", files.len());
    let mut rustfmt = Command::new("rustfmt");
    rustfmt.args(["--check", "--edition", "2024"]).args(files).current_dir(root).stdin(Stdio::null());
    match rustfmt.status() {
        Ok(status) if status.success() => Outcome::of(Vec::new()),
        Ok(status) => Outcome::of(vec![format!("rustfmt ended with {status} on {} files", files.len())]),
        Err(error) => Outcome::of(vec![format!("cannot start rustfmt: {error}")]),
    }
}

/// Rust files of a folder and of the folders in it, without what was built.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            if entry.file_name() != "target" {
                collect(&path, files);
            }
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}
