//! Tension of a cable as a function of its strain, and back, one file per law.
//!
//! Each law rises strictly, so every tension has one strain. Below strain 0 and beyond its end each goes on straight,
//! so that iterations may pass through any number. Strain is the lengthening divided by the length it is counted from,
//! dimensionless.

pub mod hysteresis;
mod inverse;
pub mod polynomial;

use hysteresis::{Hysteresis, Memory};
use polynomial::Polynomial;

/// The stretch of a piece of cable by its unstrained length, with the history where there is one.
#[derive(Clone, Debug, PartialEq)]
pub enum Stretch {
    /// Cables keep their length.
    Rigid,
    /// Strain is proportional to tension: ε = κ T with κ = 1/EA (1/N).
    Linear(f64),
    /// Tension is a polynomial of strain.
    Polynomial(Polynomial),
    /// Tension depends on the strains before; the memory is where they led to.
    Hysteresis(Box<Hysteresis>, Memory),
}

/// Tension below which ε(T)/T is taken as its limit (N).
const TINY_TENSION: f64 = 1e-9;

impl Stretch {
    /// True when cables keep their length.
    pub fn is_rigid(&self) -> bool {
        matches!(self, Self::Rigid)
    }

    /// True when the strain at a point of the cable follows from the tension there, and not linearly.
    pub fn is_pointwise(&self) -> bool {
        matches!(self, Self::Polynomial(_))
    }

    /// ε(T) and ∂ε/∂T (1/N).
    #[inline(always)]
    pub fn strain(&self, tension: f64) -> (f64, f64) {
        match self {
            Self::Rigid => (0.0, 0.0),
            Self::Linear(compliance) => (compliance * tension, *compliance),
            Self::Polynomial(law) => law.strain(tension),
            Self::Hysteresis(law, memory) => law.strain(tension, memory),
        }
    }

    /// ε(T)/T (1/N) and its derivative.
    #[inline(always)]
    pub fn secant_compliance(&self, tension: f64) -> (f64, f64) {
        match self {
            Self::Rigid => (0.0, 0.0),
            Self::Linear(compliance) => (*compliance, 0.0),
            _ if tension < TINY_TENSION => (self.strain(0.0).1, 0.0),
            _ => {
                let (strain, slope) = self.strain(tension);
                let secant = strain / tension;
                (secant, (slope - secant) / tension)
            }
        }
    }

    /// The stretch after the cable has come to this tension (N): laws with a memory remember it.
    pub fn remember(&mut self, tension: f64) {
        if let Self::Hysteresis(law, memory) = self {
            let (strain, _) = law.strain(tension, memory);
            *memory = law.advance(strain, memory);
        }
    }

    /// The stretch of a cable that has never been loaded.
    pub fn forget(&mut self) {
        if let Self::Hysteresis(_, memory) = self {
            *memory = Memory::virgin();
        }
    }

    /// What a law with a memory remembers.
    pub fn memory(&self) -> Option<&Memory> {
        match self {
            Self::Hysteresis(_, memory) => Some(memory),
            _ => None,
        }
    }
}
