//! Files read whole, no more of them than their kind may have.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::{ReadError, Size};

/// A file that cannot be read, or not be understood.
#[derive(Debug, Error)]
pub enum FileError {
    /// The system gives no bytes.
    #[error("cannot read {}: {source}", .path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Its reason.
        source: io::Error,
    },
    /// The bytes are refused.
    #[error(transparent)]
    Refused(#[from] ReadError),
}

/// The bytes of a file.
pub fn bytes_of(path: &Path, size: Size) -> Result<Vec<u8>, FileError> {
    let name = path.display().to_string();
    let unreadable = |source| FileError::Unreadable { path: path.to_owned(), source };
    let file = File::open(path).map_err(unreadable)?;
    // what the system says of a file saves reading it; pipes and devices have any length
    size.check(file.metadata().map_err(unreadable)?.len(), &name)?;
    let mut bytes = Vec::new();
    file.take(size.limit() as u64 + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    size.check(bytes.len() as u64, &name)?;
    Ok(bytes)
}
