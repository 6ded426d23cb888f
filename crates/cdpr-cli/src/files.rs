//! Files read whole and written whole.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use cdpr_model::reading::{FileError, Size, bytes_of};
use tempfile::NamedTempFile;

use crate::failure::Failure;
use crate::interruption;
use crate::session;
use crate::surroundings::SharedFiles;

/// The bytes of a file, no more than its kind may have.
pub(crate) fn read(path: &Path, size: Size) -> Result<Vec<u8>, Failure> {
    let bytes = in_memory(path).map_or_else(|| bytes_of(path, size), Ok).map_err(|error| match error {
        FileError::Unreadable { path, source } => Failure::io("read", &path.display().to_string(), &source),
        FileError::Refused(error) => error.into(),
    })?;
    if let Some(notes) = session::notes() {
        notes.lock().insert(path.to_owned(), bytes.clone());
    }
    Ok(bytes)
}

/// The bytes of a file that a run has in memory.
fn in_memory(path: &Path) -> Option<Vec<u8>> {
    session::files()?.get(path)
}

/// True if there is a file of this path.
pub(crate) fn is_there(path: &Path) -> bool {
    path.is_file() || session::files().is_some_and(|files| files.lock().contains_key(path))
}

/// Files and folders in a folder; none where it does not exist.
pub(crate) fn listed(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let in_memory = session::files().map(|files| files.in_folder(folder)).unwrap_or_default();
    let unreadable = |error| Failure::io("read", &folder.display().to_string(), &error);
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>().map_err(unreadable)?,
        Err(error) if error.kind() == io::ErrorKind::NotFound => Vec::new(),
        Err(error) => return Err(unreadable(error)),
    };
    Ok(entries.into_iter().chain(in_memory).collect())
}

/// The bytes of a file that need not exist.
pub(crate) fn read_if_there(path: &Path, size: Size) -> Result<Option<Vec<u8>>, Failure> {
    match fs::metadata(path) {
        _ if in_memory(path).is_some() => read(path, size).map(Some),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        _ => read(path, size).map(Some),
    }
}

/// Makes a folder and those above it.
pub(crate) fn make_folder(path: &Path) -> Result<(), Failure> {
    if session::files().is_some() {
        return Ok(());
    }
    fs::create_dir_all(path).map_err(|error| Failure::io("make the folder", &path.display().to_string(), &error))
}

/// A folder that this process alone writes into until the value is dropped, made where it does not exist: another process
/// that is about to write waits, so that files of two results never mix.
pub(crate) struct OwnFolder {
    /// Open and locked; the system lets go of the lock when the process ends, however it ends.
    _locked: Option<fs::File>,
}

impl OwnFolder {
    pub(crate) fn make(folder: &Path) -> Result<Self, Failure> {
        make_folder(folder)?;
        if session::files().is_some() {
            return Ok(Self { _locked: None });
        }
        // where a system cannot lock folders, files are still whole, only results may mix
        let locked = fs::File::open(folder).ok().filter(|handle| handle.lock().is_ok());
        Ok(Self { _locked: locked })
    }
}

/// Writes a file so that it is there completely or not at all.
pub(crate) fn write(path: &Path, content: &[u8]) -> Result<(), Failure> {
    write_all(&[(path, content)])
}

/// Writes files that belong together: all are written beside their targets before the first target is replaced, so that a
/// full disk or an interruption leaves the old ones.
pub(crate) fn write_all(files: &[(&Path, &[u8])]) -> Result<(), Failure> {
    if let Some(in_memory) = session::files() {
        in_memory.lock().extend(files.iter().map(|(path, content)| ((*path).to_owned(), content.to_vec())));
        return Ok(());
    }
    let mut staged = Vec::with_capacity(files.len());
    let result = stage_and_place(files, &mut staged);
    // what has no place by now goes, and then an interruption has nothing to remove
    let paths: Vec<PathBuf> = staged.iter().map(|stage| stage.file_path.clone()).collect();
    drop(staged);
    interruption::forget(&paths.iter().map(PathBuf::as_path).collect::<Vec<_>>());
    result
}

/// Bytes of a growing file that wait in memory, at most.
const WAITING_LIMIT: usize = 1 << 16;

/// Time that they wait, at most.
const WAITING_TIME: Duration = Duration::from_millis(100);

/// A file that grows while a run goes on, under its own name: whenever the run ends, what is there are whole lines.
pub(crate) struct GrowingFile {
    file: Growing,
    path: PathBuf,
    waiting: String,
    written: Instant,
}

/// Place of a growing file.
enum Growing {
    OnDisk(fs::File),
    InMemory(SharedFiles),
}

impl GrowingFile {
    /// An empty file in place of the one that may be there.
    pub(crate) fn make(path: &Path) -> Result<Self, Failure> {
        let unwritable = |error| Failure::io("write", &path.display().to_string(), &error);
        let file = match session::files() {
            Some(files) => {
                files.lock().insert(path.to_owned(), Vec::new());
                Growing::InMemory(files)
            }
            None => Growing::OnDisk(fs::File::create(path).map_err(unwritable)?),
        };
        Ok(Self { file, path: path.to_owned(), waiting: String::new(), written: Instant::now() })
    }

    /// Adds whole lines.
    pub(crate) fn add(&mut self, lines: impl FnOnce(&mut String)) -> Result<(), Failure> {
        lines(&mut self.waiting);
        match self.waiting.len() >= WAITING_LIMIT || self.written.elapsed() >= WAITING_TIME {
            true => self.write(),
            false => Ok(()),
        }
    }

    /// Writes what waits.
    pub(crate) fn write(&mut self) -> Result<(), Failure> {
        let written = match &mut self.file {
            Growing::OnDisk(file) => file.write_all(self.waiting.as_bytes()),
            Growing::InMemory(files) => {
                files.lock().entry(self.path.clone()).or_default().extend_from_slice(self.waiting.as_bytes());
                Ok(())
            }
        };
        self.waiting.clear();
        self.written = Instant::now();
        written.map_err(|error| Failure::io("write", &self.path.display().to_string(), &error))
    }
}

/// Removes a file of an earlier result, where there is one.
pub(crate) fn remove(path: &Path) -> Result<(), Failure> {
    if let Some(files) = session::files() {
        files.lock().remove(path);
        return Ok(());
    }
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => {
            Err(Failure::io("remove", &path.display().to_string(), &error))
        }
        _ => Ok(()),
    }
}

/// A file written beside its target; the file is taken when it is renamed.
struct Stage {
    file: Option<NamedTempFile>,
    file_path: PathBuf,
    target: PathBuf,
}

fn stage_and_place(files: &[(&Path, &[u8])], staged: &mut Vec<Stage>) -> Result<(), Failure> {
    let refused = |path: &Path, error: &io::Error| Failure::io("write", &path.display().to_string(), error);
    for (path, content) in files {
        stage(path, content, staged).map_err(|error| refused(path, &error))?;
    }
    interruption::undisturbed(|| {
        staged.iter_mut().try_for_each(|Stage { file, target, .. }| match file.take() {
            Some(file) => file.persist(&*target).map(drop).map_err(|error| refused(target, &error.error)),
            None => Ok(()),
        })
    })
}

/// Writes beside the target; pipes and devices such as /dev/stdout are written to as they are.
fn stage(path: &Path, content: &[u8], staged: &mut Vec<Stage>) -> io::Result<()> {
    // a link stays a link: its target is replaced
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if fs::metadata(&target).is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir()) {
        return fs::OpenOptions::new().write(true).open(&target)?.write_all(content);
    }
    if target.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    let file = interruption::temporary(|| temporary_file_beside(&target))?;
    let mut open = file.as_file();
    let written = open.write_all(content).and_then(|()| open.sync_all());
    staged.push(Stage { file_path: file.path().to_owned(), file: Some(file), target });
    written
}

fn temporary_file_beside(target: &Path) -> io::Result<NamedTempFile> {
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
        _ => PathBuf::from("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".cdpr-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // the file is no secret: the umask decides, as for any other file
        builder.permissions(fs::Permissions::from_mode(0o666));
        builder.tempfile_in(folder)
    }
    #[cfg(not(unix))]
    builder.tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    /// Promises of this file hold for every writer only while there is no other.
    #[test]
    fn nothing_else_in_the_command_writes_files() {
        fn check(folder: &Path) {
            for path in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
                if path.is_dir() {
                    check(&path);
                    continue;
                }
                if path.extension().is_none_or(|ending| ending != "rs") || path.ends_with("files.rs") {
                    continue;
                }
                let text = std::fs::read_to_string(&path).unwrap();
                let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
                let is_test = path.ends_with("tests.rs");
                for writer in ["fs::write", "File::create", "OpenOptions", "fs::rename", "fs::copy", "create_dir"] {
                    assert!(is_test || !code.contains(writer), "{} uses {writer}: see files.rs", path.display());
                }
            }
        }
        check(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    }
}
