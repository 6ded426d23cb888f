//! Poses as points, in which a turn counts as the way of the platform's anchors.

use nalgebra::Vector3;

use crate::geometry::{Pose, Twist};
use crate::model::Model;

/// Share of its own range, and of the largest one, by which a coordinate may lie beyond the samples.
const MARGINS: (f64, f64) = (0.05, 0.01);

/// Coordinates of poses about a centre, in metres.
#[derive(Clone, Debug)]
pub(super) struct PoseSpace {
    pub(super) centre: Pose,
    /// Metres that a radian counts.
    pub(super) lever: f64,
    /// Unit displacements of the motion pattern.
    basis: Vec<Twist>,
    /// Smallest and largest coordinate of the samples (m).
    pub(super) ranges: Vec<[f64; 2]>,
}

impl PoseSpace {
    /// The space about the middle of these poses.
    pub(super) fn about(model: &Model, poses: &[Pose]) -> Self {
        let first = poses.first().copied().unwrap_or_else(Pose::identity);
        let count = poses.len().max(1) as f64;
        let mean: Twist = poses.iter().map(|pose| first.displacement_to(pose)).sum::<Twist>() / count;
        let mut space = Self::of(model, (first.displaced(&mean), model.platform_radius()), Vec::new());
        let points: Vec<Vec<f64>> = poses.iter().map(|pose| space.point(pose)).collect();
        let range = |axis: usize| {
            let along = || points.iter().map(|point| point[axis]);
            [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]
        };
        space.ranges = (0..space.basis.len()).map(range).collect();
        space
    }

    /// The space about a centre, with these ranges.
    pub(super) fn of(model: &Model, (centre, lever): (Pose, f64), ranges: Vec<[f64; 2]>) -> Self {
        Self { centre, lever, basis: model.twist_basis().to_vec(), ranges }
    }

    /// Coordinates of a pose (m).
    pub(super) fn point(&self, pose: &Pose) -> Vec<f64> {
        let way = self.centre.displacement_to(pose);
        let along = |direction: &Twist| {
            let is_turn = Vector3::from(direction.fixed_rows::<3>(3)).norm() > 0.0;
            direction.dot(&way) * if is_turn { self.lever } else { 1.0 }
        };
        self.basis.iter().map(along).collect()
    }

    /// Reason why a point lies beyond the samples; nothing where it is among them.
    pub(super) fn beyond(&self, point: &[f64]) -> Option<String> {
        let size = |range: &[f64; 2]| range[1] - range[0];
        let largest = self.ranges.iter().map(size).fold(0.0, f64::max);
        point.iter().zip(&self.ranges).zip(&self.basis).find_map(|((&own, range), direction)| {
            let margin = (MARGINS.0 * size(range)).max(MARGINS.1 * largest);
            if (range[0] - margin..=range[1] + margin).contains(&own) {
                return None;
            }
            let is_turn = Vector3::from(direction.fixed_rows::<3>(3)).norm() > 0.0;
            let axis = ["x", "y", "z", "rx", "ry", "rz"][direction.iamax() % 6];
            let (unit, scale) = if is_turn { ("rad", 1.0 / self.lever) } else { ("m", 1.0) };
            let [low, high] = range.map(|end| scale * end);
            Some(format!("{axis} is {:.4} {unit} from their middle, they end at {low:.4} and {high:.4}", scale * own))
        })
    }
}
