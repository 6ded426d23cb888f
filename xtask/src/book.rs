//! Builds the book; `cargo xtask test` only checks its links, so that it needs no mdbook.

use std::path::Path;
use std::process::Command;

/// Runs an installed mdbook on docs/book.
pub(crate) fn build(root: &Path) -> Result<(), String> {
    let status = Command::new("mdbook").arg("build").arg(root.join("docs/book")).status().map_err(|error| {
        format!(
            "cannot start mdbook ({error}); install it with `cargo install mdbook`, then run `cargo xtask book` again"
        )
    })?;
    if status.success() {
        println!("open {}", root.join("docs/book/book/index.html").display());
        Ok(())
    } else {
        Err(format!("mdbook ended with {status}"))
    }
}
