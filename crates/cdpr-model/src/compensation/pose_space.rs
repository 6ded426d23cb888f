//! Poses as points, with a rotation counted as the displacement of the platform's anchors.

use super::fade::left;
use crate::geometry::{Pose, Twist};
use crate::model::Model;
use nalgebra::Vector3;

/// Margin around the samples along a coordinate: a fraction of its own range, but at least a fraction of the largest
/// range.
const MARGINS: (f64, f64) = (0.05, 0.01);

/// Range of the samples along one coordinate about their mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// World axis of the coordinate, `x` to `z` or `rx` to `rz`.
    pub axis: &'static str,
    /// `m` or `rad`.
    pub unit: &'static str,
    /// Smallest and largest coordinate of the samples, between which the map acts fully.
    pub ends: [f64; 2],
    /// Distance beyond the ends over which it fades to zero.
    pub margin: f64,
}

/// Coordinates of poses about a centre, in metres.
#[derive(Clone, Debug)]
pub(super) struct PoseSpace {
    pub(super) centre: Pose,
    /// Length that corresponds to one radian (m).
    pub(super) lever: f64,
    /// Unit displacements of the motion pattern.
    basis: Vec<Twist>,
    /// Smallest and largest coordinate of the samples (m).
    pub(super) ranges: Vec<[f64; 2]>,
}

impl PoseSpace {
    /// The space about the mean of these poses.
    pub(super) fn about(model: &Model, poses: &[Pose]) -> Self {
        let first = poses.first().copied().unwrap_or_else(Pose::identity);
        let count = poses.len().max(1) as f64;
        let mean: Twist = poses.iter().map(|pose| first.displacement_to(pose)).sum::<Twist>() / count;
        let mut space = Self::of(model, first.displaced(&mean), model.platform_radius(), Vec::new());
        let points: Vec<Vec<f64>> = poses.iter().map(|pose| space.point(pose)).collect();
        let range = |axis: usize| {
            let along = || points.iter().map(|point| point[axis]);
            [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]
        };
        space.ranges = (0..space.basis.len()).map(range).collect();
        space
    }

    /// The space about a centre, with these ranges.
    pub(super) fn of(model: &Model, centre: Pose, lever: f64, ranges: Vec<[f64; 2]>) -> Self {
        Self { centre, lever, basis: model.twist_basis().to_vec(), ranges }
    }

    /// Coordinates of a pose (m).
    pub(super) fn point(&self, pose: &Pose) -> Vec<f64> {
        let way = self.centre.displacement_to(pose);
        let along = |direction: &Twist| direction.dot(&way) * if is_turn(direction) { self.lever } else { 1.0 };
        self.basis.iter().map(along).collect()
    }

    /// Distance beyond the ends of every coordinate over which a map fades (m).
    fn margins(&self) -> impl Iterator<Item = f64> {
        let size = |range: &[f64; 2]| range[1] - range[0];
        let largest = self.ranges.iter().map(size).fold(0.0, f64::max);
        self.ranges.iter().map(move |range| (MARGINS.0 * size(range)).max(MARGINS.1 * largest))
    }

    /// Distances by which a point lies beyond the samples, as fractions of the margins.
    fn excesses(&self, point: &[f64]) -> impl Iterator<Item = f64> {
        let beyond = |(&own, &[low, high]): (&f64, &[f64; 2])| (low - own).max(own - high).max(0.0);
        point.iter().zip(&self.ranges).map(beyond).zip(self.margins()).map(|(excess, margin)| excess / margin)
    }

    /// Fraction of a map that acts at a point: 1 in the box of the samples, falling over its margins to 0.
    pub(super) fn fraction(&self, point: &[f64]) -> f64 {
        self.excesses(point).map(left).product()
    }

    /// Reason that a point lies beyond the samples, by the coordinate farthest out; `None` if it is among them.
    pub(super) fn beyond(&self, point: &[f64]) -> Option<String> {
        let farthest = self.excesses(point).enumerate().filter(|(_, part)| *part > 0.0);
        let (place, _) = farthest.max_by(|(_, one), (_, other)| one.total_cmp(other))?;
        let Extent { axis, unit, ends: [low, high], .. } = self.extents().swap_remove(place);
        let own = self.scale(&self.basis[place]) * point[place];
        Some(format!("{axis} is {own:.4} {unit} from their middle, they end at {low:.4} and {high:.4}"))
    }

    /// Range of the samples along every coordinate.
    pub(super) fn extents(&self) -> Vec<Extent> {
        let extent = |((direction, range), margin): ((&Twist, &[f64; 2]), f64)| {
            let scale = self.scale(direction);
            Extent {
                axis: ["x", "y", "z", "rx", "ry", "rz"][direction.iamax() % 6],
                unit: if is_turn(direction) { "rad" } else { "m" },
                ends: range.map(|end| scale * end),
                margin: scale * margin,
            }
        };
        self.basis.iter().zip(&self.ranges).zip(self.margins()).map(extent).collect()
    }

    /// Factor from a coordinate (m) to the unit of its direction, m or rad.
    fn scale(&self, direction: &Twist) -> f64 {
        if is_turn(direction) { 1.0 / self.lever } else { 1.0 }
    }
}

fn is_turn(direction: &Twist) -> bool {
    Vector3::from(direction.fixed_rows::<3>(3)).norm() > 0.0
}
