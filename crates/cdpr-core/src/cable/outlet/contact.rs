//! Contact point of a straight cable with its pulley, and how free length, arc and contact point follow the platform
//! anchor (eq. 2.83–2.87).

use super::Outlet;
use super::pulley::PulleyPlane;
use crate::cable::CableEnd;
use crate::cable::path::CablePath;
use crate::cable::wrench::wrench;
use crate::scalar::{Real, add, cross, dot, scale, sub};

/// Point where a straight cable leaves its pulley, with its derivatives by the platform anchor p_B (world).
///
/// With n_M = x_A × z_A across the pulley's plane, û_r = n_M × u in it and b_a = r_p (1 − cos β), the distance of C
/// from the swivel axis:
///
/// J_qu = r_p/q_f û_rᵀ (eq. 2.84), J_pA = b_a/b_xy n_M n_Mᵀ − u J_qu. Eq. 2.86 is printed without n_Mᵀ and with +u,
/// which contradicts ∂q/∂p_B = −u. A pulley that does not swivel has no term of n_M; at a point outlet all but
/// ∂q_f/∂p_B = −u is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<T> {
    /// p_A = C, where the free part begins (world, m); the frame anchor of a point outlet.
    pub point: [T; 3],
    /// Arc r_p β that is wrapped (m).
    pub arc_length: T,
    /// ∂q_f/∂p_B of the free length.
    pub free_length_by_anchor: [T; 3],
    /// J_qu = ∂(r_p β)/∂p_B of the arc.
    pub arc_length_by_anchor: [T; 3],
    /// J_pA = ∂p_A/∂p_B by rows.
    pub point_by_anchor: [[T; 3]; 3],
}

/// Derivatives of a [`Contact`] by the pose: rows ∂/∂\[δr; δφ\], world axes (per m, per rad).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactByPose<T> {
    /// Of the free length q_f.
    pub free_length: [T; 6],
    /// Of the arc r_p β (eq. 2.85).
    pub arc_length: [T; 6],
    /// Of the contact point p_A (eq. 2.86, corrected).
    pub point: [[T; 6]; 3],
    /// Of the cable vector l = p_A − p_B = q_f u (eq. 2.87).
    pub cable_vector: [[T; 6]; 3],
}

impl<T: Real> Outlet<T> {
    /// Contact point of the cable on this path to a platform anchor (world, m), with its derivatives; meaningless if
    /// the path is not finite.
    #[inline]
    pub fn contact(&self, platform_anchor: [T; 3], path: &CablePath<T>) -> Contact<T> {
        match *self {
            Self::Point { frame_anchor } => {
                let zero = path.length.constant(0.0);
                Contact {
                    point: frame_anchor,
                    arc_length: zero,
                    free_length_by_anchor: scale(zero.constant(-1.0), path.direction),
                    arc_length_by_anchor: [zero; 3],
                    point_by_anchor: [[zero; 3]; 3],
                }
            }
            Self::Swivel { frame_anchor, swivel_axis, radius } => {
                let plane = PulleyPlane::swivelling(frame_anchor, swivel_axis, radius, platform_anchor);
                on_pulley(frame_anchor, radius, &plane, path)
            }
            Self::Sided { frame_anchor, swivel_axis, side, radius } => {
                let plane = PulleyPlane::on_side(frame_anchor, swivel_axis, side, platform_anchor);
                on_pulley(frame_anchor, radius, &plane, path)
            }
        }
    }
}

fn on_pulley<T: Real>(entry: [T; 3], radius: T, plane: &PulleyPlane<T>, path: &CablePath<T>) -> Contact<T> {
    let (u, minus) = (path.direction, radius.constant(-1.0));
    let PulleyPlane { swivel_axis, radial, turning, .. } = *plane;
    let (cosine, sine) = (-dot(u, swivel_axis), -dot(u, radial));
    let from_axis = radius * (radius.constant(1.0) - cosine); // b_a
    let normal = cross(radial, swivel_axis); // n_M
    let across = cross(normal, u); // û_r
    let arc_length_by_anchor = scale(radius / path.free_length, across);
    let row = |k: usize| sub(scale(turning * from_axis * normal[k], normal), scale(u[k], arc_length_by_anchor));
    Contact {
        point: add(entry, add(scale(from_axis, radial), scale(radius * sine, swivel_axis))),
        arc_length: radius * path.wrap_angle,
        free_length_by_anchor: sub(scale(minus, u), arc_length_by_anchor),
        arc_length_by_anchor,
        point_by_anchor: [row(0), row(1), row(2)],
    }
}

impl<T: Real> Contact<T> {
    /// Derivatives by the pose of a platform that the cable holds at this end: J_pA J_pB and so on, J_pB from
    /// [`CableEnd::by_pose`].
    pub fn by_pose(&self, end: &CableEnd<T>) -> ContactByPose<T> {
        let row = |by_anchor: [T; 3]| wrench(end.moment_arm, by_anchor);
        let (point, anchor) = (self.point_by_anchor.map(row), end.by_pose());
        ContactByPose {
            free_length: row(self.free_length_by_anchor),
            arc_length: row(self.arc_length_by_anchor),
            point,
            cable_vector: [0, 1, 2].map(|k| core::array::from_fn(|column| point[k][column] - anchor[k][column])),
        }
    }
}

#[cfg(test)]
mod tests;
