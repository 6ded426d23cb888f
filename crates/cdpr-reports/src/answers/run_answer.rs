//! Answer of a run: how it ended, where the machine is, and what happened on the way.

use cdpr_model::model::Model;
use cdpr_model::robot::Assumption;
use cdpr_plant::scenario::Integrator;
use cdpr_plant::{Energy, Event, Plant, PlantState, RunEnd, Simulation, Summary, Winches};
use schemars::JsonSchema;
use serde::Serialize;

use super::pose_answer::{AngularRate, rates};
use super::{Answer, PoseAnswer, assumed_numbers, inertia_doubt, title};
use crate::keys::{Each, EnergyKeys, Maybe, SlackKeys, ViolationKeys};
use crate::number_format::{cell, short};
use crate::recording::{OTHERS, Violation, sentence};
use crate::table::Table;

/// End of a run.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
#[schemars(rename = "Run")]
pub struct RunAnswer {
    pub(crate) robot: String,
    pub(crate) model: String,
    /// `completed`, `stopped`, `failed`.
    pub(crate) status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) reason: Option<String>,
    /// `symplectic` or `error-controlled`.
    pub(crate) integrator: Integrator,
    /// Number of steps.
    pub(crate) steps: u64,
    /// State at the end.
    #[serde(rename = "final")]
    pub(crate) last: FinalState,
    /// Smallest tension of the run (N).
    #[serde(rename = "tension_min_N")]
    pub(crate) tension_min: f64,
    /// Largest tension of the run (N).
    #[serde(rename = "tension_max_N")]
    pub(crate) tension_max: f64,
    /// Energy at the end (J); null where tensions are no function of lengths alone.
    #[serde(rename = "energy_J", with = "Maybe::<EnergyKeys>")]
    pub(crate) energy: Option<Energy>,
    /// Events that happened, in their order.
    pub(crate) events: Vec<EventAnswer>,
    /// Limits of tensions that were broken after any step, by first time and cable.
    #[serde(with = "Each::<ViolationKeys>")]
    pub(crate) violations: Vec<Violation>,
    /// Cables that were slack without breaking a limit.
    #[serde(with = "Each::<SlackKeys>")]
    pub(crate) slack: Vec<Violation>,
    /// File of the states.
    pub(crate) log: String,
    /// Numbers of the robot file that the motion rests on and that no source states.
    pub(crate) assumptions: Vec<Assumption>,
    pub(crate) warnings: Vec<String>,
    #[serde(skip)]
    pub(crate) cable_names: Vec<String>,
}

/// State at the end.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub(crate) struct FinalState {
    /// Time (s).
    time_s: f64,
    #[serde(flatten)]
    pose: PoseAnswer,
    /// Velocity of the platform origin (m/s).
    velocity_m_s: Vec<f64>,
    /// Angular velocity (rad/s).
    #[serde(skip_serializing_if = "Option::is_none")]
    angular_velocity_rad_s: Option<AngularRate>,
    #[serde(rename = "tensions_N")]
    tensions: Vec<f64>,
    cable_lengths_m: Vec<f64>,
}

/// Event that happened.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(rename = "Event")]
pub(crate) struct EventAnswer {
    /// Time (s).
    time_s: f64,
    /// Kind of the event.
    kind: &'static str,
    /// Cable, from 1, of an event of one cable.
    #[serde(skip_serializing_if = "Option::is_none")]
    cable: Option<usize>,
}

impl RunAnswer {
    /// Answer of a simulation that has run, with the broken limits of its summary in words; `log` is the file with its rows.
    pub fn new(simulation: &Simulation, summary: &Summary, violations: &[Violation], log: &str) -> Self {
        let (model, state) = (simulation.plant.model(), &simulation.state);
        let (status, reason) = match &summary.end {
            RunEnd::Completed => ("completed", broken(violations).map(|limits| format!("limits are broken: {limits}"))),
            RunEnd::Stopped => ("stopped", Some(format!("the run was stopped at {} s", state.time))),
            RunEnd::Failed(error) => ("failed", Some(format!("after {:.6} s: {error}", state.time))),
        };
        let (broken_limits, slack) = violations.iter().cloned().partition(Violation::is_broken_limit);
        Self {
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            status,
            reason,
            integrator: simulation.integrator(),
            steps: summary.steps,
            last: FinalState::new(model, state),
            tension_min: summary.tension_min,
            tension_max: summary.tension_max,
            energy: simulation.plant.energy(state),
            events: summary.events.iter().map(EventAnswer::new).collect(),
            warnings: warnings(simulation, violations),
            violations: broken_limits,
            slack,
            log: log.to_owned(),
            assumptions: simulation.plant.assumptions().cloned().collect(),
            cable_names: model.robot().cables.iter().map(|cable| cable.name.clone()).collect(),
        }
    }
}

impl RunAnswer {
    /// End of the run in a word.
    pub fn status(&self) -> &'static str {
        self.status
    }

    /// Reason of a run that did not get to its end, or broke limits on its way.
    pub fn reason(&self) -> Option<&str> {
        self.reason.as_deref()
    }

    /// Least and largest tension after any step (N).
    pub fn tensions(&self) -> (f64, f64) {
        (self.tension_min, self.tension_max)
    }

    /// Warnings about the run.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Facts on machine, winches and steps: terms with their text.
    pub fn facts(&self, plant: &Plant) -> Vec<(&'static str, String)> {
        let winches = match plant.winches() {
            Winches::Ideal => "ideal: lengths are what is commanded",
            Winches::Drums => "drums with inertia and friction",
        };
        let kind = match self.integrator {
            Integrator::Symplectic => "of a fixed length",
            Integrator::ErrorControlled => "with error control",
        };
        let steps = format!("{} {kind}, the last at {} s", self.steps, short(self.last.time_s));
        let mut facts = vec![("Machine", title(plant.model())), ("Winches", winches.to_owned()), ("Steps", steps)];
        if !self.assumptions.is_empty() {
            facts.push(("Assumed numbers", assumed_numbers::line(&self.assumptions)));
        }
        facts
    }
}

fn row(violation: &Violation) -> Vec<String> {
    let limit = format!("{} = {}", violation.limit.unwrap_or_default(), short(violation.bound));
    vec![
        (violation.cable + 1).to_string(),
        limit,
        cell(Some(violation.worst), 1),
        cell(Some(violation.first), 3),
        cell(Some(violation.duration), 3),
    ]
}

/// The first broken limit in a sentence, with the number of the others.
fn broken(violations: &[Violation]) -> Option<String> {
    sentence(violations.iter().filter(|one| one.is_broken_limit()), OTHERS)
}

/// Doubts about a run: broken limits and slack cables, what cannot be, and what never happens.
fn warnings(simulation: &Simulation, violations: &[Violation]) -> Vec<String> {
    let slack = violations.iter().filter(|one| !one.is_broken_limit());
    let mut all: Vec<String> =
        broken(violations).into_iter().chain(sentence(slack, ["cable is slack", "cables are slack"])).collect();
    all.extend(inertia_doubt::of_run(simulation));
    let end = simulation.volume.duration;
    // an event at the end itself happens, whatever rounding makes of its time
    let late = simulation.events.iter().filter(|event| event.time > end * (1.0 + 1e-9));
    all.extend(late.map(|event| {
        format!(
            "the event {} never happens: the run ends at {} s (duration_s)",
            EventAnswer::new(event).words(),
            short(end)
        )
    }));
    all
}

impl FinalState {
    fn new(model: &Model, state: &PlantState) -> Self {
        let (velocity_m_s, angular_velocity_rad_s) = rates(model, &state.twist());
        Self {
            time_s: state.time,
            pose: PoseAnswer::new(model.robot(), &state.pose),
            velocity_m_s,
            angular_velocity_rad_s,
            tensions: state.cables.iter().map(|cable| cable.tension).collect(),
            cable_lengths_m: state.cables.iter().map(|cable| cable.controlled_length).collect(),
        }
    }
}

impl EventAnswer {
    fn new(event: &Event) -> Self {
        Self { time_s: event.time, kind: event.happening.kind(), cable: event.happening.cable().map(|cable| cable + 1) }
    }

    fn words(&self) -> String {
        let cable = self.cable.map(|cable| format!(" of cable {cable}")).unwrap_or_default();
        format!("{} at {} s", self.kind.to_owned() + &cable, short(self.time_s))
    }
}

impl Answer for RunAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut text = format!("{}, model {}: {}", self.robot, self.model, self.status);
        self.reason.iter().for_each(|reason| text.push_str(&format!(": {reason}")));
        text.push('\n');
        self.warnings.iter().for_each(|warning| text.push_str(&format!("caution: {warning}\n")));
        let last = &self.last;
        text.push_str(&format!("at {} s after {} steps: {}\n", short(last.time_s), self.steps, last.pose.words()));
        if !self.violations.is_empty() {
            let mut table = Table::new(["cable", "limit N", "worst N", "first s", "for s"]);
            self.violations.iter().for_each(|one| table.row(row(one)));
            text.push_str(&format!("\n{}\n", table.text(width)));
        }
        if !self.events.is_empty() {
            let events: Vec<String> = self.events.iter().map(EventAnswer::words).collect();
            text.push_str(&format!("happened: {}\n", events.join(", ")));
        }
        let (low, high) = (cell(Some(self.tension_min), 1), cell(Some(self.tension_max), 1));
        text.push_str(&format!("tensions on the way from {low} to {high} N; rows in {}\n\n", self.log));
        let mut table = Table::new(["cable", "tension N", "controlled length m"]);
        for (index, name) in self.cable_names.iter().enumerate() {
            let numbers =
                [cell(last.tensions.get(index).copied(), 1), cell(last.cable_lengths_m.get(index).copied(), 6)];
            table.row([vec![name.clone()], numbers.to_vec()].concat());
        }
        text + &table.text(width) + &assumed_numbers::section("the motion rests on assumed numbers", &self.assumptions)
    }
}
