//! Reads whole files up to the largest size of their kind.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::{ReadError, Size};

/// A file that cannot be read, or that has an error.
#[derive(Debug, Error)]
pub enum FileError {
    /// The system cannot read the file.
    #[error("cannot read {}: {source}", .path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// The content has an error.
    #[error(transparent)]
    Refused(#[from] ReadError),
}

/// Reads the bytes of a file.
pub fn bytes_of(path: &Path, size: Size) -> Result<Vec<u8>, FileError> {
    let name = path.display().to_string();
    let unreadable = |source| FileError::Unreadable { path: path.to_owned(), source };
    let file = File::open(path).map_err(unreadable)?;
    // the size from the system saves reading a large file; pipes and devices have none
    size.check(file.metadata().map_err(unreadable)?.len(), &name)?;
    let mut bytes = Vec::new();
    file.take(size.limit() as u64 + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    size.check(bytes.len() as u64, &name)?;
    Ok(bytes)
}
