//! Controllers written in Python, and what they see.

use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use cdpr::geometry::{Pose, Twist};
use cdpr::plant::{Command, ControlError, Controller, Measured as Seen, Setpoint as Wanted};
use numpy::PyArrayDyn;
use pyo3::prelude::*;

use crate::arrays::array;
use crate::plant::Kind;

/// A controller that calls `command(time, wanted, measured)` of a Python object.
pub(crate) struct OwnController {
    object: Py<PyAny>,
    period: Option<f64>,
    kind: Kind,
    raised: Raised,
}

/// The first exception of a controller, which is raised again after the run.
#[derive(Clone, Default)]
pub(crate) struct Raised(Arc<Mutex<Option<PyErr>>>);

impl Raised {
    /// The exception, if there was one.
    pub(crate) fn take(&self) -> Option<PyErr> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

impl fmt::Debug for OwnController {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OwnController").field("period", &self.period).finish_non_exhaustive()
    }
}

impl OwnController {
    /// The controller of an object with `command`; its `period` (s) and `kind` are optional, `reset` too.
    pub(crate) fn of(object: &Bound<'_, PyAny>) -> PyResult<Self> {
        let stated = |name: &str| -> PyResult<Option<Bound<'_, PyAny>>> {
            Ok(object.getattr_opt(name)?.filter(|value| !value.is_none()))
        };
        let kind = match stated("kind")? {
            Some(kind) => Kind::named(object.py(), &kind.extract::<String>()?)?,
            None => Kind::Lengths,
        };
        let period = stated("period")?.map(|period| period.extract()).transpose()?;
        Ok(Self { object: object.clone().unbind(), period, kind, raised: Raised::default() })
    }

    /// Place of the controller's first exception.
    pub(crate) fn raised(&self) -> Raised {
        self.raised.clone()
    }

    fn ask(&self, py: Python<'_>, time: f64, wanted: &Wanted, seen: &Seen<'_>, out: &mut [Command]) -> PyResult<()> {
        let answer = self.object.call_method1(py, "command", (time, Setpoint::of(wanted), Measured::of(seen)))?;
        self.kind.write(answer.bind(py), out)
    }
}

impl Controller for OwnController {
    fn command(
        &mut self,
        time: f64,
        wanted: &Wanted,
        measured: &Seen<'_>,
        out: &mut [Command],
    ) -> Result<(), ControlError> {
        Python::attach(|py| self.ask(py, time, wanted, measured, out)).map_err(|error| {
            let reason = error.to_string();
            self.raised.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
            ControlError::new(reason)
        })
    }

    fn period(&self) -> Option<f64> {
        self.period
    }

    fn reset(&mut self) {
        Python::attach(|py| {
            let reset = self.object.bind(py).getattr_opt("reset");
            if let Err(error) = reset.and_then(|reset| reset.map_or(Ok(()), |reset| reset.call0().map(drop))) {
                self.raised.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
            }
        });
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        let object = Python::attach(|py| {
            let copied = py.import("copy").and_then(|copy| copy.call_method1("deepcopy", (&self.object,)));
            // an object that cannot be copied goes on with its state
            copied.map_or_else(|_| self.object.clone_ref(py), Bound::unbind)
        });
        Box::new(Self { object, period: self.period, kind: self.kind, raised: self.raised.clone() })
    }
}

/// The wanted motion at a time.
#[pyclass(frozen, module = "cdpr._cdpr")]
pub(crate) struct Setpoint {
    pose: Pose,
    twist: Twist,
    acceleration: Twist,
    lengths: Vec<f64>,
}

/// The machine as a controller sees it.
#[pyclass(frozen, module = "cdpr._cdpr")]
pub(crate) struct Measured {
    #[pyo3(get)]
    time: f64,
    pose: Pose,
    twist: Twist,
    lengths: Vec<f64>,
    length_rates: Vec<f64>,
    tensions: Vec<f64>,
    rows: Vec<(&'static str, f64, Vec<f64>)>,
}

/// Files of sensors.
const SENSOR_FILES: [&str; 3] = ["measurements.csv", "imu.csv", "tracker.csv"];

impl Setpoint {
    fn of(wanted: &Wanted) -> Self {
        let Wanted { pose, twist, acceleration, lengths, .. } = wanted.clone();
        Self { pose, twist, acceleration, lengths }
    }
}

impl Measured {
    fn of(seen: &Seen<'_>) -> Self {
        let row = |file: &&'static str| {
            let (time, row) = seen.sensors?.last_row(file)?;
            Some((*file, time, row.to_vec()))
        };
        Self {
            time: seen.time,
            pose: seen.pose,
            twist: seen.twist,
            lengths: seen.lengths.to_vec(),
            length_rates: seen.length_rates.to_vec(),
            tensions: seen.tensions.to_vec(),
            rows: SENSOR_FILES.iter().filter_map(row).collect(),
        }
    }
}

type Numbers<'py> = PyResult<Bound<'py, PyArrayDyn<f64>>>;

fn vector<'py>(py: Python<'py>, numbers: &[f64]) -> Numbers<'py> {
    array(py, numbers, &[numbers.len()])
}

#[pymethods]
impl Setpoint {
    #[getter]
    fn pose<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        vector(py, &self.pose.numbers())
    }

    #[getter]
    fn twist<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        vector(py, self.twist.as_slice())
    }

    #[getter]
    fn acceleration<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        vector(py, self.acceleration.as_slice())
    }

    #[getter]
    fn lengths<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        vector(py, &self.lengths)
    }
}

#[pymethods]
impl Measured {
    #[getter]
    fn pose<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        vector(py, &self.pose.numbers())
    }

    #[getter]
    fn twist<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        vector(py, self.twist.as_slice())
    }

    #[getter]
    fn lengths<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        vector(py, &self.lengths)
    }

    #[getter]
    fn length_rates<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        vector(py, &self.length_rates)
    }

    #[getter]
    fn tensions<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        vector(py, &self.tensions)
    }

    /// Time and numbers of the last row of a file of sensors; `None` before the first, and without such sensors.
    fn sensor<'py>(&self, py: Python<'py>, file: &str) -> PyResult<Option<(f64, Bound<'py, PyArrayDyn<f64>>)>> {
        let row = self.rows.iter().find(|(name, ..)| *name == file);
        row.map(|(_, time, numbers)| Ok((*time, vector(py, numbers)?))).transpose()
    }
}
