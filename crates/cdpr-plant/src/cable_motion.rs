//! One cable and its winch in motion.

use super::error::StepError;
use cdpr_model::cable::span;
use cdpr_model::cable::stretch::hysteresis::Memory;

/// One cable with its winch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CableMotion {
    /// q_θ (m).
    pub controlled_length: f64,
    /// q̇_θ (m/s), positive where cable is paid out.
    pub controlled_length_rate: f64,
    /// Tension at the outlet (N), 0 where slack or broken; of the pose and the twist of the state.
    pub tension: f64,
    /// Geometric length q (m), wrapped part included.
    pub length: f64,
    /// Angle of the drum (rad), positive where cable is paid out; 0 of ideal winches.
    pub drum_angle: f64,
    /// Speed of the drum (rad/s).
    pub drum_speed: f64,
    /// Drum held by its own friction.
    pub is_stuck: bool,
    /// Cable that broke.
    pub is_broken: bool,
    /// Winch that stands still whatever it is told.
    pub is_stopped: bool,
    /// Cable that slipped since the start (m): its unstrained length without the winch.
    pub slip: f64,
    /// Memory of a cable with hysteresis.
    pub(super) memory: Option<Memory>,
    /// Shape of a cable with weight.
    pub(super) span: Option<span::SpanState<f64>>,
}

impl CableMotion {
    /// Unstrained length between winch and platform, with what slipped (m).
    #[inline]
    pub(super) fn unstrained_length(&self) -> f64 {
        self.controlled_length + self.slip
    }

    /// Refuses a controlled length (m) that leaves a whole cable nothing; `index` counts from 0.
    #[inline]
    pub(super) fn check_length(&self, index: usize, controlled: f64) -> Result<(), StepError> {
        let length = controlled + self.slip;
        match self.is_broken || !(length <= 0.0) {
            true => Ok(()),
            false => Err(StepError::NoLength { cable: index + 1, length }),
        }
    }
}
