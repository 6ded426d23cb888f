//! Worth of parameters in metres of cable.

use std::f64::consts::TAU;

use crate::robot::{Cable, ParameterKind};

/// Smallest size that counts (m).
const LEAST: f64 = 1e-3;

/// Sizes of one cable by which its parameters change lengths.
#[derive(Clone, Copy, Debug)]
pub(super) struct Worth {
    /// Mean recorded length (m).
    length: f64,
    /// Radius of the drum, no smaller than counts (m).
    drum_radius: f64,
    /// Way of the drum's contact point while the mean length is paid out (m).
    drum_travel: f64,
    /// r_p (m).
    pulley_radius: f64,
}

impl Worth {
    pub(super) fn of(cable: &Cable, mean_length: f64) -> Self {
        let drum_radius = cable.winch.radius.unwrap_or(0.0).max(LEAST);
        Self {
            length: mean_length,
            drum_radius,
            drum_travel: cable.winch.pitch().unwrap_or(0.0) * mean_length / (TAU * drum_radius),
            pulley_radius: cable.pulley_radius().unwrap_or(0.0),
        }
    }

    /// Metres that one unit of a parameter of the cable's geometry is worth.
    pub(super) fn metres(&self, kind: ParameterKind) -> f64 {
        match kind {
            ParameterKind::LengthScale => self.length,
            // the radius turns with the whole length
            ParameterKind::DrumRadius => self.length / self.drum_radius,
            ParameterKind::StartAngle => self.drum_radius,
            ParameterKind::DrumAxis => self.drum_travel.max(LEAST),
            ParameterKind::SwivelAxis => self.pulley_radius.max(LEAST),
            _ => 1.0,
        }
    }
}
