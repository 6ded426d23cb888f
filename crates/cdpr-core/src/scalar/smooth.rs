//! Numbers to which a smooth function of one variable can be applied.

use super::Real;

/// A number with a value and, for dual numbers, derivatives that follow the chain rule.
///
/// Functions that are computed for plain numbers together with their derivative serve every such type: series, inverses
/// found by iteration, tables.
pub trait Smooth: Real {
    /// The plain number.
    fn value(self) -> f64;

    /// f(self) for a function that has this value and this derivative there.
    fn chain(self, value: f64, derivative: f64) -> Self;
}

impl Smooth for f64 {
    #[inline]
    fn value(self) -> f64 {
        self
    }

    #[inline]
    fn chain(self, value: f64, _derivative: f64) -> Self {
        value
    }
}
