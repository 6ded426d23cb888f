//! The experiment of one point of a sweep, and the check that there is one.

use super::files::Files;
use super::point_error::PointError;
use super::{Subjects, Sweep};
use crate::Experiment;
use crate::reachable::Requirements;
use cdpr_model::control::InputError;
use cdpr_workspace::Bounds;
use cdpr_workspace::grid::Grid;

/// Most points tried before a sweep counts as impossible to set up.
const TRIED: usize = 1000;

/// Checks a sweep before anything is computed: an error for keys that do not exist or that files do not know, and for a
/// sweep of which no point can be set up.
pub fn check(sweep: &Sweep, subjects: &Subjects) -> Result<(), PointError> {
    let prepared = PreparedSweep::new(sweep, subjects)?;
    for (index, parameter) in sweep.parameter.iter().enumerate() {
        let first = parameter.all_values().unwrap_or_default().first().copied().unwrap_or(0.0);
        match prepared.files.with(&[(index, first)])?.read() {
            // other errors may be due to this value
            Err(PointError::Read(error)) if error.code == "toml::unknown-key" => return Err(PointError::Read(error)),
            _ => {}
        }
    }
    let mut refused = None;
    for point in sweep.points().iter().take(TRIED) {
        let values = sweep.values_of(point);
        let set_up = match sweep.calibration {
            Some(_) => prepared.experiment(values).map(drop),
            None => SetUp::new(&prepared, values).map(drop),
        };
        match set_up {
            Ok(()) => return Ok(()),
            Err(error) => {
                refused.get_or_insert(error);
            }
        }
    }
    refused.map_or(Ok(()), Err)
}

/// A sweep whose files are read, ready to set up its points.
pub struct PreparedSweep {
    pub(crate) sweep: Sweep,
    files: Files,
}

impl PreparedSweep {
    /// Reads keys and files once for all points.
    pub fn new(sweep: &Sweep, subjects: &Subjects) -> Result<Self, PointError> {
        Ok(Self { sweep: sweep.clone(), files: Files::new(sweep, subjects)? })
    }

    /// The experiment with these values of the parameters.
    pub(crate) fn experiment(&self, values: &[f64]) -> Result<Experiment, PointError> {
        let values: Vec<(usize, f64)> = values.iter().copied().enumerate().collect();
        let (study, robots) = self.files.with(&values)?.read()?;
        if study.control.compensation.is_some() {
            let reason = "it changes numbers of robots, and a map belongs to one robot as it is";
            return Err(InputError::Map { question: "a sweep", reason }.into());
        }
        Ok(Experiment::new(study, robots)?.with_tension_method(self.sweep.tension_method))
    }
}

/// Everything that a point needs before its cells are commanded.
pub(super) struct SetUp {
    pub(super) experiment: Experiment,
    pub(super) bounds: Bounds,
    pub(super) grid: Grid,
}

impl SetUp {
    pub(super) fn new(prepared: &PreparedSweep, values: &[f64]) -> Result<Self, PointError> {
        let sweep = &prepared.sweep;
        let experiment = prepared.experiment(values)?;
        let bounds = experiment.bounds(sweep.bounds_m.as_deref())?;
        let grid = Grid::new(&bounds, sweep.step_m.unwrap_or(bounds.usual_step()))?;
        experiment.reachable_with(whatever_the_error(&experiment))?;
        Ok(Self { experiment, bounds, grid })
    }
}

/// Requirements of a point on a pose: no limit of the position error, which the census compares with the thresholds,
/// unless there is no other requirement.
pub(super) fn whatever_the_error(experiment: &Experiment) -> Requirements {
    let asked = experiment.requirements();
    Requirements { position_error_max: asked.tensions.is_none().then_some(f64::MAX), ..asked }
}
