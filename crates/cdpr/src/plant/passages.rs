//! Runs with error control: from one bend of commands and wrenches to the next, between which everything is smooth.

use super::commands::Series;
use super::error::StepError;
use super::error_control::Passage;
use super::simulation::{SAME_TIME, Simulation};
use crate::geometry::Wrench;

/// Error that a step may have where a scenario does not say it.
const TOLERANCE: f64 = 1e-10;

impl Simulation {
    /// To a time, with a stop at every bend; the number of steps of the integrator.
    pub(super) fn pass_to(&mut self, target: f64) -> Result<u64, StepError> {
        let mut steps = 0;
        while self.state.time < target {
            let (from, until) = (self.state.time, self.next_bend(target));
            let wrenches = [from, until].map(|time| {
                let mut now = [0.0; 6];
                self.wrench.iter().for_each(|series| series.at(time, &mut now));
                Wrench::from(now)
            });
            let tolerance = self.time.tolerance.unwrap_or(TOLERANCE);
            let passage = Passage { time: until - from, tolerance, wrenches };
            steps += self.plant.advance(&mut self.state, &self.commands.at(until), &passage)?;
            self.state.time = until;
        }
        Ok(steps)
    }

    /// The next time at which a series bends, or the target.
    fn next_bend(&self, target: f64) -> f64 {
        let same = SAME_TIME * self.time.step_s;
        let series = self.commands.changes.iter().chain(&self.wrench);
        let between = |time: &f64| *time > self.state.time + same && *time < target - same;
        series.flat_map(|series: &Series| &series.times).copied().filter(between).fold(target, f64::min)
    }
}
