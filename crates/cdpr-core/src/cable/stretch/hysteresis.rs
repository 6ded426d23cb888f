//! Hysteresis: a loading and an unloading branch, and a memory that leads from one to the other.
//!
//! Strands rub on each other, so a rope returns less energy than it took: at the same strain the tension is higher
//! while it grows (dissertation, sec. 5.1 and Fig. 5.7). With the branches up(ε) ≥ down(ε) the law is
//!
//! f = ½(up + down) + ½(up − down)·S,  S = Σ wⱼ Sⱼ ∈ \[−1, 1\],  Σ wⱼ = 1.
//!
//! The Sⱼ are stop operators, Sⱼ ← clamp(Sⱼ + Δε/rⱼ, −1, 1): S = 1 on the loading branch, S = −1 on the unloading
//! branch, and after a reversal the fraction wⱼ of the way to the other branch is covered within the strain 2 rⱼ.
//! Stop operators are a memory of the Prandtl–Ishlinskii kind, hence of Preisach's (Brokate and Sprekels 1996, ch. 2).
//! They replace the Bouc–Wen equation because with them
//!
//! * a minor loop closes, and a larger loop erases it: cables work in small cycles, and the state must not drift;
//! * ∂f/∂ε = ½(1 + S) up′ + ½(1 − S) down′ + ½(up − down) S′ > 0 always, so that the law has an inverse;
//! * a closed cycle loses energy or none, never gains: on return to a strain, S is never above its earlier value;
//! * nothing is integrated: the state after a monotone motion is a formula of its end point.
//!
//! If both branches come together, the memory affects neither the tension nor its derivative.

mod motion;

pub use motion::{MemoryChange, Motion};

use super::Table;
use super::inverse::strain_of_tension;
use crate::scalar::Select;

/// Most stop operators of one law.
pub const TRANSITION_LIMIT: usize = 8;

/// Memory of a cable: its strain and the states Sⱼ of the stop operators at that strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory {
    /// Strain of the cable.
    pub strain: f64,
    /// States Sⱼ in \[−1, 1\]; those beyond the law's transitions have no effect.
    pub stops: [f64; TRANSITION_LIMIT],
}

impl Memory {
    /// A cable that has never been stretched: unstrained, halfway between the branches.
    pub const fn virgin() -> Self {
        Self { strain: 0.0, stops: [0.0; TRANSITION_LIMIT] }
    }

    /// A cable that was stretched from far below to this strain.
    pub const fn on_loading_branch(strain: f64) -> Self {
        Self { strain, stops: [1.0; TRANSITION_LIMIT] }
    }

    /// A cable that was relaxed from far above to this strain.
    pub const fn on_unloading_branch(strain: f64) -> Self {
        Self { strain, stops: [-1.0; TRANSITION_LIMIT] }
    }
}

/// Half sum and half difference of the branches over one piece: cubics of the strain from its start, with coefficients
/// from the constant upwards (N).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Strain at which the piece begins.
    pub start: f64,
    /// ½(up + down).
    pub middle: [f64; 4],
    /// ½(up − down).
    pub half: [f64; 4],
}

/// One stop operator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StopOperator {
    /// 1/rⱼ, change of the operator's state per strain.
    pub rate: f64,
    /// wⱼ; the weights add up to 1.
    pub weight: f64,
}

/// Half sum and half difference of the branches with their slopes (N).
#[derive(Clone, Copy)]
struct Branches<T> {
    middle: T,
    middle_slope: T,
    half: T,
    half_slope: T,
}

/// Law of two branches and their stop operators.
///
/// Below strain 0 the cable is linear without hysteresis. Beyond the last knot the half sum continues along its
/// tangent; the half difference grows linearly if it grew there, or decays without changing sign if it shrank.
#[derive(Clone, Debug, PartialEq)]
pub struct Hysteresis {
    pieces: Table<Piece>,
    end: f64,
    /// Growth of the half difference per strain beyond the end (N).
    widening: f64,
    /// Relative rate at which the half difference beyond the end decays, 1/(strain at which it has halved).
    narrowing: f64,
    /// Stop operators in use.
    stops: Table<StopOperator>,
}

impl Hysteresis {
    /// The law of these pieces, one after the other from strain 0, with `last_width` the strain width of the last
    /// piece. The branches must rise, with the loading branch on top; this is checked where files are read, not here.
    /// `None` without a piece or with more than [`TRANSITION_LIMIT`] stop operators.
    #[inline]
    pub fn new(pieces: Table<Piece>, last_width: f64, stops: Table<StopOperator>) -> Option<Self> {
        let last = pieces.last().filter(|_| stops.len() <= TRANSITION_LIMIT)?;
        let end = last.start + last_width;
        let (half, slope) = cubic(&last.half, last_width);
        let narrowing = if half > 0.0 { (-slope).max(0.0) / half } else { 0.0 };
        Some(Self { end, widening: slope.max(0.0), narrowing, stops, pieces })
    }

    /// Stop operators in use.
    #[inline]
    pub fn stops(&self) -> &[StopOperator] {
        &self.stops
    }

    /// Strain of the last knot.
    #[inline]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// Tension of the loading branch (N) and its slope (N).
    pub fn loading<T: Select>(&self, strain: T) -> (T, T) {
        let branches = self.branches(strain);
        (branches.middle + branches.half, branches.middle_slope + branches.half_slope)
    }

    /// Tension of the unloading branch (N) and its slope (N).
    pub fn unloading<T: Select>(&self, strain: T) -> (T, T) {
        let branches = self.branches(strain);
        (branches.middle - branches.half, branches.middle_slope - branches.half_slope)
    }

    /// Tension f (N) after a monotone motion from the memory's strain to this one, and ∂f/∂ε (N).
    ///
    /// The derivative is discontinuous where a stop comes to rest and where the motion reverses; there it is the
    /// derivative towards larger strain.
    #[inline]
    pub fn tension<T: Select>(&self, strain: T, memory: &Memory) -> (T, T) {
        let branches = self.branches(strain);
        let (state, state_slope) = self.state(strain, memory);
        let slope = branches.middle_slope + branches.half_slope * state + branches.half * state_slope;
        (branches.middle + branches.half * state, slope)
    }

    /// Strain ε at which a tension (N) is reached from the memory, and ∂ε/∂f (1/N): the exact inverse of
    /// [`Hysteresis::tension`].
    #[inline]
    pub fn strain<T: Select>(&self, tension: T, memory: &Memory) -> (T, T) {
        let (zero, one) = (tension.constant(0.0), tension.constant(1.0));
        let at_zero = tension.constant(1.0 / self.pieces[0].middle[1]);
        let start = memory.strain.clamp(1e-3 * self.end, self.end);
        let law = |strain| self.tension(strain, memory);
        let (strain, slope) = strain_of_tension(tension.max(zero), start, 1e-15, law);
        let pushes = tension.is_less(zero);
        ((tension * at_zero).select(pushes, strain), at_zero.select(pushes, one / slope))
    }

    /// The memory after a monotone motion to this strain.
    #[inline]
    pub fn advance(&self, strain: f64, memory: &Memory) -> Memory {
        let mut stops = memory.stops;
        for (operator, stop) in self.stops.iter().zip(&mut stops) {
            *stop = (*stop + (strain - memory.strain) * operator.rate).clamp(-1.0, 1.0);
        }
        Memory { strain, stops }
    }

    /// Energy that a closed cycle between two strains loses once it repeats, per metre of unstrained cable (N = J/m).
    ///
    /// By the trapezoidal rule on `steps` equal steps each way.
    pub fn cycle_loss(&self, lower: f64, upper: f64, steps: usize) -> f64 {
        let at = |k: usize| lower + (upper - lower) * k as f64 / steps.max(1) as f64;
        // one cycle before, so that the memory has reached its repeating state
        let bottom = self.advance(lower, &self.advance(upper, &Memory::on_loading_branch(lower)));
        let top = self.advance(upper, &bottom);
        let gap = |k: usize| self.tension(at(k), &bottom).0 - self.tension(at(k), &top).0;
        (0..steps.max(1)).map(|k| 0.5 * (gap(k) + gap(k + 1)) * (at(k + 1) - at(k))).sum()
    }

    /// S and ∂S/∂ε.
    #[inline]
    fn state<T: Select>(&self, strain: T, memory: &Memory) -> (T, T) {
        let (zero, one) = (strain.constant(0.0), strain.constant(1.0));
        let moved = strain - strain.constant(memory.strain);
        let (mut state, mut slope) = (zero, zero);
        for (operator, &before) in self.stops.iter().zip(&memory.stops) {
            let (rate, fraction) = (strain.constant(operator.rate), strain.constant(operator.weight));
            let free = strain.constant(before) + moved * rate;
            let (is_below, is_inside) = (free.is_less(-one), free.is_less(one));
            state = state + fraction * (-one).select(is_below, free.select(is_inside, one));
            slope = slope + fraction * zero.select(is_below, rate.select(is_inside, zero));
        }
        (state, slope)
    }

    #[inline]
    fn branches<T: Select>(&self, strain: T) -> Branches<T> {
        let (zero, one) = (strain.constant(0.0), strain.constant(1.0));
        let inside = strain.max(zero).min(strain.constant(self.end));
        let mut found = self.pieces[0].at(inside);
        for piece in &self.pieces[1..] {
            let is_reached = strain.constant(piece.start).is_less(inside);
            if !strain.any(is_reached) {
                break;
            }
            let next = piece.at(inside);
            found = Branches {
                middle: next.middle.select(is_reached, found.middle),
                middle_slope: next.middle_slope.select(is_reached, found.middle_slope),
                half: next.half.select(is_reached, found.half),
                half_slope: next.half_slope.select(is_reached, found.half_slope),
            };
        }
        let outside = strain - inside;
        let (is_beyond, is_below) = (zero.is_less(outside), outside.is_less(zero));
        let (widening, narrowing) = (strain.constant(self.widening), strain.constant(self.narrowing));
        let shrink = one / (one + narrowing * outside.max(zero));
        let half_beyond = (found.half + widening * outside) * shrink;
        let half_slope = (widening - narrowing * half_beyond) * shrink;
        Branches {
            middle: found.middle + found.middle_slope * outside,
            middle_slope: found.middle_slope,
            half: zero.select(is_below, half_beyond.select(is_beyond, found.half)),
            half_slope: zero.select(is_below, half_slope.select(is_beyond, found.half_slope)),
        }
    }
}

impl Piece {
    #[inline]
    fn at<T: Select>(&self, strain: T) -> Branches<T> {
        let x = strain - strain.constant(self.start);
        let (middle, middle_slope) = cubic(&self.middle, x);
        let (half, half_slope) = cubic(&self.half, x);
        Branches { middle, middle_slope, half, half_slope }
    }
}

/// Value and slope of c₀ + c₁ x + c₂ x² + c₃ x³.
#[inline]
fn cubic<T: Select>(coefficients: &[f64; 4], x: T) -> (T, T) {
    let [c0, c1, c2, c3] = coefficients.map(|c| x.constant(c));
    let two = x.constant(2.0);
    let value = c0 + x * (c1 + x * (c2 + x * c3));
    (value, c1 + x * (two * c2 + x * (x.constant(3.0) * c3)))
}
