//! Test of whether the cables act in every direction in which the platform can move.

use super::criterion::rank;
use super::{Point, Region};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;

/// Largest rank of the structure matrix at points of a region, each in the first orientation in which the criterion
/// holds; `None` if there is no such point.
///
/// If it is less than the degrees of freedom, the cables balance the load, but cannot balance any change of it in some
/// direction.
pub fn largest_rank(model: &Model, region: &Region<'_>, points: &[Point]) -> Option<usize> {
    let rank_at = |point: &Point| {
        let position = region.position(point);
        let mut poses = region.orientations().iter().map(|rotation| Pose { position, rotation: *rotation });
        let pose = poses.find(|pose| region.criterion().holds(pose))?;
        model.structure_matrix(&pose).ok().map(|matrix| rank(&matrix))
    };
    points.iter().filter_map(rank_at).max()
}
