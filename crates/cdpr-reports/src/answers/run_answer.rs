//! Answer of a run: how it ended, where the machine is, and what happened on the way.

use cdpr::geometry::MotionPattern;
use cdpr::model::Model;
use cdpr::plant::{End, Event, Happening, Simulation, State, Summary};
use serde::Serialize;

use super::{Answer, PoseAnswer};
use crate::number_format::{cell, short};
use crate::table::Table;

/// End of a run.
#[derive(Clone, Debug, Serialize)]
pub struct RunAnswer {
    robot: String,
    model: String,
    /// `completed`, `stopped`, `failed`.
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    steps: u64,
    #[serde(rename = "final")]
    last: FinalState,
    #[serde(rename = "tension_min_N")]
    tension_min: f64,
    #[serde(rename = "tension_max_N")]
    tension_max: f64,
    /// Energy at the end (J); null where tensions are no function of lengths alone.
    #[serde(rename = "energy_J")]
    energy: Option<EnergyAnswer>,
    events: Vec<EventAnswer>,
    log: String,
    #[serde(skip)]
    cable_names: Vec<String>,
}

#[derive(Clone, Debug, Serialize)]
struct FinalState {
    time_s: f64,
    #[serde(flatten)]
    pose: PoseAnswer,
    velocity_m_s: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    angular_velocity_rad_s: Option<AngularVelocity>,
    #[serde(rename = "tensions_N")]
    tensions: Vec<f64>,
    cable_lengths_m: Vec<f64>,
}

/// About the world's axes, or of a planar robot about the normal of its plane.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
enum AngularVelocity {
    Planar(f64),
    Spatial(Vec<f64>),
}

#[derive(Clone, Debug, Serialize)]
struct EnergyAnswer {
    kinetic: f64,
    elastic: f64,
    potential: f64,
}

#[derive(Clone, Debug, Serialize)]
struct EventAnswer {
    time_s: f64,
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    cable: Option<usize>,
}

impl RunAnswer {
    /// Answer of a simulation that has run; `log` is the file with its rows.
    pub fn new(simulation: &Simulation, summary: &Summary, log: &str) -> Self {
        let (model, state) = (simulation.plant.model(), &simulation.state);
        let (status, reason) = match &summary.end {
            End::Completed => ("completed", None),
            End::Stopped => ("stopped", Some(format!("the run was stopped at {} s", state.time))),
            End::Failed(error) => ("failed", Some(format!("after {:.6} s: {error}", state.time))),
        };
        let energy = simulation.plant.energy(state).map(|energy| EnergyAnswer {
            kinetic: energy.kinetic,
            elastic: energy.elastic,
            potential: energy.potential,
        });
        Self {
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            status,
            reason,
            steps: summary.steps,
            last: FinalState::new(model, state),
            tension_min: summary.tension_min,
            tension_max: summary.tension_max,
            energy,
            events: summary.events.iter().map(EventAnswer::new).collect(),
            log: log.to_owned(),
            cable_names: model.robot().cables.iter().map(|cable| cable.name.clone()).collect(),
        }
    }
}

impl FinalState {
    fn new(model: &Model, state: &State) -> Self {
        let (robot, twist) = (model.robot(), state.twist());
        let rates: Vec<f64> = model.twist_basis().iter().map(|basis| basis.dot(&twist) + 0.0).collect();
        let (velocity, turning) = rates.split_at(robot.motion_pattern.translations());
        Self {
            time_s: state.time,
            pose: PoseAnswer::new(robot, &state.pose),
            velocity_m_s: velocity.to_vec(),
            angular_velocity_rad_s: match robot.motion_pattern {
                MotionPattern::Planar => Some(AngularVelocity::Planar(turning[0])),
                MotionPattern::Spatial => Some(AngularVelocity::Spatial(turning.to_vec())),
                _ => None,
            },
            tensions: state.cables.iter().map(|cable| cable.tension).collect(),
            cable_lengths_m: state.cables.iter().map(|cable| cable.controlled_length).collect(),
        }
    }
}

impl EventAnswer {
    fn new(event: &Event) -> Self {
        Self {
            time_s: event.time,
            kind: event.happening.kind(),
            cable: Happening::cable(&event.happening).map(|cable| cable + 1),
        }
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
        let last = &self.last;
        text.push_str(&format!("\nat {} s after {} steps: {}\n", short(last.time_s), self.steps, last.pose.words()));
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
        text + &table.text(width)
    }
}
