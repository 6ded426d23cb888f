//! A chain of straight elastic elements of equal unstrained length, half of each weight at either end.
//!
//! With the force F at the outlet, the force in element k of n is τ(L (k + ½)/n): the integral of the catenary by the
//! midpoint rule, whose error falls with 1/n². The weight at the first node counts into F, that at the last into the
//! pull on the platform, so that the balance of the whole span holds exactly.

#[cfg(not(feature = "std"))]
use num_traits::Float as _;

use super::stretched::{Node, at, node_derivative};
use super::{Change, SpanState};
use crate::cable::stretch::Stretch;
use crate::scalar::{Smooth, add, dot, scale};

/// The middle of an element, weighted with the element's fraction of the length.
pub(super) fn node(element: usize, count: usize) -> Node {
    let fraction = 1.0 / count as f64;
    Node { at: (element as f64 + 0.5) * fraction, weight: fraction }
}

pub(super) fn vector<T: Smooth>(state: &SpanState<T>, weight: [T; 3], stretch: &Stretch, count: usize) -> [T; 3] {
    let (force, length) = (state.force, state.length);
    let mut sum = [length.constant(0.0); 3];
    for element in 0..count {
        let node = node(element, count);
        let tau = at(force, length, weight, &node);
        let tension = dot(tau, tau).sqrt();
        let (value, slope) = factor(tension.value(), stretch);
        let fraction = tension.chain(value, slope) * length * length.constant(node.weight);
        sum = add(sum, scale(fraction, tau));
    }
    sum
}

/// S and its derivatives along changes of state and weight, in one pass over the elements.
pub(super) fn with_derivatives<const N: usize>(
    state: &SpanState<f64>,
    weight: [f64; 3],
    stretch: &Stretch,
    count: usize,
    changes: &[Change; N],
) -> ([f64; 3], [[f64; 3]; N]) {
    let (mut vector, mut derivatives) = ([0.0; 3], [[0.0; 3]; N]);
    for element in 0..count {
        let node = node(element, count);
        let tau = at(state.force, state.length, weight, &node);
        let factor = factor(dot(tau, tau).sqrt(), stretch);
        vector = add(vector, scale(factor.0 * state.length * node.weight, tau));
        for (derivative, change) in derivatives.iter_mut().zip(changes) {
            *derivative = add(*derivative, node_derivative(state, weight, &node, change, factor.0, factor.1));
        }
    }
    (vector, derivatives)
}

/// 1/T + ε(T)/T and its derivative by T.
fn factor(tension: f64, stretch: &Stretch) -> (f64, f64) {
    let (value, slope) = stretch.secant_compliance(tension);
    let inverse = 1.0 / tension;
    (value + inverse, slope - inverse * inverse)
}
