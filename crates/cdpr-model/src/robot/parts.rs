//! Parts of a cable that several keys of the file state together: complete, or with the only key that is stated.

use super::Axis;

/// Pulley at the frame.
///
/// A file may state a radius without an axis (the position can be found from the anchor of the point model) or an axis
/// without a radius; no effect uses either.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pulley {
    /// Pulley with radius and axis.
    Whole {
        /// r_p (m).
        radius: f64,
        /// Unit vector along the swivel axis, from the winch into the pulley (world).
        swivel_axis: Axis,
    },
    /// Only the radius (m).
    Radius(f64),
    /// Only the unit vector along the swivel axis (world).
    SwivelAxis(Axis),
}

impl Pulley {
    /// The pulley with a radius (m) and a swivel axis, as far as stated; `None` without either.
    pub(crate) fn of(radius: Option<f64>, swivel_axis: Option<Axis>) -> Option<Self> {
        match (radius, swivel_axis) {
            (Some(radius), Some(swivel_axis)) => Some(Self::Whole { radius, swivel_axis }),
            (Some(radius), None) => Some(Self::Radius(radius)),
            (None, Some(swivel_axis)) => Some(Self::SwivelAxis(swivel_axis)),
            (None, None) => None,
        }
    }
}

/// Stiffness of a cable, in one of the three forms of robot files.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CableStiffness {
    /// Specific stiffness k_F = E·A (N).
    Axial(f64),
    /// Specific compliance 1/(E·A) (1/N); 0 is a rigid cable.
    Compliance(f64),
    /// Spring constant that does not depend on the length (N/m).
    Spring(f64),
}
