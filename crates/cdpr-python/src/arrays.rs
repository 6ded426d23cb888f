//! Arrays of numpy in and out: poses of any of their forms, rows of numbers, room for answers.

use cdpr::geometry::{Pose, PoseRows};
use cdpr::robot::Robot;
use numpy::{
    PyArray, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::prelude::*;

use crate::error::{OrRaise, class_of, mistaken};

/// Rows of a strided array that are put side by side at a time.
const CHUNK: usize = 4096;

/// Code of arrays of a wrong shape, type or order.
const CODE: &str = "array::unfit";

/// Array of numbers that the caller keeps, of double precision.
pub(crate) fn numbers<'py>(object: &Bound<'py, PyAny>, what: &str) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    let py = object.py();
    if let Ok(array) = object.cast::<PyArrayDyn<f64>>() {
        let is_aligned = array.data().is_aligned();
        return match array.try_readonly() {
            Ok(array) if is_aligned => Ok(array),
            Ok(_) => {
                Err(mistaken(py, CODE, format!("{what}: this array is not aligned"), "pass a copy: `array.copy()`"))
            }
            Err(_) => Err(mistaken(
                py,
                CODE,
                format!("{what}: this array is being written to"),
                "pass another array than `out`",
            )),
        };
    }
    if let Ok(array) = object.cast::<PyUntypedArray>() {
        let message =
            format!("{what}: this array has the type {}, and numbers of double precision are needed", array.dtype());
        return Err(mistaken(py, CODE, message, "pass `np.asarray(array, dtype=float)`"));
    }
    // lists and tables are small; what is no array of numbers says so itself
    let converted = py.import("numpy")?.call_method1("asarray", (object, "float64"));
    let converted = converted.map_err(|error| {
        let message = format!("{what}: numbers are needed, found {}: {error}", class_of(object));
        mistaken(py, CODE, message, "pass an array or a list of numbers")
    })?;
    Ok(converted.cast_into::<PyArrayDyn<f64>>()?.readonly())
}

/// Rows of `width` numbers: an array of one dimension is a single row.
pub(crate) struct Rows<'py> {
    array: PyReadonlyArrayDyn<'py, f64>,
    /// Number of rows.
    pub(crate) count: usize,
    /// True for an array of one dimension.
    pub(crate) is_single: bool,
}

impl<'py> Rows<'py> {
    /// Rows of as many numbers as are needed, named for messages.
    pub(crate) fn of(object: &Bound<'py, PyAny>, width: usize, what: &str, entry: &str) -> PyResult<Self> {
        let array = numbers(object, what)?;
        let shape = array.shape();
        match *shape {
            [found] if found == width => Ok(Self { array, count: 1, is_single: true }),
            [count, found] if found == width => Ok(Self { array, count, is_single: false }),
            _ => {
                let message = format!("{what}: the shape is {shape:?}, needed is (N, {width}) or ({width},): {entry}");
                Err(mistaken(object.py(), CODE, message, "check rows and columns; `array.T` swaps them"))
            }
        }
    }

    /// The numbers row by row, copied only if the array has them in another order.
    pub(crate) fn contiguous(&self) -> std::borrow::Cow<'_, [f64]> {
        match self.array.as_slice() {
            Ok(slice) if self.array.is_c_contiguous() => slice.into(),
            _ => self.array.as_array().iter().copied().collect::<Vec<_>>().into(),
        }
    }
}

/// Poses of an array, one row each.
pub(crate) struct Poses<'py> {
    form: Form<'py>,
    /// Number of poses.
    pub(crate) count: usize,
    /// True for an array of one dimension.
    pub(crate) is_single: bool,
}

/// How poses are held.
enum Form<'py> {
    /// x, y, z and a quaternion.
    Quaternions(PyReadonlyArrayDyn<'py, f64>),
    /// x, y, z and three angles.
    Angles(PyReadonlyArrayDyn<'py, f64>),
    /// Components of a motion pattern, made into poses.
    Made(Vec<[f64; 7]>),
}

impl<'py> Poses<'py> {
    /// Poses of this robot: (N, 7), (N, 6) or its own components, or one row alone.
    pub(crate) fn of(object: &Bound<'py, PyAny>, robot: &Robot, what: &str) -> PyResult<Self> {
        let py = object.py();
        let array = numbers(object, what)?;
        let (count, width, is_single) = match *array.shape() {
            [width] => (1, width, true),
            [count, width] => (count, width, false),
            _ => return Err(unfit(py, robot, what, array.shape())),
        };
        let form = match width {
            7 => Form::Quaternions(array),
            6 => Form::Angles(array),
            _ if width == robot.dof() => {
                let own: Vec<f64> = array.as_array().iter().copied().collect();
                let pose = |row: &[f64]| Ok(robot.motion_pattern.pose(robot.plane, row).or_raise(py)?.numbers());
                Form::Made(own.chunks_exact(width).map(pose).collect::<PyResult<_>>()?)
            }
            _ => return Err(unfit(py, robot, what, array.shape())),
        };
        Ok(Self { form, count, is_single })
    }

    /// Calls `work` with the first row's number and rows, for all rows in turn: for all at once if they stand side by side.
    pub(crate) fn in_parts<E>(&self, mut work: impl FnMut(usize, PoseRows<'_>) -> Result<(), E>) -> Result<(), E> {
        match &self.form {
            Form::Made(rows) => work(0, rows[..].into()),
            Form::Quaternions(array) => each_part::<7, E>(array, |first, rows| work(first, rows.into())),
            Form::Angles(array) => each_part::<6, E>(array, |first, rows| work(first, rows.into())),
        }
    }

    /// All poses.
    pub(crate) fn all(&self, py: Python<'_>) -> PyResult<Vec<Pose>> {
        let mut poses = Vec::with_capacity(self.count);
        let mut batch = cdpr::geometry::PoseBatch::default();
        let filled = self.in_parts(|_, rows| {
            batch.fill_rows(rows)?;
            poses.extend((0..batch.len()).map(|item| batch.get(item)));
            Ok::<_, cdpr::geometry::PoseRowError>(())
        });
        filled.or_raise(py)?;
        Ok(poses)
    }
}

fn unfit(py: Python<'_>, robot: &Robot, what: &str, shape: &[usize]) -> PyErr {
    let names = robot.motion_pattern.component_names(robot.plane);
    let own = match names.len() {
        6 => String::new(),
        count => format!(", or (N, {count}): {}", names.join(", ")),
    };
    let message = format!(
        "{what}: the shape is {shape:?}; a pose is a row of (N, 7): x, y, z, qx, qy, qz, qw, or (N, 6): x, y, z, rx, ry, rz (R = Rx Ry Rz){own}"
    );
    mistaken(py, CODE, message, "m and rad; one pose may be an array of one dimension")
}

fn each_part<const WIDTH: usize, E>(
    array: &PyReadonlyArrayDyn<'_, f64>,
    mut work: impl FnMut(usize, &[[f64; WIDTH]]) -> Result<(), E>,
) -> Result<(), E> {
    if array.is_c_contiguous()
        && let Ok(slice) = array.as_slice()
    {
        return work(0, slice.as_chunks().0);
    }
    let mut numbers = array.as_array().into_iter().copied();
    let count = array.len() / WIDTH;
    let mut rows = Vec::with_capacity(count.min(CHUNK));
    for first in (0..count).step_by(CHUNK) {
        rows.clear();
        for _ in first..count.min(first + CHUNK) {
            rows.push(std::array::from_fn(|_| numbers.next().unwrap_or(f64::NAN)));
        }
        work(first, &rows)?;
    }
    Ok(())
}

/// Room for an answer: the caller's array if one is given, else a new one; without the first dimension for a single row.
pub(crate) fn room<'py>(
    py: Python<'py>,
    out: Option<&Bound<'py, PyAny>>,
    shape: &[usize],
    is_single: bool,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let shape = if is_single { &shape[1..] } else { shape };
    let Some(out) = out else { return Ok(PyArray::zeros(py, shape, false)) };
    let array = out.cast::<PyArrayDyn<f64>>().map_err(|_| {
        let message = format!("out: an array of double precision is needed, found {}", class_of(out));
        mistaken(py, CODE, message, &format!("pass `np.empty({shape:?})`"))
    })?;
    if array.shape() != shape || !array.is_c_contiguous() {
        let message = format!("out: a contiguous array of the shape {shape:?} is needed, found {:?}", array.shape());
        return Err(mistaken(py, CODE, message, &format!("pass `np.empty({shape:?})`")));
    }
    Ok(array.clone())
}

/// The array, to be written to.
pub(crate) fn writable<'py>(array: &Bound<'py, PyArrayDyn<f64>>) -> PyResult<PyReadwriteArrayDyn<'py, f64>> {
    array.try_readwrite().map_err(|error| {
        let message = format!("out: this array cannot be written to: {error}");
        mistaken(array.py(), CODE, message, "pass an array of its own, which may be written to")
    })
}

/// A new array of these numbers.
pub(crate) fn array<'py>(py: Python<'py>, numbers: &[f64], shape: &[usize]) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    PyArray::from_slice(py, numbers).reshape(shape)
}
