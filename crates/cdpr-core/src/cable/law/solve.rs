//! The state of a cable with weight, sought from several starts, with its derivatives.

#[cfg(not(feature = "std"))]
use num_traits::Float as _;

use super::CableLaw;
use super::sagging::Evaluation;
use crate::cable::path::CablePath;
use crate::cable::span::{Shape, SpanState};
use crate::cable::state::{CableInput, CableState, CableStateError};
use crate::cable::wrench::CableEnd;
use crate::scalar::{add, dot, scale, sub};

/// Number of states of one cable after which no further search begins: a tension too low for the cable's weight takes
/// some hundreds to refuse.
pub(super) const MAX_STEPS: u32 = 2500;
/// Number of states that one run of Newton's method tries before it gives up; successful runs mostly take fewer than
/// ten.
pub(super) const MAX_NEWTON_STEPS: u32 = 400;
/// The straight cable in place of the span: its direction from the outlet and its lengths.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chord {
    /// From the outlet to the platform anchor, unit vector.
    pub(super) away: [f64; 3],
    /// Distance from the outlet (m).
    pub(super) free_length: f64,
    /// Length from the frame anchor, wrapped part included (m).
    pub(super) length: f64,
    /// 1 or −1, see [`crate::cable::outlet::bent::Pulley`].
    pub(super) side: f64,
}

impl CableLaw {
    /// Chord of a straight cable with this path; `NoCourse` if the path is not finite or has no free part.
    pub(super) fn chord(path: &CablePath<f64>) -> Result<Chord, CableStateError> {
        if !(path.length.is_finite() && path.free_length > 0.0) {
            return Err(CableStateError::NoCourse);
        }
        let side = if path.wrap_angle > core::f64::consts::PI { -1.0 } else { 1.0 };
        let away = scale(-1.0, path.direction);
        Ok(Chord { away, free_length: path.free_length, length: path.length, side })
    }

    /// Solves for the state of a cable with weight.
    pub(super) fn sagging_state(
        &self,
        shape: Shape,
        path: &CablePath<f64>,
        end: &CableEnd<f64>,
        known: CableInput,
        guess: Option<SpanState<f64>>,
    ) -> Result<CableState, CableStateError> {
        let chord = Self::chord(path)?;
        self.refuse_impossible(&chord, known)?;
        let mut search = CableSearch { law: self, shape, platform_anchor: end.anchor, chord, steps: 0 };
        let first = guess.unwrap_or_else(|| search.start(known));
        let found = match search.newton(known, first) {
            Err(_) if guess.is_some() => search.newton(known, search.start(known)),
            other => other,
        };
        let state = match found {
            Ok(state) => state,
            Err(gap) => search.by_length(known, gap)?,
        };
        let evaluation = self.evaluate(shape, &state, chord.side);
        let is_given_at_platform = matches!(known, CableInput::PlatformTension(_));
        Ok(CableState { is_given_at_platform, ..self.state_of(&state, &evaluation, end) })
    }

    fn refuse_impossible(&self, chord: &Chord, known: CableInput) -> Result<(), CableStateError> {
        match known {
            CableInput::ControlledLength(controlled_length)
                if self.stretch.is_rigid() && self.series_compliance == 0.0 && !(controlled_length > chord.length) =>
            {
                Err(CableStateError::TooShort { controlled_length, least: chord.length })
            }
            CableInput::OutletTension(tension) | CableInput::PlatformTension(tension) if !(tension > 0.0) => {
                Err(CableStateError::TensionTooLow { tension, least: 0.0 })
            }
            _ => Ok(()),
        }
    }

    /// State of a cable, with derivatives, from a span that obeys the equations.
    pub(super) fn state_of(&self, state: &SpanState<f64>, evaluation: &Evaluation, end: &CableEnd<f64>) -> CableState {
        let tension = dot(state.force, state.force).sqrt();
        let t = scale(1.0 / tension, state.force);
        let platform_tension = dot(evaluation.end_force, evaluation.end_force).sqrt();
        let pull = scale(-1.0, evaluation.end_force);
        // at fixed q_θ: δ(F, L) for δp_B along the axes, and for δq_θ
        let mut right = [[0.0; 4]; 4];
        (0..4).for_each(|k| right[k][k] = 1.0);
        let fixed = evaluation.by_state.solve(right);
        let pull_change = |column: usize, by: &[[f64; 4]; 4]| -> [f64; 3] {
            core::array::from_fn(|row| self.weight[row] * by[3][column] - by[row][column])
        };
        let tangent = |by: &[[f64; 4]; 4]| {
            let columns = [0, 1, 2].map(|column| pull_change(column, by));
            [0, 1, 2].map(|row| [0, 1, 2].map(|column: usize| columns[column][row]))
        };
        // at fixed |F|: the last row is t·δF
        let mut rows = evaluation.by_state;
        let length_row = rows.0[3];
        rows.0[3] = [t[0], t[1], t[2], 0.0];
        let held = rows.solve(right);
        let controlled_change = |column: usize| -> f64 { (0..4).map(|row| length_row[row] * held[row][column]).sum() };
        let strained = self.strained_length(state, evaluation);
        CableState {
            end: *end,
            recording: self.recording,
            is_given_at_platform: false,
            span: *state,
            controlled_length: evaluation.controlled_length,
            pull,
            direction: scale(1.0 / platform_tension, pull),
            outlet_tension: tension,
            platform_tension,
            wrap_angle: evaluation.wrap_angle,
            strained_length: strained,
            tangent: tangent(&fixed),
            tangent_at_tension: tangent(&held),
            by_controlled_length: pull_change(3, &fixed),
            by_tension: pull_change(3, &held),
            controlled_length_by_tension: controlled_change(3),
            controlled_length_by_anchor: [0, 1, 2].map(controlled_change),
        }
    }

    /// Strained length from the frame anchor: the wrapped part, and the free part at its mean strain (m).
    fn strained_length(&self, state: &SpanState<f64>, evaluation: &Evaluation) -> f64 {
        let middle = sub(state.force, scale(0.5 * state.length, self.weight));
        let (strain, _) = self.stretch.strain(dot(middle, middle).sqrt());
        let wrapped = self.outlet.pulley().map_or(0.0, |(_, radius)| radius * evaluation.wrap_angle);
        wrapped + state.length * (1.0 + strain)
    }
}

/// A search for the state of one cable: its law, its end and the straight line between both ends.
pub(super) struct CableSearch<'a> {
    pub(super) law: &'a CableLaw,
    pub(super) shape: Shape,
    pub(super) platform_anchor: [f64; 3],
    pub(super) chord: Chord,
    /// Number of states tried.
    pub(super) steps: u32,
}

impl CableSearch<'_> {
    fn not_found(&self, gap: f64) -> CableStateError {
        CableStateError::NotConverged { iterations: self.steps, gap }
    }

    /// First guess of the state sought.
    fn start(&self, known: CableInput) -> SpanState<f64> {
        match known {
            CableInput::OutletTension(tension) => self.taut(tension, 0.5),
            CableInput::PlatformTension(tension) => self.taut(tension, -0.5),
            CableInput::ControlledLength(length) => self.of_length(length),
        }
    }

    /// A taut cable as a parabola: its force turns evenly about the force in the middle, which points along the chord;
    /// the given tension acts at the fraction `end` of the length before the middle.
    fn taut(&self, tension: f64, end: f64) -> SpanState<f64> {
        let length = self.chord.free_length / (1.0 + self.law.stretch.strain(tension).0);
        let half = scale(end * length, self.law.weight);
        let along = dot(self.chord.away, half);
        let square = along * along + tension * tension - dot(half, half);
        let middle = if square > 0.0 { square.sqrt() - along } else { 0.0 };
        let middle = middle.max(0.1 * tension);
        let force = add(scale(middle, self.chord.away), scale(0.5 * length, self.law.weight));
        SpanState { force, length }
    }

    /// A cable of given controlled length (m): a taut one by its stretch, a slack one by the catenary of that length.
    fn of_length(&self, controlled_length: f64) -> SpanState<f64> {
        let law = self.law;
        let chord = &self.chord;
        let free = (controlled_length - (chord.length - chord.free_length)).max(0.05 * chord.free_length);
        let span = scale(chord.free_length, chord.away);
        let weight = dot(law.weight, law.weight).sqrt();
        let unit = if weight > 0.0 { scale(1.0 / weight, law.weight) } else { [0.0; 3] };
        let drop = dot(span, unit);
        let across = sub(span, scale(drop, unit));
        let width = dot(across, across).sqrt();
        let total_weight = weight * free;
        // compliance of the whole cable at rest (m/N)
        let (_, specific) = law.stretch.strain(0.0);
        let compliance =
            specific * (free + law.hidden_length + chord.length - chord.free_length) + law.series_compliance;
        // taut: free (1 + κ T) − (weight across the chord)² L³/(24 T²) = chord
        let lateral = total_weight * width / chord.free_length;
        let stretch = |tension: f64| {
            free + compliance * tension - lateral * lateral * free / (24.0 * tension * tension) - chord.free_length
        };
        let mut tension = f64::max(lateral, total_weight);
        if tension == 0.0 {
            tension = f64::max((chord.free_length - free) / compliance.max(1e-12), 1e-3);
            return SpanState { force: scale(tension, chord.away), length: free };
        }
        for _ in 0..60 {
            if stretch(tension) > 0.0 {
                break;
            }
            tension *= 2.0;
        }
        if free < 1.02 * chord.free_length {
            // the left side grows with T: bisection on the logarithm
            let mut low = 1e-3 * tension;
            let mut high = tension;
            for _ in 0..40 {
                let middle = (low * high).sqrt();
                if stretch(middle) > 0.0 { high = middle } else { low = middle }
            }
            let force = add(scale(high, chord.away), scale(0.5 * free, law.weight));
            return SpanState { force, length: free };
        }
        // slack: λ of the inextensible catenary (Jayaraman and Knudson 1981)
        let vertical = f64::min((free * free - drop * drop) / (width * width).max(1e-12), 1e8);
        let lambda = (3.0 * (vertical - 1.0)).max(1e-4).sqrt();
        let horizontal = weight * width / (2.0 * lambda);
        let hold = 0.5 * weight * (free + drop * (1.0 / lambda.tanh()));
        let direction = if width > 0.0 { scale(1.0 / width, across) } else { [0.0; 3] };
        SpanState { force: add(scale(horizontal.max(1e-9 * total_weight), direction), scale(hold, unit)), length: free }
    }

    /// The tension where `known` gives it (N) and the state for a controlled length (m); `None` if no shape was found.
    fn of_known_length(&mut self, length: f64, known: CableInput) -> Option<(f64, SpanState<f64>)> {
        let state = self.newton(CableInput::ControlledLength(length), self.of_length(length)).ok()?;
        Some((self.known_tension(&state, known), state))
    }

    /// Finds a tension through the controlled length, since every length has a state: bisection on taut lengths, down
    /// to the length of least tension. `gap` is the gap that Newton's method left (m).
    fn by_length(&mut self, known: CableInput, gap: f64) -> Result<SpanState<f64>, CableStateError> {
        let (CableInput::OutletTension(wanted) | CableInput::PlatformTension(wanted)) = known else {
            return Err(self.not_found(gap));
        };
        let least_length = match self.law.stretch.is_rigid() {
            true => self.chord.length * (1.0 + 1e-9),
            false => self.chord.length * 0.5,
        };
        let mut long = self.length_of_least_tension(known, least_length, 4.0 * self.chord.length);
        let Some((least, mut best)) = self.of_known_length(long, known) else { return Err(self.not_found(gap)) };
        if wanted < least * (1.0 - 1e-12) {
            return Err(CableStateError::TensionTooLow { tension: wanted, least });
        }
        let mut short = least_length;
        loop {
            let middle = 0.5 * (short + long);
            if !(short < middle && middle < long) {
                break;
            }
            match self.of_known_length(middle, known) {
                Some((tension, state)) if tension <= wanted => (long, best) = (middle, state),
                _ => short = middle,
            }
        }
        match self.newton(known, best) {
            Ok(state) => Ok(state),
            // at the least tension itself Newton's equations are singular
            Err(_) if (self.known_tension(&best, known) / wanted - 1.0).abs() < 1e-9 => Ok(best),
            Err(_) => Err(self.not_found(gap)),
        }
    }

    /// Controlled length of least tension (m), by golden sections: tension falls with the length, then grows with the
    /// hanging weight.
    fn length_of_least_tension(&mut self, known: CableInput, mut low: f64, mut high: f64) -> f64 {
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        let mut tension = |length| self.of_known_length(length, known).map_or(f64::INFINITY, |found| found.0);
        let (mut a, mut b) = (high - golden * (high - low), low + golden * (high - low));
        let (mut at_a, mut at_b) = (tension(a), tension(b));
        for _ in 0..60 {
            if at_a < at_b {
                (b, at_b, high) = (a, at_a, b);
                a = high - golden * (high - low);
                at_a = tension(a);
            } else {
                (a, at_a, low) = (b, at_b, a);
                b = low + golden * (high - low);
                at_b = tension(b);
            }
        }
        0.5 * (low + high)
    }
}
