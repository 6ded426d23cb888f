//! Points of plans, each computed by itself.

use cdpr_cli::PreparedPlan;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::error::refused;

/// A plan, prepared to compute its points.
#[pyclass(frozen, module = "cdpr._cdpr")]
pub(crate) struct PreparedSweep {
    plan: PreparedPlan,
}

#[pymethods]
impl PreparedSweep {
    /// The plan of the bytes of a `plan.json`.
    #[new]
    fn new(py: Python<'_>, plan: &[u8]) -> PyResult<Self> {
        let plan = py.detach(|| PreparedPlan::new(plan));
        Ok(Self { plan: plan.map_err(|error| refused(py, error))? })
    }

    #[getter]
    fn fingerprint(&self) -> &str {
        self.plan.fingerprint()
    }

    /// Values of the parameters, point by point; `None` for the parts of a command.
    #[getter]
    fn points(&self) -> Option<Vec<Vec<f64>>> {
        self.plan.points().map(<[_]>::to_vec)
    }

    /// Words of the command that is planned; `None` for a sweep.
    #[getter]
    fn command(&self) -> Option<Vec<String>> {
        self.plan.command().map(<[_]>::to_vec)
    }

    fn __len__(&self) -> usize {
        self.plan.count()
    }

    /// Name of the file of a point's row, in the folder `rows`; `None` if there is no such point.
    fn row_name(&self, point: usize) -> Option<String> {
        self.plan.row_name(point)
    }

    /// Content of that file; `None` if there is no such point.
    fn row<'py>(&self, py: Python<'py>, point: usize) -> PyResult<Option<Bound<'py, PyBytes>>> {
        let row = py.detach(|| self.plan.row(point)).map_err(|error| refused(py, error))?;
        Ok(row.map(|row| PyBytes::new(py, &row)))
    }
}
