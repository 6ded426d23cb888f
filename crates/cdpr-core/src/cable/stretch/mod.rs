//! Tension of a cable as a function of its strain, and back, one file per law.
//!
//! Each law rises strictly, so each tension has one strain. Below strain 0 and beyond its end each law continues along
//! its tangent, so that iterations may pass through any number. Strain is the lengthening divided by the unstrained
//! length,
//! dimensionless.
//!
//! A law is a file with its formula, a variant of [`Stretch`], and a line in its method `answer`.

pub mod hysteresis;
mod inverse;
mod law;
pub mod polynomial;
mod table;
pub mod two_piece;

pub use table::Table;

use hysteresis::{Hysteresis, Memory};
use law::{Inextensible, IsPointwise, Law, Proportional, Question, SecantCompliance, Strain, StrainByNumber, Tension};
use polynomial::Polynomial;
use two_piece::TwoPiece;

/// Law of stretch of a piece of cable by its unstrained length, at a memory if the law has one. Immutable, and copied
/// without allocation: [`Stretch::memory_at`] returns the memory after a motion, for the caller to keep.
#[derive(Clone, Debug, PartialEq)]
pub enum Stretch {
    /// Cables keep their length.
    Rigid,
    /// Strain is proportional to tension: ε = κ T with κ = 1/EA (1/N).
    Linear(f64),
    /// Tension is a polynomial of strain.
    Polynomial(Polynomial),
    /// Tension has two slopes that meet at a strain.
    TwoPiece(TwoPiece<f64>),
    /// Tension depends on past strains; the memory is the state that they led to.
    Hysteresis(Hysteresis, Memory),
}

/// A law with a memory and the state of that memory.
struct Remembering<'a> {
    law: &'a Hysteresis,
    memory: &'a Memory,
}

impl Law for Remembering<'_> {
    // a piece of cable has one memory, therefore one strain
    const IS_POINTWISE: bool = false;

    #[inline]
    fn strain(&self, tension: f64) -> (f64, f64) {
        self.law.strain(tension, self.memory)
    }

    #[inline]
    fn tension(&self, strain: f64, memory: Option<&Memory>) -> Option<(f64, f64)> {
        Some(self.law.tension(strain, memory.unwrap_or(self.memory)))
    }
}

impl Stretch {
    /// Answer of the law to a question; the only place that lists every law.
    #[inline]
    fn answer<Q: Question>(&self, question: Q) -> Q::Answer {
        match self {
            Self::Rigid => question.put(&Inextensible),
            Self::Linear(compliance) => question.put(&Proportional(*compliance)),
            Self::Polynomial(law) => question.put(law),
            Self::TwoPiece(law) => question.put(law),
            Self::Hysteresis(law, memory) => question.put(&Remembering { law, memory }),
        }
    }

    /// True when cables keep their length.
    #[inline]
    pub fn is_rigid(&self) -> bool {
        matches!(self, Self::Rigid)
    }

    /// True when the strain at a point of the cable follows from the tension there, and not linearly.
    #[inline]
    pub fn is_pointwise(&self) -> bool {
        self.answer(IsPointwise)
    }

    /// ε(T) and ∂ε/∂T (1/N).
    #[inline]
    pub fn strain(&self, tension: f64) -> (f64, f64) {
        self.answer(Strain(tension))
    }

    /// T(ε) and ∂T/∂ε (N), from the given memory, else from that of the law; `None` for cables that keep their length.
    #[inline]
    pub fn tension(&self, strain: f64, memory: Option<&Memory>) -> Option<(f64, f64)> {
        self.answer(Tension(strain, memory))
    }

    /// ε(T)/T (1/N) and its derivative.
    #[inline]
    pub fn secant_compliance(&self, tension: f64) -> (f64, f64) {
        self.answer(SecantCompliance(tension))
    }

    /// ∂ε/∂p at fixed tension by the law's parameter with index `number`, counted from 0; 0 if the law has no such
    /// parameter.
    #[inline]
    pub fn strain_by_number(&self, tension: f64, number: usize) -> f64 {
        self.answer(StrainByNumber(tension, number))
    }

    /// Memory of the cable after a monotone motion to this tension (N); `None` for laws without one.
    #[inline]
    pub fn memory_at(&self, tension: f64) -> Option<Memory> {
        match self {
            Self::Hysteresis(law, memory) => Some(law.advance(law.strain(tension, memory).0, memory)),
            _ => None,
        }
    }

    /// The law at another memory; unchanged if it has none.
    #[must_use]
    #[inline]
    pub fn with_memory(&self, memory: &Memory) -> Self {
        match self {
            Self::Hysteresis(law, _) => Self::Hysteresis(law.clone(), *memory),
            other => other.clone(),
        }
    }

    /// Memory that the law starts from; `None` for laws without one.
    #[inline]
    pub fn memory(&self) -> Option<&Memory> {
        match self {
            Self::Hysteresis(_, memory) => Some(memory),
            _ => None,
        }
    }
}
