//! Everything that keeps a command from answering, and its exit code.

use std::io;

use cdpr_model::reading::ErrorCode;
use cdpr_model::reading::ReadError;
use schemars::JsonSchema;
use serde::Serialize;

/// Why there is no answer.
#[derive(Clone, Debug)]
pub(crate) enum Failure {
    /// A file that says something wrong.
    File(Box<ReadError>),
    /// Arguments, or arguments and files, that do not fit together.
    Input {
        /// Stable short name, explained by `cdpr explain`.
        code: &'static str,
        /// Fault and reason.
        message: String,
        /// How to mend it.
        help: Option<String>,
    },
    /// Numbers that left the range a computer can represent.
    Numerical {
        /// Stable short name.
        code: &'static str,
        /// The event.
        message: String,
    },
    /// A file that cannot be read or written.
    Io {
        /// Stable short name.
        code: &'static str,
        /// The attempt, and the system's answer.
        message: String,
        /// How to mend it.
        help: Option<String>,
    },
}

/// Commands and options that mend what the library refuses, by the code of the error.
const REMEDIES: &[(&str, &str)] = &[
    ("objective::no-task", "give --task STUDY.toml, whose table [task] has min and max"),
    ("data::no-validation", "give --validation, a column `set`, or another --split"),
    (
        "data::gauge-open",
        "hold coordinates with --hold, give --known, as level[1,2,3], or choose --gauge anchors or least-change",
    ),
    ("limits::missing-key", "add the key to the robot file, or give --min and --max for all cables"),
    ("load::missing-key", "add the key to the robot file, or give --wrench where the command takes it"),
    (
        "csv::no-poses",
        "--merge FILE adds a tracker's log, --columns x_m=… names columns; `identify`, `evaluate` and `select` do without poses",
    ),
    ("csv::not-a-number", "--skip-invalid leaves such rows out"),
    ("model::missing-key", "`cdpr place-pulleys --help` tells how pulleys come from the anchors of the point model"),
    ("toml::missing-key", "`cdpr schema --help` tells how to list the keys of every file"),
    ("plan::priors", "state the accuracies of the sensors with --sigma"),
];

/// A failure as scripts see it.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(rename = "Failure")]
pub(crate) struct FailureObject<'a> {
    status: &'static str,
    reason: &'a str,
    /// How to mend it.
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<&'a str>,
    /// File that says something wrong.
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<&'a str>,
    /// Line of the file, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
    /// Column of the line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    column: Option<usize>,
    code: &'static str,
    /// Exit code of the command.
    exit_code: u8,
}

impl Failure {
    /// A command line that cannot be understood.
    pub(crate) fn usage(code: &'static str, message: impl Into<String>) -> Self {
        Self::Input { code, message: message.into(), help: None }
    }

    /// Input that cannot be used, with the way out.
    pub(crate) fn input(code: &'static str, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Input { code, message: message.into(), help: Some(help.into()) }
    }

    /// Input that the library refused, with the argument or file it came from; messages of the library name the cure, and the help the
    /// options for it.
    pub(crate) fn refused(what: &str, error: &dyn ErrorCode) -> Self {
        let code = error.code();
        Self::Input { code, message: format!("{what}: {error}"), help: remedy(code).map(str::to_owned) }
    }

    /// A calculation that overflowed.
    pub(crate) fn numerical(message: impl Into<String>) -> Self {
        Self::Numerical { code: "numerical::overflow", message: message.into() }
    }

    /// A result that cannot be put into its format.
    pub(crate) fn unwritable(what: &str, error: &dyn std::error::Error) -> Self {
        Self::Numerical { code: "numerical::unwritable", message: format!("{what} cannot be written: {error}") }
    }

    /// The system refused to `verb` a file.
    pub(crate) fn io(verb: &str, path: &str, error: &io::Error) -> Self {
        let code = if verb == "read" { "io::read" } else { "io::write" };
        Self::Io { code, message: format!("cannot {verb} {path}: {}", system_reason(error)), help: None }
    }

    /// The same failure with a hint how to mend it.
    pub(crate) fn with_help(mut self, text: impl Into<String>) -> Self {
        if let Self::Input { help, .. } | Self::Io { help, .. } = &mut self {
            *help = Some(text.into());
        }
        self
    }

    /// The failure with the value of an argument in place of its name, where the message starts with that.
    pub(crate) fn with_value(mut self, argument: &str, value: &str) -> Self {
        if let Self::Input { message, .. } = &mut self
            && let Some(rest) = message.strip_prefix(argument).filter(|rest| rest.starts_with(": "))
        {
            *message = format!("{value}{rest}");
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

    /// Stable short name, explained by `cdpr explain`.
    pub(crate) fn code(&self) -> &'static str {
        match self {
            Self::File(error) => error.code,
            Self::Input { code, .. } | Self::Numerical { code, .. } | Self::Io { code, .. } => code,
        }
    }

    /// Fault and reason, without the place.
    pub(crate) fn message(&self) -> &str {
        match self {
            Self::File(error) => &error.message,
            Self::Input { message, .. } | Self::Numerical { message, .. } | Self::Io { message, .. } => message,
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
            code: self.code(),
            exit_code: self.exit_code(),
        }
    }
}

impl From<ReadError> for Failure {
    /// The help is that of the library, and the options for it.
    fn from(mut error: ReadError) -> Self {
        let parts = [error.help.take(), remedy(error.code).map(str::to_owned)];
        error.help = parts.into_iter().flatten().reduce(|help, remedy| format!("{help}; {remedy}"));
        Self::File(Box::new(error))
    }
}

/// Commands and options that mend an error of the library.
fn remedy(code: &str) -> Option<&'static str> {
    REMEDIES.iter().find(|(of, _)| *of == code).map(|(_, remedy)| *remedy)
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

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_reports::explanations;

    #[test]
    fn remedies_are_those_of_codes_that_are_explained() {
        for (code, remedy) in REMEDIES {
            assert!(explanations::all().any(|explanation| explanation.code == *code), "{code}");
            assert!(remedy.contains("--"), "{code}: {remedy}");
        }
    }
}
