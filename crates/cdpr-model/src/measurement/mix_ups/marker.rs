//! Poses of a marker that were taken for those of the platform, and anchors that would explain the same.

use nalgebra::{Matrix3, Vector3};

use crate::geometry::Pose;
use crate::measurement::comparison::frames::marker_of;
use crate::measurement::comparison::{Data, Fit};
use crate::robot::Robot;

/// Steps of an anchor.
const STEPS: usize = 10;
/// Offset as a fraction of the anchors' diagonal, and angle (rad), below which neither is reported.
const WORTH_SHARE: f64 = 1e-3;
const WORTH_ANGLE: f64 = 0.01;

/// The platform's pose in the frame of the marker.
pub(super) struct Marker(Pose);

impl Marker {
    /// The pose of the platform in the marker's frame that fits best, with the misfit (m) that it leaves; `None` where
    /// it lies beyond the robot, or where this is not below a share of what free frame anchors leave.
    pub(super) fn of(data: &Data<'_>, share: f64) -> Option<(f64, Self)> {
        let (left, frames) = marker_of(data);
        let is_near = frames.marker.position.norm() < data.robot.anchor_diagonal();
        (is_near && left < share * left_by_anchors(data)).then_some((left, Self(frames.marker)))
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

/// Misfit that is left if each frame anchor lies where its lengths fit best (m).
fn left_by_anchors(data: &Data<'_>) -> f64 {
    let m = data.recorded.len();
    let squares: f64 = (0..m).map(|cable| left_by_anchor(data, cable)).sum();
    (squares / m.max(1) as f64).sqrt()
}

/// Mean square residual of one cable with its best frame anchor, offset and scale (m²).
fn left_by_anchor(data: &Data<'_>, cable: usize) -> f64 {
    let (anchors, recorded) = (&data.robot.cables[cable], &data.recorded[cable]);
    let ends: Vec<Vector3<f64>> = data.poses.iter().map(|pose| pose.transform(&anchors.platform_anchor)).collect();
    let count = ends.len().max(1) as f64;
    let lengths = |anchor: &Vector3<f64>| -> Vec<f64> { ends.iter().map(|end| (anchor - end).norm()).collect() };
    let (mut anchor, mut least) = (anchors.frame_anchor, f64::INFINITY);
    for _ in 0..STEPS {
        let modelled = lengths(&anchor);
        let fit = Fit::of(&modelled, recorded);
        let residuals: Vec<f64> = modelled.iter().zip(recorded).map(|(l, q)| fit.residual(*l, *q)).collect();
        let squares = residuals.iter().map(|residual| residual * residual).sum::<f64>() / count;
        if !(squares < least) {
            break;
        }
        least = squares;
        let directions: Vec<Vector3<f64>> =
            ends.iter().zip(&modelled).map(|(end, length)| (anchor - end) / length.max(f64::MIN_POSITIVE)).collect();
        let mean = directions.iter().sum::<Vector3<f64>>() / count;
        let (mut normal, mut gradient) = (Matrix3::zeros(), Vector3::zeros());
        for (direction, residual) in directions.iter().zip(&residuals) {
            let row = fit.scale * (direction - mean);
            normal += row * row.transpose();
            gradient += row * *residual;
        }
        normal += Matrix3::identity() * (1e-6 * normal.trace());
        let Some(factor) = normal.cholesky() else { break };
        anchor += factor.solve(&gradient);
    }
    least
}
