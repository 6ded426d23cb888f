//! Second derivatives of the lengths, for the descent where lengths contradict each other.

use nalgebra::{Matrix3, Vector3};

use super::descent::Problem;
use crate::geometry::Pose;
use crate::scalar::LANES;

impl Problem<'_> {
    /// Σ ρ ∂²q/∂x² (lower triangle): added to the normal matrix, it turns Gauss–Newton into Newton.
    ///
    /// With dp = v + ω × b and D = ∂u/∂p_B: ∂²q = −dpᵀ D dp − (u·ω)(b·ω) + (u·b) ω·ω. Lengths that do not fit the robot
    /// leave residuals large enough for this to decide how fast, and whether, the descent arrives.
    #[inline(never)] // seldom needed: the kernel stays small without it
    pub(super) fn curvature<const N: usize>(&self, pose: &Pose) -> [[f64; N]; N] {
        let model = self.model;
        let mut sum = [[0.0; N]; N];
        for cable in 0..model.cable_count() {
            let Ok((course, b)) = model.course(cable, pose) else { continue };
            let residual = course.length - self.targets[cable / LANES][cable % LANES];
            let u = Vector3::from(course.direction);
            let gradient = Matrix3::from_fn(|row, column| course.direction_gradient[row][column]);
            let parts = |k: usize| {
                let twist = &model.twist_basis()[k];
                let (v, omega): (Vector3<f64>, Vector3<f64>) =
                    (twist.fixed_rows::<3>(0).into(), twist.fixed_rows::<3>(3).into());
                (v + omega.cross(&b), omega)
            };
            for i in 0..N {
                let (motion_i, omega_i) = parts(i);
                for j in 0..=i {
                    let (motion_j, omega_j) = parts(j);
                    let mixed = 0.5 * (u.dot(&omega_i) * b.dot(&omega_j) + u.dot(&omega_j) * b.dot(&omega_i));
                    let curvature = -motion_i.dot(&(gradient * motion_j)) - mixed + u.dot(&b) * omega_i.dot(&omega_j);
                    sum[i][j] += residual * curvature;
                }
            }
        }
        sum
    }
}
