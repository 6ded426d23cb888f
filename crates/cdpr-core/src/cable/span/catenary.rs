//! Elastic catenary, exact.
//!
//! The chord of τ from τ₀ = F to τ₁ = F − p L has the length |p| L, so with a = |τ₀|, b = |τ₁|, σ = a + b and
//! y = (|p| L/σ)² the integral of τ/|τ| is
//!
//! (2L/σ) \[F − ½ p L + ψ(y) (L/σ)² (F (p·p) − p (F·p))\], ψ(y) = (atanh(√y)/√y − 1)/y = 1/3 + y/5 + y²/7 + …
//!
//! This is Irvine's solution (Cable Structures, 1981, ch. 1; Miermeister 2021, sec. 2.3) without its differences of
//! nearly equal logarithms: it holds at any inclination, upright too, and for p = 0.

#[cfg(not(feature = "std"))]
use num_traits::Float as _;

use super::stretched::{along_chord, along_chord_derivative};
use super::{Change, SpanState};
use crate::cable::stretch::Stretch;
use crate::scalar::{Smooth, add, dot, scale, sub};

pub(super) fn vector<T: Smooth>(state: &SpanState<T>, weight: [T; 3], stretch: &Stretch) -> [T; 3] {
    let (force, length) = (state.force, state.length);
    let parts = Parts::new(force, length, weight);
    let psi_value = psi(parts.y.value());
    let psi = parts.y.chain(psi_value.0, psi_value.1);
    let inner = add(parts.middle, scale(psi * parts.ratio * parts.ratio, parts.across));
    let unstretched = scale(parts.ratio + parts.ratio, inner);
    add(unstretched, along_chord(force, length, weight, stretch))
}

/// S and its derivatives along changes of state and weight; shared terms are computed once.
#[inline]
pub(super) fn with_derivatives<const N: usize>(
    state: &SpanState<f64>,
    weight: [f64; 3],
    stretch: &Stretch,
    changes: &[Change; N],
) -> ([f64; 3], [[f64; 3]; N]) {
    let parts = Parts::new(state.force, state.length, weight);
    let psi = psi(parts.y);
    let inner = add(parts.middle, scale(psi.0 * parts.ratio * parts.ratio, parts.across));
    let hanging = Hanging { state, weight, parts, psi, inner };
    let vector = add(scale(2.0 * hanging.parts.ratio, inner), along_chord(state.force, state.length, weight, stretch));
    let derivatives = core::array::from_fn(|index| {
        let change = &changes[index];
        add(hanging.derivative(change), along_chord_derivative(state, weight, stretch, change))
    });
    (vector, derivatives)
}

/// A span with all terms that its derivatives share.
struct Hanging<'a> {
    state: &'a SpanState<f64>,
    weight: [f64; 3],
    parts: Parts<f64>,
    /// ψ and its derivative by y.
    psi: (f64, f64),
    /// F − ½ p L + ψ (L/σ)² (F (p·p) − p (F·p)) (N): the span without stretch is 2 L/σ times this.
    inner: [f64; 3],
}

impl Hanging<'_> {
    /// Derivative of the part of S without stretch.
    #[inline]
    fn derivative(&self, change: &Change) -> [f64; 3] {
        let (force, length, weight) = (self.state.force, self.state.length, self.weight);
        let Parts { ratio, across, sum, .. } = self.parts;
        let (psi, psi_slope) = self.psi;
        // changes of τ₁, σ, L/σ, p·p, y, F (p·p) − p (F·p) and ½ (τ₀ + τ₁)
        let d_end = sub(sub(change.force, scale(change.length, weight)), scale(length, change.weight));
        let d_start = dot(force, change.force) / self.parts.start_tension;
        let d_sum = d_start + dot(self.parts.end, d_end) / self.parts.end_tension;
        let d_ratio = (change.length - ratio * d_sum) / sum;
        let d_square = 2.0 * dot(weight, change.weight);
        let square = dot(weight, weight);
        let d_y = d_square * ratio * ratio + 2.0 * square * ratio * d_ratio;
        let along = dot(force, weight);
        let d_along = dot(change.force, weight) + dot(force, change.weight);
        let d_across = sub(
            add(scale(square, change.force), scale(d_square, force)),
            add(scale(along, change.weight), scale(d_along, weight)),
        );
        let d_middle = scale(0.5, add(change.force, d_end));
        let d_factor = psi_slope * d_y * ratio * ratio + 2.0 * psi * ratio * d_ratio;
        let d_inner = add(d_middle, add(scale(d_factor, across), scale(psi * ratio * ratio, d_across)));
        add(scale(2.0 * d_ratio, self.inner), scale(2.0 * ratio, d_inner))
    }
}

/// Terms that values and derivatives share, with F the force at the start (N), p the weight (N/m) and L the length (m).
struct Parts<T> {
    end: [T; 3],
    start_tension: T,
    end_tension: T,
    /// σ.
    sum: T,
    /// L/σ.
    ratio: T,
    y: T,
    /// F (p·p) − p (F·p).
    across: [T; 3],
    /// F − ½ p L.
    middle: [T; 3],
}

impl<T: Smooth> Parts<T> {
    #[inline]
    fn new(force: [T; 3], length: T, weight: [T; 3]) -> Self {
        let end = sub(force, scale(length, weight));
        let (start_tension, end_tension) = (dot(force, force).sqrt(), dot(end, end).sqrt());
        let sum = start_tension + end_tension;
        let ratio = length / sum;
        let square = dot(weight, weight);
        let across = sub(scale(square, force), scale(dot(force, weight), weight));
        let middle = scale(length.constant(0.5), add(force, end));
        Self { end, start_tension, end_tension, sum, ratio, y: square * ratio * ratio, across, middle }
    }
}

/// ψ and its derivative for 0 ≤ y < 1.
fn psi(y: f64) -> (f64, f64) {
    if y < 0.04 {
        // eleven terms: the next is below 1e-16 of the first
        let mut value = 0.0;
        let mut slope = 0.0;
        for k in (0..12).rev() {
            slope = slope * y + value;
            value = value * y + 1.0 / f64::from(2 * k + 3);
        }
        return (value, slope);
    }
    let x = y.sqrt();
    let phi = x.atanh() / x;
    let value = (phi - 1.0) / y;
    let phi_slope = (1.0 / (1.0 - y) - phi) / (2.0 * y);
    (value, (phi_slope - value) / y)
}

#[cfg(test)]
mod tests {
    use super::psi;

    #[test]
    fn both_forms_of_psi_meet_where_they_change() {
        let (below, above) = (psi(0.04 - 1e-12), psi(0.04 + 1e-12));
        // (φ − 1)/y loses two digits at y = 0.04, its derivative three
        assert!((below.0 - above.0).abs() < 1e-12 && (below.1 - above.1).abs() < 1e-11, "{below:?} {above:?}");
    }

    #[test]
    fn the_slope_of_psi_is_its_derivative() {
        for y in [1e-9, 1e-3, 0.03, 0.05, 0.3, 0.9] {
            let h = 1e-6 * f64::max(y, 1e-3);
            let slope = (psi(y + h).0 - psi(y - h).0) / (2.0 * h);
            assert!((slope / psi(y).1 - 1.0).abs() < 1e-6, "{y}");
        }
    }
}
