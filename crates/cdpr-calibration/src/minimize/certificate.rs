//! Proof that a largest norm is the least.

/// Samples whose norms no change of the parameters makes smaller together.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// The largest norm.
    pub largest: f64,
    /// Samples (from 1) that have it, with their multipliers, which sum to one over all samples.
    pub active: Vec<ActiveSample>,
    /// ‖Σ λ ∂‖r‖²/∂p‖/Σ λ ‖∂‖r‖²/∂p‖: 0 where nothing makes all of them smaller to first order.
    pub subgradient: f64,
    /// Bound of what the largest norm lies above the least near here, relative; not a number where the search did not end there.
    pub gap: f64,
}

/// A sample that holds the largest norm up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ActiveSample {
    /// Number of the sample, from 1.
    pub sample: usize,
    /// λ.
    pub multiplier: f64,
}

impl Certificate {
    /// The same with the largest norm in metres, of rows whose unit is so many.
    pub(crate) fn in_metres(self, unit: Option<f64>) -> Self {
        Self { largest: self.largest * unit.unwrap_or(1.0), ..self }
    }
}
