//! Pulley: the cable enters at D, wraps and leaves tangentially (eq. 2.16–2.29). Its plane turns with the platform
//! anchor about the swivel axis, or is fixed with a given side (planar robots).

use thiserror::Error;

use crate::cable::path::{CablePath, normalized};
use crate::scalar::{Real, add, cross, dot, scale, sub};

/// Added under the root of the distance from the swivel axis: too small to change any bit of a distance above 1e-142 m,
/// it keeps r_p = 0 free of 0/0 when the platform anchor lies on the axis.
const AXIS_GUARD: f64 = 1e-300;

/// Sine of the angle from the swivel axis below which rounding hides on which side of the axis the anchor lies.
pub const ON_AXIS: f64 = 1e-12;

/// The plane of a pulley and the platform anchor in it.
pub(super) struct PulleyPlane<T> {
    /// z_A.
    pub(super) swivel_axis: [T; 3],
    /// x_A.
    pub(super) radial: [T; 3],
    /// Component of the anchor along z_A from D (m).
    b_z: T,
    /// Component of the anchor along x_A from D (m).
    b_xy: T,
    /// Rate at which the plane turns as the anchor moves across it (1/m): 1/b_xy, or 0 for a fixed plane.
    pub(super) turning: T,
}

impl<T: Real> PulleyPlane<T> {
    /// Plane that turns with the platform anchor about the swivel axis.
    #[inline(always)]
    pub(super) fn swivelling(entry: [T; 3], swivel_axis: [T; 3], radius: T, platform_anchor: [T; 3]) -> Self {
        let d = sub(platform_anchor, entry);
        let b_z = dot(d, swivel_axis);
        let across = sub(d, scale(b_z, swivel_axis));
        let b_xy = (dot(across, across) + radius.constant(AXIS_GUARD)).sqrt();
        let turning = radius.constant(1.0) / b_xy;
        Self { swivel_axis, radial: scale(turning, across), b_z, b_xy, turning }
    }

    /// Fixed plane, with x_A = `side`.
    #[inline(always)]
    pub(super) fn on_side(entry: [T; 3], swivel_axis: [T; 3], side: [T; 3], platform_anchor: [T; 3]) -> Self {
        let d = sub(platform_anchor, entry);
        let (b_z, b_xy) = (dot(d, swivel_axis), dot(d, side));
        Self { swivel_axis, radial: side, b_z, b_xy, turning: b_z.constant(0.0) }
    }
}

/// Path over a pulley of radius r_p (m) whose swivel axis runs through D along the unit vector z_A (world).
///
/// x_A points from the axis to the platform anchor. Inside the pulley (b_M < r_p) the result is NaN.
#[inline(always)]
pub fn path<T: Real>(entry: [T; 3], swivel_axis: [T; 3], radius: T, platform_anchor: [T; 3]) -> CablePath<T> {
    path_in_plane(PulleyPlane::swivelling(entry, swivel_axis, radius, platform_anchor), radius)
}

/// Path over a pulley that does not swivel: its centre lies at D + r_p x_A, with the unit vector x_A = `side` (world).
///
/// For anchors in the plane of z_A and x_A. Inside the pulley, and on its open side (b_xy < 0, b_z > 0), where the
/// cable would lift off, the result is NaN.
#[inline(always)]
pub fn path_on_side<T: Real>(
    entry: [T; 3],
    swivel_axis: [T; 3],
    side: [T; 3],
    radius: T,
    platform_anchor: [T; 3],
) -> CablePath<T> {
    let plane = PulleyPlane::on_side(entry, swivel_axis, side, platform_anchor);
    // a branchless case: NaN in the last quadrant, else 0
    let open_side =
        radius.constant(0.0) * (radius.constant(1.5 * core::f64::consts::PI) - plane.b_xy.full_angle(plane.b_z)).sqrt();
    let mut path = path_in_plane(plane, radius);
    path.length = path.length + open_side;
    path
}

/// Path with h = b_xy − r_p: q_f = √(h² + b_z² − r_p²), β = arg((q_f + i r_p)(b_z + i h)) in [0, 2π), q = q_f + r_p β
/// and −u = cos β z_A + sin β x_A.
#[inline(always)]
fn path_in_plane<T: Real>(plane: PulleyPlane<T>, radius: T) -> CablePath<T> {
    let PulleyPlane { swivel_axis, radial, b_z, b_xy, turning } = plane;
    let one = radius.constant(1.0);
    let h = b_xy - radius;
    let center_distance_squared = h * h + b_z * b_z; // b_M²
    let free_length = (center_distance_squared - radius * radius).sqrt();
    // b_M² cos β and b_M² sin β: the angle needs no division
    let (forward, sideways) = (free_length * b_z - radius * h, free_length * h + radius * b_z);
    let wrap_angle = sideways.full_angle(forward);
    let by_square = one / center_distance_squared;
    let (cosine, sine) = (forward * by_square, sideways * by_square);

    // The free part swings about C in the pulley's plane (along `bend`) and turns with the swivel (along `side`).
    let bend = sub(scale(cosine, radial), scale(sine, swivel_axis));
    let side = cross(swivel_axis, radial);
    let (swing, swivel) = (one / free_length, sine * turning);
    let mut direction_gradient = [[one; 3]; 3];
    for row in 0..3 {
        for column in 0..3 {
            direction_gradient[row][column] = -(swing * bend[row] * bend[column] + swivel * side[row] * side[column]);
        }
    }
    CablePath {
        length: free_length + radius * wrap_angle,
        free_length,
        direction: add(scale(-cosine, swivel_axis), scale(-sine, radial)),
        wrap_angle,
        length_by_radius: wrap_angle - sine,
        direction_by_radius: scale((cosine - one) * swing, bend),
        direction_gradient,
    }
}

/// Swivel angle of the pulley (rad, in (−π, π]): the angle of its plane about the swivel axis, right-handed, from the
/// part of `reference` (any length) across the axis.
///
/// `None` if it is not determined: the platform anchor or the reference lies on the axis.
pub fn swivel_angle(
    entry: [f64; 3],
    swivel_axis: [f64; 3],
    reference: [f64; 3],
    platform_anchor: [f64; 3],
) -> Option<f64> {
    let d = sub(platform_anchor, entry);
    let side = cross(swivel_axis, reference);
    // side × z_A is the part of the reference across the axis
    let (sine, cosine) = (dot(d, side), dot(d, cross(side, swivel_axis)));
    let scale = dot(d, d).sqrt() * dot(reference, reference).sqrt();
    (num_traits::Float::hypot(sine, cosine) > ON_AXIS * scale).then(|| num_traits::Float::atan2(sine, cosine))
}

/// Reason for which a pulley cannot be placed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum PlacementError {
    /// The cable runs back along the swivel axis, so every swivel angle fits.
    #[error("the cable runs against the swivel axis at this pose, so the pulley's swivel angle is not determined")]
    AlongAxis,
    /// Outlet and platform anchor coincide.
    #[error("outlet and platform anchor coincide at this pose")]
    ZeroLength,
}

/// Entry point D (world, m) of a pulley whose contact point lies on `outlet` when the cable runs to `platform_anchor`.
///
/// Anchors published for the point model are contact points, not D (sec. 3.8):
/// D = C − r_p (1 − cos β) x_A − r_p sin β z_A with β in [0, π] from the cable's direction alone.
pub fn place(
    outlet: [f64; 3],
    swivel_axis: [f64; 3],
    radius: f64,
    platform_anchor: [f64; 3],
) -> Result<[f64; 3], PlacementError> {
    let away = direction(outlet, platform_anchor)?;
    let cosine = dot(away, swivel_axis);
    let across = sub(away, scale(cosine, swivel_axis));
    let sine = dot(across, across).sqrt();
    if sine < 1e-12 {
        // along the axis the cable does not touch the pulley; against it, the cable turns by π in an unknown plane
        return if cosine > 0.0 || radius == 0.0 { Ok(outlet) } else { Err(PlacementError::AlongAxis) };
    }
    let radial = scale(1.0 / sine, across);
    Ok(entry_before(outlet, (swivel_axis, cosine), (radial, sine), radius))
}

/// Unit vector from the outlet to the platform anchor.
fn direction(outlet: [f64; 3], platform_anchor: [f64; 3]) -> Result<[f64; 3], PlacementError> {
    let (away, length) = normalized(sub(platform_anchor, outlet));
    if length > 0.0 { Ok(away) } else { Err(PlacementError::ZeroLength) }
}

/// [`place`] for a pulley that does not swivel, with x_A = `side`; defined for any direction in its plane.
pub fn place_on_side(
    outlet: [f64; 3],
    swivel_axis: [f64; 3],
    side: [f64; 3],
    radius: f64,
    platform_anchor: [f64; 3],
) -> Result<[f64; 3], PlacementError> {
    let away = direction(outlet, platform_anchor)?;
    let (cosine, sine) = (dot(away, swivel_axis), dot(away, side));
    Ok(entry_before(outlet, (swivel_axis, cosine), (side, sine), radius))
}

/// Entry point D from the contact point, with z_A and cos β, x_A and sin β.
fn entry_before(
    outlet: [f64; 3],
    (swivel_axis, cosine): ([f64; 3], f64),
    (radial, sine): ([f64; 3], f64),
    radius: f64,
) -> [f64; 3] {
    sub(sub(outlet, scale(radius * (1.0 - cosine), radial)), scale(radius * sine, swivel_axis))
}
