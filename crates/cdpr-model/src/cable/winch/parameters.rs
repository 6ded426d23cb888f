//! Numbers of a drum, and a controlled length with its derivatives by them.

use nalgebra::Vector3;

use crate::robot::DrumSide;

/// Numbers of a cylindrical drum with a helical groove.
///
/// The drum angle counts cable paid out as positive, in whichever direction the drum turns for it. At the start angle
/// the controlled length is the start length and the contact point is level with `position`; paying out moves it along
/// `axis` by one pitch per turn. There the first layer is full: with a groove of finite length, paying out empties it,
/// and reeling in beyond the start needs further layers, which run back and forth over the same groove.
///
/// All lengths are of the cable's centre line: the radius is that of the groove's bottom plus half a cable diameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Radius r of the cable's centre line in the first layer (m).
    pub radius: f64,
    /// Travel of the contact point along the axis in one turn (m), not negative.
    pub pitch: f64,
    /// Drum angle at which the controlled length is `start_length` (rad).
    pub start_angle: f64,
    /// Controlled length at `start_angle` (m).
    pub start_length: f64,
    /// Position and axis of the drum; `None` with a guide that travels with the contact point, for which they have no
    /// effect.
    pub mounting: Option<Mounting>,
    /// Length of the groove along the axis (m); `None` is a groove without ends.
    pub groove_length: Option<f64>,
    /// Radius that each further layer adds (m); `None` is a drum of one layer.
    pub layer_height: Option<f64>,
    /// Increase Q of the squared radius per metre wound (m), for a spool without pitch; 0 for a drum.
    pub build_up: f64,
    /// Change of the length on the drum per change of the controlled length: the mechanical advantage of a tackle, 1
    /// without.
    pub advantage: f64,
}

/// Position and axis of a drum, and its first pulley.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mounting {
    /// Point of the drum's axis level with the contact point at the start angle (world, m).
    pub position: Vector3<f64>,
    /// Unit vector along the drum's axis, in the direction in which the contact point travels while the first layer is
    /// paid out (world).
    pub axis: Vector3<f64>,
    /// Side on which the cable leaves.
    pub side: DrumSide,
    /// Point at which the cable enters the first pulley (world, m).
    pub pulley: Vector3<f64>,
}

/// A controlled length with its derivatives by the parameters of a drum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrumLength {
    /// q_θ (m).
    pub value: f64,
    /// ∂q_θ/∂θ by the drum angle (m/rad), above zero; minus the derivative by the start angle.
    pub by_angle: f64,
    /// ∂q_θ/∂r by the radius at a fixed angle (rad, about the angle turned).
    pub by_radius: f64,
    /// Derivative by the pitch at a fixed angle.
    pub by_pitch: f64,
    /// Derivative by the build-up at a fixed angle.
    pub by_build_up: f64,
    /// Derivative by the start length: 1.
    pub by_start_length: f64,
    /// Derivative by the point at which the cable enters the first pulley (world): the direction of the free part at
    /// the start minus that at the angle.
    pub by_pulley: Vector3<f64>,
    /// Derivative by the vector along the drum's axis (world, m), which may only turn.
    pub by_axis: Vector3<f64>,
}

impl DrumLength {
    /// Controlled length and derivatives with a tackle: changes from the start length are divided by `advantage`.
    pub(super) fn geared_down(self, start_length: f64, advantage: f64) -> Self {
        Self {
            value: start_length + (self.value - start_length) / advantage,
            by_angle: self.by_angle / advantage,
            by_radius: self.by_radius / advantage,
            by_pitch: self.by_pitch / advantage,
            by_build_up: self.by_build_up / advantage,
            by_start_length: self.by_start_length,
            by_pulley: self.by_pulley / advantage,
            by_axis: self.by_axis / advantage,
        }
    }

    /// Length and derivatives at an angle beyond the groove, for callers that return no error: all NaN.
    pub const NAN: Self = Self {
        value: f64::NAN,
        by_angle: f64::NAN,
        by_radius: f64::NAN,
        by_pitch: f64::NAN,
        by_build_up: f64::NAN,
        by_start_length: f64::NAN,
        by_pulley: Vector3::new(f64::NAN, f64::NAN, f64::NAN),
        by_axis: Vector3::new(f64::NAN, f64::NAN, f64::NAN),
    };
}
