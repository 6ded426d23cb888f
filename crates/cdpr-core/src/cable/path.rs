//! The path of one cable from its outlet to the platform anchor.

use thiserror::Error;

use super::wrench::wrench;
use crate::scalar::{Real, dot, rotate_back, scale};

/// Length and pull of one rigid, straight cable, with the terms of their derivatives.
///
/// Identities that hold for every outlet (p_B: platform anchor in the world, a: frame anchor):
/// ∂q/∂p_B = −u, ∂q/∂a = u (the involute property), ∂u/∂p_B = −∂u/∂a.
#[derive(Clone, Copy, Debug)]
pub struct CablePath<T> {
    /// Geometric length q from the frame anchor, wrapped part included (m).
    pub length: T,
    /// Length of the straight part q_f (m).
    pub free_length: T,
    /// Unit pull u on the platform, from the platform anchor towards the outlet (world).
    pub direction: [T; 3],
    /// Wrap angle β on the pulley, in [0, 2π) (rad); 0 at a point outlet.
    pub wrap_angle: T,
    /// ∂q/∂r_p by the pulley radius: β − sin β.
    pub length_by_radius: T,
    /// ∂u/∂r_p by the pulley radius (1/m).
    pub direction_by_radius: [T; 3],
    /// ∂u/∂p_B by rows (1/m), symmetric.
    pub direction_gradient: [[T; 3]; 3],
}

/// Reason for which a cable has no unique path.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum GeometryError {
    /// The two anchors coincide, so the cable has no direction.
    #[error("cable {cable}: its platform anchor lies on its outlet, so the cable has no direction")]
    ZeroLength {
        /// Number of the cable, from 1.
        cable: usize,
    },
    /// The platform anchor lies inside the pulley.
    #[error(
        "cable {cable}: its platform anchor lies inside its pulley (radius {radius} m), so no cable can leave it tangentially"
    )]
    InsidePulley {
        /// Number of the cable, from 1.
        cable: usize,
        /// Pulley radius (m).
        radius: f64,
    },
    /// The platform anchor lies on the swivel axis, so the pulley has no unique plane.
    #[error("cable {cable}: its platform anchor lies on the pulley's swivel axis, so the swivel angle is not unique")]
    OnSwivelAxis {
        /// Number of the cable, from 1.
        cable: usize,
    },
    /// The cable would lift off a pulley that does not swivel.
    #[error(
        "cable {cable}: its platform anchor lies on the open side of its pulley, which does not swivel, so the cable would lift off; is pulley_wrap_side right?"
    )]
    OpenSide {
        /// Number of the cable, from 1.
        cable: usize,
    },
    /// A number of the pose or the cable is so large or so small that the length overflows.
    #[error("cable {cable}: its length is not a finite number; check the units of pose and anchors (m)")]
    NotFinite {
        /// Number of the cable, from 1.
        cable: usize,
    },
}

impl GeometryError {
    /// Number of the cable, from 1.
    #[inline]
    pub fn cable(&self) -> usize {
        match *self {
            Self::ZeroLength { cable }
            | Self::InsidePulley { cable, .. }
            | Self::OnSwivelAxis { cable }
            | Self::OpenSide { cable }
            | Self::NotFinite { cable } => cable,
        }
    }
}

impl<T: Real> CablePath<T> {
    /// Derivatives of length and direction by the pose: rows ∂q/∂\[δr; δφ\] and ∂u/∂\[δr; δφ\], for the moment arm
    /// b = R b_P.
    ///
    /// ∂q = −\[u; b × u\] and ∂u = ∂u/∂p_B · \[I, −\[b\]×\] (see the book, “Models”).
    #[inline(always)]
    pub fn by_pose(&self, moment_arm: [T; 3]) -> ([T; 6], [[T; 6]; 3]) {
        let [x, y, z] = self.direction_gradient;
        let length = wrench(moment_arm, scale(self.length.constant(-1.0), self.direction));
        (length, [wrench(moment_arm, x), wrench(moment_arm, y), wrench(moment_arm, z)])
    }

    /// Derivatives of the recorded length s q + o, times a weight: by frame anchor (world), platform anchor (platform
    /// frame), offset o, scale s and pulley radius. R is given by rows.
    #[inline(always)]
    pub fn recorded_length_row(&self, rotation: &[[T; 3]; 3], weight: T, length_scale: T) -> [T; 9] {
        let factor = weight * length_scale;
        let u = self.direction;
        let in_platform = rotate_back(rotation, u);
        [
            factor * u[0],
            factor * u[1],
            factor * u[2],
            -(factor * in_platform[0]),
            -(factor * in_platform[1]),
            -(factor * in_platform[2]),
            weight,
            weight * self.length,
            factor * self.length_by_radius,
        ]
    }

    /// Derivatives of length and direction by the platform anchor in the platform frame, R given by rows.
    ///
    /// ∂q/∂b_P = −Rᵀ u, ∂u/∂b_P = ∂u/∂p_B R.
    #[inline(always)]
    pub fn by_platform_anchor(&self, rotation: &[[T; 3]; 3]) -> ([T; 3], [[T; 3]; 3]) {
        let [x, y, z] = self.direction_gradient;
        let length = rotate_back(rotation, scale(self.length.constant(-1.0), self.direction));
        (length, [rotate_back(rotation, x), rotate_back(rotation, y), rotate_back(rotation, z)])
    }
}

/// Unit vector and length of `v`.
#[inline(always)]
pub(super) fn normalized<T: Real>(v: [T; 3]) -> ([T; 3], T) {
    let length = dot(v, v).sqrt();
    (scale(length.constant(1.0) / length, v), length)
}
