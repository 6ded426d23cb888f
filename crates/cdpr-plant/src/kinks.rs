//! Stages cut where a cable goes slack or taut: the force has a kink there, and a step across it loses two orders.
//!
//! A cable that is taut at one end of the stages and slack at the other has its kink between. A cable that goes slack
//! and taut again (or the reverse) shows it in the middle: the parabola through both ends and the middle has its
//! extremum on the other side of zero. The stages are cut there, and each part then has a kink that its ends show.

use super::command::Command;
use super::error::StepError;
use super::plant::Plant;
use super::pulls::elongation_rate;
use super::stage_start::CableStart;
use super::state::PlantState;
use super::step::MIDDLE_AHEAD;

/// Most cuts of a step; more cables seldom change sides within one.
const CUTS: usize = 8;

/// Fraction of a step next to its ends in which a kink is not cut: its error falls with the square.
const END: f64 = 1e-3;

/// Iterations for the position of a kink, each of which is some hundred times more accurate.
const LOOKS: usize = 3;

/// Cables that change sides within the stages, each with the fraction of the stages at which it appears to do so.
struct Changes {
    /// The first cable whose ends show a kink.
    kink: Option<(usize, f64)>,
    /// The first cable with an extremum on the other side.
    turn: Option<(usize, f64)>,
}

impl Plant {
    /// Runs the stages over a time (s), cut at kinks.
    pub(super) fn pass_kinks(&self, state: &mut PlantState, commands: &[Command], time: f64) -> Result<(), StepError> {
        // time up to the next extremum of a cable on the other side, and after it
        let (mut left, mut behind) = (time, 0.0);
        // cables with weight are never slack
        for _ in 0..if self.sags { 0 } else { CUTS } {
            self.note_start(state)?;
            self.stages(state, commands, left)?;
            let Changes { kink, turn } = self.changes(state);
            if let Some(kink) = kink {
                left *= 1.0 - self.go_to_kink(state, commands, left, kink)?;
            } else if let Some(fraction) = self.turn_on_other_side(state, commands, left, turn)? {
                behind += (1.0 - fraction) * left;
                left *= fraction;
            } else if behind > 0.0 {
                (left, behind) = (behind, 0.0);
            } else {
                return Ok(());
            }
        }
        self.stages(state, commands, left + behind)
    }

    fn note_start(&self, state: &mut PlantState) -> Result<(), StepError> {
        state.pulls.find(self, &state.pose, &mut state.cables)?;
        for cable in 0..state.cables.len() {
            let (sum, now) = (self.unclipped(state, cable), &state.cables[cable]);
            let (length, rate) = (now.controlled_length, now.controlled_length_rate);
            state.pulls.start.cables[cable] =
                CableStart { length, rate, angle: now.drum_angle, speed: now.drum_speed, sum, middle: sum };
        }
        (state.pulls.start.pose, state.pulls.start.momentum) = (state.pose, state.momentum);
        Ok(())
    }

    fn restore_start(state: &mut PlantState) {
        (state.pose, state.momentum) = (state.pulls.start.pose, state.pulls.start.momentum);
        for (cable, start) in state.cables.iter_mut().zip(&state.pulls.start.cables) {
            (cable.controlled_length, cable.controlled_length_rate) = (start.length, start.rate);
            (cable.drum_angle, cable.drum_speed) = (start.angle, start.speed);
        }
        state.pulls.is_current = false;
    }

    /// Tension of law and damper of a cable before clipping (N), at the pose for which the pulls were computed.
    #[inline]
    pub(super) fn unclipped(&self, state: &PlantState, cable: usize) -> f64 {
        let law = &state.pulls.laws[cable];
        if law.damping == 0.0 {
            return law.tension;
        }
        let rate = elongation_rate(&state.pulls.columns[cable], &state.twist());
        law.tension + law.damping * (rate - state.cables[cable].controlled_length_rate)
    }

    /// Cables that changed sides between the ends of the stages, or appear to have done so twice.
    #[inline]
    fn changes(&self, state: &PlantState) -> Changes {
        let mut changes = Changes { kink: None, turn: None };
        for (cable, start) in state.pulls.start.cables.iter().enumerate() {
            let end = self.unclipped(state, cable);
            let (first, fraction) = if (start.sum > 0.0) != (end > 0.0) {
                (&mut changes.kink, start.sum / (start.sum - end))
            } else if let Some(fraction) = turn(start.sum, start.middle, end) {
                (&mut changes.turn, fraction)
            } else {
                continue;
            };
            if fraction > END && fraction < 1.0 - END && first.is_none_or(|(_, least)| fraction < least) {
                *first = Some((cable, fraction));
            }
        }
        changes
    }

    /// Runs the stages up to a kink, sought from a first guess; returns the fraction of the time passed.
    fn go_to_kink(
        &self,
        state: &mut PlantState,
        commands: &[Command],
        time: f64,
        (cable, guess): (usize, f64),
    ) -> Result<f64, StepError> {
        let start = state.pulls.start.cables[cable].sum;
        let (mut before, mut after) = ((0.0, start), (1.0, self.unclipped(state, cable)));
        let mut fraction = guess;
        for look in 1..=LOOKS {
            Self::restore_start(state);
            self.stages(state, commands, fraction * time)?;
            if look == LOOKS {
                break;
            }
            let found = (fraction, self.unclipped(state, cable));
            let next = crossing(before, found, after);
            match (found.1 > 0.0) == (start > 0.0) {
                true => before = found,
                false => after = found,
            }
            fraction = if next > END && next < 1.0 - END { next } else { fraction };
        }
        Ok(fraction)
    }

    /// The fraction of the stages at which a cable that ends on its own side has an extremum on the other one; `None`
    /// if there is none. The state is back at the start of the stages if there is one, else at their end.
    fn turn_on_other_side(
        &self,
        state: &mut PlantState,
        commands: &[Command],
        time: f64,
        turn: Option<(usize, f64)>,
    ) -> Result<Option<f64>, StepError> {
        let Some((cable, fraction)) = turn else { return Ok(None) };
        let start = state.pulls.start.cables[cable].sum;
        Self::restore_start(state);
        self.stages(state, commands, fraction * time)?;
        let turns = (self.unclipped(state, cable) > 0.0) != (start > 0.0);
        Self::restore_start(state);
        if !turns {
            self.stages(state, commands, time)?;
        }
        Ok(turns.then_some(fraction))
    }
}

/// Position of the extremum of the parabola through ends and middle, if it lies on the other side of zero than both
/// ends; else `None`.
#[inline]
fn turn(start: f64, middle: f64, end: f64) -> Option<f64> {
    // the kick in the middle lies where a constant acceleration has moved its pose too far
    const SCALE: f64 = 1.0 / (1.0 - 8.0 * MIDDLE_AHEAD);
    let middle = (middle - 4.0 * MIDDLE_AHEAD * (start + end)) * SCALE;
    let (across, bend) = (end - start, start + end - 2.0 * middle);
    // open to the side of the ends, with middle − across²/(8 bend) on the other one
    let turns = start * end > 0.0 && bend * start > 0.0 && 8.0 * bend * middle < across * across;
    if turns { Some(0.5 - across / (4.0 * bend)) } else { None }
}

/// Position of the zero of the parabola through three points at ascending positions, whose outer ones lie on different
/// sides; from a straight line if rounding leaves no parabola.
fn crossing(before: (f64, f64), found: (f64, f64), after: (f64, f64)) -> f64 {
    let slope = |a: (f64, f64), b: (f64, f64)| (b.1 - a.1) / (b.0 - a.0);
    let (first, second) = (slope(before, found), slope(found, after));
    let bend = (second - first) / (after.0 - before.0);
    // s(t) = s₁ + rise (t − t₁) + bend (t − t₁)²
    let rise = first + bend * (found.0 - before.0);
    let root = (rise * rise - 4.0 * bend * found.1).max(0.0).sqrt();
    let next = found.0 - 2.0 * found.1 / (rise + root.copysign(rise));
    if next > before.0 && next < after.0 {
        next
    } else {
        before.0 + (after.0 - before.0) * before.1 / (before.1 - after.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parabolas_cross_zero_and_turn_where_they_do() {
        // (t − 0.3)(t − 2) and its other side
        let of = |t: f64| (t - 0.3) * (t - 2.0);
        for sign in [1.0, -1.0] {
            let at = |t: f64| (t, sign * of(t));
            assert!((crossing(at(0.0), at(0.6), at(1.0)) - 0.3).abs() < 1e-15);
            assert!((crossing(at(0.0), at(0.1), at(1.0)) - 0.3).abs() < 1e-15);
        }
        // a straight line, and three points whose middle one is the zero
        assert_eq!(crossing((0.0, 1.0), (0.5, 0.5), (1.5, -0.5)), 1.0);
        assert_eq!(crossing((0.0, 1.0), (0.25, 0.0), (1.0, -0.5)), 0.25);
        let bent = |t: f64, turn: f64, deep: f64| (t - turn) * (t - turn) - deep;
        for sign in [1.0, -1.0] {
            for (at, deep, turns) in [(0.4, 0.1, true), (0.4, -0.1, false), (0.7, 0.05, true), (0.4, 0.2, false)] {
                // the middle in the stages, ahead by the acceleration 2
                let seen = bent(0.5, at, deep) + 2.0 * MIDDLE_AHEAD;
                let found = turn(sign * bent(0.0, at, deep), sign * seen, sign * bent(1.0, at, deep));
                assert_eq!(found.is_some(), turns, "{at} {deep}: {found:?}");
                assert!(found.is_none_or(|found| (found - at).abs() < 1e-12), "{at} {deep}: {found:?}");
            }
        }
    }
}
