//! Machines in time, step by step.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use cdpr::plant::{self, Command, StepError, Winches};
use numpy::{PyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::arrays::{Poses, Rows, array, numbers, writable};
use crate::error::{OrRaise, mistaken};
use crate::model::Model;

/// Quantity of commands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    /// Controlled lengths (m).
    Lengths,
    /// Rates of controlled lengths (m/s).
    Speeds,
    /// Torques of motors (N·m).
    Torques,
    /// Tensions (N).
    Tensions,
}

impl Kind {
    const NAMES: [(&'static str, Self); 4] = [
        ("lengths", Self::Lengths),
        ("speeds", Self::Speeds),
        ("torques", Self::Torques),
        ("tensions", Self::Tensions),
    ];

    /// The quantity with this name.
    pub(crate) fn named(py: Python<'_>, name: &str) -> PyResult<Self> {
        let found = Self::NAMES.iter().find(|(known, _)| *known == name).map(|(_, kind)| *kind);
        found.ok_or_else(|| {
            let message = format!("there are no commands of the kind `{name}`");
            mistaken(py, "usage::value", message, "choose lengths, speeds, torques or tensions")
        })
    }

    fn of(self, number: f64) -> Command {
        match self {
            Self::Lengths => Command::Length(number),
            Self::Speeds => Command::Speed(number),
            Self::Torques => Command::Torque(number),
            Self::Tensions => Command::Tension(number),
        }
    }

    /// Writes an array of commands, one per cable.
    pub(crate) fn write(self, commands: &Bound<'_, PyAny>, out: &mut [Command]) -> PyResult<()> {
        let rows = Rows::of(commands, out.len(), "commands", "one command per cable")?;
        out.iter_mut().zip(rows.contiguous().iter()).for_each(|(place, number)| *place = self.of(*number));
        Ok(())
    }
}

/// A machine in time. Immutable; its changing quantities are in a `PlantState`.
#[pyclass(frozen, module = "cdpr._cdpr")]
pub(crate) struct Plant {
    plant: Arc<plant::Plant>,
}

/// State of a machine in time; a copy is a snapshot.
#[pyclass(frozen, module = "cdpr._cdpr")]
pub(crate) struct PlantState {
    inside: Mutex<Inside>,
}

/// A state with room for its commands.
struct Inside {
    state: plant::PlantState,
    commands: Vec<Command>,
}

/// Times, poses, twists, tensions and lengths of a run, and the reason for which it ended early.
type Run<'py> = (
    Bound<'py, PyArrayDyn<f64>>,
    Bound<'py, PyArrayDyn<f64>>,
    Bound<'py, PyArrayDyn<f64>>,
    Bound<'py, PyArrayDyn<f64>>,
    Bound<'py, PyArrayDyn<f64>>,
    Option<String>,
);

#[pymethods]
impl Plant {
    #[new]
    #[pyo3(signature = (model, winches="ideal"))]
    fn new(py: Python<'_>, model: PyRef<'_, Model>, winches: &str) -> PyResult<Self> {
        let winches = match winches {
            "ideal" => Winches::Ideal,
            "drums" => Winches::Drums,
            other => {
                let message = format!("winches: there are no winches `{other}`");
                return Err(mistaken(py, "usage::value", message, "choose ideal or drums"));
            }
        };
        let plant = plant::Plant::new(cdpr::Model::clone(&model.model), winches).or_raise(py)?;
        Ok(Self { plant: Arc::new(plant) })
    }

    /// Equilibrium at a pose with tensions, of which the nearest that balance the load are taken.
    fn at_rest(&self, py: Python<'_>, pose: &Bound<'_, PyAny>, tensions: &Bound<'_, PyAny>) -> PyResult<PlantState> {
        let pose = self.pose(py, pose)?;
        let tensions = Rows::of(tensions, self.cables(), "tensions", "one tension per cable (N)")?;
        PlantState::new(self.plant.at_rest(&pose, &tensions.contiguous()).or_raise(py)?)
    }

    /// At rest at a pose with controlled lengths, whether they balance the load or not.
    fn with_lengths(
        &self,
        py: Python<'_>,
        pose: &Bound<'_, PyAny>,
        lengths: &Bound<'_, PyAny>,
    ) -> PyResult<PlantState> {
        let pose = self.pose(py, pose)?;
        let lengths = Rows::of(lengths, self.cables(), "lengths", "one controlled length per cable (m)")?;
        PlantState::new(self.plant.with_lengths(&pose, &lengths.contiguous()).or_raise(py)?)
    }

    /// Advances a state by a time under commands.
    #[pyo3(signature = (state, commands, dt, kind="lengths"))]
    fn step(
        &self,
        py: Python<'_>,
        state: PyRef<'_, PlantState>,
        commands: &Bound<'_, PyAny>,
        dt: f64,
        kind: &str,
    ) -> PyResult<()> {
        let kind = Kind::named(py, kind)?;
        let rows = Rows::of(commands, self.cables(), "commands", "one command per cable")?;
        let numbers = rows.contiguous();
        // nothing of Python runs while the state is locked
        let mut inside = state.lock();
        let Inside { state, commands } = &mut *inside;
        commands.iter_mut().zip(numbers.iter()).for_each(|(place, number)| *place = kind.of(*number));
        self.plant.step(state, commands, dt).or_raise(py)
    }

    /// Runs through rows of commands, one per step, and keeps every so many states besides the first.
    #[pyo3(signature = (state, commands, dt, every=1, kind="lengths"))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        state: PyRef<'py, PlantState>,
        commands: &Bound<'py, PyAny>,
        dt: f64,
        every: usize,
        kind: &str,
    ) -> PyResult<Run<'py>> {
        let (kind, cables) = (Kind::named(py, kind)?, self.cables());
        let rows = Rows::of(commands, cables, "commands", "one command per cable")?;
        let all = rows.contiguous();
        let mut log = Log::default();
        let mut failure: Option<StepError> = None;
        // signals are looked at between parts
        for part in all.chunks(PART * cables) {
            py.check_signals()?;
            let state = &*state;
            let log = &mut log;
            failure = py.detach(|| {
                let mut inside = state.lock();
                let Inside { state, commands } = &mut *inside;
                for row in part.chunks_exact(cables) {
                    if log.steps == 0 {
                        log.note(state);
                    }
                    commands.iter_mut().zip(row).for_each(|(place, number)| *place = kind.of(*number));
                    if let Err(error) = self.plant.step(state, commands, dt) {
                        return Some(error);
                    }
                    log.steps += 1;
                    if log.steps.is_multiple_of(every.max(1)) {
                        log.note(state);
                    }
                }
                None
            });
            if failure.is_some() {
                break;
            }
        }
        let count = log.times.len();
        let of = |numbers: &[f64], width: usize| array(py, numbers, &[count, width]);
        Ok((
            array(py, &log.times, &[count])?,
            of(&log.poses, 7)?,
            of(&log.twists, 6)?,
            of(&log.tensions, cables)?,
            of(&log.lengths, cables)?,
            failure.map(|error| error.to_string()),
        ))
    }
}

/// Steps between two looks at signals.
const PART: usize = 10_000;

/// Recorded states.
#[derive(Default)]
struct Log {
    steps: usize,
    times: Vec<f64>,
    poses: Vec<f64>,
    twists: Vec<f64>,
    tensions: Vec<f64>,
    lengths: Vec<f64>,
}

impl Log {
    fn note(&mut self, state: &plant::PlantState) {
        self.times.push(state.time);
        self.poses.extend(state.pose.numbers());
        self.twists.extend(state.twist().as_slice());
        self.tensions.extend(state.cables.iter().map(|cable| cable.tension));
        self.lengths.extend(state.cables.iter().map(|cable| cable.controlled_length));
    }
}

impl Plant {
    fn cables(&self) -> usize {
        self.plant.model().cable_count()
    }

    fn pose(&self, py: Python<'_>, pose: &Bound<'_, PyAny>) -> PyResult<cdpr::Pose> {
        match Poses::of(pose, self.plant.model().robot(), "pose")?.all(py)?[..] {
            [pose] => Ok(pose),
            _ => Err(mistaken(py, "array::unfit", "pose: one pose is needed", "pass one row")),
        }
    }
}

type Numbers<'py> = PyResult<Bound<'py, PyArrayDyn<f64>>>;

#[pymethods]
impl PlantState {
    #[getter]
    fn time(&self) -> f64 {
        self.lock().state.time
    }

    #[getter]
    fn pose<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        array(py, &self.lock().state.pose.numbers(), &[7])
    }

    #[getter]
    fn twist<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        array(py, self.lock().state.twist().as_slice(), &[6])
    }

    #[getter]
    fn tensions<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.of_cables(py, |state, cable| state.cables[cable].tension)
    }

    #[getter]
    fn lengths<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.of_cables(py, |state, cable| state.cables[cable].controlled_length)
    }

    #[getter]
    fn length_rates<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.of_cables(py, |state, cable| state.cables[cable].controlled_length_rate)
    }

    /// Writes pose (7), twist (6) and tensions (m) into an array.
    fn observe<'py>(&self, out: &Bound<'py, PyAny>) -> PyResult<()> {
        let width = 13 + self.lock().state.cables.len();
        if numbers(out, "out")?.shape() != [width] {
            let message = format!("out: an array of {width} numbers is needed");
            return Err(mistaken(out.py(), "array::unfit", message, "pose (7), twist (6), then a tension per cable"));
        }
        let mut writing = writable(out.cast::<PyArrayDyn<f64>>()?)?;
        let places = writing.as_slice_mut()?;
        let inside = self.lock();
        let state = &inside.state;
        places[..7].copy_from_slice(&state.pose.numbers());
        places[7..13].copy_from_slice(state.twist().as_slice());
        places[13..].iter_mut().zip(&state.cables).for_each(|(place, cable)| *place = cable.tension);
        Ok(())
    }

    fn copy(&self) -> Self {
        let inside = self.lock();
        Self { inside: Mutex::new(Inside { state: inside.state.clone(), commands: inside.commands.clone() }) }
    }

    fn __copy__(&self) -> Self {
        self.copy()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.copy()
    }

    fn __eq__(&self, other: PyRef<'_, Self>) -> bool {
        // two locks of one state would wait for each other
        std::ptr::eq(self, &*other) || self.lock().state == other.lock().state
    }
}

impl PlantState {
    fn new(state: plant::PlantState) -> PyResult<Self> {
        let commands = state.cables.iter().map(|cable| Command::Length(cable.controlled_length)).collect();
        Ok(Self { inside: Mutex::new(Inside { state, commands }) })
    }

    fn lock(&self) -> MutexGuard<'_, Inside> {
        // a step that failed leaves whole numbers
        self.inside.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn of_cables<'py>(&self, py: Python<'py>, of: impl Fn(&plant::PlantState, usize) -> f64) -> Numbers<'py> {
        let inside = self.lock();
        let numbers: Vec<f64> = (0..inside.state.cables.len()).map(|cable| of(&inside.state, cable)).collect();
        drop(inside);
        array(py, &numbers, &[numbers.len()])
    }
}
