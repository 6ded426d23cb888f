//! The committed script and style are those that `viewer/` makes: checked by hashes, so that no test needs npm.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

fn viewer() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../viewer")
}

fn hash(path: &Path) -> String {
    let content = std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    Sha256::digest(content).iter().fold(String::new(), |text, byte| format!("{text}{byte:02x}"))
}

fn files(folder: &Path, found: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => files(&path, found),
            false => {
                let name = path.strip_prefix(viewer()).unwrap().to_str().unwrap().to_owned();
                found.insert(name.replace('\\', "/"));
            }
        }
    }
}

/// Every source has the hash of the stamp, no source is missing from it, and nobody changed what was made.
#[test]
fn the_generated_files_belong_to_the_sources_of_the_viewer() {
    let generated = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/html_page/generated");
    let stamp = std::fs::read_to_string(generated.join("viewer.stamp")).unwrap();
    let remedy = "run `cargo xtask viewer` and commit what it wrote";
    let mut listed = BTreeSet::new();
    for line in stamp.lines() {
        let (expected, name) = line.split_once("  ").unwrap();
        let path = name.strip_prefix("generated/").map_or_else(|| viewer().join(name), |made| generated.join(made));
        assert_eq!(hash(&path), expected, "{name} changed: {remedy}");
        listed.insert(name.to_owned());
    }
    let notices = std::fs::read_to_string(generated.join("notices.txt")).unwrap();
    let told = std::fs::read_to_string(viewer().join("../THIRD-PARTY.txt")).unwrap();
    assert!(told.contains(&notices), "THIRD-PARTY.txt lacks notices.txt: {remedy}");
    let mut sources = BTreeSet::new();
    files(&viewer().join("src"), &mut sources);
    files(&viewer().join("build"), &mut sources);
    let forgotten: Vec<&String> = sources.difference(&listed).collect();
    assert!(forgotten.is_empty(), "{forgotten:?} are not in the bundle: {remedy}");
}
