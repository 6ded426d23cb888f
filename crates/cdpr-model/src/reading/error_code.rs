//! Stable short names of all errors of the library, for scripts and for looking up.
//!
//! A code is `area::mistake` in words. One mistake has one code, in whichever function it occurs: an error that only
//! contains another one has the other's code. Errors of files ([`ReadError`]) contain their own.

use super::{FileError, ReadError};

/// An error with a stable short name.
pub trait ErrorCode: std::error::Error {
    /// The name, e.g. `data::all-equal`.
    fn code(&self) -> &'static str;

    /// The error of a file that is behind this one, with place and help; `None` if no text of a file is at fault.
    fn read_error(&self) -> Option<&ReadError> {
        None
    }
}

impl ErrorCode for ReadError {
    fn code(&self) -> &'static str {
        self.code
    }

    fn read_error(&self) -> Option<&ReadError> {
        Some(self)
    }
}

impl ErrorCode for FileError {
    fn code(&self) -> &'static str {
        match self {
            Self::Unreadable { .. } => "io::read",
            Self::Refused(error) => error.code(),
        }
    }

    fn read_error(&self) -> Option<&ReadError> {
        match self {
            Self::Unreadable { .. } => None,
            Self::Refused(error) => Some(error),
        }
    }
}
