//! Everything that keeps a command from answering, and its exit code.

use std::io;

use cdpr::reading::ReadError;
use serde::Serialize;

/// Why there is no answer.
#[derive(Clone, Debug)]
pub(crate) enum Failure {
    /// A file that says something wrong.
    File(Box<ReadError>),
    /// Arguments, or arguments and files, that do not fit together.
    Input {
        /// What is wrong and why.
        message: String,
        /// How to mend it.
        help: Option<String>,
    },
    /// Numbers that left the range a computer can represent.
    Numerical {
        /// What happened.
        message: String,
    },
    /// A file that cannot be read or written.
    Io {
        /// What was tried, and the system's answer.
        message: String,
        /// How to mend it.
        help: Option<String>,
    },
}

/// A failure as scripts see it.
#[derive(Debug, Serialize)]
pub(crate) struct FailureObject<'a> {
    status: &'static str,
    reason: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    column: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    code: Option<&'static str>,
    exit_code: u8,
}

impl Failure {
    /// A command line that cannot be understood.
    pub(crate) fn usage(message: impl Into<String>) -> Self {
        Self::Input { message: message.into(), help: None }
    }

    /// Input that cannot be used, with the way out.
    pub(crate) fn input(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Input { message: message.into(), help: Some(help.into()) }
    }

    /// Input that the library refused, with the argument or file it came from; messages of the library name the cure.
    pub(crate) fn refused(what: &str, error: &dyn std::error::Error) -> Self {
        Self::Input { message: format!("{what}: {error}"), help: None }
    }

    /// A calculation that overflowed.
    pub(crate) fn numerical(message: impl Into<String>) -> Self {
        Self::Numerical { message: message.into() }
    }

    /// The system refused to `verb` a file.
    pub(crate) fn io(verb: &str, path: &str, error: &io::Error) -> Self {
        Self::Io { message: format!("cannot {verb} {path}: {}", system_reason(error)), help: None }
    }

    /// The same failure with a hint how to mend it.
    pub(crate) fn with_help(mut self, text: impl Into<String>) -> Self {
        if let Self::Input { help, .. } | Self::Io { help, .. } = &mut self {
            *help = Some(text.into());
        }
        self
    }

    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            Self::File(_) | Self::Input { .. } => 2,
            Self::Numerical { .. } => 3,
            Self::Io { .. } => 4,
        }
    }

    /// What is wrong and why, without the place.
    pub(crate) fn message(&self) -> &str {
        match self {
            Self::File(error) => &error.message,
            Self::Input { message, .. } | Self::Numerical { message } | Self::Io { message, .. } => message,
        }
    }

    /// How to mend it.
    pub(crate) fn help(&self) -> Option<&str> {
        match self {
            Self::File(error) => error.help.as_deref(),
            Self::Input { help, .. } | Self::Io { help, .. } => help.as_deref(),
            Self::Numerical { .. } => None,
        }
    }

    pub(crate) fn object(&self) -> FailureObject<'_> {
        let read_error = if let Self::File(error) = self { Some(error) } else { None };
        FailureObject {
            status: "error",
            reason: self.message(),
            help: self.help(),
            file: read_error.map(|error| error.file_name.as_str()),
            line: read_error.and_then(|error| error.line()),
            column: read_error.and_then(|error| error.column()),
            code: read_error.map(|error| error.code),
            exit_code: self.exit_code(),
        }
    }
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        Self::File(Box::new(error))
    }
}

/// The system's reason without its error number.
fn system_reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".to_owned(),
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        _ => error.to_string(),
    }
}
