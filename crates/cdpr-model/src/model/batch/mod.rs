//! Lengths and structure matrices at many poses at once, a pose per lane.
//!
//! Every number has the same bits as at a single pose, on every vector unit: [`Model::cable_lengths`] and
//! [`Model::structure_matrix`] use the same formulas for one number instead of eight. If a cable has no path its
//! numbers are NaN; [`Model::path`] gives the reason.

#[cfg(test)]
mod tests;

use super::{Model, in_pattern};
use crate::cable::wrench::wrench;
use crate::geometry::PoseBatch;
use crate::scalar::{Kernel, LANES, LaneTable, Lanes, Line, Unit, dispatch_on, over_parts};

impl Model {
    /// Geometric cable lengths q (m) of many poses, a row per cable: [`Model::cable_lengths`] for each.
    ///
    /// Claims no memory if `lengths` has held as many poses before.
    ///
    /// ```
    /// use cdpr::geometry::PoseBatch;
    /// use cdpr::model::{Composition, Model};
    /// use cdpr::robot::Robot;
    /// use cdpr::scalar::LaneTable;
    ///
    /// let robot = Robot::builtin("cablerobot-simulator-helicopter").ok_or("unknown robot")?;
    /// let home = robot.home.ok_or("no home pose")?;
    /// let model = Model::new(robot, Composition::STANDARD)?;
    /// let poses: PoseBatch = [home; 100].iter().collect();
    /// let mut lengths = LaneTable::default();
    /// model.batch_cable_lengths(&poses, &mut lengths);
    /// assert_eq!(lengths.get(3, 42), model.cable_lengths(&home)?[3]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn batch_cable_lengths(&self, poses: &PoseBatch, lengths: &mut LaneTable) {
        lengths.reshape(self.cable_count(), poses.len());
        over_parts(lengths.lines_mut(), self.cable_count(), &mut (), |_, first, lines| {
            Lengths { model: self, poses, first: first / LANES, lines }.run_on(Unit::widest());
        });
    }

    /// Structure matrices Aᵀ of many poses: [`Model::structure_matrix`] for each, its n × m entries column by column,
    /// so that row `cable · n + k` of the table has component k of that cable.
    ///
    /// Claims no memory if `matrices` has held as many poses before.
    pub fn batch_structure_matrices(&self, poses: &PoseBatch, matrices: &mut LaneTable) {
        matrices.reshape(self.dof() * self.cable_count(), poses.len());
        over_parts(matrices.lines_mut(), self.dof() * self.cable_count(), &mut (), |_, first, lines| {
            StructureMatrices { model: self, poses, first: first / LANES, lines }.run_on(Unit::widest());
        });
    }
}

/// [`Model::batch_cable_lengths`] on any unit.
struct Lengths<'a> {
    model: &'a Model,
    poses: &'a PoseBatch,
    /// Index of the group of poses at which the lines begin.
    first: usize,
    lines: &'a mut [Line],
}

impl Lengths<'_> {
    /// Runs on an available unit; compiled only here, for library and tests.
    #[inline(never)]
    fn run_on(self, unit: Unit) {
        dispatch_on(unit, self).unwrap_or_default();
    }
}

impl Kernel for Lengths<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { model, poses, first, lines } = self;
        let zero = lanes.constant(0.0);
        for (group, lengths) in (first..).zip(lines.chunks_exact_mut(model.cable_count())) {
            let (position, rotation) = poses.at(lanes, group);
            let mut needs_scalar = zero;
            for (cables, target) in model.groups().iter().zip(lengths.chunks_mut(LANES)) {
                for (lane, target) in target.iter_mut().enumerate() {
                    let cable = cables.path_in_lanes(lane, position, &rotation);
                    cable.path.length.store(&mut target.0);
                    needs_scalar = needs_scalar + cable.needs_scalar;
                }
            }
            if lanes.any(zero.is_less(needs_scalar)) {
                settle_lengths(model, poses, group, lengths);
            }
        }
    }
}

/// Writes the lengths of one group, each pose on its own.
#[cold]
#[inline(never)]
fn settle_lengths(model: &Model, poses: &PoseBatch, group: usize, lengths: &mut [Line]) {
    for lane in 0..LANES.min(poses.len() - group * LANES) {
        let pose = poses.get(group * LANES + lane);
        for (cable, line) in lengths.iter_mut().enumerate() {
            line.0[lane] = model.path(cable, &pose).map_or(f64::NAN, |(path, _)| path.length);
        }
    }
}

/// [`Model::batch_structure_matrices`] on any unit.
struct StructureMatrices<'a> {
    model: &'a Model,
    poses: &'a PoseBatch,
    /// Index of the group of poses at which the lines begin.
    first: usize,
    lines: &'a mut [Line],
}

impl StructureMatrices<'_> {
    /// Runs on an available unit; compiled only here, for library and tests.
    #[inline(never)]
    fn run_on(self, unit: Unit) {
        dispatch_on(unit, self).unwrap_or_default();
    }
}

impl Kernel for StructureMatrices<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { model, poses, first, lines } = self;
        let zero = lanes.constant(0.0);
        let n = model.dof();
        for (group, matrices) in (first..).zip(lines.chunks_exact_mut(n * model.cable_count())) {
            let (position, rotation) = poses.at(lanes, group);
            let mut needs_scalar = zero;
            for (cables, target) in model.groups().iter().zip(matrices.chunks_mut(LANES * n)) {
                for (lane, target) in target.chunks_exact_mut(n).enumerate() {
                    let cable = cables.path_in_lanes(lane, position, &rotation);
                    let column = in_pattern(model.twist_basis(), wrench(cable.moment_arm, cable.path.direction));
                    for (target, entry) in target.iter_mut().zip(&column) {
                        entry.store(&mut target.0);
                    }
                    needs_scalar = needs_scalar + cable.needs_scalar;
                }
            }
            if lanes.any(zero.is_less(needs_scalar)) {
                settle_matrices(model, poses, group, matrices);
            }
        }
    }
}

/// Writes the structure matrices of one group, each pose on its own.
#[cold]
#[inline(never)]
fn settle_matrices(model: &Model, poses: &PoseBatch, group: usize, matrices: &mut [Line]) {
    let n = model.dof();
    for lane in 0..LANES.min(poses.len() - group * LANES) {
        let pose = poses.get(group * LANES + lane);
        for (cable, lines) in matrices.chunks_exact_mut(n).enumerate() {
            let column = model.structure_column(cable, &pose);
            for (line, twist) in lines.iter_mut().zip(model.twist_basis()) {
                line.0[lane] = column.as_ref().map_or(f64::NAN, |column| twist.dot(column));
            }
        }
    }
}
