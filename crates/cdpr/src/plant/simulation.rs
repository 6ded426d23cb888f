//! A scenario as it goes: machine, start, commands and events in time.

use std::ops::ControlFlow;

use super::commands::{Commands, Series};
use super::course::{Course, End, Summary};
use super::error::{PlantError, ScenarioKey, StepError};
use super::event::{Event, Happening};
use super::linearization::{SENSIBLE, sensible_step};
use super::plant::{Damping, Plant};
use super::scenario::{EventKind, EventTable, Integrator, Scenario, Start, Time};
use super::sensors::Sensors;
use super::state::State;
use super::violations::Judge;
use super::volume::{SAME_TIME, Volume, grid};
use crate::geometry::{Pose, Twist, Wrench};
use crate::metamodel::initial_tensions;
use crate::metamodel::study::{Initial, TensionMethod};
use crate::model::Model;
use crate::robot::Robot;

/// A machine on its way through a scenario.
#[derive(Clone, Debug)]
pub struct Simulation {
    /// The machine.
    pub plant: Plant,
    /// Its state by now.
    pub state: State,
    /// Events, in the order of time.
    pub events: Vec<Event>,
    /// Sensors with what they have seen.
    pub sensors: Option<Sensors>,
    /// Volume of what it records.
    pub volume: Volume,
    pub(super) time: Time,
    pub(super) commands: Commands,
    pub(super) wrench: Option<Series>,
}

impl Simulation {
    /// The machine of a scenario on its start, its robot read by the caller.
    pub fn new(scenario: &Scenario, robot: Robot) -> Result<Self, PlantError> {
        let machine = &scenario.machine;
        let model = Model::new(robot, machine.model.parse()?)?;
        let damping = match machine.cable_damping_N_s_per_m {
            Some(constant) => vec![Damping { constant, time: 0.0 }; model.cable_count()],
            None => model.robot().cables.iter().map(Damping::of).collect(),
        };
        let plant = Plant::with_damping(model, machine.winches, damping)?;
        let mut state = start_of(&plant, &scenario.start)?;
        match scenario.time.integrator {
            Integrator::Symplectic => check_step(&plant, &state, scenario.time.step_s)?,
            Integrator::ErrorControlled => check_smooth(&plant, &state)?,
        }
        let commands = Commands::of(&plant, &state, scenario)?;
        let events = events_of(&plant, &scenario.event)?;
        let wrench = scenario.wrench.as_ref().map(|series| {
            let key = ScenarioKey::of("wrench", "wrench");
            let row = |row: &Vec<f64>| Ok(of_components(&plant.model, row, key)?.as_slice().to_vec());
            let rows = series.wrench.iter().map(row).collect::<Result<Vec<_>, PlantError>>()?;
            Ok::<_, PlantError>(Series { times: series.time_s.clone(), rows })
        });
        let wrench = wrench.transpose()?;
        displace(&plant, &mut state, &scenario.start)?;
        let sensors = scenario.sensors.as_ref().map(|table| Sensors::new(table, &plant.model)).transpose()?;
        let volume = Volume::of(&plant, &scenario.time, sensors.as_ref());
        Ok(Self { plant, state, events, sensors, volume, time: scenario.time, commands, wrench })
    }

    /// Runs to the end, and shows every state that is recorded: the start, after each time of a record, and the last one. A state at the time of an
    /// event is shown before it.
    pub fn run<E>(
        &mut self,
        mut watch: impl FnMut(&Plant, &State) -> Result<ControlFlow<()>, E>,
    ) -> Result<Summary, E> {
        let Time { duration_s: duration, step_s: step, .. } = self.time;
        let (count, every) = grid(&self.time);
        let mut course = Course::new(Judge::new(self.plant.model.robot(), self.volume.record_interval));
        course.look(&self.state);
        self.measure();
        if watch(&self.plant, &self.state)?.is_break() {
            return Ok(course.ended(End::Stopped));
        }
        self.happen_until(0.0, &mut course);
        for index in 0..count {
            let target = if index + 1 == count { duration } else { (index + 1) as f64 * step };
            let is_recorded = (index + 1) % every == 0 || index + 1 == count;
            if !is_recorded && self.skips_unrecorded_times() {
                continue;
            }
            if let Err(error) = self.advance(target, &mut course) {
                return Ok(course.ended(End::Failed(error)));
            }
            if is_recorded && watch(&self.plant, &self.state)?.is_break() {
                return Ok(course.ended(End::Stopped));
            }
            self.happen_until(target, &mut course);
        }
        Ok(course.ended(End::Completed))
    }

    /// To a time of the grid, with a stop at every event before it.
    fn advance(&mut self, target: f64, course: &mut Course) -> Result<(), StepError> {
        let same = SAME_TIME * self.time.step_s;
        while let Some(event) = self.events.get(course.next).filter(|event| event.time < target - same) {
            self.step_to(event.time, course)?;
            self.happen_until(self.state.time, course);
        }
        self.step_to(target, course)
    }

    /// True where the integrator has steps of its own and no sensor looks at those of the file.
    fn skips_unrecorded_times(&self) -> bool {
        self.time.integrator == Integrator::ErrorControlled && self.sensors.is_none()
    }

    fn step_to(&mut self, target: f64, course: &mut Course) -> Result<(), StepError> {
        course.steps += match self.time.integrator {
            #[cfg(any(feature = "error-control", test))]
            Integrator::ErrorControlled => self.pass_to(target, course)?,
            _ => self.take_step(target)?,
        };
        course.look(&self.state);
        self.measure();
        Ok(())
    }

    /// One step to a time; the number of steps.
    fn take_step(&mut self, target: f64) -> Result<u64, StepError> {
        let (from, whole) = (self.state.time, self.time.step_s);
        let time = target - from;
        // the grid's times are rounded, its step is not
        let time = if (time - whole).abs() <= SAME_TIME * whole { whole } else { time };
        let event = self.state.external;
        if let Some(series) = &self.wrench {
            let mut now = [0.0; 6];
            series.at(from + 0.5 * time, &mut now);
            self.state.external += Wrench::from(now);
        }
        let command = self.commands.at(target);
        let taken = self.plant.step(&mut self.state, &command, time);
        self.state.external = event;
        taken?;
        self.state.time = target;
        Ok(1)
    }

    /// Integrator of the scenario.
    pub fn integrator(&self) -> Integrator {
        self.time.integrator
    }

    /// Sensors look at the state.
    fn measure(&mut self) {
        let Some(sensors) = &mut self.sensors else { return };
        let mut further = [0.0; 6];
        if let Some(series) = &self.wrench {
            series.at(self.state.time, &mut further);
        }
        sensors.look(&self.plant, &self.state, &Wrench::from(further));
    }

    /// Everything up to a time happens.
    fn happen_until(&mut self, time: f64, course: &mut Course) {
        let until = time + SAME_TIME * self.time.step_s;
        while let Some(event) = self.events.get(course.next).filter(|event| event.time <= until) {
            self.plant.apply(&mut self.state, &event.happening);
            course.events.push(*event);
            course.next += 1;
        }
    }
}

/// The machine at rest in the equilibrium of its start.
fn start_of(plant: &Plant, start: &Start) -> Result<State, PlantError> {
    let robot = plant.model.robot();
    let pose = robot.motion_pattern.pose(robot.plane, &start.pose);
    let pose = pose.map_err(|reason| PlantError::Components { key: ScenarioKey::of("start", "pose"), reason })?;
    let initial = Initial {
        tensions_N: start.tensions_N.clone(),
        tension_method: match (&start.tensions_N, start.tension_method) {
            (None, None) => Some(TensionMethod::Qp),
            (_, method) => method,
        },
        tension_limits_N: start.tension_limits_N,
        ..Initial::default()
    };
    let tensions = initial_tensions(&initial, &plant.model, &pose)?;
    plant.at_rest(&pose, &tensions)
}

/// Displacement and twist of the start.
fn displace(plant: &Plant, state: &mut State, start: &Start) -> Result<(), PlantError> {
    let of = |numbers: &Option<Vec<f64>>, key| match numbers {
        Some(numbers) => of_components(&plant.model, numbers, ScenarioKey::of("start", key)),
        None => Ok(Twist::zeros()),
    };
    let displacement = of(&start.displacement, "displacement")?;
    if displacement != Twist::zeros() {
        let pose: Pose = state.pose.displaced(&displacement);
        state.set_pose(pose);
    }
    state.set_twist(&of(&start.twist, "twist")?);
    Ok(plant.observe(state)?)
}

/// A twist or wrench by its components in the degrees of freedom.
fn of_components(model: &Model, numbers: &[f64], key: ScenarioKey) -> Result<Twist, PlantError> {
    let robot = model.robot();
    robot.motion_pattern.twist(robot.plane, numbers).map_err(|reason| PlantError::Components { key, reason })
}

/// Refuses steps that the fastest motion about the start does not allow.
fn check_step(plant: &Plant, state: &State, step: f64) -> Result<(), PlantError> {
    let linear = plant.linearize(state)?;
    let Some(fastest) = linear.fastest() else { return Ok(()) };
    // where friction falls with speed, the speed of a drum grows
    let grows = plant.drums.iter().map(|drum| drum.friction.steepest_fall() / drum.inertia);
    let fastest = grows.fold(fastest, f64::max);
    match step * fastest <= SENSIBLE {
        true => Ok(()),
        false => {
            let (largest, frequency) = (sensible_step(fastest), fastest / std::f64::consts::TAU);
            Err(PlantError::StepTooLarge { step, largest, frequency })
        }
    }
}

/// Refuses machines whose forces jump where a step with error control does not see it coming.
fn check_smooth(plant: &Plant, state: &State) -> Result<(), PlantError> {
    let refuse = |reason: String| {
        let message = format!("integrator = \"error-controlled\" is not for this run: {reason}; use \"symplectic\"");
        Err(PlantError::Value { key: ScenarioKey::of("time", "integrator"), message })
    };
    if cfg!(not(any(feature = "error-control", test))) {
        return refuse("this build is without the feature `error-control`".to_owned());
    }
    if state.cables.iter().any(|cable| cable.memory.is_some()) {
        return refuse("cables with hysteresis remember at the end of every fixed step".to_owned());
    }
    match plant.drums.iter().position(|drum| drum.friction.is_dry()) {
        Some(drum) => {
            let what = if plant.drums[drum].friction.standing > 0.0 { "drum" } else { "pulley" };
            refuse(format!("the {what} of cable {} sticks and slides by dry friction, which jumps", drum + 1))
        }
        None => Ok(()),
    }
}

fn events_of(plant: &Plant, tables: &[EventTable]) -> Result<Vec<Event>, PlantError> {
    let event = |(index, table): (usize, &EventTable)| {
        Ok(Event { time: table.time_s, happening: happening_of(plant, index, table)? })
    };
    let mut events = tables.iter().enumerate().map(event).collect::<Result<Vec<_>, PlantError>>()?;
    // a stable sort: what happens at one time happens in the order of the file
    events.sort_by(|a, b| a.time.total_cmp(&b.time));
    check_masses(plant, &events)?;
    Ok(events)
}

fn happening_of(plant: &Plant, index: usize, table: &EventTable) -> Result<Happening, PlantError> {
    let model = &plant.model;
    let key = |key| ScenarioKey { table: "event", index: Some(index), key };
    let cable = || match table.cable.unwrap_or(0) {
        number if (1..=model.cable_count()).contains(&number) => Ok(number - 1),
        number => {
            let message = format!("cable {number} does not exist: cables count from 1 to {}", model.cable_count());
            Err(PlantError::Value { key: key("cable"), message })
        }
    };
    let finite = |name, number: Option<f64>| match number.unwrap_or(0.0) {
        number if number.is_finite() => Ok(number),
        number => Err(PlantError::Value { key: key(name), message: format!("{name} is {number}; it is finite") }),
    };
    Ok(match table.kind {
        EventKind::CableBreak => Happening::CableBreak { cable: cable()? },
        EventKind::WinchStop => Happening::WinchStop { cable: cable()? },
        EventKind::Slip => Happening::Slip { cable: cable()?, length: finite("length_m", table.length_m)? },
        EventKind::Load => {
            let place = table.position_m.clone().unwrap_or_else(|| vec![0.0; model.axes().len()]);
            if place.len() != model.axes().len() || place.iter().any(|x| !x.is_finite()) {
                let message = format!("position_m has {} finite numbers", model.axes().len());
                return Err(PlantError::Value { key: key("position_m"), message });
            }
            let place = model.axes().iter().zip(&place).map(|(axis, along)| axis * *along).sum();
            Happening::Load { mass: finite("mass_kg", table.mass_kg)?, place }
        }
        EventKind::Wrench => {
            let numbers = table.wrench.as_deref().unwrap_or_default();
            Happening::Wrench(of_components(model, numbers, key("wrench"))?)
        }
    })
}

/// Loads must be heavy or light enough that a mass is left, and a file without gravity does not say what they weigh.
fn check_masses(plant: &Plant, events: &[Event]) -> Result<(), PlantError> {
    let mut body = plant.inertia.body;
    for (index, event) in events.iter().enumerate() {
        let Happening::Load { mass, place } = event.happening else { continue };
        let key = ScenarioKey { table: "event", index: Some(index), key: "mass_kg" };
        let refused = |message: String| Err(PlantError::Value { key, message });
        if plant.model.robot().gravity.is_none() {
            return refused("what a load weighs is unknown: add gravity_m_s2 to the robot file".to_owned());
        }
        let turns = plant.model.robot().motion_pattern == crate::geometry::MotionPattern::Spatial;
        match body.with_point_mass(mass, &place) {
            Some(next) if !turns || next.inertia.cholesky().is_some() => body = next,
            _ => return refused(format!("{mass} kg leave no body: mass and inertia stay above zero")),
        }
    }
    Ok(())
}
