//! Moments of a machine's run, as pages, figures and files show them.

mod mcap_file;
mod messages;
mod violation;

use cdpr::Limits;
use cdpr::geometry::Pose;
use cdpr::plant::{Event, Happening, State};
use cdpr::robot::Robot;

use crate::number_format::significant;
pub use mcap_file::{McapError, mcap_bytes};
pub(crate) use violation::{OTHERS, sentence, stretches_of_limits};
pub use violation::{Stretch, Violation};

/// State of the machine at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Time since the start (s).
    pub time: f64,
    /// Platform pose.
    pub pose: Pose,
    /// Tensions (N), pull positive, one per cable.
    pub tensions: Vec<f64>,
}

/// Event of a run in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Occurrence {
    /// Time since the start (s).
    pub time: f64,
    /// Words, as `cable 3 breaks`.
    pub words: String,
    /// Cable that it is about, from 0.
    pub cable: Option<usize>,
    /// True where the cable is no longer there afterwards.
    pub breaks: bool,
}

impl Occurrence {
    fn of(event: &Event, robot: &Robot) -> Self {
        let cable = event.happening.cable();
        let name = cable.map(|cable| format!("cable {}", robot.cables[cable].name)).unwrap_or_default();
        let words = match &event.happening {
            Happening::CableBreak { .. } => format!("{name} breaks"),
            Happening::WinchStop { .. } => format!("the winch of {name} stands still"),
            Happening::Slip { length, .. } => format!("{name} slips by {} mm", significant(1e3 * length, 3)),
            Happening::Load { mass, .. } if *mass < 0.0 => format!("{} kg are taken off", significant(-mass, 4)),
            Happening::Load { mass, .. } => format!("{} kg are taken up", significant(*mass, 4)),
            Happening::Wrench(wrench) => {
                let force = significant(wrench.fixed_rows::<3>(0).norm(), 4);
                format!(
                    "a wrench acts: force {force} N, moment {} N·m",
                    significant(wrench.fixed_rows::<3>(3).norm(), 4)
                )
            }
            other => other.kind().to_owned(),
        };
        Self { time: event.time, words, cable, breaks: matches!(event.happening, Happening::CableBreak { .. }) }
    }
}

/// Record of a run: moments in order of time, and what happened.
#[derive(Clone, Debug)]
pub struct Recording<'a> {
    /// Robot that moved.
    pub robot: &'a Robot,
    /// Moments, in order of time.
    pub moments: Vec<Moment>,
    /// Events that happened, in order of time.
    pub events: Vec<Occurrence>,
    /// Least and largest tension of each cable (N); empty where the limits are unknown.
    pub limits: Vec<(f64, f64)>,
}

impl<'a> Recording<'a> {
    /// An empty record of a robot with the limits of its file.
    pub fn new(robot: &'a Robot) -> Self {
        let limits = Limits::of(robot, None, None).ok();
        let pairs = |limits: Limits| limits.minimum().iter().copied().zip(limits.maximum().iter().copied()).collect();
        Self { robot, moments: Vec::new(), events: Vec::new(), limits: limits.map(pairs).unwrap_or_default() }
    }

    /// Adds the state of the machine.
    pub fn note(&mut self, state: &State) {
        self.moments.push(Moment {
            time: state.time,
            pose: state.pose,
            tensions: state.cables.iter().map(|cable| cable.tension).collect(),
        });
    }

    /// Adds events that happened.
    pub fn happened(&mut self, events: &[Event]) {
        let robot = self.robot;
        self.events.extend(events.iter().map(|event| Occurrence::of(event, robot)));
    }

    /// Least and largest tension of the colours of each cable (N): its limits, or nothing and the largest tension of the record.
    fn tension_range(&self) -> Vec<(f64, f64)> {
        if !self.limits.is_empty() {
            return self.limits.clone();
        }
        let largest = self.moments.iter().flat_map(|moment| &moment.tensions).copied().fold(0.0, f64::max);
        vec![(0.0, largest); self.robot.cables.len()]
    }

    /// True after an event that took the cable away.
    fn is_broken(&self, cable: usize, time: f64) -> bool {
        self.events.iter().any(|event| event.breaks && event.cable == Some(cable) && event.time < time)
    }
}
