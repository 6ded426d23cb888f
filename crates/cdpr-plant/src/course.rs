//! Record of a run, from which its summary is made.

use super::error::StepError;
use super::events::Event;
use super::state::PlantState;
use super::violations::{Judge, Violation};

/// Reason for which a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum RunEnd {
    /// The run reached the end of its time.
    Completed,
    /// The caller stopped it.
    Stopped,
    /// The machine could not take another step.
    Failed(StepError),
}

/// Outcome of a run.
#[must_use = "check `end`: the machine may not have got to the end"]
#[derive(Clone, Debug)]
pub struct Summary {
    /// Reason for which the run ended.
    pub end: RunEnd,
    /// Steps taken.
    pub steps: u64,
    /// Least tension of a cable that is not broken, after any step (N).
    pub tension_min: f64,
    /// Largest tension after any step (N).
    pub tension_max: f64,
    /// Events that happened.
    pub events: Vec<Event>,
    /// Intervals of time in which tensions broke limits of the robot file or cables were slack, checked after each
    /// step; sorted by time, then cable.
    pub violations: Vec<Violation>,
}

/// Record of a run up to the present step.
#[derive(Clone, Debug)]
pub(super) struct Course {
    pub(super) steps: u64,
    /// Index of the next event.
    pub(super) next: usize,
    pub(super) events: Vec<Event>,
    tension_min: f64,
    tension_max: f64,
    judge: Judge,
}

impl Course {
    /// A record before the first step.
    pub(super) fn new(judge: Judge) -> Self {
        Self { steps: 0, next: 0, events: Vec::new(), tension_min: f64::INFINITY, tension_max: 0.0, judge }
    }

    /// Updates the record with the state after a step.
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
