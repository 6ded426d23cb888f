//! Runs with error control: from one bend of commands and wrenches to the next, between which everything is smooth.

use super::commands::Series;
use super::course::Course;
use super::error::StepError;
use super::error_control::Passage;
use super::simulation::Simulation;
use super::state::State;
use super::volume::SAME_TIME;
use crate::geometry::Wrench;

/// Error that a step may have where a scenario does not say it.
const TOLERANCE: f64 = 1e-10;

impl Simulation {
    /// To a time, with a stop at every bend; the number of steps of the integrator, after each of which the course looks at the machine.
    pub(super) fn pass_to(&mut self, target: f64, course: &mut Course) -> Result<u64, StepError> {
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
            let look = &mut |state: &State| course.look(state);
            steps += self.plant.advance(&mut self.state, &self.commands.at(until), &passage, look)?;
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
