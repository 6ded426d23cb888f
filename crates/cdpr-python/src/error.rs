//! Errors of the library as the exceptions of the package.

use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;

/// `cdpr._errors.refused`, which makes an exception of code, message, help and place.
static REFUSED: PyOnceLock<Py<PyAny>> = PyOnceLock::new();

/// The exception of an error of the library.
pub(crate) fn refused(py: Python<'_>, error: impl Into<cdpr::Error>) -> PyErr {
    let cdpr::Error { code, message, help, place } = error.into();
    let place = place.map(|place| (place.file, place.line, place.column));
    raised(py, code, message, help, place)
}

/// The exception of a mistake in the arguments.
pub(crate) fn mistaken(py: Python<'_>, code: &str, message: impl Into<String>, help: &str) -> PyErr {
    raised(py, code, message.into(), Some(help.to_owned()), None)
}

type Place = (String, Option<usize>, Option<usize>);

fn raised(py: Python<'_>, code: &str, message: String, help: Option<String>, place: Option<Place>) -> PyErr {
    let make = REFUSED.get_or_try_init(py, || {
        let module = py.import("cdpr._errors")?;
        module.getattr("refused").map(Bound::unbind)
    });
    match make.and_then(|make| make.call1(py, (code, message, help, place))) {
        Ok(exception) => PyErr::from_value(exception.into_bound(py)),
        Err(error) => error,
    }
}

/// Results whose errors become exceptions.
pub(crate) trait OrRaise<T> {
    /// The value, or the exception of its error.
    fn or_raise(self, py: Python<'_>) -> PyResult<T>;
}

impl<T, E: Into<cdpr::Error>> OrRaise<T> for Result<T, E> {
    fn or_raise(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|error| refused(py, error))
    }
}

/// Name of an object's class, for messages.
pub(crate) fn class_of(object: &Bound<'_, PyAny>) -> String {
    let class: Bound<'_, PyType> = object.get_type();
    class.name().map_or_else(|_| "object".to_owned(), |name| name.to_string())
}
