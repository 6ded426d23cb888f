//! Structure matrix and load at eight poses at once.

use super::factors::Rows;
use crate::cable::wrench::wrench;
use crate::model::{Model, in_pattern};
use crate::scalar::{LANES, Lanes, add, constants, cross, rotate};
use crate::statics::Load;
use crate::tension::Limits;

/// The balance of a robot with at most eight cables.
pub(in crate::equilibrium) struct Balance<'a> {
    pub(in crate::equilibrium) model: &'a Model,
    pub(in crate::equilibrium) load: &'a Load,
    /// The middle of each cable's limits (N).
    pub(in crate::equilibrium) middle: [f64; LANES],
}

impl<'a> Balance<'a> {
    pub(in crate::equilibrium) fn new(model: &'a Model, load: &'a Load, limits: &Limits) -> Self {
        let mut middle = [0.0; LANES];
        for (cable, middle) in middle.iter_mut().enumerate().take(limits.cable_count()) {
            *middle = limits.middle(cable);
        }
        Self { model, load, middle }
    }

    /// True for robots with up to eight cables, no fewer than degrees of freedom, whose directions follow from the pose
    /// alone.
    pub(in crate::equilibrium) fn serves(model: &Model) -> bool {
        model.cables().has_fixed_directions() && (model.dof()..=LANES).contains(&model.cable_count())
    }

    /// Writes the rows of the structure matrix, zeros from row n on; returns a number above 0 if a cable may have no
    /// path. Columns without a cable do not change.
    #[inline(always)]
    pub(in crate::equilibrium) fn fill<L: Lanes>(
        &self,
        rows: &mut Rows<L>,
        position: [L; 3],
        rotation: &[[L; 3]; 3],
    ) -> L {
        let mut needs_scalar = position[0].constant(0.0);
        let cables = &self.model.groups()[0];
        let basis = self.model.twist_basis();
        for cable in 0..self.model.cable_count() {
            let found = cables.path_in_lanes(cable, position, rotation);
            let column = in_pattern(basis, wrench(found.moment_arm, found.path.direction));
            for row in 0..6 {
                rows[row][cable] = column[row];
            }
            needs_scalar = needs_scalar + found.needs_scalar;
        }
        needs_scalar
    }

    /// Aᵀ f_m + w, the residual of the load at the middle of the limits (N, N·m).
    #[inline(always)]
    pub(in crate::equilibrium) fn residual<L: Lanes>(&self, rotation: &[[L; 3]; 3], rows: &Rows<L>) -> [L; 6] {
        let l = rotation[0][0];
        let (weight, center) = self.load.weight();
        let weight = constants(l, (*weight).into());
        let center = rotate(rotation, constants(l, (*center).into()));
        let constant = self.load.constant_part();
        let force = add(constants(l, [constant[0], constant[1], constant[2]]), weight);
        let moment = add(constants(l, [constant[3], constant[4], constant[5]]), cross(center, weight));
        let [[x, y, z], [a, b, c]] = [force, moment];
        let mut residual = in_pattern(self.model.twist_basis(), [x, y, z, a, b, c]);
        for cable in 0..self.model.cable_count() {
            let middle = l.constant(self.middle[cable]);
            for row in 0..6 {
                residual[row] = residual[row] + rows[row][cable] * middle;
            }
        }
        residual
    }
}
