//! Files that sources include: a package has none from outside its folder.

use std::path::{Path, PathBuf};

/// Complaints about sources of a package that include what stands outside it.
pub(crate) fn leaving(package: &Path) -> Result<Vec<String>, String> {
    let mut complaints = Vec::new();
    for file in sources(&package.join("src"))? {
        let text = std::fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
        let depth = file.strip_prefix(package).map_or(0, |inside| inside.components().count() - 1);
        let lines = (1..).zip(text.lines()).filter(|(_, line)| leads_up(line, depth));
        complaints.extend(lines.map(|(number, _)| {
            format!(
                "{}:{number}: includes a file from outside the package, which lacks it when it is published",
                file.display()
            )
        }));
    }
    Ok(complaints)
}

/// Whether a line includes a file more folders up than the package has above the source.
fn leads_up(line: &str, depth: usize) -> bool {
    let includes = ["include_str!", "include_bytes!"].into_iter().flat_map(|include| line.split(include).skip(1));
    includes.filter_map(|rest| rest.split('"').nth(1)).any(|path| path.matches("../").count() > depth)
}

/// Rust files under a folder, but those of tests, which packages do not compile.
fn sources(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let told = |error: std::io::Error| format!("{}: {error}", folder.display());
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(told)? {
        let path = entry.map_err(told)?.path();
        if path.ends_with("tests") || path.ends_with("tests.rs") {
        } else if path.is_dir() {
            files.extend(sources(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort_unstable();
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_that_leaves_the_package_is_seen() {
        let line = |path: &str| format!("text: include_str!(concat!(\"{path}\", $name)),");
        assert!(leads_up(&line("../../../../../studies/"), 3));
        assert!(!leads_up(&line("../../../studies/"), 3));
        assert!(!leads_up("let path = \"../../../../../studies/\";", 3));
    }
}
