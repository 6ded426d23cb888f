//! The loop of a simulation: when its controller is asked, what it sees, and what winches are told between two questions.

use super::command::Command;
use super::controller::{Controller, Measured, Setpoint};
use super::error::{PlantError, StepError};
use super::sensors::Sensors;
use super::state::PlantState;

/// Commands of a controller with a period from one question to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Between {
    /// They stay as they are: ideal winches have the new lengths at the end of the next step.
    #[default]
    Hold,
    /// They go straight from the last answer to the new one, which they reach when the next question is asked.
    Line,
}

/// Moment for which commands are needed.
pub(super) struct Moment<'a> {
    /// End of the step (s).
    pub(super) until: f64,
    /// Times that differ by less than this are one (s).
    pub(super) same: f64,
    pub(super) state: &'a PlantState,
    pub(super) sensors: Option<&'a Sensors>,
    pub(super) wanted: &'a Setpoint,
    pub(super) between: Between,
}

/// A controller with its clock and its answers.
#[derive(Clone, Debug)]
pub(super) struct ControlLoop {
    controller: Box<dyn Controller>,
    /// Number of the period that has begun, and the time of its question (s); `None` before the first.
    asked: Option<(u64, f64)>,
    /// Answer before the last one.
    before: Vec<Command>,
    /// Last answer.
    answer: Vec<Command>,
    /// Commands of now.
    now: Vec<Command>,
    /// Lengths, rates and tensions as the controller sees them.
    seen: [Vec<f64>; 3],
}

impl ControlLoop {
    /// A loop before its first question, the winches where they stand.
    pub(super) fn new(controller: Box<dyn Controller>, state: &PlantState) -> Result<Self, PlantError> {
        if let Some(period) = controller.period().filter(|period| !(*period > 0.0 && period.is_finite())) {
            return Err(PlantError::Period { period });
        }
        let held: Vec<Command> = state.cables.iter().map(|cable| Command::Length(cable.controlled_length)).collect();
        let seen = [(); 3].map(|()| vec![0.0; held.len()]);
        Ok(Self { controller, asked: None, before: held.clone(), now: held.clone(), answer: held, seen })
    }

    /// Goes back to before the first question, the winches where they stand.
    pub(super) fn reset(&mut self, state: &PlantState) {
        self.controller.reset();
        self.asked = None;
        for (command, cable) in self.answer.iter_mut().zip(&state.cables) {
            *command = Command::Length(cable.controlled_length);
        }
    }

    /// Times at which commands bend; `None` if only questions show it.
    pub(super) fn bends(&self) -> Option<&[f64]> {
        if self.controller.period().is_some() { None } else { self.controller.bends() }
    }

    /// The first question after a time (s); `None` without a period.
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
                    // there is no way from an answer that nobody gave
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
