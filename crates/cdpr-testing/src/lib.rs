//! Cases of property tests, and data beside the project: shared by the tests of all crates.
#![allow(clippy::print_stderr, reason = "tests say what they skip")]

pub mod property;

use std::path::PathBuf;

/// Folder of the repository.
pub fn repository() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// A file of the folder `shared/data` beside the repository; `None` with a word where it is absent.
///
/// # Panics
/// Where it is absent with `CI=true`.
pub fn shared(path: &str) -> Option<Vec<u8>> {
    let path = repository().join("../shared/data").join(path);
    let bytes = std::fs::read(&path).ok();
    if bytes.is_none() {
        assert!(std::env::var("CI").as_deref() != Ok("true"), "CI must have {}", path.display());
        eprintln!("skipped: {} is not here (measured data are no part of the repository)", path.display());
    }
    bytes
}
