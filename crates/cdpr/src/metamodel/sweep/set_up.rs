//! The experiment of one point of a sweep, and whether there is one at all.

use nalgebra::Vector3;
use thiserror::Error;
use toml::Table;

use super::key::Place;
use super::point::whatever_the_error;
use super::{Key, KeyError, Parameter, Subjects, Sweep};
use crate::metamodel::{Experiment, ExperimentError, InputError, Robots, Study};
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
    for parameter in &sweep.parameter {
        let first = parameter.all_values().unwrap_or_default().first().copied().unwrap_or(0.0);
        match Files::new([(parameter, first)], subjects)?.read() {
            // other mistakes may be those of this value
            Err(PointError::Read(error)) if error.code == "toml::unknown-key" => return Err(PointError::Read(error)),
            _ => {}
        }
    }
    let mut refused = None;
    for values in sweep.points().iter().take(TRIED) {
        match SetUp::new(sweep, subjects, values) {
            Ok(_) => return Ok(()),
            Err(error) => {
                refused.get_or_insert(error);
            }
        }
    }
    refused.map_or(Ok(()), Err)
}

/// Everything that a point needs before its cells are commanded.
pub(super) struct SetUp {
    pub(super) experiment: Experiment,
    pub(super) bounds: Bounds,
    pub(super) grid: Grid,
}

impl SetUp {
    pub(super) fn new(sweep: &Sweep, subjects: &Subjects, values: &[f64]) -> Result<Self, PointError> {
        let parameters = sweep.parameter.iter().zip(values.iter().copied());
        let (study, robots) = Files::new(parameters, subjects)?.read()?;
        let experiment = Experiment::new(study, robots)?.with_tension_method(sweep.tension_method);
        let bounds = experiment.bounds(sweep.bounds_m.as_deref())?;
        let grid = Grid::new(&bounds, sweep.step_m.unwrap_or(bounds.usual_step()))?;
        experiment.reachable_with(whatever_the_error(&experiment))?;
        Ok(Self { experiment, bounds, grid })
    }
}

/// The files with the values of some parameters.
struct Files<'a> {
    study: Table,
    control: Table,
    machine: Table,
    offset_robot: Option<&'a str>,
    /// Radius (m) and axis.
    pulleys: Option<(f64, Option<&'a [f64]>)>,
}

impl<'a> Files<'a> {
    fn new(
        parameters: impl IntoIterator<Item = (&'a Parameter, f64)>,
        subjects: &'a Subjects,
    ) -> Result<Self, PointError> {
        let table = |text: &str, name: &str| -> Result<Table, ReadError> {
            text.parse().map_err(|error: toml::de::Error| ReadError::new(name, "toml::syntax", error.to_string()))
        };
        let mut files = Self {
            study: table(&subjects.study, "the study")?,
            control: table(&subjects.control, "the control model")?,
            machine: table(&subjects.machine, "the machine")?,
            offset_robot: subjects.offset_robot.as_deref(),
            pulleys: None,
        };
        for (parameter, value) in parameters {
            let key: Key = parameter.key.parse()?;
            match key.place {
                Place::Study => key.set(&mut files.study, value)?,
                Place::Control => key.set(&mut files.control, value)?,
                Place::Machine => key.set(&mut files.machine, value)?,
                Place::Both => {
                    key.set(&mut files.control, value)?;
                    key.set(&mut files.machine, value)?;
                }
                Place::PlacedPulleys => files.pulleys = Some((value, parameter.swivel_axis.as_deref())),
            }
        }
        Ok(files)
    }

    /// The study and its robots; nobody asks a sweep for predictions.
    fn read(&self) -> Result<(Study, Robots), PointError> {
        let text = |table: &Table, name: &str| -> Result<String, ReadError> {
            toml::to_string(table).map_err(|error| ReadError::new(name, "toml::syntax", error.to_string()))
        };
        let robot = |table: &Table, name: &str| Robot::from_toml(&text(table, name)?, name);
        let name = "the study of this point";
        let study = Study::from_toml_bytes(text(&self.study, name)?.as_bytes(), name)?;
        let mut machine = robot(&self.machine, "the machine of this point")?;
        if let Some((radius, axis)) = self.pulleys {
            machine = with_pulleys(&machine, &study, radius, axis)?;
        }
        let former = self.offset_robot.map(|text| Robot::from_toml(text, "the offset robot")).transpose()?;
        let control = robot(&self.control, "the control model of this point")?;
        Ok((study, Robots { control, machine, prediction: None, former }))
    }
}

/// The machine with a pulley of this radius at every cable that touches at the anchor at the initial pose.
///
/// The axis is one for all cables, or that of each cable's file.
fn with_pulleys(machine: &Robot, study: &Study, radius: f64, axis: Option<&[f64]>) -> Result<Robot, PointError> {
    let common = match axis {
        None => None,
        Some(&[first, second]) if machine.motion_pattern.is_planar() => Some(machine.plane.embed([first, second])),
        Some(&[x, y, z]) => Some(Vector3::new(x, y, z)),
        Some(_) => return Err(PointError::SwivelAxis),
    };
    let pulley = |cable: &Cable| -> Result<(f64, Vector3<f64>), PointError> {
        let axis = common.or(cable.pulley_swivel_axis);
        let axis = axis.ok_or_else(|| PointError::NoSwivelAxis { cable: cable.name.clone() })?;
        Ok((radius, axis.try_normalize(0.0).ok_or(PointError::NoDirection)?))
    };
    let pulleys: Vec<_> = machine.cables.iter().map(pulley).collect::<Result<_, _>>()?;
    let pose = study.initial_pose(machine).map_err(InputError::from)?;
    Ok(place_pulleys(machine, &pulleys, &pose)?)
}
