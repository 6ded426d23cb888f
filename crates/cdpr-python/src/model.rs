//! Models: inverse and forward problems, tensions, structure matrices and stiffness of many poses.

use std::sync::Arc;

use cdpr::Robot as RobotData;
use cdpr::equilibrium::{self, ForwardAnswers, ForwardRows, ForwardSettings, Status};
use cdpr::geometry::Pose;
use cdpr::nalgebra::DMatrix;
use cdpr::statics::Stiffness;
use cdpr::tension;
use cdpr::workspace::Verdict;
use numpy::{PyArray1, PyArrayDyn};
use pyo3::prelude::*;

use crate::arrays::{Poses, Rows, array, room, writable};
use crate::choices::{self, LimitArguments};
use crate::error::{OrRaise, mistaken};
use crate::robot::Robot;
use crate::state::{State, course_of_lengths, course_of_poses};

/// A robot with chosen effects. Immutable; any number of threads may use it.
#[pyclass(frozen, module = "cdpr._cdpr")]
pub(crate) struct Model {
    pub(crate) model: Arc<cdpr::Model>,
}

/// Poses, statuses, residuals, iterations and tensions.
type Forward<'py> = (
    Bound<'py, PyArrayDyn<f64>>,
    Bound<'py, PyArray1<u8>>,
    Bound<'py, PyArrayDyn<f64>>,
    Bound<'py, PyArray1<u32>>,
    Option<Bound<'py, PyArrayDyn<f64>>>,
);

/// Margins, limiting cables, and the unit of the margins.
type Margins<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArray1<i64>>, String);

/// Tensions, and a status for each pose.
type Distributed<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArray1<u8>>);

#[pymethods]
impl Model {
    #[new]
    fn new(py: Python<'_>, robot: PyRef<'_, Robot>, composition: &str) -> PyResult<Self> {
        let composition = composition.parse().or_raise(py)?;
        let model = cdpr::Model::new(RobotData::clone(&robot.robot), composition).or_raise(py)?;
        Ok(Self { model: Arc::new(model) })
    }

    #[getter]
    fn composition(&self) -> String {
        self.model.composition().to_string()
    }

    #[getter]
    fn needs_tensions(&self) -> bool {
        self.model.needs_tensions()
    }

    /// The robot at rest at a pose (home if none is given), with cables that were never loaded.
    #[pyo3(signature = (pose=None))]
    fn state(&self, py: Python<'_>, pose: Option<&Bound<'_, PyAny>>) -> PyResult<State> {
        let model = &*self.model;
        let Some(pose) = pose else { return Ok(State::of(equilibrium::State::at_home(model))) };
        match Poses::of(pose, model.robot(), "pose")?.all(py)?[..] {
            [pose] => Ok(State::of(equilibrium::State::at(model, &pose))),
            _ => Err(mistaken(py, "array::unfit", "pose: one pose is needed", "pass one row")),
        }
    }

    /// Lengths that depend on no tensions.
    #[pyo3(signature = (poses, out=None))]
    fn lengths<'py>(
        &self,
        py: Python<'py>,
        poses: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let (model, cables) = (&*self.model, self.model.cable_count());
        let poses = Poses::of(poses, model.robot(), "poses")?;
        let lengths = room(py, out, &[poses.count, cables], poses.is_single)?;
        {
            let mut writing = writable(&lengths)?;
            let room = writing.as_slice_mut()?;
            let computed = poses.in_parts(|first, rows| {
                let part = &mut room[first * cables..][..rows.len() * cables];
                py.detach(|| model.lengths_of_rows(rows, part))
            });
            computed.or_raise(py)?;
        }
        Ok(lengths)
    }

    /// Controlled lengths under tensions.
    #[pyo3(signature = (poses, tensions, state=None, out=None))]
    fn lengths_under<'py>(
        &self,
        py: Python<'py>,
        poses: &Bound<'py, PyAny>,
        tensions: &Bound<'py, PyAny>,
        state: Option<PyRef<'_, State>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let (model, cables) = (&*self.model, self.model.cable_count());
        let poses = Poses::of(poses, model.robot(), "poses")?;
        let tensions = Rows::of(tensions, cables, "tensions", "one tension per cable (N)")?;
        let given = tensions.contiguous();
        let repeated;
        let all: &[f64] = match tensions.count {
            count if count == poses.count => &given,
            1 => {
                repeated = given.repeat(poses.count);
                &repeated
            }
            count => {
                let message = format!("tensions: {count} rows for {} poses", poses.count);
                return Err(mistaken(py, "array::unfit", message, "give one row per pose, or one for all"));
            }
        };
        let lengths = room(py, out, &[poses.count, cables], poses.is_single)?;
        {
            let mut writing = writable(&lengths)?;
            let room = writing.as_slice_mut()?;
            if let Some(state) = state.as_deref() {
                let poses = poses.all(py)?;
                py.detach(|| course_of_lengths(model, &poses, all, &mut state.lock(), room));
                drop(writing);
                return Ok(lengths);
            }
            let state = equilibrium::State::at_home(model);
            let computed = poses.in_parts(|first, rows| {
                let places = first * cables..(first + rows.len()) * cables;
                let (own, part) = (&all[places.clone()], &mut room[places]);
                py.detach(|| model.inverse_of_rows(rows, own, &state, part))
            });
            computed.or_raise(py)?;
        }
        Ok(lengths)
    }

    /// Poses that emerge from controlled lengths.
    #[pyo3(signature = (lengths, guess=None, wrench=None, state=None))]
    fn forward<'py>(
        &self,
        py: Python<'py>,
        lengths: &Bound<'py, PyAny>,
        guess: Option<&Bound<'py, PyAny>>,
        wrench: Option<&Bound<'py, PyAny>>,
        state: Option<PyRef<'_, State>>,
    ) -> PyResult<Forward<'py>> {
        let (model, cables) = (&*self.model, self.model.cable_count());
        let lengths = Rows::of(lengths, cables, "lengths", "one controlled length per cable (m)")?;
        let load = choices::load_if_given(py, model.robot(), wrench)?;
        let guesses: Vec<[f64; 7]> = match guess {
            Some(guess) => Poses::of(guess, model.robot(), "guess")?.all(py)?.iter().map(Pose::numbers).collect(),
            // a course goes on from its state
            None if state.is_some() => Vec::new(),
            None => vec![model.robot().home_or_middle().numbers()],
        };
        let count = lengths.count;
        let numbers = lengths.contiguous();
        let (mut poses, mut statuses) = (vec![[0.0; 7]; count], vec![Status::NotConverged; count]);
        let (mut residual_rms, mut iterations) = (vec![0.0; count], vec![0; count]);
        let mut tensions = vec![f64::NAN; count * cables];
        let state = state.as_deref();
        let computed = py.detach(|| {
            let problems = ForwardRows { lengths: &numbers, guesses: guesses[..].into(), load: load.as_ref() };
            let answers = ForwardAnswers {
                poses: &mut poses,
                statuses: &mut statuses,
                residual_rms: Some(&mut residual_rms),
                iterations: Some(&mut iterations),
                tensions: Some(&mut tensions),
            };
            match state {
                Some(state) => course_of_poses(model, &problems, &mut state.lock(), answers),
                None => {
                    let mut state = equilibrium::State::at_home(model);
                    model.forward_of_rows(&problems, &ForwardSettings::default(), &mut state, answers)
                }
            }
        });
        computed.or_raise(py)?;
        let codes: Vec<u8> = statuses.iter().map(|status| *status as u8).collect();
        let has_tensions = count == 0 || tensions.iter().any(|tension| tension.is_finite());
        let shape = [count, cables];
        let shape = if lengths.is_single { &shape[1..] } else { &shape[..] };
        let tensions = has_tensions.then(|| array(py, &tensions, shape)).transpose()?;
        let rows = if lengths.is_single { &[7][..] } else { &[count, 7] };
        Ok((
            array(py, poses.as_flattened(), rows)?,
            PyArray1::from_vec(py, codes),
            array(py, &residual_rms, &[count])?,
            PyArray1::from_vec(py, iterations),
            tensions,
        ))
    }

    /// Reason for which the forward problem of one row has no solution; `None` if it has one.
    #[pyo3(signature = (lengths, guess=None, wrench=None))]
    fn forward_reason(
        &self,
        py: Python<'_>,
        lengths: &Bound<'_, PyAny>,
        guess: Option<&Bound<'_, PyAny>>,
        wrench: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Option<String>> {
        let model = &*self.model;
        let lengths = Rows::of(lengths, model.cable_count(), "lengths", "one controlled length per cable (m)")?;
        let load = choices::load_if_given(py, model.robot(), wrench)?;
        let guess = guess.map(|guess| Poses::of(guess, model.robot(), "guess")?.all(py)).transpose()?;
        let guess = guess.as_ref().and_then(|poses| poses.first());
        let mut state = equilibrium::State::at_home(model);
        let solution = model.forward(&lengths.contiguous(), load.as_ref(), guess, &mut state).or_raise(py)?;
        Ok(solution.reason.clone())
    }

    /// Tensions that balance the load within limits, and a status for each pose.
    #[pyo3(signature = (poses, method, limits=None, wrench=None, out=None))]
    fn tensions<'py>(
        &self,
        py: Python<'py>,
        poses: &Bound<'py, PyAny>,
        method: &str,
        limits: Option<LimitArguments<'py>>,
        wrench: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Distributed<'py>> {
        let (model, cables) = (&*self.model, self.model.cable_count());
        let poses = Poses::of(poses, model.robot(), "poses")?;
        let load = choices::load(py, model.robot(), wrench)?;
        let limits = choices::limits(py, model.robot(), limits)?;
        let method = choices::method(py, method)?;
        let tensions = room(py, out, &[poses.count, cables], poses.is_single)?;
        let mut statuses = vec![tension::Status::Undecided; poses.count];
        {
            let mut writing = writable(&tensions)?;
            let room = writing.as_slice_mut()?;
            let computed = poses.in_parts(|first, rows| {
                let part = &mut room[first * cables..][..rows.len() * cables];
                let own = &mut statuses[first..first + rows.len()];
                py.detach(|| model.tensions_of_rows(&load, &limits, method, rows, part, own))
            });
            computed.or_raise(py)?;
        }
        let codes = statuses.iter().map(|status| *status as u8).collect();
        Ok((tensions, PyArray1::from_vec(py, codes)))
    }

    /// Whether tensions within limits balance the load, pose by pose.
    #[pyo3(signature = (poses, limits=None, wrench=None))]
    fn feasible<'py>(
        &self,
        py: Python<'py>,
        poses: &Bound<'py, PyAny>,
        limits: Option<LimitArguments<'py>>,
        wrench: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray1<bool>>> {
        let model = &*self.model;
        let poses = Poses::of(poses, model.robot(), "poses")?.all(py)?;
        let load = choices::load(py, model.robot(), wrench)?;
        let limits = choices::limits(py, model.robot(), limits)?;
        let mut answers = vec![false; poses.len()];
        let computed =
            py.detach(|| cdpr::equilibrium::feasibility::feasible(model, &load, &limits, &poses, &mut answers));
        computed.or_raise(py)?;
        Ok(PyArray1::from_vec(py, answers))
    }

    /// Whether criteria by name hold, pose by pose.
    #[pyo3(signature = (poses, criteria, limits=None, wrench=None))]
    fn satisfies<'py>(
        &self,
        py: Python<'py>,
        poses: &Bound<'py, PyAny>,
        criteria: Vec<String>,
        limits: Option<LimitArguments<'py>>,
        wrench: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray1<bool>>> {
        let setting = choices::setting(py, &self.model, limits, wrench)?;
        let criterion = choices::criterion(py, &criteria, &setting)?;
        let poses = Poses::of(poses, self.model.robot(), "poses")?.all(py)?;
        let mut answers = vec![false; poses.len()];
        py.detach(|| criterion.holds_all(&poses, &mut answers));
        Ok(PyArray1::from_vec(py, answers))
    }

    /// Margins of a criterion by name, pose by pose, in its unit, and the limiting cables (from 0; -1 if there is none).
    #[pyo3(signature = (poses, criterion, limits=None, wrench=None))]
    fn margins<'py>(
        &self,
        py: Python<'py>,
        poses: &Bound<'py, PyAny>,
        criterion: &str,
        limits: Option<LimitArguments<'py>>,
        wrench: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Margins<'py>> {
        let setting = choices::setting(py, &self.model, limits, wrench)?;
        let criterion = choices::criterion(py, &[criterion.to_owned()], &setting)?;
        let poses = Poses::of(poses, self.model.robot(), "poses")?.all(py)?;
        let verdicts: Vec<Verdict> = py.detach(|| poses.iter().map(|pose| criterion.judge(pose)).collect());
        let margins: Vec<f64> = verdicts.iter().map(|verdict| verdict.margin).collect();
        let cables = verdicts.iter().map(|verdict| verdict.cable.map_or(-1, |cable| cable as i64)).collect();
        let unit = criterion.unit().to_owned();
        Ok((array(py, &margins, &[margins.len()])?, PyArray1::from_vec(py, cables), unit))
    }

    /// Structure matrices Aᵀ: wrenches of unit tensions.
    #[pyo3(signature = (poses, out=None))]
    fn structure_matrix<'py>(
        &self,
        py: Python<'py>,
        poses: &Bound<'py, PyAny>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let (model, cables, dof) = (&*self.model, self.model.cable_count(), self.model.dof());
        self.matrices(py, poses, [dof, cables], out, |pose| model.structure_matrix(pose).ok())
    }

    /// Stiffness matrices at poses with tensions, in the components of the motion pattern.
    #[pyo3(signature = (poses, tensions, wrench=None, out=None))]
    fn stiffness<'py>(
        &self,
        py: Python<'py>,
        poses: &Bound<'py, PyAny>,
        tensions: &Bound<'py, PyAny>,
        wrench: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let (model, cables, dof) = (&*self.model, self.model.cable_count(), self.model.dof());
        let load = choices::load(py, model.robot(), wrench)?;
        let tensions = Rows::of(tensions, cables, "tensions", "one tension per cable (N)")?;
        let given = tensions.contiguous();
        let mut index = 0;
        self.matrices(py, poses, [dof, dof], out, |pose| {
            let own = given.get(index * cables..(index + 1) * cables).unwrap_or(&given[..cables]);
            index += usize::from(tensions.count > 1);
            Some(Stiffness::at(model, pose, own, &load).ok()?.system)
        })
    }
}

impl Model {
    /// A matrix for each pose; NaN where there is none.
    fn matrices<'py>(
        &self,
        py: Python<'py>,
        poses: &Bound<'py, PyAny>,
        [rows, columns]: [usize; 2],
        out: Option<&Bound<'py, PyAny>>,
        mut of: impl FnMut(&Pose) -> Option<DMatrix<f64>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let poses = Poses::of(poses, self.model.robot(), "poses")?;
        let matrices = room(py, out, &[poses.count, rows, columns], poses.is_single)?;
        {
            let mut writing = writable(&matrices)?;
            let all = writing.as_slice_mut()?;
            for (pose, places) in poses.all(py)?.iter().zip(all.chunks_exact_mut(rows * columns)) {
                match of(pose) {
                    Some(matrix) => {
                        places.iter_mut().enumerate().for_each(|(k, place)| *place = matrix[(k / columns, k % columns)])
                    }
                    None => places.fill(f64::NAN),
                }
            }
        }
        Ok(matrices)
    }
}
