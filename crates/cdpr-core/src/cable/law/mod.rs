//! The implicit law of one cable with all its effects: g(p_B, s, q_θ) = 0 with a pull t(p_B, s) on the platform.
//!
//! p_B is the platform anchor in the world, q_θ the controlled length, s the internal state. For a sagging cable
//! s = (F, L) of [`super::span`], and with the outlet C(F) and its wrap angle β(F)
//!
//! C(F) + S(F, L) − p_B = 0, q_θ = L + (r_p β + q_h − c_s |F|)/(1 + ε(|F|)) − q_h, t = −(F − p L):
//!
//! outlet and span are solved together, so that swivel, wrap and contact point follow the end tangent of the span. The
//! wrapped part and the hidden length q_h carry the tension at the outlet; c_s is the compliance in series (eq. 6.18).
//!
//! The tangent ∂t/∂p_B at fixed q_θ is symmetric if it is the Hessian of an energy: for every straight cable, and for
//! a catenary that leaves from a point. Over a pulley the weight of the wrapped part is left out, and finite elements
//! take cable up at all their nodes instead of the outlet: the asymmetry is of the order of w r_p, or of the weight of
//! an element: 1e-4 or 1e-7 of the stiffness for a steel cable at 700 N.

mod continued;
mod lengths;
mod matrix4;
mod newton;
mod parameters;
mod sagging;
mod solve;
mod straight;
#[cfg(test)]
mod tests;

pub use lengths::CableLengths;
pub use parameters::{LawChange, LawParameter};
pub use straight::unit_spring;

use super::elasticity::Elasticity;
use super::outlet::Outlet;
use super::path::CablePath;
use super::span::{Shape, SpanState};
use super::state::{CableInput, CableState, CableStateError, Recording};
use super::stretch::Stretch;
use super::stretch::hysteresis::Memory;
use super::wrench::CableEnd;
use crate::cable::elasticity::StiffnessBasis;

/// Law of one cable: all its properties except its end on the platform.
#[derive(Clone, Debug, PartialEq)]
pub struct CableLaw {
    /// Outlet: a point, or a pulley.
    pub outlet: Outlet<f64>,
    /// Stretch by the unstrained length; [`Kind::Linear`] has its own law.
    pub stretch: Stretch,
    /// q_h, strained length between winch and outlet that the geometry does not see (m).
    pub hidden_length: f64,
    /// c_s, compliance in series (m/N).
    pub series_compliance: f64,
    /// p, weight per unstrained length along gravity (world, N/m).
    pub weight: [f64; 3],
    /// Calibration of the length and tension that the robot records of this cable.
    pub recording: Recording,
    /// Formula that the cable obeys.
    pub kind: Kind,
}

/// Formula of a cable law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Straight and rigid: its length is the length of its path at any tension.
    Rigid,
    /// Straight and linear, in closed form, with the basis of its stiffness; a constant spring if there is no basis.
    Linear(Elasticity<f64>, Option<StiffnessBasis>),
    /// Straight, with the law of stretch by unstrained length.
    Stretching,
    /// With weight.
    Sagging(Shape),
}

impl CableLaw {
    /// Path of the straight, rigid cable to a platform anchor (world, m).
    fn path(&self, platform_anchor: [f64; 3]) -> CablePath<f64> {
        self.outlet.path(platform_anchor)
    }

    /// Returns the law with its stretch at this memory; unchanged if its stretch has no memory.
    #[must_use]
    #[inline]
    pub fn with_memory(&self, memory: &Memory) -> Self {
        Self { stretch: self.stretch.with_memory(memory), ..self.clone() }
    }

    /// State of the cable with its end at `end` on the platform and one more quantity given by `input`.
    #[inline]
    pub fn state(&self, end: impl Into<CableEnd<f64>>, input: CableInput) -> Result<CableState, CableStateError> {
        self.state_from(end, input, None)
    }

    /// [`CableLaw::state`], where a cable with weight starts its search from the span `guess` of a cable nearby.
    #[inline]
    pub fn state_from(
        &self,
        end: impl Into<CableEnd<f64>>,
        input: CableInput,
        guess: Option<SpanState<f64>>,
    ) -> Result<CableState, CableStateError> {
        let end = end.into();
        let state = self.state_on(&self.path(end.anchor), &end, input, guess)?;
        match input {
            CableInput::ControlledLength(_) => Ok(state),
            CableInput::OutletTension(_) | CableInput::PlatformTension(_) => state.unless_overstretched(),
        }
    }

    /// [`CableLaw::state_from`] with the path of the straight cable to the end. Unlike there, a tension that stretches
    /// the cable from a controlled length below zero is no error.
    #[inline]
    pub fn state_on(
        &self,
        path: &CablePath<f64>,
        end: &CableEnd<f64>,
        input: CableInput,
        guess: Option<SpanState<f64>>,
    ) -> Result<CableState, CableStateError> {
        match self.kind {
            Kind::Rigid | Kind::Linear(..) | Kind::Stretching => self.straight_state(path, end, input),
            Kind::Sagging(shape) => self.sagging_state(shape, path, end, input, guess),
        }
    }

    /// True if the cable is straight and does not stretch, so that its stiffness is infinite.
    #[inline]
    pub fn is_inextensible_line(&self) -> bool {
        match self.kind {
            Kind::Rigid => true,
            Kind::Linear(law, _) => law.is_rigid(),
            Kind::Stretching | Kind::Sagging(_) => false,
        }
    }

    /// True if a cable of this tension may be slack, so that its length does not follow from its tension: the cable has
    /// no weight, and its tension is at most `allowance` (N).
    #[inline]
    pub fn may_be_slack(&self, tension: f64, allowance: f64) -> bool {
        tension <= allowance && !matches!(self.kind, Kind::Sagging(_))
    }
}
