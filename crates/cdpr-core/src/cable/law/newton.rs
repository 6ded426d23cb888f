//! Newton's method for the state of a cable with weight.

#[cfg(not(feature = "std"))]
use num_traits::Float as _;

use super::matrix4::Matrix4;
use super::sagging::Evaluation;
use super::solve::{CableSearch, MAX_NEWTON_STEPS, MAX_STEPS};
use crate::cable::span::SpanState;
use crate::cable::state::CableInput;
use crate::scalar::{dot, scale, sub};
use crate::solve::{self, Control, Rules, Step, StepRule, Stop, Trial, descend};

/// Distance from the state sought, relative to force and length, at which the search ends.
const TOLERANCE: f64 = 1e-12;
/// Gap, as a fraction of the free length, that is left to rounding.
const ROUNDING: f64 = 1e-12;
/// Longest step, relative to force and length.
const LONGEST_STEP: f64 = 0.7;

/// A state with its evaluation and the gap that it leaves in the equations.
#[derive(Clone, Copy)]
struct Tried {
    state: SpanState<f64>,
    evaluation: Evaluation,
    /// Residuals of the equations: the position of the platform anchor (m), then the given length (m) or tension (N).
    gap: [f64; 4],
    /// Size of the gap (m).
    size: f64,
}

/// Equations of one cable, in the form that the loop shared by all searches reads.
struct Newton<'a, 's> {
    search: &'a mut CableSearch<'s>,
    known: CableInput,
    at: Tried,
    trial: Tried,
    /// Change of force (N) and length (m).
    step: [f64; 4],
    /// True at the slacker of two lengths that have the same tension.
    is_slacker: bool,
    /// Count of states after which the search gives up.
    most: u32,
}

impl solve::Problem for Newton<'_, '_> {
    type Number = f64;

    fn step(&mut self, _: &Control<f64>) -> Step<f64> {
        let Tried { state, evaluation, gap, .. } = &self.at;
        let rows = self.search.rows(evaluation, state, self.known);
        let solved = rows.solve([[-gap[0], 0.0], [-gap[1], 0.0], [-gap[2], 0.0], [-gap[3], 1.0]]);
        let step = solved.map(|[entry, _]| entry);
        // Of two lengths with one tension, the slacker one grows with the tension; the length of a cable of almost no
        // weight changes with the tension by no more than rounding. The free part alone does not show this: over a
        // pulley it grows as the wrapped part shrinks.
        self.is_slacker = match self.known {
            CableInput::ControlledLength(_) => false,
            CableInput::OutletTension(tension) | CableInput::PlatformTension(tension) => {
                let by_tension: f64 = (0..4).map(|k| evaluation.by_state.0[3][k] * solved[k][1]).sum();
                by_tension * tension > 1e-9 * state.length
            }
        };
        let force_step = [step[0], step[1], step[2]];
        let tension = dot(state.force, state.force).sqrt();
        let relative = f64::max(dot(force_step, force_step).sqrt() / tension, step[3].abs() / state.length);
        // no step turns the force around or makes the length negative
        let fraction = f64::min(1.0, LONGEST_STEP / relative);
        self.step = step.map(|entry| fraction * entry);
        // once the gap is down to rounding, one more step is enough, however long rounding makes it
        let size = if self.at.size < ROUNDING * self.search.chord.free_length { 0.0 } else { fraction * relative };
        Step::whole(size, relative.is_finite() && self.search.steps < self.most)
    }

    fn evaluate(&mut self, fraction: f64, _: bool) -> Trial<f64> {
        if self.at.size < f64::INFINITY {
            self.trial = self.search.tried(moved(&self.at.state, &self.step, fraction), self.known);
        }
        Trial::new(1.0, self.trial.size < self.at.size)
    }

    fn accept(&mut self, helps: bool, _: f64) {
        if helps {
            self.at = self.trial;
        }
    }

    fn rests(&mut self, _: f64, _: f64) -> bool {
        self.at.size < ROUNDING * self.search.chord.free_length
    }
}

impl CableSearch<'_> {
    fn tried(&mut self, state: SpanState<f64>, known: CableInput) -> Tried {
        self.steps += 1;
        let evaluation = self.law.evaluate(self.shape, &state, self.chord.side);
        let gap = self.gap(&evaluation, &state, known);
        Tried { state, evaluation, gap, size: self.size(&gap, known) }
    }

    fn gap(&self, evaluation: &Evaluation, state: &SpanState<f64>, known: CableInput) -> [f64; 4] {
        let [x, y, z] = sub(evaluation.end, self.platform_anchor);
        let last = match known {
            CableInput::ControlledLength(length) => evaluation.controlled_length - length,
            CableInput::OutletTension(tension) | CableInput::PlatformTension(tension) => {
                self.known_tension(state, known) - tension
            }
        };
        [x, y, z, last]
    }

    /// Tension at the end where `known` gives it: at the platform anchor, else at the outlet (N).
    pub(super) fn known_tension(&self, state: &SpanState<f64>, known: CableInput) -> f64 {
        let force = match known {
            CableInput::PlatformTension(_) => sub(state.force, scale(state.length, self.law.weight)),
            _ => state.force,
        };
        dot(force, force).sqrt()
    }

    /// Derivatives of the four equations by the state (F, L), by rows.
    fn rows(&self, evaluation: &Evaluation, state: &SpanState<f64>, known: CableInput) -> Matrix4 {
        let mut rows = evaluation.by_state;
        let unit = |force: [f64; 3]| scale(1.0 / dot(force, force).sqrt(), force);
        match known {
            CableInput::ControlledLength(_) => {}
            CableInput::OutletTension(_) => {
                let [x, y, z] = unit(state.force);
                rows.0[3] = [x, y, z, 0.0];
            }
            CableInput::PlatformTension(_) => {
                let t = unit(evaluation.end_force);
                rows.0[3] = [t[0], t[1], t[2], -dot(t, self.law.weight)];
            }
        }
        rows
    }

    /// Norm of the gap (m); the gap of a tension counts as a fraction of that tension, times the free length.
    fn size(&self, gap: &[f64; 4], known: CableInput) -> f64 {
        let last = match known {
            CableInput::ControlledLength(_) => gap[3],
            CableInput::OutletTension(tension) | CableInput::PlatformTension(tension) => {
                gap[3] / tension * self.chord.free_length
            }
        };
        (gap[0] * gap[0] + gap[1] * gap[1] + gap[2] * gap[2] + last * last).sqrt()
    }

    /// State that solves the equations, sought from `start`; if there is none, the error is the size of the gap that is
    /// left (m).
    pub(super) fn newton(&mut self, known: CableInput, start: SpanState<f64>) -> Result<SpanState<f64>, f64> {
        let most = MAX_STEPS.min(self.steps + MAX_NEWTON_STEPS);
        let rules = Rules {
            tolerance: TOLERANCE,
            max_iterations: MAX_NEWTON_STEPS,
            least_gain: 0.0,
            rule: StepRule::Shortening,
        };
        let at = self.tried(start, known);
        let from = Tried { size: f64::INFINITY, ..at };
        let mut newton = Newton { search: self, known, at: from, trial: at, step: [0.0; 4], is_slacker: false, most };
        let end = descend(&mut newton, &rules);
        match end.stop() == Stop::Stationary && !newton.is_slacker {
            true => Ok(newton.at.state),
            false => Err(newton.at.size),
        }
    }
}

fn moved(state: &SpanState<f64>, step: &[f64; 4], step_fraction: f64) -> SpanState<f64> {
    SpanState {
        force: [0, 1, 2].map(|k| state.force[k] + step_fraction * step[k]),
        length: state.length + step_fraction * step[3],
    }
}
