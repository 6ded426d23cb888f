//! Cables packed eight at a time into lanes, for single poses.

use crate::cable::elasticity::Elasticity;
use crate::cable::outlet::Outlet;
use crate::cable::{CableEnd, CablePath};
use crate::scalar::{LANES, Lanes, constants};

/// A cable at poses in lanes, or cables in lanes at a pose.
#[derive(Clone, Copy, Debug)]
pub struct CablePathInLanes<L> {
    /// Path of the straight cable.
    pub path: CablePath<L>,
    /// b = R b_P (world, m).
    pub moment_arm: [L; 3],
    /// 0 where the path certainly exists, 1 where the single pose must decide.
    pub needs_scalar: L,
}

/// Eight cables, or fewer with copies of the last one whose weight is 0.
#[derive(Clone, Debug)]
pub struct CableGroup {
    /// Outlets of one kind.
    pub outlet: Outlet<[f64; LANES]>,
    /// b_P (platform frame, m).
    pub platform_anchor: [[f64; LANES]; 3],
    /// 1 for a cable, 0 for a copy that fills the group.
    pub weight: [f64; LANES],
    /// κ_q, κ_θ, c₀ of [`Elasticity`]; all 0 in a model without elasticity.
    pub elasticity: [[f64; LANES]; 3],
}

impl CableGroup {
    /// Paths and moment arms b = R b_P of the group's cables at a pose given by position and rotation rows.
    #[inline(always)]
    pub fn paths<L: Lanes>(&self, l: L, position: [f64; 3], rotation: &[[f64; 3]; 3]) -> (CablePath<L>, [L; 3]) {
        let cables = self.checked_paths(l, position, rotation);
        (cables.path, cables.moment_arm)
    }

    /// [`CableGroup::paths`] with the flag of cables that may have no path.
    #[inline(always)]
    pub fn checked_paths<L: Lanes>(&self, l: L, position: [f64; 3], rotation: &[[f64; 3]; 3]) -> CablePathInLanes<L> {
        let rows = [constants(l, rotation[0]), constants(l, rotation[1]), constants(l, rotation[2])];
        let end = CableEnd::at(constants(l, position), &rows, load(l, &self.platform_anchor));
        let outlet = self.outlet.load(l);
        let path = outlet.path(end.anchor);
        let needs_scalar = outlet.needs_scalar(end.anchor, &path);
        CablePathInLanes { path, moment_arm: end.moment_arm, needs_scalar }
    }

    /// Path and moment arm of one of the group's cables at poses given by positions and rotation rows, with the bits of
    /// the single pose.
    #[inline(always)]
    pub fn path_in_lanes<L: Lanes>(
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

    /// The elasticity of the group's cables.
    #[inline(always)]
    pub fn elasticity<L: Lanes>(&self, l: L) -> Elasticity<L> {
        let [by_length, by_controlled_length, constant] = load(l, &self.elasticity);
        Elasticity { by_length, by_controlled_length, constant }
    }
}

#[inline(always)]
fn load<L: Lanes>(l: L, vectors: &[[f64; LANES]; 3]) -> [L; 3] {
    [l.load(&vectors[0]), l.load(&vectors[1]), l.load(&vectors[2])]
}

#[inline]
fn entry(vectors: &[[f64; LANES]; 3], lane: usize) -> [f64; 3] {
    [vectors[0][lane], vectors[1][lane], vectors[2][lane]]
}
