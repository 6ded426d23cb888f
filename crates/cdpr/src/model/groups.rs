//! Cables packed eight at a time into lanes, for single poses.

use crate::cable::elasticity::Elasticity;
use crate::cable::outlet::Outlet;
use crate::cable::{CableEnd, CablePath};
use crate::model::batch::CablePathInLanes;
use crate::scalar::{LANES, Lanes, constants};

/// Eight cables, or fewer with copies of the last one that weigh nothing.
#[derive(Clone, Debug)]
pub(crate) struct CableGroup {
    /// Outlets of one kind.
    pub(crate) outlet: Outlet<[f64; LANES]>,
    pub(crate) platform_anchor: [[f64; LANES]; 3],
    /// 1 for a cable, 0 for a copy that fills the group.
    pub(crate) weight: [f64; LANES],
    /// κ_q, κ_θ, c₀ of [`Elasticity`]; all 0 in a model without elasticity.
    pub(crate) elasticity: [[f64; LANES]; 3],
}

impl CableGroup {
    /// Paths and moment arms b = R b_P of the group's cables at a pose given by position and rotation rows.
    #[inline(always)]
    pub(crate) fn paths<L: Lanes>(&self, l: L, position: [f64; 3], rotation: &[[f64; 3]; 3]) -> (CablePath<L>, [L; 3]) {
        let cables = self.checked_paths(l, position, rotation);
        (cables.path, cables.moment_arm)
    }

    /// [`CableGroup::paths`], and the cables that may have none.
    #[inline(always)]
    pub(crate) fn checked_paths<L: Lanes>(
        &self,
        l: L,
        position: [f64; 3],
        rotation: &[[f64; 3]; 3],
    ) -> CablePathInLanes<L> {
        let rows = [constants(l, rotation[0]), constants(l, rotation[1]), constants(l, rotation[2])];
        let end = CableEnd::at(constants(l, position), &rows, load(l, &self.platform_anchor));
        let outlet = self.outlet.load(l);
        let path = outlet.path(end.anchor);
        let needs_scalar = outlet.needs_scalar(end.anchor, &path);
        CablePathInLanes { path, moment_arm: end.moment_arm, needs_scalar }
    }

    /// The elasticity of the group's cables.
    #[inline(always)]
    pub(crate) fn elasticity<L: Lanes>(&self, l: L) -> Elasticity<L> {
        let [by_length, by_controlled_length, constant] = load(l, &self.elasticity);
        Elasticity { by_length, by_controlled_length, constant }
    }
}

#[inline(always)]
fn load<L: Lanes>(l: L, vectors: &[[f64; LANES]; 3]) -> [L; 3] {
    [l.load(&vectors[0]), l.load(&vectors[1]), l.load(&vectors[2])]
}
