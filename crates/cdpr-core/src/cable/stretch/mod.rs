//! Tension of a cable as a function of its strain, and back, one file per law.
//!
//! Each law rises strictly, so every tension has one strain. Below strain 0 and beyond its end each goes on straight,
//! so that iterations may pass through any number. Strain is the lengthening divided by the length it is counted from,
//! dimensionless.

pub mod hysteresis;
mod inverse;
pub mod polynomial;
mod table;

pub use table::Table;

use hysteresis::{Hysteresis, Memory};
use polynomial::Polynomial;

/// The stretch of a piece of cable by its unstrained length, at a memory where it has one. Immutable, and copied without allocation:
/// what a cable comes to remember is told by [`Stretch::memory_at`], and kept by whoever asks.
#[derive(Clone, Debug, PartialEq)]
pub enum Stretch {
    /// Cables keep their length.
    Rigid,
    /// Strain is proportional to tension: ε = κ T with κ = 1/EA (1/N).
    Linear(f64),
    /// Tension is a polynomial of strain.
    Polynomial(Polynomial),
    /// Tension depends on the strains before; the memory is where they led to.
    Hysteresis(Hysteresis, Memory),
}

/// Tension below which ε(T)/T is taken as its limit (N).
const TINY_TENSION: f64 = 1e-9;

impl Stretch {
    /// True when cables keep their length.
    #[inline]
    pub fn is_rigid(&self) -> bool {
        matches!(self, Self::Rigid)
    }

    /// True when the strain at a point of the cable follows from the tension there, and not linearly.
    #[inline]
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

    /// Memory of the cable after a monotone motion to this tension (N); nothing for laws without one.
    #[inline]
    pub fn memory_at(&self, tension: f64) -> Option<Memory> {
        match self {
            Self::Hysteresis(law, memory) => Some(law.advance(law.strain(tension, memory).0, memory)),
            _ => None,
        }
    }

    /// The law at another memory; itself where it has none.
    #[must_use]
    #[inline]
    pub fn with_memory(&self, memory: &Memory) -> Self {
        match self {
            Self::Hysteresis(law, _) => Self::Hysteresis(law.clone(), *memory),
            other => other.clone(),
        }
    }

    /// Memory that the law starts from.
    #[inline]
    pub fn memory(&self) -> Option<&Memory> {
        match self {
            Self::Hysteresis(_, memory) => Some(memory),
            _ => None,
        }
    }
}
