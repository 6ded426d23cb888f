//! The winch of a cable as the robot file states it; [`crate::cable::winch`] has what it does.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::Axis;

/// Winch of a cable: a drum with what drives it. The radius alone is an ideal winch; the effect `drum` needs groove and place too.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CableWinch {
    /// Radius r of the drum, to the cable's centre line (m).
    pub radius: Option<f64>,
    /// Groove of the drum.
    pub groove: Option<Groove>,
    /// Unit vector along the drum's axis, the way the contact point travels while cable is paid out (world).
    pub axis: Option<Axis>,
    /// Point of the drum's axis level with the contact point at the start angle (world, m).
    pub position: Option<Vector3<f64>>,
    /// Side on which the cable leaves the drum; left when unknown.
    pub side: Option<DrumSide>,
    /// True when a guide travels with the contact point, so that the free length stays the same.
    pub guided: Option<bool>,
    /// Point at which the cable from the drum enters its first pulley (world, m); the frame anchor when unknown.
    pub first_pulley: Option<Vector3<f64>>,
    /// Drum angle at which the controlled length is `start_length` (rad); 0 when unknown.
    pub start_angle: Option<f64>,
    /// Controlled length at `start_angle` (m); 0 when unknown.
    pub start_length: Option<f64>,
    /// Motor angle = gear_ratio · drum angle; 1 when unknown.
    pub gear_ratio: Option<f64>,
    /// Squared radius that a spool gains with every metre wound on it (m): 0 for a drum in whose groove the cable lies.
    pub build_up: Option<f64>,
    /// Length on the drum over length of the cable, as tackle makes it; 1 when unknown.
    pub mechanical_advantage: Option<f64>,
    /// Counts of the motor's encoder in one turn of the motor.
    pub encoder_counts_per_turn: Option<f64>,
    /// Inertia of the drum about its axis (kg·m²).
    pub drum_inertia: Option<f64>,
    /// Inertia of the motor's rotor about its axis (kg·m²).
    pub rotor_inertia: Option<f64>,
    /// Dry friction at the drum (N·m).
    pub coulomb_friction: Option<f64>,
    /// Dry friction of a drum that stands (N·m); that of one that turns when unknown.
    pub static_friction: Option<f64>,
    /// Speed at which dry friction has fallen by 1 − 1/e of its way from the static one to Coulomb's (rad/s).
    pub stribeck_speed: Option<f64>,
    /// Friction at the drum per speed (N·m·s/rad).
    pub viscous_friction: Option<f64>,
}

/// Groove of a drum: ends belong to a pitch, and further layers to ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Groove {
    /// Pitch (m per turn).
    pub pitch: f64,
    /// Ends; without when unknown.
    pub ends: Option<GrooveEnds>,
}

/// Ends of a groove, between which layers of cable lie on each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrooveEnds {
    /// Length of the groove along the axis (m).
    pub length: f64,
    /// Radius that each further layer of cable adds (m); one layer when unknown.
    pub layer_height: Option<f64>,
}

impl CableWinch {
    /// Pitch of the groove (m per turn).
    pub fn pitch(&self) -> Option<f64> {
        self.groove.map(|groove| groove.pitch)
    }

    /// Length of the groove along the axis (m).
    pub fn groove_length(&self) -> Option<f64> {
        self.groove?.ends.map(|ends| ends.length)
    }

    /// Radius that each further layer adds (m).
    pub fn layer_height(&self) -> Option<f64> {
        self.groove?.ends?.layer_height
    }

    /// Gives the groove a pitch (m per turn); its ends stay.
    pub fn set_pitch(&mut self, pitch: f64) {
        self.groove = Some(Groove { pitch, ends: self.groove.and_then(|groove| groove.ends) });
    }

    /// Gives the groove a length (m), its layers stay; a drum without groove stays without.
    pub fn set_groove_length(&mut self, length: f64) {
        if let Some(groove) = &mut self.groove {
            groove.ends = Some(GrooveEnds { length, layer_height: groove.ends.and_then(|ends| ends.layer_height) });
        }
    }

    /// Gives further layers a height (m); a groove without ends stays without.
    pub(crate) fn set_layer_height(&mut self, height: f64) {
        if let Some(ends) = self.groove.as_mut().and_then(|groove| groove.ends.as_mut()) {
            ends.layer_height = Some(height);
        }
    }
}

/// Side on which a cable leaves its drum, seen along `axis` with the first pulley above.
///
/// By symmetry the length does not depend on it; contact point, direction of rotation and the room that the cable needs do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DrumSide {
    /// On the left: the drum turns positively (right-handed) about its axis when it pays out.
    #[default]
    Left,
    /// On the right: the drum turns negatively about its axis when it pays out.
    Right,
}

impl DrumSide {
    /// Sense in which the drum turns about its axis when it pays out: +1 where the cable leaves on the left.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }
}
