//! Lengths of a cable with a given tension on its path, among them the controlled length of its winch.

use super::{CableLaw, Kind};
use crate::cable::path::CablePath;
use crate::cable::state::{CableInput, CableStateError};
use crate::cable::stretch::hysteresis::Memory;
use crate::cable::wrench::CableEnd;

/// Lengths, direction and tensions of a cable at rest: the fields of a [`CableState`](crate::cable::CableState) without
/// derivatives. The tension may be unknown (NaN).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CableLengths {
    /// Strained length from frame anchor to platform anchor (m).
    pub length: f64,
    /// q_θ (m); NaN where it depends on a tension that is unknown.
    pub controlled_length: f64,
    /// Direction of the pull at the platform anchor (unit vector, world).
    pub direction: [f64; 3],
    /// Wrap angle (rad).
    pub wrap_angle: f64,
    /// Tension at the outlet (N).
    pub outlet_tension: f64,
    /// Tension at the platform anchor (N) of a cable with weight.
    pub platform_tension: Option<f64>,
}

impl CableLaw {
    /// Controlled length q_θ (m) of a cable of geometric length q (m) with a tension of any sign (N); `None` for laws
    /// without a closed form.
    #[inline]
    pub fn closed_length(&self, q: f64, tension: f64) -> Option<f64> {
        match &self.kind {
            Kind::Rigid => Some(q),
            Kind::Linear(law, _) => Some(law.controlled_length(q, tension)),
            Kind::Stretching | Kind::Sagging(_) => None,
        }
    }

    /// Lengths with a tension (N; NaN if unknown), from `memory`, or from the law's own memory if there is none.
    /// Inlined, so that callers of closed forms compute only the fields they read.
    #[inline]
    pub fn lengths_on(
        &self,
        path: &CablePath<f64>,
        end: &CableEnd<f64>,
        tension: f64,
        input: impl FnOnce(f64) -> CableInput,
        memory: Option<&Memory>,
    ) -> Result<CableLengths, CableStateError> {
        let of_path = |controlled_length: f64| CableLengths {
            length: path.length,
            controlled_length,
            direction: path.direction,
            wrap_angle: path.wrap_angle,
            outlet_tension: tension,
            platform_tension: None,
        };
        match self.closed_length(path.length, tension) {
            Some(length) if length > 0.0 || tension.is_nan() => Ok(of_path(length)),
            Some(_) => Err(CableStateError::Overstretched { tension }),
            None if tension.is_nan() => Ok(of_path(f64::NAN)),
            None => self.solved_lengths(path, end, input(tension), memory),
        }
    }

    #[inline(never)]
    fn solved_lengths(
        &self,
        path: &CablePath<f64>,
        end: &CableEnd<f64>,
        input: CableInput,
        memory: Option<&Memory>,
    ) -> Result<CableLengths, CableStateError> {
        let state = match memory {
            Some(memory) => self.with_memory(memory).state_on(path, end, input, None)?,
            None => self.state_on(path, end, input, None)?,
        };
        let state = state.unless_overstretched()?;
        Ok(CableLengths {
            length: state.strained_length,
            controlled_length: state.controlled_length,
            direction: state.direction,
            wrap_angle: state.wrap_angle,
            outlet_tension: state.outlet_tension,
            platform_tension: matches!(self.kind, Kind::Sagging(_)).then_some(state.platform_tension),
        })
    }
}
