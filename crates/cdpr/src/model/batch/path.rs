//! One cable at eight poses at once.

use crate::cable::{CableEnd, CablePath};
use crate::model::CableGroup;
use crate::scalar::{LANES, Lanes, constants};

/// A cable at poses in lanes, or cables in lanes at a pose.
pub(crate) struct CablePathInLanes<L> {
    pub(crate) path: CablePath<L>,
    /// b = R b_P (world, m).
    pub(crate) moment_arm: [L; 3],
    /// 0 where the path exists for sure, 1 where the single pose must say whether it does.
    pub(crate) needs_scalar: L,
}

impl CableGroup {
    /// CablePath and moment arm of one of the group's cables at poses given by positions and rotation rows: the bits of
    /// `Model::path_at`.
    #[inline(always)]
    pub(crate) fn path_in_lanes<L: Lanes>(
        &self,
        lane: usize,
        position: [L; 3],
        rotation: &[[L; 3]; 3],
    ) -> CablePathInLanes<L> {
        let l = position[0];
        let end = CableEnd::at(position, rotation, constants(l, entry(&self.platform_anchor, lane)));
        let outlet = self.outlet.spread(l, lane);
        let path = outlet.path(end.anchor);
        let needs_scalar = outlet.needs_scalar(end.anchor, &path);
        CablePathInLanes { path, moment_arm: end.moment_arm, needs_scalar }
    }
}

#[inline(always)]
fn entry(vectors: &[[f64; LANES]; 3], lane: usize) -> [f64; 3] {
    [vectors[0][lane], vectors[1][lane], vectors[2][lane]]
}
