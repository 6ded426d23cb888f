//! Parts of a cable that several keys of the file make together: they are whole, or it is said which key is there alone.

use super::Axis;

/// Pulley at the frame.
///
/// Files may state a radius without an axis (the place can be found from the anchor of the point model) or an axis without a radius; no effect reads either.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pulley {
    /// Pulley of a known size and place.
    Whole {
        /// r_p (m).
        radius: f64,
        /// Unit vector along the swivel axis, from the winch into the pulley (world).
        swivel_axis: Axis,
    },
    /// Radius alone (m).
    Radius(f64),
    /// Unit vector along the swivel axis alone (world).
    SwivelAxis(Axis),
}

impl Pulley {
    /// The pulley that a radius (m) and a swivel axis make; `None` without either.
    pub(crate) fn of(radius: Option<f64>, swivel_axis: Option<Axis>) -> Option<Self> {
        match (radius, swivel_axis) {
            (Some(radius), Some(swivel_axis)) => Some(Self::Whole { radius, swivel_axis }),
            (Some(radius), None) => Some(Self::Radius(radius)),
            (None, Some(swivel_axis)) => Some(Self::SwivelAxis(swivel_axis)),
            (None, None) => None,
        }
    }
}

/// Stiffness of a cable in one of the three ways that files know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CableStiffness {
    /// Specific stiffness k_F = E·A (N).
    Axial(f64),
    /// Specific compliance 1/(E·A) (1/N); 0 is a rigid cable.
    Compliance(f64),
    /// Spring constant that does not depend on the length (N/m).
    Spring(f64),
}
