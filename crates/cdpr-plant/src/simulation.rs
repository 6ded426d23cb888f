//! Simulation of a scenario: machine, start, commands and events in time.

use std::ops::ControlFlow;

use super::control_loop::{Between, ControlLoop, Moment};
use super::controller::{Controller, Setpoint};
use super::controllers::ControlSetting;
use super::course::{Course, RunEnd, Summary};
use super::error::{PlantError, ScenarioKey, StepError};
use super::events::Event;
use super::linearization::{SENSIBLE, sensible_step};
use super::plant::{Damping, Plant};
use super::scenario::{Integrator, Scenario, Start, Time};
use super::sensors::Sensors;
use super::series::Series;
use super::state::PlantState;
use super::violations::Judge;
use super::volume::{SAME_TIME, Volume, grid};
use cdpr_model::control::Initial;
use cdpr_model::control::initial_tensions;
use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use cdpr_model::tension::Method;

/// A machine during the run of a scenario.
#[derive(Clone, Debug)]
pub struct Simulation {
    /// The machine.
    pub plant: Plant,
    /// Current state of the machine.
    pub state: PlantState,
    /// Events, sorted by time.
    pub events: Vec<Event>,
    /// Sensors with their readings so far.
    pub sensors: Option<Sensors>,
    /// Volume of the run's records.
    pub volume: Volume,
    /// Setpoint of the controller: rest at the start, before the platform is displaced.
    pub setpoint: Setpoint,
    /// Commands between two calls of a controller with a period.
    pub between: Between,
    pub(super) time: Time,
    pub(super) control: ControlLoop,
    pub(super) wrench: Option<Series>,
}

impl Simulation {
    /// The machine of a scenario at its start, under the scenario's controller; the caller reads the robot.
    pub fn new(scenario: &Scenario, robot: Robot) -> Result<Self, PlantError> {
        Self::with(scenario, robot, |setting| scenario.control.controller(setting))
    }

    /// The machine of a scenario at its start, under a given controller instead of the scenario's.
    pub fn with_controller(
        scenario: &Scenario,
        robot: Robot,
        controller: Box<dyn Controller>,
    ) -> Result<Self, PlantError> {
        Self::with(scenario, robot, |_| Ok(controller))
    }

    fn with(
        scenario: &Scenario,
        robot: Robot,
        controller: impl FnOnce(&ControlSetting<'_>) -> Result<Box<dyn Controller>, PlantError>,
    ) -> Result<Self, PlantError> {
        let machine = &scenario.machine;
        let model = Model::new(robot, machine.model.parse()?)?;
        let damping = match machine.cable_damping_N_s_per_m {
            Some(constant) => vec![Damping { constant, time: 0.0 }; model.cable_count()],
            None => model.robot().cables.iter().map(Damping::of).collect(),
        };
        let plant = Plant::with_damping(model, machine.winches, damping)?;
        let mut state = start_of(&plant, &scenario.start)?;
        check_integrator(&plant, &state, &scenario.time)?;
        let setting = ControlSetting { plant: &plant, state: &state, stated: &scenario.control.stated };
        let control = ControlLoop::new(controller(&setting)?, &state)?;
        let lengths = state.cables.iter().map(|cable| cable.controlled_length).collect();
        let setpoint = Setpoint::at_rest(state.pose, lengths);
        let events = Event::of(&plant, &scenario.event)?;
        check_friction(&plant, &state, &events, &scenario.time)?;
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
        let (time, between) = (scenario.time, Between::default());
        Ok(Self { plant, state, events, sensors, volume, setpoint, between, time, control, wrench })
    }

    /// Runs to the end and passes every recorded state to `watch`: the start, each time of a record, and the last
    /// state. A state at the time of an event is passed before the event.
    pub fn run<E>(
        &mut self,
        mut watch: impl FnMut(&Plant, &PlantState) -> Result<ControlFlow<()>, E>,
    ) -> Result<Summary, E> {
        let Time { duration_s: duration, step_s: step, .. } = self.time;
        let (count, every) = grid(&self.time);
        let mut course = Course::new(Judge::new(self.plant.model.robot(), self.volume.record_interval));
        self.control.reset(&self.state);
        course.look(&self.state);
        self.measure();
        if watch(&self.plant, &self.state)?.is_break() {
            return Ok(course.ended(RunEnd::Stopped));
        }
        self.happen_until(0.0, &mut course);
        for index in 0..count {
            let target = if index + 1 == count { duration } else { (index + 1) as f64 * step };
            let is_recorded = (index + 1) % every == 0 || index + 1 == count;
            if !is_recorded && self.skips_unrecorded_times() {
                continue;
            }
            if let Err(error) = self.advance(target, &mut course) {
                return Ok(course.ended(RunEnd::Failed(error)));
            }
            if is_recorded && watch(&self.plant, &self.state)?.is_break() {
                return Ok(course.ended(RunEnd::Stopped));
            }
            self.happen_until(target, &mut course);
        }
        Ok(course.ended(RunEnd::Completed))
    }

    /// Runs to a time of the grid, with a stop at every event and every call of the controller before it.
    fn advance(&mut self, target: f64, course: &mut Course) -> Result<(), StepError> {
        let same = self.same_time();
        loop {
            let event = self.events.get(course.next).map(|event| event.time);
            let question = self.control.next_question(self.state.time + same);
            let stops = event.into_iter().chain(question).filter(|time| *time < target - same);
            let Some(stop) = stops.min_by(f64::total_cmp) else { break };
            self.step_to(stop, course)?;
            self.happen_until(self.state.time, course);
        }
        self.step_to(target, course)
    }

    /// Times that differ by less than this are equal (s).
    pub(super) fn same_time(&self) -> f64 {
        SAME_TIME * self.time.step_s
    }

    /// True if the integrator chooses its own steps, and neither sensors nor the controller need those of the file.
    fn skips_unrecorded_times(&self) -> bool {
        let is_alone = self.sensors.is_none() && self.control.bends().is_some();
        self.time.integrator == Integrator::ErrorControlled && is_alone
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

    /// Takes one step to a time; returns the number of steps of the integrator.
    fn take_step(&mut self, target: f64) -> Result<u64, StepError> {
        let (from, whole) = (self.state.time, self.time.step_s);
        let time = target - from;
        // the grid's times are rounded, its step is not
        let time = if (time - whole).abs() <= SAME_TIME * whole { whole } else { time };
        let commands = self.control.commands(&Moment {
            until: target,
            same: SAME_TIME * whole,
            state: &self.state,
            sensors: self.sensors.as_ref(),
            wanted: &self.setpoint,
            between: self.between,
        })?;
        let event = self.state.external;
        if let Some(series) = &self.wrench {
            let mut now = [0.0; 6];
            series.at(from + 0.5 * time, &mut now);
            self.state.external += Wrench::from(now);
        }
        let taken = self.plant.step(&mut self.state, commands, time);
        self.state.external = event;
        taken?;
        self.state.time = target;
        Ok(1)
    }

    /// Integrator of the scenario.
    pub fn integrator(&self) -> Integrator {
        self.time.integrator
    }

    /// Updates the sensors with the state.
    fn measure(&mut self) {
        let Some(sensors) = &mut self.sensors else { return };
        let mut further = [0.0; 6];
        if let Some(series) = &self.wrench {
            series.at(self.state.time, &mut further);
        }
        sensors.look(&self.plant, &self.state, &Wrench::from(further));
    }

    /// Applies all events up to a time.
    fn happen_until(&mut self, time: f64, course: &mut Course) {
        let until = time + self.same_time();
        while let Some(event) = self.events.get(course.next).filter(|event| event.time <= until) {
            self.plant.apply(&mut self.state, event.happening.as_ref());
            course.events.push(event.clone());
            course.next += 1;
        }
    }
}

/// The machine at rest in the equilibrium of its start.
fn start_of(plant: &Plant, start: &Start) -> Result<PlantState, PlantError> {
    let robot = plant.model.robot();
    let pose = robot.motion_pattern.pose(robot.plane, &start.pose);
    let pose = pose.map_err(|reason| PlantError::Components { key: ScenarioKey::of("start", "pose"), reason })?;
    let initial = Initial {
        tensions_N: start.tensions_N.clone(),
        tension_method: match (&start.tensions_N, start.tension_method) {
            (None, None) => Some(Method::Qp),
            (_, method) => method,
        },
        tension_limits_N: start.tension_limits_N,
        ..Initial::default()
    };
    let tensions = initial_tensions(&initial, &plant.model, &pose)?;
    plant.at_rest(&pose, &tensions)
}

/// Applies displacement and twist of the start.
fn displace(plant: &Plant, state: &mut PlantState, start: &Start) -> Result<(), PlantError> {
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
    plant.observe(state)?;
    plant.settle_all(state);
    Ok(())
}

/// A twist or wrench from its components in the degrees of freedom.
fn of_components(model: &Model, numbers: &[f64], key: ScenarioKey) -> Result<Twist, PlantError> {
    let robot = model.robot();
    robot.motion_pattern.twist(robot.plane, numbers).map_err(|reason| PlantError::Components { key, reason })
}

/// Checks that the scenario's integrator suits the machine at its start.
fn check_integrator(plant: &Plant, state: &PlantState, time: &Time) -> Result<(), PlantError> {
    match time.integrator {
        Integrator::Symplectic => check_step(plant, state, time.step_s),
        Integrator::ErrorControlled => check_smooth(state),
    }
}

/// Checks that the integrator also suits the friction that drums have after events.
fn check_friction(plant: &Plant, start: &PlantState, events: &[Event], time: &Time) -> Result<(), PlantError> {
    let (mut later, mut changed) = (start.clone(), start.clone());
    for event in events {
        plant.apply(&mut later, event.happening.as_ref());
        if later.friction != changed.friction {
            changed.friction.clone_from(&later.friction);
            check_integrator(plant, &changed, time)?;
        }
    }
    Ok(())
}

/// Checks that the step is small enough for the fastest motion about the start.
fn check_step(plant: &Plant, state: &PlantState, step: f64) -> Result<(), PlantError> {
    let linear = plant.linearize(state)?;
    let Some(fastest) = linear.fastest() else { return Ok(()) };
    // if friction falls with speed, the speed of a drum grows
    let drums = plant.drums.iter().zip(&state.friction);
    let grows = drums.map(|(drum, friction)| friction.steepest_fall() / drum.inertia);
    let fastest = grows.fold(fastest, f64::max);
    match step * fastest <= SENSIBLE {
        true => Ok(()),
        false => {
            let (largest, frequency) = (sensible_step(fastest), fastest / std::f64::consts::TAU);
            Err(PlantError::StepTooLarge { step, largest, frequency })
        }
    }
}

/// Checks that no force jumps in a way that a step with error control cannot foresee.
fn check_smooth(state: &PlantState) -> Result<(), PlantError> {
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
    Ok(())
}
