//! The winch of a cable: motor angle ↔ drum angle ↔ controlled length, and encoder counts.

pub mod drum;
mod layers;
#[cfg(test)]
mod tests;
pub mod turns;

use std::f64::consts::TAU;

use crate::robot::Cable;
pub use drum::{Departure, Drum, DrumError, DrumLength, GrooveError, Mounting, Parameters};

/// A drum with what drives it.
#[derive(Clone, Debug, PartialEq)]
pub struct Winch {
    /// The drum.
    pub drum: Drum,
    /// Motor angle = gear ratio × drum angle; negative where the motor turns backwards to pay out.
    pub gear_ratio: f64,
    /// Counts of the motor's encoder in one turn of the motor; `None` when unknown.
    pub counts_per_turn: Option<f64>,
}

impl Winch {
    /// The winch without its drum: controlled length linear in the drum angle, radius times angle from the start. `None`
    /// without a radius.
    ///
    /// It is what a controller assumes that knows a radius only, and the limit of a drum without pitch.
    pub fn ideal(cable: &Cable) -> Option<Result<Self, DrumError>> {
        let radius = cable.drum_radius?;
        Some(Self::with(cable, Parameters { radius, ..parameters(cable, radius, 0.0, None, None) }))
    }

    /// The winch of a robot's cable; `None` when its file lacks what [`missing_key`] names.
    pub fn of(cable: &Cable) -> Option<Result<Self, DrumError>> {
        let (radius, pitch) = (cable.drum_radius?, cable.drum_pitch?);
        let mounting = match cable.drum_guided {
            Some(true) => None,
            _ => Some(Mounting {
                position: cable.drum_position?,
                axis: cable.drum_axis?,
                side: cable.drum_side.unwrap_or_default(),
                // the pulley's entry D, unless the cable runs over others before
                pulley: cable.drum_pulley.unwrap_or(cable.frame_anchor),
            }),
        };
        Some(Self::with(cable, parameters(cable, radius, pitch, mounting, cable.drum_groove_length)))
    }

    fn with(cable: &Cable, parameters: Parameters) -> Result<Self, DrumError> {
        Ok(Self {
            drum: Drum::new(parameters)?,
            gear_ratio: cable.gear_ratio.unwrap_or(1.0),
            counts_per_turn: cable.encoder_counts_per_turn,
        })
    }

    /// Motor angle at a controlled length (m → rad).
    pub fn motor_angle(&self, controlled_length: f64) -> Result<f64, GrooveError> {
        Ok(self.gear_ratio * self.drum.angle(controlled_length)?)
    }

    /// Controlled length at a motor angle (rad → m).
    pub fn controlled_length(&self, motor_angle: f64) -> Result<f64, GrooveError> {
        self.drum.length(motor_angle / self.gear_ratio)
    }

    /// Encoder counts at a motor angle (rad), from zero at the angle zero; `None` when the counts per turn are unknown.
    pub fn encoder_counts(&self, motor_angle: f64) -> Option<f64> {
        Some(motor_angle / TAU * self.counts_per_turn?)
    }

    /// Motor angle at an encoder count (rad); `None` when the counts per turn are unknown.
    pub fn motor_angle_of_counts(&self, counts: f64) -> Option<f64> {
        Some(counts * TAU / self.counts_per_turn?)
    }
}

fn parameters(
    cable: &Cable,
    radius: f64,
    pitch: f64,
    mounting: Option<Mounting>,
    groove_length: Option<f64>,
) -> Parameters {
    Parameters {
        radius,
        pitch,
        start_angle: cable.drum_start_angle.unwrap_or(0.0),
        start_length: cable.drum_start_length.unwrap_or(0.0),
        mounting,
        groove_length,
        layer_height: cable.drum_layer_height.filter(|_| groove_length.is_some()),
    }
}

/// The robot-file key that a cable lacks for the effect `drum`; `None` when it has all.
pub fn missing_key(cable: &Cable) -> Option<&'static str> {
    let guided = cable.drum_guided == Some(true);
    [
        ("drum_radius_m", cable.drum_radius.is_some()),
        ("drum_pitch_m", cable.drum_pitch.is_some()),
        ("drum_axis", guided || cable.drum_axis.is_some()),
        ("drum_position_m", guided || cable.drum_position.is_some()),
    ]
    .into_iter()
    .find_map(|(key, present)| (!present).then_some(key))
}
