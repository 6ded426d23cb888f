//! One error for programs that need no other.

use std::fmt;

use cdpr_model::reading::{ErrorCode, ReadError};

/// Any error of the library, for programs and bindings that tell their users and go on: `?` makes it of every other one.
///
/// ```
/// fn volume(file: &str) -> Result<f64, cdpr::Error> {
///     let robot = cdpr::Robot::from_file(file)?;
///     let load = cdpr::Load::of(&robot)?;
///     let model = cdpr::Model::new(robot, "standard".parse()?)?;
///     Ok(cdpr::workspace::Workspace::of(&model, &load).wrench_feasible().volume()?.size)
/// }
///
/// let error = volume("no-such-robot.toml").unwrap_err();
/// assert_eq!(error.code, "io::read");
/// assert!(error.message.contains("no-such-robot.toml"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// Stable short name of the mistake, e.g. `data::all-equal`: scripts compare it, and the book's list of codes explains it.
    pub code: &'static str,
    /// Fault and reason in words, without place and help.
    pub message: String,
    /// How to mend it, where a file is at fault and the library knows.
    pub help: Option<String>,
    /// Place of the fault; `None` unless a file is at fault.
    pub place: Option<Place>,
}

/// Place in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file as the caller named it.
    pub file: String,
    /// Line from 1; `None` if the file as a whole is meant.
    pub line: Option<usize>,
    /// Column in characters, from 1; `None` if the file as a whole is meant.
    pub column: Option<usize>,
}

impl fmt::Display for Error {
    /// `file:line:column: message`, and the help on a line of its own.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = &self.place {
            write!(formatter, "{}:", place.file)?;
            if let (Some(line), Some(column)) = (place.line, place.column) {
                write!(formatter, "{line}:{column}:")?;
            }
            formatter.write_str(" ")?;
        }
        formatter.write_str(&self.message)?;
        match &self.help {
            Some(help) => write!(formatter, "\n  help: {help}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for Error {}

impl<E: ErrorCode> From<E> for Error {
    fn from(error: E) -> Self {
        let code = error.code();
        let Some(ReadError { file_name, message, help, .. }) = error.read_error() else {
            return Self { code, message: error.to_string(), help: None, place: None };
        };
        let (line, column) = error.read_error().map_or((None, None), |error| (error.line(), error.column()));
        let place = Some(Place { file: file_name.clone(), line, column });
        Self { code, message: message.clone(), help: help.clone(), place }
    }
}

#[cfg(feature = "files")]
#[cfg(test)]
mod tests {
    use super::*;
    use crate::tension::Limits;
    use crate::{Composition, FreeParameters, Robot};

    fn of<T, E: ErrorCode + fmt::Display>(result: Result<T, E>) -> (String, Error) {
        match result {
            Ok(_) => panic!("no error"),
            Err(error) => (error.to_string(), Error::from(error)),
        }
    }

    #[test]
    fn an_error_of_a_file_keeps_its_place_and_its_words() {
        let (words, error) = of(Robot::from_toml("# a robot\nlayout_version = 99\n", "a.toml"));
        assert_eq!(error.to_string(), words);
        let place = error.place.unwrap();
        assert_eq!((place.file.as_str(), place.line, place.column), ("a.toml", Some(2), Some(18)));
        assert!(error.help.is_some() && !error.message.contains("a.toml"));
        assert_eq!(error.code, "robot::layout-version");
    }

    #[test]
    fn other_errors_keep_code_and_words() {
        let errors = [
            of("wind".parse::<Composition>()),
            of(Limits::uniform(3, 5.0, 1.0)),
            of("frame-anchor,wind".parse::<FreeParameters>()),
        ];
        let codes = ["model::unknown-effect", "limits::empty-range", "parameter::unknown-name"];
        for ((words, error), code) in errors.into_iter().zip(codes) {
            assert_eq!((error.message.as_str(), error.code), (words.as_str(), code));
            assert_eq!((&error.help, &error.place), (&None, &None));
        }
    }
}
