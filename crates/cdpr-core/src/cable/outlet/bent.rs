//! Outlet (point or swivelling pulley) of a cable whose direction is given at the outlet, for sagging cables.

use crate::scalar::{Smooth, add, cross, dot, scale, sub};

/// A swivelling pulley and the side on which its cable leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulley<T> {
    /// z_A, unit vector along the swivel axis, from the winch into the pulley (world).
    pub swivel_axis: [T; 3],
    /// r_p (m).
    pub radius: T,
    /// 1 when the cable leaves on the side of the axis to which it runs, −1 when it crosses the axis (wrapped by more
    /// than half a turn).
    pub side: f64,
}

/// Contact point and wrap angle of a cable that leaves in a given direction.
#[derive(Clone, Copy, Debug)]
pub struct Outlet<T> {
    /// C, from the frame anchor (world, m).
    pub contact: [T; 3],
    /// β (rad).
    pub wrap_angle: T,
    /// x_A, in the pulley's plane, perpendicular to the axis.
    radial: [T; 3],
    /// −u·z_A.
    cosine: T,
    /// −u·x_A.
    sine: T,
}

/// C and β for a cable that leaves with the direction t = cos β z_A + sin β x_A (unit vector, from the outlet on): the
/// pulley swivels until t lies in its plane. C = D + r_p (1 − cos β) x_A + r_p sin β z_A. Along the axis the result is
/// NaN.
#[inline]
pub fn outlet<T: Smooth>(pulley: &Pulley<T>, direction: [T; 3]) -> Outlet<T> {
    let one = pulley.radius.constant(1.0);
    let axis = pulley.swivel_axis;
    let cosine = dot(direction, axis);
    let across = sub(direction, scale(cosine, axis));
    let sine = dot(across, across).sqrt() * one.constant(pulley.side);
    let radial = scale(one / sine, across);
    let r = pulley.radius;
    Outlet {
        contact: add(scale(r * (one - cosine), radial), scale(r * sine, axis)),
        wrap_angle: sine.full_angle(cosine),
        radial,
        cosine,
        sine,
    }
}

impl Outlet<f64> {
    /// Changes of C (m) and β (rad) when the direction changes by δt (perpendicular to t).
    #[inline]
    pub fn derivative(&self, pulley: &Pulley<f64>, change: [f64; 3]) -> ([f64; 3], f64) {
        let (axis, radial) = (pulley.swivel_axis, self.radial);
        let side = cross(axis, radial);
        let (d_cosine, d_sine) = (dot(change, axis), dot(change, radial));
        let d_radial = scale(dot(change, side) / self.sine, side);
        let r = pulley.radius;
        let turned = add(scale(-r * d_cosine, radial), scale(r * (1.0 - self.cosine), d_radial));
        (add(turned, scale(r * d_sine, axis)), self.cosine * d_sine - self.sine * d_cosine)
    }

    /// ∂C/∂r_p and ∂(r_p β)/∂r_p at a fixed direction.
    #[inline]
    pub fn by_radius(&self, pulley: &Pulley<f64>) -> ([f64; 3], f64) {
        let contact = add(scale(1.0 - self.cosine, self.radial), scale(self.sine, pulley.swivel_axis));
        (contact, self.wrap_angle)
    }
}
