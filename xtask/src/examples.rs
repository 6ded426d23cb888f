//! Runs every example: an example asserts its result, so running is testing.

use std::path::Path;

use crate::cargo;
use crate::outcome::Outcome;

/// Runs `examples/src/bin/*.rs` in order of their names; each counts as one check.
pub(crate) fn run(root: &Path) -> Outcome {
    let mut total = Outcome::default();
    for name in names(root) {
        println!("$ cargo run -p examples --bin {name}");
        total.add(Outcome::of(cargo::run_example(root, &name, &[]).err().into_iter().collect()));
    }
    total
}

fn names(root: &Path) -> Vec<String> {
    // No folder, no examples.
    let Ok(entries) = std::fs::read_dir(root.join("examples/src/bin")) else { return Vec::new() };
    let mut names: Vec<String> =
        entries.filter_map(|entry| entry.ok()?.file_name().to_str()?.strip_suffix(".rs").map(str::to_owned)).collect();
    names.sort_unstable();
    names
}
