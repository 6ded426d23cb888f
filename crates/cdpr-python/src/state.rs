//! States of robots whose cables remember, and courses of rows through them.

use std::sync::{Mutex, MutexGuard, PoisonError};

use cdpr::equilibrium::{self, ForwardAnswers, ForwardRows, ForwardSettings, RowsError};
use cdpr::geometry::{Pose, PoseBatch};
use numpy::PyArrayDyn;
use pyo3::prelude::*;

use crate::arrays::array;

/// Memories of a robot's cables, and the pose at which it settled last.
#[pyclass(frozen, module = "cdpr._cdpr")]
pub(crate) struct State {
    state: Mutex<equilibrium::State>,
}

#[pymethods]
impl State {
    #[getter]
    fn pose<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        array(py, &self.lock().pose().numbers(), &[7])
    }

    fn copy(&self) -> Self {
        Self { state: Mutex::new(self.lock().clone()) }
    }

    fn __copy__(&self) -> Self {
        self.copy()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.copy()
    }
}

impl State {
    /// A state to begin with.
    pub(crate) fn of(state: equilibrium::State) -> Self {
        Self { state: Mutex::new(state) }
    }

    /// The state, for one thread at a time.
    pub(crate) fn lock(&self) -> MutexGuard<'_, equilibrium::State> {
        // a state is replaced whole
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Lengths along a course of poses under tensions, of cables that remember; NaN where there are none.
pub(crate) fn course_of_lengths(
    model: &cdpr::Model,
    poses: &[Pose],
    tensions: &[f64],
    state: &mut equilibrium::State,
    lengths: &mut [f64],
) {
    let cables = model.cable_count();
    for ((pose, own), row) in poses.iter().zip(tensions.chunks_exact(cables)).zip(lengths.chunks_exact_mut(cables)) {
        match model.inverse(pose, own, state) {
            Ok(found) => row.iter_mut().zip(&found.cables).for_each(|(place, own)| *place = own.controlled_length),
            Err(_) => row.fill(f64::NAN),
        }
        state.settle_inverse(model);
    }
}

/// Poses along a course of lengths, of cables that remember; without guesses each search begins at the pose before.
pub(crate) fn course_of_poses(
    model: &cdpr::Model,
    problems: &ForwardRows<'_>,
    state: &mut equilibrium::State,
    answers: ForwardAnswers<'_>,
) -> Result<(), RowsError> {
    let (cables, settings) = (model.cable_count(), ForwardSettings::default());
    let ForwardAnswers { poses, statuses, residual_rms, iterations, tensions } = answers;
    let (mut residual_rms, mut iterations, mut tensions) = (residual_rms, iterations, tensions);
    let mut guesses = PoseBatch::default();
    guesses.fill_rows(problems.guesses)?;
    for (row, lengths) in problems.lengths.chunks_exact(cables).enumerate() {
        let guess = match guesses.len() {
            0 => state.pose(),
            1 if row > 0 => state.pose(),
            count => guesses.get(row.min(count - 1)),
        };
        let solution = model.forward_with(&settings, lengths, problems.load, Some(&guess), state)?;
        (poses[row], statuses[row]) = (solution.pose.numbers(), solution.status);
        if let Some(places) = &mut residual_rms {
            places[row] = solution.residual_rms;
        }
        if let Some(places) = &mut iterations {
            places[row] = solution.iterations;
        }
        if let Some(places) = &mut tensions {
            places[row * cables..][..cables].iter_mut().zip(&solution.tensions).for_each(|(place, own)| *place = *own);
        }
        state.settle_forward(model);
    }
    Ok(())
}
