//! Commands of a scenario, and series over time.

use super::error::{PlantError, ScenarioKey};
use super::plant::Plant;
use super::scenario::{ControlKind, Scenario};
use super::state::State;
use super::step::Command;

/// Commands of a scenario.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Commands {
    kind: ControlKind,
    /// Lengths (m) or torques (N·m) of the start.
    start: Vec<f64>,
    pub(super) changes: Option<Series>,
    now: Vec<f64>,
}

impl Commands {
    pub(super) fn of(plant: &Plant, state: &State, scenario: &Scenario) -> Result<Self, PlantError> {
        let kind = scenario.control.kind;
        let start = match kind {
            ControlKind::Torques => plant.holding_torques(state)?,
            _ => state.cables.iter().map(|cable| cable.controlled_length).collect(),
        };
        let changes = match (&scenario.control.time_s, &scenario.control.length_change_m) {
            (Some(times), Some(rows)) => Some(Series { times: times.clone(), rows: rows.clone() }),
            _ => None,
        };
        let expected = start.len();
        let wrong = |row: &&Vec<f64>| row.len() != expected || row.iter().any(|x| !x.is_finite());
        if changes.as_ref().is_some_and(|series| series.rows.iter().find(wrong).is_some()) {
            let message = format!("a row of length_change_m has a finite number for each of the {expected} cables");
            return Err(PlantError::Value { key: ScenarioKey::of("control", "length_change_m"), message });
        }
        Ok(Self { kind, now: start.clone(), start, changes })
    }

    /// Command for the step that ends at a time.
    pub(super) fn at(&mut self, time: f64) -> Command<'_> {
        if let Some(series) = &self.changes {
            series.at(time, &mut self.now);
            self.now.iter_mut().zip(&self.start).for_each(|(now, start)| *now += start);
        }
        match self.kind {
            ControlKind::Torques => Command::Torques(&self.now),
            ControlKind::Lengths | ControlKind::LengthChanges => Command::Lengths(&self.now),
        }
    }
}

/// Rows over time, straight between them and constant outside.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Series {
    pub(super) times: Vec<f64>,
    pub(super) rows: Vec<Vec<f64>>,
}

impl Series {
    /// Writes the row at a time.
    pub(super) fn at(&self, time: f64, row: &mut [f64]) {
        let after = self.times.partition_point(|&other| other <= time);
        let (low, high) = (after.saturating_sub(1), after.min(self.times.len() - 1));
        let width = self.times[high] - self.times[low];
        let share = if width > 0.0 { (time - self.times[low]) / width } else { 0.0 };
        for (entry, (a, b)) in row.iter_mut().zip(self.rows[low].iter().zip(&self.rows[high])) {
            *entry = a + (b - a) * share;
        }
    }
}
