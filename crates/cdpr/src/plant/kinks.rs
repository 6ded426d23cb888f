//! Stages cut where a cable goes slack or taut: the force has a kink there, which costs a step that runs over it two of its orders.

use super::error::StepError;
use super::plant::Plant;
use super::pulls::elongation_rate;
use super::stage_start::CableStart;
use super::state::State;
use super::step::Command;

/// Cuts of a step, at most; more cables than these seldom change sides within one.
const CUTS: usize = 8;

/// Share of a step next to its ends in which a kink is left: what it costs falls with the square.
const END: f64 = 1e-3;

/// Looks for the place of a kink, each of which comes some hundred times nearer.
const LOOKS: usize = 3;

impl Plant {
    /// Stages over a time (s), cut at kinks.
    pub(super) fn pass_kinks(&self, state: &mut State, command: &Command<'_>, time: f64) -> Result<(), StepError> {
        let mut left = time;
        // cables with weight are never slack
        for _ in 0..if self.sags { 0 } else { CUTS } {
            self.note_start(state)?;
            self.stages(state, command, left)?;
            let Some((cable, share)) = self.first_kink(state) else { return Ok(()) };
            left *= 1.0 - self.go_to_kink(state, command, left, (cable, share))?;
        }
        self.stages(state, command, left)
    }

    fn note_start(&self, state: &mut State) -> Result<(), StepError> {
        state.pulls.find(self, &state.pose, &mut state.cables)?;
        for cable in 0..state.cables.len() {
            let (sum, now) = (self.unclipped(state, cable), &state.cables[cable]);
            let (length, rate) = (now.controlled_length, now.controlled_length_rate);
            state.pulls.start.cables[cable] =
                CableStart { length, rate, angle: now.drum_angle, speed: now.drum_speed, sum };
        }
        (state.pulls.start.pose, state.pulls.start.momentum) = (state.pose, state.momentum);
        Ok(())
    }

    fn restore_start(state: &mut State) {
        (state.pose, state.momentum) = (state.pulls.start.pose, state.pulls.start.momentum);
        for (cable, start) in state.cables.iter_mut().zip(&state.pulls.start.cables) {
            (cable.controlled_length, cable.controlled_length_rate) = (start.length, start.rate);
            (cable.drum_angle, cable.drum_speed) = (start.angle, start.speed);
        }
        state.pulls.is_current = false;
    }

    /// Law and damper of a cable before they are clipped (N), at the pose that its pulls were found for.
    #[inline]
    fn unclipped(&self, state: &State, cable: usize) -> f64 {
        let law = &state.pulls.laws[cable];
        if law.damping == 0.0 {
            return law.tension;
        }
        let rate = elongation_rate(&state.pulls.columns[cable], &state.twist());
        law.tension + law.damping * (rate - state.cables[cable].controlled_length_rate)
    }

    /// The cable that changed sides first, and the share of the stages after which it seems to have.
    fn first_kink(&self, state: &State) -> Option<(usize, f64)> {
        let mut first: Option<(usize, f64)> = None;
        for (cable, start) in state.pulls.start.cables.iter().enumerate() {
            let end = self.unclipped(state, cable);
            if (start.sum > 0.0) == (end > 0.0) {
                continue;
            }
            let share = start.sum / (start.sum - end);
            if share > END && share < 1.0 - END && first.is_none_or(|(_, least)| share < least) {
                first = Some((cable, share));
            }
        }
        first
    }

    /// Stages up to a kink, sought by false position from its first guess; the share of the time gone.
    fn go_to_kink(
        &self,
        state: &mut State,
        command: &Command<'_>,
        time: f64,
        (cable, guess): (usize, f64),
    ) -> Result<f64, StepError> {
        let start = state.pulls.start.cables[cable].sum;
        let (mut before, mut after) = ((0.0, start), (1.0, self.unclipped(state, cable)));
        let mut share = guess;
        for look in 1..=LOOKS {
            Self::restore_start(state);
            self.stages(state, command, share * time)?;
            let sum = self.unclipped(state, cable);
            if look == LOOKS {
                break;
            }
            match (sum > 0.0) == (start > 0.0) {
                true => before = (share, sum),
                false => after = (share, sum),
            }
            let next = before.0 + (after.0 - before.0) * before.1 / (before.1 - after.1);
            share = if next > END && next < 1.0 - END { next } else { share };
        }
        Ok(share)
    }
}
