//! The folder of a result.

use std::path::{Path, PathBuf};

use cdpr_reports::NamedFile;
use cdpr_reports::comparison::Comparison;

use crate::failure::Failure;
use crate::files;

/// Writes the result into a folder, which is made where it does not exist; files of the same names are replaced, and calibrated robots
/// of a former result go.
///
/// All files are written before the first is put in its place; `result.json` comes last, so that a folder that has it is
/// complete. Of two processes that write into one folder the second waits for the first.
pub(crate) fn write_folder(folder: &Path, comparison: &Comparison, more: Vec<NamedFile>) -> Result<(), Failure> {
    let made = comparison.files().map_err(|error| Failure::unwritable(error.file, &*error.reason))?;
    let all: Vec<NamedFile> = more.into_iter().chain(made).collect();
    let _own = files::OwnFolder::make(folder)?;
    files::make_folder(&folder.join("calibrated"))?;
    let paths: Vec<PathBuf> = all.iter().map(|file| folder.join(&file.name)).collect();
    let pairs: Vec<(&Path, &[u8])> =
        paths.iter().map(PathBuf::as_path).zip(all.iter().map(|file| &file.content[..])).collect();
    files::write_all(&pairs)?;
    remove_former(folder, &paths)
}

/// Removes the calibrated robots that another result left here: they are named as ours are, and none of ours.
fn remove_former(folder: &Path, ours: &[PathBuf]) -> Result<(), Failure> {
    let calibrated = folder.join("calibrated");
    let mut former = vec![folder.join("calibrated.toml")];
    for path in files::listed(&calibrated)? {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let is_numbered = name
            .split_once('-')
            .is_some_and(|(number, _)| number.len() >= 2 && number.chars().all(|digit| digit.is_ascii_digit()));
        if is_numbered && name.ends_with(".toml") {
            former.push(path);
        }
    }
    former.iter().filter(|path| !ours.contains(*path)).try_for_each(|path| files::remove(path))
}
