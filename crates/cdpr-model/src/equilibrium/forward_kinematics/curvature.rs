//! Second derivatives of the lengths, for descents with contradictory lengths.

use nalgebra::Matrix6;

use super::descent::Problem;
use crate::cable::wrench::wrench_by_pose;
use crate::geometry::Pose;
use crate::scalar::LANES;

impl Problem<'_> {
    /// Σ ρ ∂²q/∂x² (lower triangle): added to the normal matrix, it turns Gauss–Newton into Newton.
    ///
    /// ∂²q/∂x² is minus the symmetric part of ∂\[u; b × u\]/∂x. For lengths that do not fit the robot the residuals are
    /// so large that this term decides the speed, and the success, of the descent.
    #[inline(never)] // seldom needed: the kernel stays small without it
    pub(super) fn curvature<const N: usize>(&self, pose: &Pose) -> [[f64; N]; N] {
        let model = self.model;
        let mut sum = [[0.0; N]; N];
        for cable in 0..model.cable_count() {
            let Ok((path, moment_arm)) = model.path(cable, pose) else { continue };
            let residual = path.length - self.targets[cable / LANES][cable % LANES];
            let by_pose = wrench_by_pose(&path.direction_gradient, moment_arm.into(), path.direction);
            let by_pose =
                Matrix6::from_fn(|row, column| -0.5 * residual * (by_pose[row][column] + by_pose[column][row]));
            for i in 0..N {
                let change = by_pose * model.twist_basis()[i];
                for j in 0..=i {
                    sum[i][j] += model.twist_basis()[j].dot(&change);
                }
            }
        }
        sum
    }
}
