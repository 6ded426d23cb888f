//! One point of a sweep.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use toml::Table;

use super::key::Place;
use super::{Key, Sweep};
use crate::metamodel::reachable::{Census, Reachable, Requirements};
use crate::metamodel::{Control, Driving, Study, winch_offsets};
use crate::model::{Composition, Model, place_pulleys};
use crate::robot::{Cable, Robot};
use crate::statics::Load;
use crate::tension::Limits;
use crate::workspace::criterion::WrenchFeasible;
use crate::workspace::grid::{self, Grid};
use crate::workspace::{Archetype, Bounds, Region};

/// The files that a sweep varies, as TOML text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Subjects {
    /// The study.
    pub study: String,
    /// The robot of the control model.
    pub control: String,
    /// The robot of the machine.
    pub machine: String,
    /// The robot with which the winches were set, where the study names one.
    pub offset_robot: Option<String>,
}

/// What a point of a sweep says; sizes in m² or m³, the thresholds in the order of the sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Number of the point, from 0.
    pub point: usize,
    /// Value of each parameter.
    pub values: Vec<f64>,
    /// Where the machine is wrench-feasible; nothing without tension limits.
    pub physical: Option<f64>,
    /// What is reached with tensions within their limits, whatever the error.
    pub reachable: Option<f64>,
    /// What is reached with each largest position error.
    pub by_accuracy: Vec<f64>,
    /// Cells of the grid.
    pub cells: u64,
    /// Why there is nothing to reach, in words: the machine cannot be set up so, or the box lies outside its reach.
    pub reason: Option<String>,
}

/// Answers one point; what cannot be built has a reason instead of sizes.
pub fn row(sweep: &Sweep, subjects: &Subjects, point: usize, values: &[f64]) -> Row {
    let nothing = |reason: String| Row {
        point,
        values: values.to_vec(),
        physical: None,
        reachable: None,
        by_accuracy: Vec::new(),
        cells: 0,
        reason: Some(reason),
    };
    measured(sweep, subjects, point, values).unwrap_or_else(nothing)
}

fn words(error: &dyn std::error::Error) -> String {
    error.to_string()
}

fn measured(sweep: &Sweep, subjects: &Subjects, point: usize, values: &[f64]) -> Result<Row, String> {
    let varied = Varied::new(sweep, subjects, values)?;
    let Varied { study, control, machine, offset_model } = &varied;
    let start = study.initial_pose(machine.robot()).map_err(|error| error.to_string())?;
    let set_with = offset_model.as_ref().unwrap_or(control);
    let offsets = winch_offsets(&study.initial, set_with, machine, &start).map_err(|error| words(&error))?;
    let tension_method = sweep.tension_method.or(study.control.tension_method).unwrap_or_default();
    let mut driving =
        Driving::new(Control { model: control, tension_method }, machine, &offsets).map_err(|error| words(&error))?;
    if let Some(history) = &study.history {
        driving = driving.with_history(history, &start);
    }
    let limits = Limits::of(machine.robot(), None, None).ok();
    let is_elastic = machine.composition().depends_on_tension();
    let requirements = Requirements {
        tensions: limits.clone().filter(|_| is_elastic),
        // what the thresholds ask is asked of the census
        position_error_max: (!is_elastic || limits.is_none()).then_some(f64::MAX),
        rotation_error_max: study.limits.as_ref().and_then(|limits| limits.rotation_error_max_rad),
    };
    let reachable = Reachable::new(driving, requirements).map_err(|error| words(&error))?;
    let archetype = Archetype::ConstantOrientation(start.rotation);
    let region = Region::new(machine, &reachable, &archetype).map_err(|error| words(&error))?;
    let bounds = match &sweep.bounds_m {
        Some(ends) => Bounds::new(machine.axes().len(), ends),
        None => Bounds::around(machine),
    };
    let bounds = bounds.map_err(|error| words(&error))?;
    let grid = Grid::new(&bounds, sweep.step_m.unwrap_or(bounds.usual_step())).map_err(|error| words(&error))?;
    let census = Census::take(&reachable, &region, &grid);
    let size = |most: Option<f64>| grid::outcome(&grid, &census.reached(most)).size;
    let physical = || {
        let load = Load::of(machine.robot()).ok()?;
        let criterion = WrenchFeasible::new(machine, &load, limits.as_ref()?).ok()?;
        Some(grid::count(&region.with_criterion(&criterion), &grid).outcome(&grid).size)
    };
    let (physical, reachable) = (physical(), size(None));
    let is_out_of_reach = physical == Some(0.0) && reachable == 0.0;
    Ok(Row {
        point,
        values: values.to_vec(),
        physical,
        reachable: Some(reachable),
        by_accuracy: sweep.position_error_max_m.iter().map(|&most| size(Some(most))).collect(),
        cells: grid.points(),
        reason: is_out_of_reach.then(|| {
            let ends: Vec<String> = bounds.ends().iter().map(f64::to_string).collect();
            format!(
                "the box {} lies outside the robot's reach: its cables can balance the load at no cell of it",
                ends.join(", ")
            )
        }),
    })
}

/// Study and models with the parameters of a point.
struct Varied {
    study: Study,
    control: Model,
    machine: Model,
    offset_model: Option<Model>,
}

impl Varied {
    fn new(sweep: &Sweep, subjects: &Subjects, values: &[f64]) -> Result<Self, String> {
        let table = |text: &str| text.parse::<Table>().map_err(|error| error.to_string());
        let (mut study, mut control, mut machine) =
            (table(&subjects.study)?, table(&subjects.control)?, table(&subjects.machine)?);
        let mut pulleys = None;
        for (parameter, &value) in sweep.parameter.iter().zip(values) {
            let key: Key = parameter.key.parse().map_err(|error: super::KeyError| error.to_string())?;
            let set = |file: &mut Table| key.set(file, value).map_err(|error| error.to_string());
            match key.place {
                Place::Study => set(&mut study)?,
                Place::Control => set(&mut control)?,
                Place::Machine => set(&mut machine)?,
                Place::Both => {
                    set(&mut control)?;
                    set(&mut machine)?;
                }
                Place::PlacedPulleys => pulleys = Some((value, parameter.swivel_axis.clone())),
            }
        }
        let text = |table: &Table| toml::to_string(table).map_err(|error| error.to_string());
        let study = Study::from_toml_bytes(text(&study)?.as_bytes(), "the study of this point");
        let study = study.map_err(|error| error.to_string())?;
        let robot = |table: &Table, name: &str| -> Result<Robot, String> {
            let robot = Robot::from_toml(&text(table)?, name).map_err(|error| error.to_string())?;
            Ok(study.limited(robot))
        };
        let mut machine = robot(&machine, "the machine of this point")?;
        if let Some((radius, axis)) = pulleys {
            machine = with_pulleys(&machine, &study, radius, axis.as_deref())?;
        }
        let model = |robot: Robot, composition: &str| -> Result<Model, String> {
            let composition: Composition =
                composition.parse().map_err(|error: crate::model::CompositionError| error.to_string())?;
            Model::new(robot, composition).map_err(|error| words(&error))
        };
        let offset_model = match &subjects.offset_robot {
            Some(former) => Some(model(robot(&table(former)?, "the offset robot")?, &study.control.model)?),
            None => None,
        };
        Ok(Self {
            control: model(robot(&control, "the control model of this point")?, &study.control.model)?,
            machine: model(machine, &study.machine.model)?,
            offset_model,
            study,
        })
    }
}

/// The machine with a pulley of this radius at every cable that touches at the anchor at the initial pose.
///
/// The axis is one for all cables, or that of each cable's file.
fn with_pulleys(machine: &Robot, study: &Study, radius: f64, axis: Option<&[f64]>) -> Result<Robot, String> {
    let common = match axis {
        None => None,
        Some(&[first, second]) if machine.motion_pattern.is_planar() => Some(machine.plane.embed([first, second])),
        Some(&[x, y, z]) => Some(Vector3::new(x, y, z)),
        Some(_) => {
            return Err(
                "a swivel_axis is three numbers, as [0, 0, 1], or two in the plane of a planar robot".to_owned()
            );
        }
    };
    let pulley = |cable: &Cable| -> Result<(f64, Vector3<f64>), String> {
        let axis = common.or(cable.pulley_swivel_axis).ok_or_else(|| {
            format!(
                "placed_pulley_radius_m needs swivel_axis, as [0, 0, 1], or pulley_swivel_axis of every cable, which \"{}\" lacks",
                cable.name
            )
        })?;
        Ok((radius, axis.try_normalize(0.0).ok_or("a swivel_axis of length 0 has no direction")?))
    };
    let pulleys: Vec<_> = machine.cables.iter().map(pulley).collect::<Result<_, _>>()?;
    let pose = study.initial_pose(machine).map_err(|error| error.to_string())?;
    place_pulleys(machine, &pulleys, &pose).map_err(|error| words(&error))
}
