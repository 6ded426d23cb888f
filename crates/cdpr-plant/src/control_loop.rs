//! The control loop of a simulation: the times at which the controller is called, its inputs, and the commands between
//! two calls.

use super::command::Command;
use super::controller::{Controller, Measured, Setpoint};
use super::error::{PlantError, StepError};
use super::sensors::Sensors;
use super::state::PlantState;

/// Commands between two calls of a controller with a period.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Between {
    /// The commands are held: ideal winches have the new lengths at the end of the next step.
    #[default]
    Hold,
    /// The commands go linearly from the last answer to the new one, which they reach at the next call.
    Line,
}

/// Time for which commands are needed, with the inputs of the controller.
pub(super) struct Moment<'a> {
    /// End of the step (s).
    pub(super) until: f64,
    /// Times that differ by less than this are equal (s).
    pub(super) same: f64,
    pub(super) state: &'a PlantState,
    pub(super) sensors: Option<&'a Sensors>,
    pub(super) wanted: &'a Setpoint,
    pub(super) between: Between,
}

/// A controller with its clock and its last answers.
#[derive(Clone, Debug)]
pub(super) struct ControlLoop {
    controller: Box<dyn Controller>,
    /// Number of the current period, and the time of its call (s); `None` before the first.
    asked: Option<(u64, f64)>,
    /// Answer before the last one.
    before: Vec<Command>,
    /// Last answer.
    answer: Vec<Command>,
    /// Current commands.
    now: Vec<Command>,
    /// Lengths, rates and tensions passed to the controller.
    seen: [Vec<f64>; 3],
}

impl ControlLoop {
    /// A loop before its first call, with the winches at their present lengths.
    pub(super) fn new(controller: Box<dyn Controller>, state: &PlantState) -> Result<Self, PlantError> {
        if let Some(period) = controller.period().filter(|period| !(*period > 0.0 && period.is_finite())) {
            return Err(PlantError::Period { period });
        }
        let held: Vec<Command> = state.cables.iter().map(|cable| Command::Length(cable.controlled_length)).collect();
        let seen = [(); 3].map(|()| vec![0.0; held.len()]);
        Ok(Self { controller, asked: None, before: held.clone(), now: held.clone(), answer: held, seen })
    }

    /// Resets the loop to before its first call, with the winches at their present lengths.
    pub(super) fn reset(&mut self, state: &PlantState) {
        self.controller.reset();
        self.asked = None;
        for (command, cable) in self.answer.iter_mut().zip(&state.cables) {
            *command = Command::Length(cable.controlled_length);
        }
    }

    /// Times at which commands change their slope; `None` if they are known only from calls.
    pub(super) fn bends(&self) -> Option<&[f64]> {
        if self.controller.period().is_some() { None } else { self.controller.bends() }
    }

    /// Time of the first call after `time` (s); `None` without a period.
    pub(super) fn next_question(&self, time: f64) -> Option<f64> {
        let period = self.controller.period()?;
        Some(((time / period).floor() + 1.0) * period)
    }

    /// Commands for a step.
    pub(super) fn commands(&mut self, moment: &Moment<'_>) -> Result<&[Command], StepError> {
        let Some(period) = self.controller.period() else {
            self.ask(moment.until, moment)?;
            return Ok(&self.answer);
        };
        let from = moment.state.time;
        let number = ((from + moment.same) / period).floor() as u64;
        let began = match self.asked {
            Some((last, began)) if last == number => began,
            last => {
                self.before.copy_from_slice(&self.answer);
                self.ask(from, moment)?;
                if last.is_none() {
                    // without an earlier answer there is no line to follow
                    self.before.copy_from_slice(&self.answer);
                }
                self.asked = Some((number, from));
                from
            }
        };
        let fraction = match moment.between {
            Between::Hold => 1.0,
            Between::Line => (moment.until - began) / period,
        };
        for (now, (before, answer)) in self.now.iter_mut().zip(self.before.iter().zip(&self.answer)) {
            *now = answer.after(*before, fraction);
        }
        Ok(&self.now)
    }

    fn ask(&mut self, time: f64, moment: &Moment<'_>) -> Result<(), StepError> {
        let state = moment.state;
        let [lengths, length_rates, tensions] = &mut self.seen;
        for (index, cable) in state.cables.iter().enumerate() {
            (lengths[index], length_rates[index]) = (cable.controlled_length, cable.controlled_length_rate);
            tensions[index] = cable.tension;
        }
        let measured = Measured {
            time: state.time,
            pose: state.pose,
            twist: state.twist(),
            lengths,
            length_rates,
            tensions,
            sensors: moment.sensors,
        };
        Ok(self.controller.command(time, moment.wanted, &measured, &mut self.answer)?)
    }
}
