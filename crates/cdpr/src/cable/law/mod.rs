//! The implicit law of one cable with all its effects: g(p_B, s, q_θ) = 0 with a pull t(p_B, s) on the platform.
//!
//! p_B is the platform anchor in the world, q_θ the controlled length, s the internal state. For a sagging cable s = (F, L)
//! of [`super::span`], and with the outlet C(F) and its wrap angle β(F)
//!
//! C(F) + S(F, L) − p_B = 0, q_θ = L + (r_p β + q_h − c_s |F|)/(1 + ε(|F|)) − q_h, t = −(F − p L):
//!
//! outlet and span are solved together, so that swivel, wrap and contact point follow the end tangent of the span. The
//! wrapped part and the hidden length q_h carry the tension at the outlet; c_s is the compliance in series (eq. 6.18).
//!
//! The tangent ∂t/∂p_B at fixed q_θ is symmetric where it is the Hessian of an energy: of every straight cable, and of a
//! catenary that leaves from a point. Over a pulley the weight of the wrapped part is left out, and finite elements take cable
//! up at all their nodes instead of the outlet: what is missing to symmetry is of the order of w r_p and of the weight of an
//! element, 1e-4 and 1e-7 of the stiffness for a steel cable at 700 N.

mod parameters;
mod sagging;
mod solve;
mod straight;
#[cfg(test)]
mod tests;

pub(crate) use parameters::outlet_change;
pub use parameters::{LawChange, LawParameter};
use thiserror::Error;

use super::course::Course;
use super::elasticity::Elasticity;
use super::outlet::Outlet;
use super::span::{Shape, State};
use super::stretch::Stretch;
use super::stretch::hysteresis::Memory;

/// What one cable is made of, beside its platform anchor.
#[derive(Clone, Debug, PartialEq)]
pub struct CableLaw {
    /// Outlet: a point, or a pulley.
    pub outlet: Outlet<f64>,
    /// How it stretches by its unstrained length; [`Kind::Linear`] has its own law.
    pub stretch: Stretch,
    /// q_h, strained length between winch and outlet that the geometry does not see (m).
    pub hidden_length: f64,
    /// c_s, compliance in series (m/N).
    pub series_compliance: f64,
    /// p, weight per unstrained length along gravity (world, N/m).
    pub weight: [f64; 3],
    /// Which of the laws it obeys.
    pub kind: Kind,
}

/// Which formula a cable law has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Straight, linear or rigid, in closed form.
    Linear(Elasticity<f64>),
    /// Straight, with the law of stretch by unstrained length.
    Stretching,
    /// With weight.
    Sagging(Shape),
}

/// What is known of a cable beside the place of its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Known {
    /// q_θ (m).
    ControlledLength(f64),
    /// Tension at the outlet, where robots measure it (N).
    OutletTension(f64),
    /// Tension at the platform anchor (N).
    PlatformTension(f64),
}

/// A cable at rest between its outlet and a platform anchor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hold {
    /// F and L; of a straight cable F = f times the direction away from the outlet and L its unstrained free length.
    pub state: State<f64>,
    /// q_θ (m).
    pub controlled_length: f64,
    /// Pull t on the platform (world, N).
    pub pull: [f64; 3],
    /// Unit vector of the pull at the platform anchor, along the cable's end tangent; defined for slack straight cables too.
    pub direction: [f64; 3],
    /// Tension at the outlet (N).
    pub outlet_tension: f64,
    /// Tension at the platform anchor (N).
    pub platform_tension: f64,
    /// Wrap angle (rad).
    pub wrap_angle: f64,
    /// Strained length from the frame anchor, wrapped part included (m).
    pub strained_length: f64,
    /// ∂t/∂p_B at fixed q_θ, by rows (N/m); symmetric.
    pub tangent: [[f64; 3]; 3],
    /// ∂t/∂q_θ at fixed p_B (N/m).
    pub by_controlled_length: [f64; 3],
    /// ∂t/∂T by the tension at the outlet, at fixed p_B.
    pub by_tension: [f64; 3],
    /// ∂q_θ/∂T by the tension at the outlet, at fixed p_B (m/N).
    pub controlled_length_by_tension: f64,
    /// ∂q_θ/∂p_B at fixed tension at the outlet.
    pub controlled_length_by_anchor: [f64; 3],
}

/// Why a cable cannot be as asked.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum HoldError {
    /// A cable that does not stretch is shorter than the distance it has to span.
    #[error(
        "the controlled length {controlled_length:.6} m is shorter than the chord allows: without stretch at least {least:.6} m \
         are needed to reach the platform anchor; give the cable a stiffness, or pay out more"
    )]
    TooShort {
        /// q_θ (m).
        controlled_length: f64,
        /// Least length (m).
        least: f64,
    },
    /// No cable of this weight has so little tension here.
    #[error(
        "a tension of {tension:.3} N is less than the cable's own weight leaves: at this pose its outlet carries {least:.3} N at \
         least"
    )]
    TensionTooLow {
        /// Tension asked for (N).
        tension: f64,
        /// Least tension (N).
        least: f64,
    },
    /// More tension than the law of stretch can take with a length left.
    #[error("a tension of {tension:.3} N stretches the cable from a controlled length below zero")]
    Overstretched {
        /// Tension (N).
        tension: f64,
    },
    /// The cable runs along the swivel axis of its pulley, or its anchor lies inside.
    #[error("the cable has no unique course over its pulley")]
    NoCourse,
    /// The iteration ended without an answer.
    #[error("no shape of the cable was found after {iterations} steps: {}", missing(*.gap))]
    NotConverged {
        /// Steps tried, those of all searches.
        iterations: u32,
        /// Length still missing (m); NaN where numbers overflowed.
        gap: f64,
    },
}

/// The gap that an iteration left, in words.
fn missing(gap: f64) -> String {
    match gap.is_finite() {
        true => format!("{gap:.3e} m are missing"),
        false => {
            "its forces and lengths are too large to calculate with; check the units of tensions (N) and lengths (m)"
                .to_owned()
        }
    }
}

impl HoldError {
    /// True where numbers left the range that a computer represents: not the cable is at fault, but what was asked.
    pub fn is_overflow(&self) -> bool {
        matches!(self, Self::NotConverged { gap, .. } if !gap.is_finite())
    }
}

impl CableLaw {
    /// The straight, rigid cable between the same ends.
    fn course(&self, platform_anchor: [f64; 3]) -> Course<f64> {
        self.outlet.course(platform_anchor)
    }

    /// The law of the cable once it remembers this; itself where its stretch has no memory.
    #[must_use]
    pub fn with_memory(&self, memory: &Memory) -> Self {
        Self { stretch: self.stretch.with_memory(memory), ..self.clone() }
    }

    /// The cable at a platform anchor (world, m), with one more thing known.
    pub fn hold(&self, platform_anchor: [f64; 3], known: Known) -> Result<Hold, HoldError> {
        self.hold_from(platform_anchor, known, None)
    }

    /// [`CableLaw::hold`], sought from the state of a cable nearby.
    pub fn hold_from(
        &self,
        platform_anchor: [f64; 3],
        known: Known,
        guess: Option<State<f64>>,
    ) -> Result<Hold, HoldError> {
        match self.kind {
            Kind::Linear(_) | Kind::Stretching => self.hold_straight(platform_anchor, known),
            Kind::Sagging(shape) => self.hold_sagging(shape, platform_anchor, known, guess),
        }
    }
}
