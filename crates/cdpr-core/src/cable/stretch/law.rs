//! Laws of stretch: the trait that every law implements, the questions that are put to the law of a cable, and the two
//! laws without a file of their own.

use super::hysteresis::Memory;

/// Tension below which ε(T)/T is taken as its limit (N).
const TINY_TENSION: f64 = 1e-9;

/// A law of stretch of a piece of cable.
pub(super) trait Law {
    /// True when the strain at a point of the cable follows from the tension there, and not linearly.
    const IS_POINTWISE: bool;

    /// ε(T) and ∂ε/∂T (1/N).
    fn strain(&self, tension: f64) -> (f64, f64);

    /// T(ε) and ∂T/∂ε (N), from the given memory, else from that of the law; `None` for cables that keep their length.
    fn tension(&self, strain: f64, memory: Option<&Memory>) -> Option<(f64, f64)>;

    /// ε(T)/T (1/N) and its derivative.
    #[inline]
    fn secant_compliance(&self, tension: f64) -> (f64, f64) {
        if tension < TINY_TENSION {
            return (self.strain(0.0).1, 0.0);
        }
        let (strain, slope) = self.strain(tension);
        let secant = strain / tension;
        (secant, (slope - secant) / tension)
    }

    /// ∂ε/∂p at fixed tension by the law's parameter with index `number`, counted from 0; 0 if the law has no such
    /// parameter.
    #[inline]
    fn strain_by_number(&self, _tension: f64, _number: usize) -> f64 {
        0.0
    }
}

/// A question that every law answers.
pub(super) trait Question {
    type Answer;

    fn put<L: Law>(self, law: &L) -> Self::Answer;
}

/// [`Law::strain`].
pub(super) struct Strain(pub(super) f64);

impl Question for Strain {
    type Answer = (f64, f64);

    #[inline]
    fn put<L: Law>(self, law: &L) -> (f64, f64) {
        law.strain(self.0)
    }
}

/// [`Law::tension`].
pub(super) struct Tension<'m>(pub(super) f64, pub(super) Option<&'m Memory>);

impl Question for Tension<'_> {
    type Answer = Option<(f64, f64)>;

    #[inline]
    fn put<L: Law>(self, law: &L) -> Option<(f64, f64)> {
        law.tension(self.0, self.1)
    }
}

/// [`Law::secant_compliance`].
pub(super) struct SecantCompliance(pub(super) f64);

impl Question for SecantCompliance {
    type Answer = (f64, f64);

    #[inline]
    fn put<L: Law>(self, law: &L) -> (f64, f64) {
        law.secant_compliance(self.0)
    }
}

/// [`Law::strain_by_number`].
pub(super) struct StrainByNumber(pub(super) f64, pub(super) usize);

impl Question for StrainByNumber {
    type Answer = f64;

    #[inline]
    fn put<L: Law>(self, law: &L) -> f64 {
        law.strain_by_number(self.0, self.1)
    }
}

/// [`Law::IS_POINTWISE`].
pub(super) struct IsPointwise;

impl Question for IsPointwise {
    type Answer = bool;

    #[inline]
    fn put<L: Law>(self, _: &L) -> bool {
        L::IS_POINTWISE
    }
}

/// Cables that keep their length.
pub(super) struct Inextensible;

impl Law for Inextensible {
    const IS_POINTWISE: bool = false;

    #[inline]
    fn strain(&self, _: f64) -> (f64, f64) {
        (0.0, 0.0)
    }

    #[inline]
    fn tension(&self, _: f64, _: Option<&Memory>) -> Option<(f64, f64)> {
        None
    }

    #[inline]
    fn secant_compliance(&self, _: f64) -> (f64, f64) {
        (0.0, 0.0)
    }
}

/// ε = κ T, with κ (1/N).
pub(super) struct Proportional(pub(super) f64);

impl Law for Proportional {
    const IS_POINTWISE: bool = false;

    #[inline]
    fn strain(&self, tension: f64) -> (f64, f64) {
        (self.0 * tension, self.0)
    }

    #[inline]
    fn tension(&self, strain: f64, _: Option<&Memory>) -> Option<(f64, f64)> {
        (self.0 != 0.0).then(|| (strain / self.0, 1.0 / self.0))
    }

    #[inline]
    fn secant_compliance(&self, _: f64) -> (f64, f64) {
        (self.0, 0.0)
    }
}
