//! The pose of the platform.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

#[cfg(not(feature = "std"))]
use num_traits::Float as _;

use super::Twist;

/// Count of the numbers of a pose: position x, y, z, then the quaternion x, y, z, w.
pub const POSE_ROWS: usize = 7;

/// Position and orientation of the platform frame in the world frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Origin of the platform frame (world, m).
    pub position: Vector3<f64>,
    /// Rotation from platform to world.
    pub rotation: UnitQuaternion<f64>,
}

/// Rotation about a unit vector: the bits of [`UnitQuaternion::new`], without its exponential of 0.
fn about(axis: Vector3<f64>, angle: f64) -> UnitQuaternion<f64> {
    let half = axis * angle / 2.0;
    let square = half.norm_squared();
    if square <= f64::EPSILON * f64::EPSILON {
        return UnitQuaternion::identity();
    }
    let length = square.sqrt();
    UnitQuaternion::new_unchecked(Quaternion::from_parts(length.cos(), half * (length.sin() / length)))
}

impl Pose {
    /// Pose of a platform frame that coincides with the world frame.
    #[inline]
    pub fn identity() -> Self {
        Self { position: Vector3::zeros(), rotation: UnitQuaternion::identity() }
    }

    /// Pose from a position (m) and the dissertation's angles, R = Rx(φx) Ry(φy) Rz(φz) (rad).
    #[inline]
    pub fn from_xyz_angles(position: Vector3<f64>, angles: [f64; 3]) -> Self {
        let rotation = about(Vector3::x(), angles[0]) * about(Vector3::y(), angles[1]) * about(Vector3::z(), angles[2]);
        Self { position, rotation }
    }

    /// The angles of [`Pose::from_xyz_angles`] (rad); φx and φz in (−π, π], φy in [−π/2, π/2].
    ///
    /// At φy = ±π/2 only φx ± φz is determined; φz is then 0.
    #[inline]
    pub fn xyz_angles(&self) -> [f64; 3] {
        let m = self.rotation_matrix();
        let sine = m[(0, 2)].clamp(-1.0, 1.0);
        if 1.0 - sine.abs() < 1e-14 {
            return [m[(2, 1)].atan2(m[(1, 1)]), sine.asin(), 0.0];
        }
        [(-m[(1, 2)]).atan2(m[(2, 2)]), sine.asin(), (-m[(0, 1)]).atan2(m[(0, 0)])]
    }

    /// The rotation as a matrix R, world = R · platform.
    #[inline]
    pub fn rotation_matrix(&self) -> Matrix3<f64> {
        self.rotation.to_rotation_matrix().into_inner()
    }

    /// Rows of the rotation matrix, for the generic kernels.
    #[inline]
    pub fn rotation_rows(&self) -> [[f64; 3]; 3] {
        let m = self.rotation_matrix();
        [0, 1, 2].map(|row| [m[(row, 0)], m[(row, 1)], m[(row, 2)]])
    }

    /// Position x, y, z (m), then the quaternion x, y, z, w.
    #[inline]
    pub fn numbers(&self) -> [f64; POSE_ROWS] {
        let (r, q) = (&self.position, &self.rotation.coords);
        [r.x, r.y, r.z, q.x, q.y, q.z, q.w]
    }

    /// The inverse of [`Pose::numbers`].
    #[inline]
    pub fn from_numbers([x, y, z, i, j, k, w]: [f64; POSE_ROWS]) -> Self {
        Self { position: Vector3::new(x, y, z), rotation: UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, k)) }
    }

    /// A platform point in the world (m).
    #[inline]
    pub fn transform(&self, point_p: &Vector3<f64>) -> Vector3<f64> {
        self.position + self.rotation * point_p
    }

    /// The pose after a displacement [δr; δφ] in world axes: position r + δr, rotation exp(δφ) R.
    #[must_use]
    #[inline]
    pub fn displaced(&self, twist: &Twist) -> Self {
        let turn = UnitQuaternion::new(twist.fixed_rows::<3>(3).into_owned());
        Self { position: self.position + twist.fixed_rows::<3>(0), rotation: turn * self.rotation }
    }

    /// The displacement [δr; δφ] that leads from `self` to `other`: the inverse of [`Pose::displaced`].
    #[inline]
    pub fn displacement_to(&self, other: &Self) -> Twist {
        let mut twist = Twist::zeros();
        twist.fixed_rows_mut::<3>(0).copy_from(&(other.position - self.position));
        twist.fixed_rows_mut::<3>(3).copy_from(&(other.rotation * self.rotation.inverse()).scaled_axis());
        twist
    }

    /// Rotation from a proper rotation matrix given by rows; `None` when it is not orthonormal to 1e-6 or mirrors.
    #[inline]
    pub fn rotation_from_rows(rows: &[[f64; 3]; 3]) -> Option<UnitQuaternion<f64>> {
        let m = Matrix3::from_fn(|row, column| rows[row][column]);
        let deviation = (m.transpose() * m - Matrix3::identity()).amax();
        // written so that NaN is refused too
        if !(deviation < 1e-6 && m.determinant() > 0.0) {
            return None;
        }
        Some(UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(m)))
    }

    /// Rotation from x, y, z, w; `None` when the norm is not 1 within 1 %. Normalised otherwise.
    #[inline]
    pub fn rotation_from_xyzw(xyzw: [f64; 4]) -> Option<UnitQuaternion<f64>> {
        let quaternion = Quaternion::new(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
        ((quaternion.norm() - 1.0).abs() < 0.01).then(|| UnitQuaternion::new_normalize(quaternion))
    }

    /// Geodesic angle between two orientations (rad), in [0, π].
    #[inline]
    pub fn angle_to(&self, other: &Self) -> f64 {
        self.rotation.angle_to(&other.rotation)
    }

    /// True when every number is finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        self.position.iter().all(|x| x.is_finite()) && self.rotation.coords.iter().all(|x| x.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_survive_the_round_trip() {
        for angles in [[0.3, -0.7, 1.1], [-2.9, 1.5, 3.0], [0.0, 0.0, 0.0]] {
            let pose = Pose::from_xyz_angles(Vector3::zeros(), angles);
            for (found, expected) in pose.xyz_angles().iter().zip(angles) {
                assert!((found - expected).abs() < 1e-12, "{found} {expected}"); // rounding only
            }
        }
    }

    #[test]
    fn turns_about_an_axis_have_the_bits_of_any_turn() {
        for step in -400_i32..=400 {
            let angle = f64::from(step).powi(3) * 1e-7;
            for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
                let (found, expected) = (about(axis, angle), UnitQuaternion::new(axis * angle));
                assert_eq!(found.coords.map(f64::to_bits), expected.coords.map(f64::to_bits), "{angle}");
            }
        }
        assert_eq!(about(Vector3::x(), 1e-300), UnitQuaternion::identity());
    }

    #[test]
    fn at_gimbal_lock_the_angles_still_give_the_rotation() {
        for sign in [1.0, -1.0] {
            let pose = Pose::from_xyz_angles(Vector3::zeros(), [0.4, sign * core::f64::consts::FRAC_PI_2, 0.3]);
            let again = Pose::from_xyz_angles(Vector3::zeros(), pose.xyz_angles());
            assert!(pose.angle_to(&again) < 1e-7); // asin near 1 loses half the digits
        }
    }

    #[test]
    fn displacement_is_the_inverse_of_displaced() {
        let pose = Pose::from_xyz_angles(Vector3::new(1.0, 2.0, 3.0), [0.1, 0.2, 0.3]);
        let twist = Twist::new(0.1, -0.2, 0.3, 0.4, -0.5, 0.6);
        let back = pose.displacement_to(&pose.displaced(&twist));
        assert!((back - twist).amax() < 1e-14);
    }

    #[test]
    fn a_mirror_is_not_a_rotation() {
        assert!(Pose::rotation_from_rows(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]]).is_none());
        assert!(Pose::rotation_from_rows(&[[f64::NAN, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).is_none());
    }
}
