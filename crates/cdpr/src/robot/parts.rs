//! Parts of a cable that several keys of the file make together: they are whole, or it is said which key is there alone.

use nalgebra::Vector3;

use super::Cable;

/// Pulley at the frame.
///
/// Files may state a radius without an axis (`cdpr place-pulleys` finds the place) or an axis without a radius; no effect reads either.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pulley {
    /// Pulley of a known size and place.
    Whole {
        /// r_p (m).
        radius: f64,
        /// Unit vector along the swivel axis, from the winch into the pulley (world).
        swivel_axis: Vector3<f64>,
    },
    /// Radius alone (m).
    Radius(f64),
    /// Unit vector along the swivel axis alone (world).
    SwivelAxis(Vector3<f64>),
}

impl Pulley {
    /// The pulley that a radius (m) and a swivel axis make; `None` without either.
    pub fn of(radius: Option<f64>, swivel_axis: Option<Vector3<f64>>) -> Option<Self> {
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

impl Cable {
    /// Pulley radius r_p (m), with or without an axis.
    pub fn pulley_radius(&self) -> Option<f64> {
        match self.pulley? {
            Pulley::Whole { radius, .. } | Pulley::Radius(radius) => Some(radius),
            Pulley::SwivelAxis(_) => None,
        }
    }

    /// Unit vector along the pulley's swivel axis (world), with or without a radius.
    pub fn pulley_swivel_axis(&self) -> Option<Vector3<f64>> {
        match self.pulley? {
            Pulley::Whole { swivel_axis, .. } | Pulley::SwivelAxis(swivel_axis) => Some(swivel_axis),
            Pulley::Radius(_) => None,
        }
    }

    /// Gives the pulley a radius (m); its axis stays.
    pub fn set_pulley_radius(&mut self, radius: f64) {
        self.pulley = Pulley::of(Some(radius), self.pulley_swivel_axis());
    }

    /// Gives the pulley a swivel axis (unit, world); its radius stays.
    pub fn set_pulley_swivel_axis(&mut self, swivel_axis: Vector3<f64>) {
        self.pulley = Pulley::of(self.pulley_radius(), Some(swivel_axis));
    }

    /// E·A (N), where it is stated as a stiffness.
    pub fn axial_stiffness(&self) -> Option<f64> {
        match self.stiffness? {
            CableStiffness::Axial(stiffness) => Some(stiffness),
            CableStiffness::Compliance(_) | CableStiffness::Spring(_) => None,
        }
    }

    /// 1/(E·A) (1/N), where it is stated as a compliance.
    pub fn axial_compliance(&self) -> Option<f64> {
        match self.stiffness? {
            CableStiffness::Compliance(compliance) => Some(compliance),
            CableStiffness::Axial(_) | CableStiffness::Spring(_) => None,
        }
    }

    /// Specific compliance 1/(E·A) (1/N), stated in either way; `None` for a constant spring.
    pub fn specific_compliance(&self) -> Option<f64> {
        match self.stiffness? {
            CableStiffness::Axial(stiffness) => Some(1.0 / stiffness),
            CableStiffness::Compliance(compliance) => Some(compliance),
            CableStiffness::Spring(_) => None,
        }
    }

    /// Spring constant (N/m) of a cable whose stiffness does not depend on its length.
    pub fn spring_constant(&self) -> Option<f64> {
        match self.stiffness? {
            CableStiffness::Spring(constant) => Some(constant),
            CableStiffness::Axial(_) | CableStiffness::Compliance(_) => None,
        }
    }
}
