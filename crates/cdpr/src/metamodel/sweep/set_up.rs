//! The experiment of one point of a sweep, and whether there is one at all.

use nalgebra::Vector3;
use thiserror::Error;

use super::files::Files;
use super::point::whatever_the_error;
use super::{KeyError, Subjects, Sweep};
use crate::metamodel::{Experiment, ExperimentError, InputError, Study};
use crate::model::{PlacePulleysError, place_pulleys};
use crate::reading::ReadError;
use crate::robot::{Cable, Robot};
use crate::workspace::grid::Grid;
use crate::workspace::{Bounds, WorkspaceError};

/// Why a point of a sweep cannot be set up.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PointError {
    /// A key that leads nowhere.
    #[error(transparent)]
    Key(#[from] KeyError),
    /// A value that study or robot files cannot have, or a key that they do not know.
    #[error(transparent)]
    Read(#[from] Box<ReadError>),
    /// Models that make no experiment.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A box, or cells, that are none.
    #[error(transparent)]
    Workspace(#[from] WorkspaceError),
    /// Pulleys that have no place.
    #[error(transparent)]
    Pulleys(#[from] PlacePulleysError),
    /// Neither two nor three components.
    #[error("a swivel_axis is three numbers, as [0, 0, 1], or two in the plane of a planar robot")]
    SwivelAxis,
    /// An axis of length 0.
    #[error("a swivel_axis of length 0 has no direction")]
    NoDirection,
    /// Nobody says how a pulley is to swivel.
    #[error(
        "placed_pulley_radius_m needs swivel_axis, as [0, 0, 1], or pulley_swivel_axis of every cable, which \"{cable}\" lacks"
    )]
    NoSwivelAxis {
        /// Name of the cable.
        cable: String,
    },
}

impl From<ExperimentError> for PointError {
    fn from(error: ExperimentError) -> Self {
        Self::Input(error.error)
    }
}

impl From<ReadError> for PointError {
    fn from(error: ReadError) -> Self {
        Self::Read(Box::new(error))
    }
}

/// Points that are tried before a sweep counts as one that can be set up nowhere.
const TRIED: usize = 1000;

/// Refuses a sweep before anything is computed: keys that lead nowhere or that files do not know, and what can be set up at none of
/// the points.
pub fn check(sweep: &Sweep, subjects: &Subjects) -> Result<(), PointError> {
    let prepared = PreparedSweep::new(sweep, subjects)?;
    for (index, parameter) in sweep.parameter.iter().enumerate() {
        let first = parameter.all_values().unwrap_or_default().first().copied().unwrap_or(0.0);
        match prepared.files.with(&[(index, first)])?.read() {
            // other mistakes may be those of this value
            Err(PointError::Read(error)) if error.code == "toml::unknown-key" => return Err(PointError::Read(error)),
            _ => {}
        }
    }
    let mut refused = None;
    for values in sweep.points().iter().take(TRIED) {
        match SetUp::new(&prepared, values) {
            Ok(_) => return Ok(()),
            Err(error) => {
                refused.get_or_insert(error);
            }
        }
    }
    refused.map_or(Ok(()), Err)
}

/// A sweep whose files are read, so that its points can be set up.
pub struct PreparedSweep<'a> {
    pub(super) sweep: &'a Sweep,
    files: Files<'a>,
}

impl<'a> PreparedSweep<'a> {
    /// Reads keys and files once for all points.
    pub fn new(sweep: &'a Sweep, subjects: &'a Subjects) -> Result<Self, PointError> {
        Ok(Self { sweep, files: Files::new(sweep, subjects)? })
    }
}

/// Everything that a point needs before its cells are commanded.
pub(super) struct SetUp {
    pub(super) experiment: Experiment,
    pub(super) bounds: Bounds,
    pub(super) grid: Grid,
}

impl SetUp {
    pub(super) fn new(prepared: &PreparedSweep<'_>, values: &[f64]) -> Result<Self, PointError> {
        let sweep = prepared.sweep;
        let values: Vec<(usize, f64)> = values.iter().copied().enumerate().collect();
        let (study, robots) = prepared.files.with(&values)?.read()?;
        let experiment = Experiment::new(study, robots)?.with_tension_method(sweep.tension_method);
        let bounds = experiment.bounds(sweep.bounds_m.as_deref())?;
        let grid = Grid::new(&bounds, sweep.step_m.unwrap_or(bounds.usual_step()))?;
        experiment.reachable_with(whatever_the_error(&experiment))?;
        Ok(Self { experiment, bounds, grid })
    }
}

/// The machine with a pulley of this radius at every cable that touches at the anchor at the initial pose.
///
/// The axis is one for all cables, or that of each cable's file.
pub(super) fn with_pulleys(
    machine: &Robot,
    study: &Study,
    radius: f64,
    axis: Option<&[f64]>,
) -> Result<Robot, PointError> {
    let common = match axis {
        None => None,
        Some(&[first, second]) if machine.motion_pattern.is_planar() => Some(machine.plane.embed([first, second])),
        Some(&[x, y, z]) => Some(Vector3::new(x, y, z)),
        Some(_) => return Err(PointError::SwivelAxis),
    };
    let pulley = |cable: &Cable| -> Result<(f64, Vector3<f64>), PointError> {
        let axis = common.or(cable.pulley_swivel_axis());
        let axis = axis.ok_or_else(|| PointError::NoSwivelAxis { cable: cable.name.clone() })?;
        Ok((radius, axis.try_normalize(0.0).ok_or(PointError::NoDirection)?))
    };
    let pulleys: Vec<_> = machine.cables.iter().map(pulley).collect::<Result<_, _>>()?;
    let pose = study.initial_pose(machine).map_err(InputError::from)?;
    Ok(place_pulleys(machine, &pulleys, &pose)?)
}
