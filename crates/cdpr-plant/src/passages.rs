//! Runs with error control: from one kink of commands and wrenches to the next, between which all forces are smooth.

use super::control_loop::Moment;
use super::course::Course;
use super::error::StepError;
use super::error_control::Passage;
use super::series::Series;
use super::simulation::Simulation;
use super::state::PlantState;
use cdpr_model::geometry::Wrench;

/// Default of the error that a step may have.
const TOLERANCE: f64 = 1e-10;

impl Simulation {
    /// Runs to a time, with a stop at every kink; returns the number of steps of the integrator. The course is updated
    /// after each.
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
            let commands = self.control.commands(&Moment {
                until,
                same: self.same_time(),
                state: &self.state,
                sensors: self.sensors.as_ref(),
                wanted: &self.setpoint,
                between: self.between,
            })?;
            let look = &mut |state: &PlantState| course.look(state);
            steps += self.plant.advance(&mut self.state, commands, &passage, look)?;
            self.state.time = until;
        }
        Ok(steps)
    }

    /// The next time at which a series has a kink, or the target.
    fn next_bend(&self, target: f64) -> f64 {
        let same = self.same_time();
        let of_wrench = self.wrench.iter().flat_map(|series: &Series| &series.times);
        let bends = self.control.bends().unwrap_or_default().iter().chain(of_wrench);
        let between = |time: &f64| *time > self.state.time + same && *time < target - same;
        bends.copied().filter(between).fold(target, f64::min)
    }
}
