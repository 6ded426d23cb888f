//! The free part of a cable with weight: the vector between its ends.
//!
//! A span hangs from the outlet C with the force F (N) pulling at C, and has the unstrained length L (m). With the
//! weight p per unstrained length (N/m, a vector along gravity) the force at the unstrained distance s from C is
//! τ(s) = F − p s, and its end lies at C + S,
//!
//! S = ∫₀ᴸ (1 + ε(|τ|)) τ/|τ| ds.
//!
//! The state (F, L) determines everything: S, the pull −τ(L) on the platform and both end tensions. It is not singular
//! for p → 0, where the span becomes the straight line S = L (1 + ε) F/|F|. The tension at one end would not do as a
//! state, since two lengths have the same tension.

mod catenary;
mod finite_elements;
mod state;
mod stretched;

pub use state::{Change, SpanState};

use super::stretch::Stretch;
use crate::scalar::Smooth;

/// Model of a span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// The exact integral: an elastic catenary (Irvine 1981).
    Catenary,
    /// This many straight elements with half of their weight at either end.
    FiniteElements(usize),
}

impl Shape {
    /// S for weight p per unstrained length (N/m).
    #[inline]
    pub fn vector<T: Smooth>(self, state: &SpanState<T>, weight: [T; 3], stretch: &Stretch) -> [T; 3] {
        match self {
            Self::Catenary => catenary::vector(state, weight, stretch),
            Self::FiniteElements(count) => finite_elements::vector(state, weight, stretch, count),
        }
    }

    /// S and its derivatives along changes of state and weight.
    #[inline]
    pub fn with_derivatives<const N: usize>(
        self,
        state: &SpanState<f64>,
        weight: [f64; 3],
        stretch: &Stretch,
        changes: &[Change; N],
    ) -> ([f64; 3], [[f64; 3]; N]) {
        match self {
            Self::Catenary => catenary::with_derivatives(state, weight, stretch, changes),
            Self::FiniteElements(count) => finite_elements::with_derivatives(state, weight, stretch, count, changes),
        }
    }

    /// ∂S/∂p at a fixed state by a number of the law of stretch, counted from 0.
    pub fn by_stretch_number(
        self,
        state: &SpanState<f64>,
        weight: [f64; 3],
        stretch: &Stretch,
        number: usize,
    ) -> [f64; 3] {
        let change = |tension| stretch.strain_by_number(tension, number);
        match self {
            Self::Catenary => stretched::by_number(stretched::nodes(stretch).iter().copied(), state, weight, change),
            Self::FiniteElements(count) => {
                let nodes = (0..count).map(|element| finite_elements::node(element, count));
                stretched::by_number(nodes, state, weight, change)
            }
        }
    }
}
