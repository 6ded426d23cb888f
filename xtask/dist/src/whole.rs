//! Files that appear whole or not at all.

use std::path::Path;

/// Writes beside the place under another name, then gives the file its own.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let told = |error: std::io::Error| format!("cannot write {}: {error}; nothing was changed there", path.display());
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(told)?;
    }
    let unfinished = path.with_added_extension(format!("{}.part", std::process::id()));
    let written = std::fs::write(&unfinished, bytes).and_then(|()| std::fs::rename(&unfinished, path));
    if written.is_err() {
        // it may not even have begun; the error that is told is the first one
        let _ = std::fs::remove_file(&unfinished);
    }
    written.map_err(told)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_cannot_be_written_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let taken = folder.path().join("taken");
        std::fs::create_dir_all(taken.join("inside")).unwrap();
        assert!(write(&taken, b"bytes").unwrap_err().contains("nothing was changed"));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        write(&folder.path().join("new/file"), b"bytes").unwrap();
        assert_eq!(std::fs::read(folder.path().join("new/file")).unwrap(), b"bytes");
    }
}
