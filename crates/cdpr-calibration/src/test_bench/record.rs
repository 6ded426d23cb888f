//! Records of a test bench.

/// Elongation against tension of one cable, in the order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// Elongations from any zero (m).
    pub elongations: Vec<f64>,
    /// Tensions, pull positive (N).
    pub tensions: Vec<f64>,
    /// Above zero while the elongation grows, below while it shrinks, zero at rest.
    pub directions: Option<Vec<f64>>,
}
