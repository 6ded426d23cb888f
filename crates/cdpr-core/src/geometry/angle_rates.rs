//! Angular velocity of the platform from the rates of the pose's angles, and back (eq. 2.45, 2.46).

use nalgebra::{Matrix3, Vector3};

#[cfg(not(feature = "std"))]
use num_traits::Float as _;

use super::Pose;

/// Value of |cos φy| below which the axes of φx and φz count as parallel; [`Pose::xyz_angles`] sets φz to 0 there too.
const GIMBAL_LOCK: f64 = 1.5e-7;

impl Pose {
    /// J_P = \[e_x, Rx e_y, Rx Ry e_z\] at the angles φ of [`Pose::from_xyz_angles`] (rad): ω = J_P φ̇, a small turn δφ
    /// of the platform = J_P times a change of the angles (world axes, 3×3, dimensionless; eq. 2.45, 2.46).
    ///
    /// Its determinant is cos φy: at φy = ±π/2 no change of the angles turns about e_x × Rx e_y.
    pub fn xyz_angle_jacobian(angles: [f64; 3]) -> Matrix3<f64> {
        let ((sx, cx), (sy, cy)) = (angles[0].sin_cos(), angles[1].sin_cos());
        Matrix3::from_columns(&[Vector3::x(), Vector3::new(0.0, cx, sx), Vector3::new(sy, -sx * cy, cx * cy)])
    }

    /// J_P⁻¹, from ω to the rates of the angles (3×3, dimensionless): φ̇ = J_P⁻¹ ω.
    ///
    /// `None` if the axes of φx and φz are parallel (φy = ±π/2, gimbal lock to 1e-7 rad).
    pub fn xyz_angle_jacobian_inverse(angles: [f64; 3]) -> Option<Matrix3<f64>> {
        let ((sx, cx), (sy, cy)) = (angles[0].sin_cos(), angles[1].sin_cos());
        // written so that NaN gives `None` too
        (cy.abs() > GIMBAL_LOCK).then(|| {
            let (along_y, along_z) = (-sx / cy, cx / cy);
            Matrix3::new(1.0, -sy * along_y, -sy * along_z, 0.0, cx, sx, 0.0, along_y, along_z)
        })
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use nalgebra::{Const, SVector};
    use num_dual::{DualNum, DualVec};
    use proptest::prelude::*;

    use super::*;
    use cdpr_testing::property;

    type Dual = DualVec<f64, Const<3>>;

    /// R = Rx Ry Rz in dual numbers of the three angles.
    fn rotation(angles: [f64; 3]) -> [[Dual; 3]; 3] {
        let angle =
            |k: usize| Dual::new(angles[k], num_dual::Derivative::some(SVector::<f64, 3>::ith(k, 1.0))).sin_cos();
        let ((sx, cx), (sy, cy), (sz, cz)) = (angle(0), angle(1), angle(2));
        let (zero, one) = (Dual::from(0.0), Dual::from(1.0));
        let product = |a: [[Dual; 3]; 3], b: [[Dual; 3]; 3]| {
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j]))
        };
        let x = [[one, zero, zero], [zero, cx, -sx], [zero, sx, cx]];
        let y = [[cy, zero, sy], [zero, one, zero], [-sy, zero, cy]];
        let z = [[cz, -sz, zero], [sz, cz, zero], [zero, zero, one]];
        product(product(x, y), z)
    }

    proptest! {
        #![proptest_config(property::cases(300))]

        /// ω̃ = Ṙ Rᵀ, column by column; both sides are exact, so only rounding separates them.
        #[test]
        fn the_angle_jacobian_is_the_derivative_of_the_rotation(
            angles in [-PI..PI, -PI..PI, -PI..PI],
        ) {
            let rows = rotation(angles);
            let value = Matrix3::from_fn(|i, j| rows[i][j].re);
            let pose = Pose::from_xyz_angles(Vector3::zeros(), angles);
            prop_assert!((value - pose.rotation_matrix()).amax() < 1e-14);
            let jacobian = Pose::xyz_angle_jacobian(angles);
            for column in 0..3 {
                let by_angle = Matrix3::from_fn(|i, j| rows[i][j].eps.unwrap_generic(Const, Const::<1>)[column]);
                let spin = by_angle * value.transpose();
                let omega = Vector3::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]);
                prop_assert!((jacobian.column(column) - omega).amax() < 1e-14, "column {column}: {omega}");
            }
            prop_assert!((jacobian.determinant() - angles[1].cos()).abs() < 1e-14);
        }

        /// Rounding grows with the inverse Jacobian, as 1/cos φy.
        #[test]
        fn rates_and_angular_velocity_lead_to_each_other(angles in [-PI..PI, -1.57..1.57_f64, -PI..PI]) {
            let inverse = Pose::xyz_angle_jacobian_inverse(angles).unwrap();
            let gap = inverse * Pose::xyz_angle_jacobian(angles) - Matrix3::identity();
            prop_assert!(gap.amax() < 1e-14 / angles[1].cos(), "{gap}");
        }
    }

    #[test]
    fn at_gimbal_lock_angular_velocities_have_no_rates() {
        for angles in
            [[0.4, FRAC_PI_2, 0.3], [0.4, -FRAC_PI_2, 0.3], [0.0, FRAC_PI_2 - 1e-7, 0.0], [0.0, f64::NAN, 0.0]]
        {
            assert_eq!(Pose::xyz_angle_jacobian_inverse(angles), None, "{angles:?}");
        }
        assert!(Pose::xyz_angle_jacobian_inverse([0.4, FRAC_PI_2 - 1e-6, 0.3]).is_some());
    }
}
