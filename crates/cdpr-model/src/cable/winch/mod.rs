//! The winch of a cable: motor angle ↔ drum angle ↔ controlled length, and encoder counts.

pub mod drum;
mod layers;
mod parameters;
mod speed;
#[cfg(test)]
mod tests;
pub mod turns;

use std::f64::consts::TAU;

use crate::robot::{Cable, GrooveEnds};
pub use drum::{Departure, Drum, DrumError, GrooveError};
pub use parameters::{DrumLength, Mounting, Parameters};
pub use speed::SpeedLimit;

/// A drum with its gear and encoder.
#[derive(Clone, Debug, PartialEq)]
pub struct Winch {
    /// The drum.
    pub drum: Drum,
    /// Motor angle = gear ratio × drum angle; negative if the motor turns backwards to pay out.
    pub gear_ratio: f64,
    /// Counts of the motor's encoder per turn of the motor; `None` if unknown.
    pub counts_per_turn: Option<f64>,
}

impl Winch {
    /// The winch as an ideal one: paid-out length is radius times angle from the start, or that of a spool with this
    /// radius at the start; `None` without a radius.
    ///
    /// It is the model of a controller that knows only a radius, and the limit of a drum without pitch.
    pub fn ideal(cable: &Cable) -> Option<Result<Self, DrumError>> {
        let radius = cable.winch.radius?;
        Some(Self::with(cable, Parameters { radius, ..parameters(cable, radius, 0.0, None, None) }))
    }

    /// The winch of a robot's cable; `None` if its file lacks radius, pitch, axis or position of the drum.
    pub fn of(cable: &Cable) -> Option<Result<Self, DrumError>> {
        let winch = &cable.winch;
        let (radius, groove) = (winch.radius?, winch.groove?);
        let mounting = match winch.guided {
            Some(true) => None,
            _ => Some(Mounting {
                position: winch.position?,
                axis: *winch.axis?,
                side: winch.side.unwrap_or_default(),
                // the pulley's entry D, unless the cable passes other pulleys before
                pulley: winch.first_pulley.unwrap_or(cable.frame_anchor),
            }),
        };
        Some(Self::with(cable, parameters(cable, radius, groove.pitch, mounting, groove.ends)))
    }

    fn with(cable: &Cable, parameters: Parameters) -> Result<Self, DrumError> {
        Ok(Self {
            drum: Drum::new(parameters)?,
            gear_ratio: cable.winch.gear_ratio.unwrap_or(1.0),
            counts_per_turn: cable.winch.encoder_counts_per_turn,
        })
    }

    /// Motor angle at a controlled length (m → rad).
    pub(crate) fn motor_angle(&self, controlled_length: f64) -> Result<f64, GrooveError> {
        Ok(self.gear_ratio * self.drum.angle(controlled_length)?)
    }

    /// Controlled length at a motor angle (rad → m).
    pub(crate) fn controlled_length(&self, motor_angle: f64) -> Result<f64, GrooveError> {
        self.drum.length(motor_angle / self.gear_ratio)
    }

    /// Encoder counts at a motor angle (rad), zero at the angle zero; `None` if the counts per turn are unknown.
    pub(crate) fn encoder_counts(&self, motor_angle: f64) -> Option<f64> {
        Some(motor_angle / TAU * self.counts_per_turn?)
    }
}

fn parameters(
    cable: &Cable,
    radius: f64,
    pitch: f64,
    mounting: Option<Mounting>,
    ends: Option<GrooveEnds>,
) -> Parameters {
    Parameters {
        radius,
        pitch,
        start_angle: cable.winch.start_angle.unwrap_or(0.0),
        start_length: cable.winch.start_length.unwrap_or(0.0),
        mounting,
        groove_length: ends.map(|ends| ends.length),
        layer_height: ends.and_then(|ends| ends.layer_height),
        build_up: cable.winch.build_up.unwrap_or(0.0),
        advantage: cable.winch.mechanical_advantage.unwrap_or(1.0),
    }
}

/// The robot-file key that a cable lacks for the effect `drum`; `None` if it has all.
pub(crate) fn missing_key(cable: &Cable) -> Option<&'static str> {
    let winch = &cable.winch;
    let guided = winch.guided == Some(true);
    [
        ("drum_radius_m", winch.radius.is_some()),
        ("drum_pitch_m", winch.groove.is_some()),
        ("drum_axis", guided || winch.axis.is_some()),
        ("drum_position_m", guided || winch.position.is_some()),
    ]
    .into_iter()
    .find_map(|(key, present)| (!present).then_some(key))
}
