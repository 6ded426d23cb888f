//! The winch of a cable as the robot file states it; its law is in [`crate::cable::winch`].

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::Axis;

/// Winch of a cable: a drum with its drive. A radius alone makes an ideal winch; the effect `drum` also needs groove
/// and position.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CableWinch {
    /// Radius r of the drum, to the cable's centre line (m).
    pub radius: Option<f64>,
    /// Groove of the drum.
    pub groove: Option<Groove>,
    /// Unit vector along the drum's axis, in the direction in which the contact point travels while cable is paid out
    /// (world).
    pub axis: Option<Axis>,
    /// Point of the drum's axis level with the contact point at the start angle (world, m).
    pub position: Option<Vector3<f64>>,
    /// Side on which the cable leaves the drum; left when unknown.
    pub side: Option<DrumSide>,
    /// True if a guide travels with the contact point, so that the free length stays constant.
    pub guided: Option<bool>,
    /// Point at which the cable from the drum enters its first pulley (world, m); the frame anchor when unknown.
    pub first_pulley: Option<Vector3<f64>>,
    /// Drum angle at which the controlled length is `start_length` (rad); 0 when unknown.
    pub start_angle: Option<f64>,
    /// Controlled length at `start_angle` (m); 0 when unknown.
    pub start_length: Option<f64>,
    /// Motor angle = gear_ratio · drum angle; 1 when unknown.
    pub gear_ratio: Option<f64>,
    /// Increase of a spool's squared radius per metre wound (m): 0 for a drum with the cable in its groove.
    pub build_up: Option<f64>,
    /// Length on the drum over length of the cable, with a tackle; 1 when unknown.
    pub mechanical_advantage: Option<f64>,
    /// Counts of the motor's encoder per turn of the motor.
    pub encoder_counts_per_turn: Option<f64>,
    /// Largest speed of the motor (rad/s); no limit when unknown.
    pub motor_speed_max: Option<f64>,
    /// Inertia of the drum about its axis (kg·m²).
    pub drum_inertia: Option<f64>,
    /// Inertia of the motor's rotor about its axis (kg·m²).
    pub rotor_inertia: Option<f64>,
    /// Dry friction at the drum (N·m).
    pub coulomb_friction: Option<f64>,
    /// Static friction of the drum (N·m); equal to the dry friction of the turning drum when unknown.
    pub static_friction: Option<f64>,
    /// Speed at which dry friction has fallen from the static value by 1 − 1/e of the difference to Coulomb's (rad/s).
    pub stribeck_speed: Option<f64>,
    /// Viscous friction at the drum (N·m·s/rad).
    pub viscous_friction: Option<f64>,
}

/// Groove of a drum: ends need a pitch, and further layers need ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Groove {
    /// Pitch (m per turn).
    pub pitch: f64,
    /// Ends of the groove; no ends when unknown.
    pub ends: Option<GrooveEnds>,
}

/// Ends of a groove, between which layers of cable lie on each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrooveEnds {
    /// Length of the groove along the axis (m).
    pub length: f64,
    /// Increase of the radius with each further layer of cable (m); one layer when unknown.
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

    /// Increase of the radius with each further layer (m).
    pub fn layer_height(&self) -> Option<f64> {
        self.groove?.ends?.layer_height
    }

    /// Sets the pitch of the groove (m per turn); its ends do not change.
    pub fn set_pitch(&mut self, pitch: f64) {
        self.groove = Some(Groove { pitch, ends: self.groove.and_then(|groove| groove.ends) });
    }

    /// Sets the length of the groove (m), its layers do not change; no effect on a drum without groove.
    pub fn set_groove_length(&mut self, length: f64) {
        if let Some(groove) = &mut self.groove {
            groove.ends = Some(GrooveEnds { length, layer_height: groove.ends.and_then(|ends| ends.layer_height) });
        }
    }

    /// Sets the height of further layers (m); no effect on a groove without ends.
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
    /// Sense in which the drum turns about its axis when it pays out: +1 if the cable leaves on the left.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }
}
