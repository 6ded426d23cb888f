//! Poses of a marker that were taken for those of the platform.

use nalgebra::{DMatrix, DVector, UnitQuaternion, Vector3};

use super::data::Data;
use crate::geometry::{Pose, Twist, product};
use crate::robot::Robot;

/// Steps allowed, and the length of a step that ends the search (m, rad).
const STEPS: usize = 30;
const STEP_END: f64 = 1e-9;
/// Offset as a fraction of the anchors' diagonal, and angle (rad), below which neither is reported.
const WORTH_SHARE: f64 = 1e-3;
const WORTH_ANGLE: f64 = 0.01;

/// The platform's pose in the frame of the marker.
pub(super) struct Marker(Pose);

impl Marker {
    /// The pose of the platform in the marker's frame that fits best, by Gauss–Newton steps from the identity; each
    /// cable's lengths may have an offset.
    pub(super) fn of(data: &Data<'_>) -> Option<Self> {
        let robot = data.robot;
        let basis = robot.motion_pattern.twist_basis(robot.plane);
        let mut marker = Self(Pose::identity());
        for _ in 0..STEPS {
            let step = marker.step(data, &basis)?;
            marker.0 = Pose {
                position: marker.0.position + step.fixed_rows::<3>(0),
                rotation: marker.0.rotation * UnitQuaternion::new(step.fixed_rows::<3>(3).into_owned()),
            };
            if !marker.0.is_finite() || marker.0.position.norm() > robot.anchor_diagonal() {
                return None;
            }
            if step.amax() < STEP_END {
                break;
            }
        }
        Some(marker)
    }

    /// The Gauss–Newton step of the marker's pose along the robot's degrees of freedom.
    fn step(&self, data: &Data<'_>, basis: &[Twist]) -> Option<Twist> {
        let (rows, count) = (data.poses.len(), basis.len());
        let m = data.recorded.len();
        let mut jacobian = DMatrix::zeros(rows * m, count);
        let mut residuals = DVector::zeros(rows * m);
        for (cable, recorded) in data.recorded.iter().enumerate() {
            let anchors = &data.robot.cables[cable];
            for (row, pose) in data.poses.iter().enumerate() {
                let platform = product(pose, &self.0);
                let span = platform.transform(&anchors.platform_anchor) - anchors.frame_anchor;
                let (length, at) = (span.norm(), cable * rows + row);
                residuals[at] = recorded[row] - length;
                for (k, unit) in basis.iter().enumerate() {
                    let (shift, turn): (Vector3<f64>, Vector3<f64>) =
                        (unit.fixed_rows::<3>(0).into(), unit.fixed_rows::<3>(3).into());
                    let moved = pose.rotation * shift + platform.rotation * turn.cross(&anchors.platform_anchor);
                    jacobian[(at, k)] = span.dot(&moved) / length;
                }
            }
            centre(residuals.as_mut_slice(), cable * rows, rows);
            (0..count).for_each(|k| centre(jacobian.column_mut(k).as_mut_slice(), cable * rows, rows));
        }
        let normal = jacobian.tr_mul(&jacobian);
        // directions that the data do not determine keep their values
        let solved = normal.pseudo_inverse(1e-9 * (1.0 + rows as f64)).ok()? * jacobian.tr_mul(&residuals);
        Some(basis.iter().zip(solved.iter()).map(|(unit, size)| unit * *size).sum())
    }

    /// Poses of the platform from those of the marker.
    pub(super) fn platform_poses(&self, poses: &[Pose]) -> Vec<Pose> {
        poses.iter().map(|pose| product(pose, &self.0)).collect()
    }

    /// Offset and rotation in words.
    pub(super) fn words(&self, robot: &Robot) -> String {
        let Pose { position, rotation } = self.0;
        let mut parts = Vec::new();
        if position.norm() > WORTH_SHARE * robot.anchor_diagonal() {
            parts.push(format!(
                "the platform's origin lies at ({:.3}, {:.3}, {:.3}) m in the marker's frame",
                position.x, position.y, position.z
            ));
        }
        if rotation.angle() > WORTH_ANGLE {
            parts.push(format!("the platform is turned by {:.1}° against it", rotation.angle().to_degrees()));
        }
        format!("the poses look like those of a marker, not of the platform: {}", parts.join(", "))
    }
}

/// Subtracts the mean from a range of numbers.
fn centre(numbers: &mut [f64], from: usize, count: usize) {
    let stretch = &mut numbers[from..from + count];
    let mean = stretch.iter().sum::<f64>() / count.max(1) as f64;
    stretch.iter_mut().for_each(|number| *number -= mean);
}
