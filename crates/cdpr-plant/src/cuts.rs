//! Stages cut where a force has a kink or a jump, across which a step loses orders: where a cable goes slack or taut, and where a drum with
//! dry friction begins to turn, turns round or comes to rest.
//!
//! A cable that is taut at one end of the stages and slack at the other has its kink between, and a drum whose [`margin`](Plant::margin) is used
//! up has its switch there. What changes sides twice shows it in the middle: the parabola through both ends and the middle has its extremum on
//! the other side of zero. The stages are cut there, and each part then has a change that its ends show.

use super::error::StepError;
use super::plant::Plant;
use super::pulls::elongation_rate;
use super::stage_start::CableStart;
use super::state::PlantState;
use super::step::{MIDDLE_AHEAD, SPEED_AHEAD};
use cdpr_model::geometry::Twist;

/// Most cuts of a step without dry friction; more cables seldom change sides within one.
const CUTS: usize = 8;

/// Most cuts of a step with dry friction, in which every drum may stick and slide.
const CUTS_OF_DRUMS: usize = 64;

/// Fraction of a step next to its ends in which a kink is not cut: its error falls with the square.
const END: f64 = 1e-3;

/// Iterations for the position of a kink, each of which is some hundred times more accurate.
const LOOKS: usize = 3;

/// Most iterations for the position of a switch, which takes four to six.
const LOOKS_FOR_SWITCHES: usize = 60;

/// Accuracy of the position of a switch (fraction of the stages): a force that jumps there has an error in proportion.
const SWITCH: f64 = 1e-10;

/// Distance below which two switches are one (fraction of the stages).
const SAME: f64 = 1e-8;

/// A quantity that changes its side.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Side {
    /// The sum of law and damper of a cable.
    Cable(usize),
    /// The margin of a drum.
    Drum(usize),
}

/// Changes within the stages, each with the fraction of the stages at which it appears to lie.
#[derive(Clone, Copy, Debug, Default)]
struct Changes {
    /// The first one that the ends show.
    first: Option<(Side, f64)>,
    /// The first cable with an extremum on the other side.
    cable_turns: Option<(Side, f64)>,
    /// The first drum with such an extremum.
    drum_turns: Option<(Side, f64)>,
}

/// Place of a cut (fraction of the stages).
#[derive(Clone, Copy, Debug)]
enum Cut {
    /// At the present state.
    Here(f64),
    /// Earlier: at an extremum on the other side.
    Before(f64),
}

impl Plant {
    /// Runs the stages over a time (s), cut at kinks and switches.
    pub(super) fn pass_cuts(&self, state: &mut PlantState, time: f64) -> Result<(), StepError> {
        // time up to the next extremum on the other side, and after it
        let (mut left, mut behind) = (time, 0.0);
        let cuts = match (state.pulls.is_dry, self.sags) {
            (true, _) => CUTS_OF_DRUMS,
            // cables with weight are never slack
            (false, true) => 0,
            (false, false) => CUTS,
        };
        for _ in 0..cuts {
            self.note_start(state)?;
            self.stages(state, left)?;
            let found = self.changes(state);
            if let Some(change) = found.first {
                match self.go_to_first(state, left, change)? {
                    Cut::Here(fraction) => left *= 1.0 - fraction,
                    Cut::Before(fraction) => (left, behind) = (fraction * left, behind + (1.0 - fraction) * left),
                }
            } else if let Some(fraction) = self.turn_on_other_side(state, left, found.cable_turns)? {
                (left, behind) = (fraction * left, behind + (1.0 - fraction) * left);
            } else if let Some(fraction) = self.turn_on_other_side(state, left, found.drum_turns)? {
                (left, behind) = (fraction * left, behind + (1.0 - fraction) * left);
            } else if behind > 0.0 {
                (left, behind) = (behind, 0.0);
            } else {
                return Ok(());
            }
        }
        self.stages(state, left + behind)
    }

    fn note_start(&self, state: &mut PlantState) -> Result<(), StepError> {
        state.pulls.find(self, &state.pose, &mut state.cables)?;
        let twist = self.twist_if_asked(state);
        for cable in 0..state.cables.len() {
            let (sum, now) = (self.unclipped(state, cable, &twist), &state.cables[cable]);
            let (length, rate) = (now.controlled_length, now.controlled_length_rate);
            let margin = if state.pulls.is_dry { self.margin(state, cable, &twist) } else { f64::INFINITY };
            let (angle, speed) = (now.drum_angle, now.drum_speed);
            state.pulls.start.cables[cable] =
                CableStart { length, rate, angle, speed, sum, middle: sum, margin, middle_margin: margin };
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

    /// Twist of the platform, of which tensions and margins are asked; zero where forces do not depend on speeds.
    #[inline]
    pub(super) fn twist_if_asked(&self, state: &PlantState) -> Twist {
        if self.dissipates { state.twist() } else { Twist::zeros() }
    }

    /// Tension of law and damper of a cable before clipping (N), at the pose for which the pulls were computed.
    #[inline]
    pub(super) fn unclipped(&self, state: &PlantState, cable: usize, twist: &Twist) -> f64 {
        let law = &state.pulls.laws[cable];
        if law.damping == 0.0 {
            return law.tension;
        }
        let rate = elongation_rate(&state.pulls.columns[cable], twist);
        law.tension + law.damping * (rate - state.cables[cable].controlled_length_rate)
    }

    /// Changes between the start of the stages and the present state, and those that appear to have happened twice.
    #[inline]
    fn changes(&self, state: &PlantState) -> Changes {
        let (mut changes, twist) = (Changes::default(), self.twist_if_asked(state));
        for (index, start) in state.pulls.start.cables.iter().enumerate() {
            if !self.sags {
                let (end, side) = (self.unclipped(state, index, &twist), Side::Cable(index));
                if (start.sum > 0.0) != (end > 0.0) {
                    note(&mut changes.first, side, Some(start.sum / (start.sum - end)).filter(is_within));
                } else {
                    let turns = turn(start.sum, start.middle, end, MIDDLE_AHEAD);
                    note(&mut changes.cable_turns, side, turns.filter(is_within));
                }
            }
            if state.pulls.is_dry {
                let (margin, side) = (self.margin(state, index, &twist), Side::Drum(index));
                if margin < 0.0 {
                    note(&mut changes.first, side, Some((start.margin / (start.margin - margin)).max(0.0)));
                } else if margin.is_finite() {
                    let ahead = if state.cables[index].is_stuck { MIDDLE_AHEAD } else { SPEED_AHEAD };
                    let turns = turn(start.margin, start.middle_margin, margin, ahead);
                    note(&mut changes.drum_turns, side, turns.filter(is_within));
                }
            }
        }
        changes
    }

    /// Runs the stages up to the first change, sought from the one that appears to be the first; drums whose margin is used up there switch. The
    /// state is back at the start where something has an extremum on the other side before.
    fn go_to_first(
        &self,
        state: &mut PlantState,
        time: f64,
        (mut side, mut guess): (Side, f64),
    ) -> Result<Cut, StepError> {
        let mut span = 1.0;
        loop {
            let fraction = match side {
                Side::Cable(cable) => self.go_to_kink(state, time, cable, (guess * span, span))?,
                Side::Drum(drum) => self.go_to_switch(state, time, drum, span)?,
            };
            if !state.pulls.is_dry {
                return Ok(Cut::Here(fraction));
            }
            let found = self.changes(state);
            // what changes so near that it is one with this change lies at the end
            match found.first.filter(|(other, at)| *other != side && *at < 1.0 - SAME && fraction > 0.0) {
                Some((other, at)) => (side, guess, span) = (other, at, fraction),
                None => {
                    for turn in [found.cable_turns, found.drum_turns] {
                        if let Some(at) = self.turn_on_other_side(state, fraction * time, turn)? {
                            return Ok(Cut::Before(at * fraction));
                        }
                    }
                    if let Side::Drum(drum) = side {
                        self.switch(state, drum);
                    }
                    self.switch_what_is_used_up(state);
                    return Ok(Cut::Here(fraction));
                }
            }
        }
    }

    /// Runs the stages up to the kink of a cable, sought from a first guess and before the present state; both are fractions of the time, as
    /// what is returned.
    fn go_to_kink(
        &self,
        state: &mut PlantState,
        time: f64,
        cable: usize,
        (guess, span): (f64, f64),
    ) -> Result<f64, StepError> {
        let start = state.pulls.start.cables[cable].sum;
        let now = |state: &PlantState| self.unclipped(state, cable, &self.twist_if_asked(state));
        let (mut before, mut after) = ((0.0, start), (span, now(state)));
        let mut fraction = guess;
        for look in 1..=LOOKS {
            Self::restore_start(state);
            self.stages(state, fraction * time)?;
            if look == LOOKS {
                break;
            }
            let found = (fraction, now(state));
            let next = crossing(before, found, after);
            match (found.1 > 0.0) == (start > 0.0) {
                true => before = found,
                false => after = found,
            }
            fraction = if is_within(&next) { next } else { fraction };
        }
        Ok(fraction)
    }

    /// Runs the stages up to where the margin of a drum is used up, which it is in the present state; returns the fraction of the time.
    fn go_to_switch(&self, state: &mut PlantState, time: f64, drum: usize, span: f64) -> Result<f64, StepError> {
        let now = |state: &PlantState| self.margin(state, drum, &state.twist());
        let (mut before, mut after) = ((0.0, state.pulls.start.cables[drum].margin), (span, now(state)));
        // a drum that begins at its limit has margin a little later
        let straight = |before: (f64, f64), after: (f64, f64)| match before.1 > 0.0 {
            true => before.0 + (after.0 - before.0) * before.1 / (before.1 - after.1),
            false => 0.25 * after.0,
        };
        let mut fraction = straight(before, after);
        for _ in 0..LOOKS_FOR_SWITCHES {
            if !(fraction > 1e-3 * SWITCH) {
                break;
            }
            Self::restore_start(state);
            self.stages(state, fraction * time)?;
            let (found, is_between) = ((fraction, now(state)), before.1 > 0.0);
            let bent = if is_between { crossing(before, found, after) } else { f64::INFINITY };
            if found.1 == 0.0 || (bent - fraction).abs() < SWITCH {
                return Ok(fraction);
            }
            match found.1 > 0.0 {
                true => before = found,
                false => after = found,
            }
            fraction = if is_between { bent } else { straight(before, after) };
        }
        Self::restore_start(state);
        state.pulls.find(self, &state.pose, &mut state.cables)?;
        Ok(0.0)
    }

    /// The fraction of the stages at which what ends on its own side has an extremum on the other one; `None` if there is none. The state is
    /// back at the start of the stages if there is one, else at their end.
    fn turn_on_other_side(
        &self,
        state: &mut PlantState,
        time: f64,
        turn: Option<(Side, f64)>,
    ) -> Result<Option<f64>, StepError> {
        let Some((side, fraction)) = turn else { return Ok(None) };
        Self::restore_start(state);
        self.stages(state, fraction * time)?;
        let twist = self.twist_if_asked(state);
        let turns = match side {
            Side::Cable(cable) => {
                (self.unclipped(state, cable, &twist) > 0.0) != (state.pulls.start.cables[cable].sum > 0.0)
            }
            Side::Drum(drum) => self.margin(state, drum, &twist) < 0.0,
        };
        Self::restore_start(state);
        if !turns {
            self.stages(state, time)?;
        }
        Ok(turns.then_some(fraction))
    }
}

/// Takes a change at a fraction as the first one if it is earlier.
#[inline]
fn note(first: &mut Option<(Side, f64)>, side: Side, fraction: Option<f64>) {
    if let Some(fraction) = fraction
        && first.is_none_or(|(_, least)| fraction < least)
    {
        *first = Some((side, fraction));
    }
}

/// True for fractions that are not next to an end.
#[inline]
fn is_within(fraction: &f64) -> bool {
    *fraction > END && *fraction < 1.0 - END
}

/// Position of the extremum of the parabola through ends and middle, if it lies on the other side of zero than both
/// ends; else `None`. `ahead` is the excess of the middle over the second derivative and the square of the step.
#[inline]
fn turn(start: f64, middle: f64, end: f64, ahead: f64) -> Option<f64> {
    let middle = (middle - 4.0 * ahead * (start + end)) / (1.0 - 8.0 * ahead);
    let (across, bend) = (end - start, start + end - 2.0 * middle);
    // open to the side of the ends, with middle − across²/(8 bend) on the other one
    let turns = start * end > 0.0 && bend * start > 0.0 && 8.0 * bend * middle < across * across;
    if turns { Some(0.5 - across / (4.0 * bend)) } else { None }
}

/// Position of the zero of the parabola through three points at ascending positions, whose outer ones lie on different
/// sides; from a straight line if rounding leaves no parabola.
pub(super) fn crossing(before: (f64, f64), found: (f64, f64), after: (f64, f64)) -> f64 {
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
                let found = turn(sign * bent(0.0, at, deep), sign * seen, sign * bent(1.0, at, deep), MIDDLE_AHEAD);
                assert_eq!(found.is_some(), turns, "{at} {deep}: {found:?}");
                assert!(found.is_none_or(|found| (found - at).abs() < 1e-12), "{at} {deep}: {found:?}");
            }
        }
    }
}
