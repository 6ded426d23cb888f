//! Polynomial stiffening: f = Σ cₖ εᵏ, k from 1 (dissertation, sec. 5.1).
//!
//! Ropes of fibres stiffen as their strands settle: the stiffness at 12 kN can be ten times that at 500 N.
//! c₁ is the stiffness at zero tension (N), and with it alone the law is the linear one with E·A = c₁.

use super::Table;
use super::hysteresis::Memory;
use super::inverse::strain_of_tension;
use super::law::Law;
use crate::scalar::Select;

/// A polynomial that rises from strain 0 to its end, continued on both sides by its tangents there.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial {
    coefficients: Table<f64>,
    end: f64,
}

impl Polynomial {
    /// The law f = Σ cₖ εᵏ with `coefficients` c₁, c₂, … (N), which must rise up to the strain `end`; this is checked
    /// where files are read, not here.
    #[inline]
    pub fn rising_to(end: f64, coefficients: Table<f64>) -> Self {
        Self { coefficients, end }
    }

    /// c₁, c₂, … (N).
    #[inline]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// Strain beyond which the law is linear.
    #[inline]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// Tension f (N) at a strain and the stiffness ∂f/∂ε (N).
    #[inline]
    pub fn tension<T: Select>(&self, strain: T) -> (T, T) {
        let zero = strain.constant(0.0);
        let inside = strain.max(zero).min(strain.constant(self.end));
        let (mut sum, mut slope) = (zero, zero);
        for &c in self.coefficients.iter().rev() {
            slope = slope * inside + sum;
            sum = sum * inside + strain.constant(c);
        }
        // f = ε·sum, so ∂f/∂ε = sum + ε·∂sum/∂ε
        let slope = sum + inside * slope;
        (inside * sum + slope * (strain - inside), slope)
    }

    /// Strain ε at a tension (N) and the compliance ∂ε/∂f (1/N): the exact inverse of [`Polynomial::tension`].
    #[inline]
    pub fn strain<T: Select>(&self, tension: T) -> (T, T) {
        let (zero, one) = (tension.constant(0.0), tension.constant(1.0));
        let Some(&stiffness) = self.coefficients.first() else { return (zero, zero) };
        let at_zero = tension.constant(1.0 / stiffness);
        // a cable that stiffens has less strain than a linear one; any positive strain may be the start
        let start = 1e-2;
        // a smooth law: after a step of 1e-8 the next one is rounding
        let (strain, slope) = strain_of_tension(tension.max(zero), start, 1e-8, |strain| self.tension(strain));
        let pushes = tension.is_less(zero);
        ((tension * at_zero).select(pushes, strain), at_zero.select(pushes, one / slope))
    }
}

impl Law for Polynomial {
    const IS_POINTWISE: bool = true;

    #[inline]
    fn strain(&self, tension: f64) -> (f64, f64) {
        self.strain(tension)
    }

    #[inline]
    fn tension(&self, strain: f64, _: Option<&Memory>) -> Option<(f64, f64)> {
        Some(self.tension(strain))
    }
}
