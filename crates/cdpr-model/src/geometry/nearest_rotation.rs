//! The rotation nearest to the moment matrix of pairs of directions.

use nalgebra::{Matrix3, Rotation3, SVD, UnitQuaternion, Vector3};

/// The rotation R with the largest tr(Rᵀ M) (Umeyama 1991), about the normal of a plane if one is given.
pub fn nearest_rotation(mut moment: Matrix3<f64>, normal: Option<Vector3<f64>>) -> UnitQuaternion<f64> {
    if let Some(normal) = normal {
        // large enough that the rotation keeps the normal
        moment += 1e3 * (moment.norm() + 1.0) * normal * normal.transpose();
    }
    let SVD { u: Some(u), v_t: Some(v_t), .. } = SVD::new(moment, true, true) else {
        return UnitQuaternion::identity();
    };
    let mirror = if (u * v_t).determinant() < 0.0 { -1.0 } else { 1.0 };
    let rotation = u * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, mirror)) * v_t;
    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation))
}
