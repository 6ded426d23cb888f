//! One cable and its winch in motion.

use super::error::StepError;
use cdpr_model::cable::span;
use cdpr_model::cable::stretch::hysteresis::Memory;

/// One cable with its winch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CableMotion {
    /// q_θ (m).
    pub controlled_length: f64,
    /// q̇_θ (m/s), positive if cable is paid out.
    pub controlled_length_rate: f64,
    /// Tension at the outlet (N) for the pose and the twist of the state; 0 if the cable is slack or broken.
    pub tension: f64,
    /// Geometric length q (m), wrapped part included.
    pub length: f64,
    /// Angle of the drum (rad), positive if cable is paid out; 0 for ideal winches.
    pub drum_angle: f64,
    /// Speed of the drum (rad/s).
    pub drum_speed: f64,
    /// True if the drum stands, held by friction, a brake or a stop; its speed is exactly 0 then.
    pub is_stuck: bool,
    /// True if the cable broke.
    pub is_broken: bool,
    /// True if the winch stands still under any command.
    pub is_stopped: bool,
    /// Length that slipped since the start (m): it adds to the unstrained length without the winch.
    pub slip: f64,
    /// Memory of a cable with hysteresis; `None` for other cables.
    pub(super) memory: Option<Memory>,
    /// Shape of a cable with weight; `None` for other cables.
    pub(super) span: Option<span::SpanState<f64>>,
}

impl CableMotion {
    /// Unstrained length between winch and platform, slip included (m).
    #[inline]
    pub(super) fn unstrained_length(&self) -> f64 {
        self.controlled_length + self.slip
    }

    /// Checks that a controlled length (m) leaves a whole cable a positive unstrained length; `index` counts from 0.
    #[inline]
    pub(super) fn check_length(&self, index: usize, controlled: f64) -> Result<(), StepError> {
        let length = controlled + self.slip;
        match self.is_broken || !(length <= 0.0) {
            true => Ok(()),
            false => Err(StepError::NoLength { cable: index + 1, length }),
        }
    }
}
