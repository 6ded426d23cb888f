//! Packs the command `cdpr` for people without a compiler, and checks what a publication of the crates takes.
//! Started by `cargo xtask`.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a terminal program that talks to its developer")]

mod archive;
mod check;
mod contents;
mod expression;
mod includes;
mod licences;
mod manifests;
mod metadata;
mod platform;
mod whole;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "\
Usage: dist pack COMMAND FOLDER    an archive of the program COMMAND, written into FOLDER
       dist sums FOLDER            the file SHA256SUMS of all packages in FOLDER
       dist check COMMAND FOLDER   the same, read back and compared with what went in
       dist manifests              what every published crate states, and what it may depend on
       dist licences               licences of all packages against deny.toml";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let root = root();
    let complaints = match words.as_slice() {
        ["pack", command, folder] => pack(&root, Path::new(command), Path::new(folder)),
        ["check", command, folder] => check::check(&root, Path::new(command), Path::new(folder)),
        ["sums", folder] => check::sums(Path::new(folder)).map(|path| told(&path)),
        ["manifests"] => manifests::check(&root),
        ["licences"] => licences::check(&root),
        _ => Err(USAGE.to_owned()),
    };
    match complaints {
        Ok(complaints) if complaints.is_empty() => ExitCode::SUCCESS,
        Ok(complaints) => {
            eprintln!("{}", complaints.join("\n"));
            ExitCode::FAILURE
        }
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

fn pack(root: &Path, command: &Path, folder: &Path) -> Result<Vec<String>, String> {
    check::packed(root, command, folder).map(|(_, path)| told(&path))
}

/// Tells of a file that was written; there is no complaint of it.
fn told(path: &Path) -> Vec<String> {
    println!("wrote {}", path.display());
    Vec::new()
}

/// The workspace root. Cargo sets it for every run, so a moved clone needs no rebuild.
fn root() -> PathBuf {
    let manifest =
        std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| env!("CARGO_MANIFEST_DIR").into(), PathBuf::from);
    manifest.ancestors().nth(2).map_or_else(|| manifest.clone(), Path::to_path_buf)
}
