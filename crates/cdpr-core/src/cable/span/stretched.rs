//! Integrals of a function of the tension along a span, as weighted sums.

#[cfg(not(feature = "std"))]
use num_traits::Float as _;

use super::{Change, SpanState};
use crate::cable::stretch::Stretch;
use crate::scalar::{Smooth, add, dot, scale, sub};

/// A node of a sum: its position as a fraction of the length from the outlet, and its weight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) at: f64,
    pub(super) weight: f64,
}

/// Gauss–Legendre points with three nodes: exact to the fifth power along the chord.
const GAUSS: [Node; 3] = [
    Node { at: 0.112_701_665_379_258_31, weight: 5.0 / 18.0 },
    Node { at: 0.5, weight: 4.0 / 9.0 },
    Node { at: 0.887_298_334_620_741_7, weight: 5.0 / 18.0 },
];

/// The midpoint, which is exact for linear laws and the one node of laws with a memory.
const MIDDLE: [Node; 1] = [Node { at: 0.5, weight: 1.0 }];

/// Nodes of the sum along a whole span.
pub(super) fn nodes(stretch: &Stretch) -> &'static [Node] {
    match stretch.is_pointwise() {
        true => &GAUSS,
        false => &MIDDLE,
    }
}

/// ∫ ε(|τ|) τ/|τ| ds, the part of S that stretch adds (m).
#[inline]
pub(super) fn along_chord<T: Smooth>(force: [T; 3], length: T, weight: [T; 3], stretch: &Stretch) -> [T; 3] {
    let zero = [length.constant(0.0); 3];
    if stretch.is_rigid() {
        return zero;
    }
    nodes(stretch).iter().fold(zero, |sum, node| {
        let tau = at(force, length, weight, node);
        let fraction = secant(tau, stretch) * length * length.constant(node.weight);
        add(sum, scale(fraction, tau))
    })
}

/// Derivative of [`along_chord`].
pub(super) fn along_chord_derivative(
    state: &SpanState<f64>,
    weight: [f64; 3],
    stretch: &Stretch,
    change: &Change,
) -> [f64; 3] {
    if stretch.is_rigid() {
        return [0.0; 3];
    }
    nodes(stretch).iter().fold([0.0; 3], |sum, node| {
        let tau = at(state.force, state.length, weight, node);
        let (e, slope) = stretch.secant_compliance(dot(tau, tau).sqrt());
        add(sum, node_derivative(state, weight, node, change, e, slope))
    })
}

/// ∫ e(|τ|) τ/|τ| ds over these nodes, with e the change of the strain at a tension.
pub(super) fn by_number(
    nodes: impl Iterator<Item = Node>,
    state: &SpanState<f64>,
    weight: [f64; 3],
    strain_change: impl Fn(f64) -> f64,
) -> [f64; 3] {
    nodes.fold([0.0; 3], |sum, node| {
        let tau = at(state.force, state.length, weight, &node);
        let tension = dot(tau, tau).sqrt();
        add(sum, scale(node.weight * state.length * strain_change(tension) / tension, tau))
    })
}

/// Derivative of w L c(|τ|) τ along a change, for a factor c with this value and slope.
#[inline]
pub(super) fn node_derivative(
    state: &SpanState<f64>,
    weight: [f64; 3],
    node: &Node,
    change: &Change,
    value: f64,
    slope: f64,
) -> [f64; 3] {
    let length = state.length;
    let tau = at(state.force, length, weight, node);
    let moved = add(scale(change.length, weight), scale(length, change.weight));
    let d_tau = sub(change.force, scale(node.at, moved));
    let d_tension = dot(tau, d_tau) / dot(tau, tau).sqrt();
    let along = node.weight * (change.length * value + length * slope * d_tension);
    add(scale(along, tau), scale(node.weight * length * value, d_tau))
}

/// τ at a node (N).
#[inline]
pub(super) fn at<T: Smooth>(force: [T; 3], length: T, weight: [T; 3], node: &Node) -> [T; 3] {
    sub(force, scale(length * length.constant(node.at), weight))
}

/// ε(T)/T at a force.
#[inline]
fn secant<T: Smooth>(tau: [T; 3], stretch: &Stretch) -> T {
    let tension = dot(tau, tau).sqrt();
    let (value, slope) = stretch.secant_compliance(tension.value());
    tension.chain(value, slope)
}
