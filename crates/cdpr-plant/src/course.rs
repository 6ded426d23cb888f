//! Course of a run, from which its summary is made.

use super::error::StepError;
use super::events::Event;
use super::state::PlantState;
use super::violations::{Judge, Violation};

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum RunEnd {
    /// At the end of its time.
    Completed,
    /// Whoever watched it said so.
    Stopped,
    /// The machine could not go on.
    Failed(StepError),
}

/// Outcome of a run.
#[must_use = "check `end`: the machine may not have got to the end"]
#[derive(Clone, Debug)]
pub struct Summary {
    /// How it ended.
    pub end: RunEnd,
    /// Steps taken.
    pub steps: u64,
    /// Least tension of a cable that is not broken, after any step (N).
    pub tension_min: f64,
    /// Largest tension after any step (N).
    pub tension_max: f64,
    /// Events that happened.
    pub events: Vec<Event>,
    /// Stretches of time in which tensions broke limits of the robot file after any step, or cables were slack; by time and cable.
    pub violations: Vec<Violation>,
}

/// Course of a run so far.
#[derive(Clone, Debug)]
pub(super) struct Course {
    pub(super) steps: u64,
    /// Number of the event that comes next.
    pub(super) next: usize,
    pub(super) events: Vec<Event>,
    tension_min: f64,
    tension_max: f64,
    judge: Judge,
}

impl Course {
    /// A course before its first step.
    pub(super) fn new(judge: Judge) -> Self {
        Self { steps: 0, next: 0, events: Vec::new(), tension_min: f64::INFINITY, tension_max: 0.0, judge }
    }

    /// Looks at the state after a step.
    pub(super) fn look(&mut self, state: &PlantState) {
        for cable in state.cables.iter().filter(|cable| !cable.is_broken) {
            self.tension_min = self.tension_min.min(cable.tension);
            self.tension_max = self.tension_max.max(cable.tension);
        }
        self.judge.look(state);
    }

    /// The summary of a run that ended.
    pub(super) fn ended(self, end: RunEnd) -> Summary {
        let Self { steps, events, tension_min, tension_max, judge, .. } = self;
        Summary { end, steps, tension_min, tension_max, events, violations: judge.found() }
    }
}
