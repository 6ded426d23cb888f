//! The closed form of tension distribution at many poses at once, a pose per lane.
//!
//! f = f_m − A⁺ᵀ (w + Aᵀ f_m), the tensions of [`closed_form::solve`], by the products AᵀA instead of singular values,
//! with one correction for their rounding: both agree to rounding. If rows of the structure matrix are nearly
//! dependent, if a cable may have no path, and for robots with more than eight cables or fewer cables than degrees of
//! freedom, each pose is solved on its own.

mod normal;
mod single_pose;

use normal::{Normal, moved};
pub(super) use single_pose::{ClosedFormTensions, OnePose};

use super::feasibility::balance::Balance;
use super::feasibility::factors::{Rows, product};
use crate::geometry::PoseBatch;
use crate::model::Model;
use crate::scalar::{Kernel, LANES, LaneTable, Lanes, Line, Unit, dispatch_on, over_parts};
use crate::statics::Load;
use crate::tension::{InputError, Limits, closed_form};

/// Tensions (N) nearest to the middle of the limits that balance the load at each pose, a row per cable, within the
/// limits or not (see `Limits::contain`); NaN if a cable has no path, and for sagging cables, since their directions
/// follow their tensions.
///
/// Claims no memory in lanes if `tensions` has held as many poses before.
///
/// ```
/// use cdpr::equilibrium::closed_form;
/// use cdpr::geometry::PoseBatch;
/// use cdpr::model::{Composition, Model};
/// use cdpr::robot::Robot;
/// use cdpr::scalar::LaneTable;
/// use cdpr::statics::Load;
/// use cdpr::tension::Limits;
///
/// let robot = Robot::builtin("cogiro").ok_or("unknown robot")?;
/// let home = robot.home.ok_or("no home pose")?;
/// let (load, limits) = (Load::of(&robot)?, Limits::uniform(8, 0.0, 5000.0)?);
/// let model = Model::new(robot, Composition::STANDARD)?;
/// let mut tensions = LaneTable::default();
/// closed_form::solve_batch(&model, &load, &limits, &[home; 3].iter().collect::<PoseBatch>(), &mut tensions)?;
/// assert_eq!(tensions.get(7, 0), tensions.get(7, 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve_batch(
    model: &Model,
    load: &Load,
    limits: &Limits,
    poses: &PoseBatch,
    tensions: &mut LaneTable,
) -> Result<(), InputError> {
    let cables = model.cable_count();
    if limits.cable_count() != cables {
        return Err(InputError::LimitCount { expected: cables, found: limits.cable_count() });
    }
    tensions.reshape(cables, poses.len());
    let balance = Balance::new(model, load, limits);
    over_parts(tensions.lines_mut(), cables, &mut (), |(), first, lines| {
        Tensions { balance: &balance, limits, poses, first: first / LANES, lines }.run_on(Unit::widest());
    });
    Ok(())
}

/// Tensions for a part of a batch.
struct Tensions<'a> {
    balance: &'a Balance<'a>,
    limits: &'a Limits,
    poses: &'a PoseBatch,
    /// Index of the group of poses at which the lines begin.
    first: usize,
    lines: &'a mut [Line],
}

impl Tensions<'_> {
    /// Runs on an available unit; compiled only here, for library and tests.
    #[inline(never)]
    fn run_on(self, unit: Unit) {
        dispatch_on(unit, self).unwrap_or_default();
    }
}

impl Kernel for Tensions<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { balance, limits, poses, first, lines } = self;
        let (cables, dof) = (balance.model.cable_count(), balance.model.dof());
        let fits = Balance::serves(balance.model);
        let mut rows = [[lanes.constant(0.0); LANES]; 6];
        for (group, lines) in (first..).zip(lines.chunks_exact_mut(cables)) {
            if !fits {
                ask_single(balance, limits, poses, group, lines);
                continue;
            }
            let (position, rotation) = poses.at(lanes, group);
            let needs_scalar = balance.fill(&mut rows, position, &rotation);
            let residual = balance.residual(&rotation, &rows);
            let normal = normal_of(&rows, dof);
            let mut found = [lanes.constant(0.0); LANES];
            move_along(&mut found, &rows, normal.solve(residual));
            // residual from rounding of the products: after this correction the tensions are as exact as by orthogonal
            // factors
            let left = left_over(&found, &rows, residual);
            move_along(&mut found, &rows, normal.solve(left));
            for (cable, line) in lines.iter_mut().enumerate() {
                (lanes.constant(balance.middle[cable]) + found[cable]).store(&mut line.0);
            }
            if lanes.any((normal.has_rank - needs_scalar).is_less(lanes.constant(1.0))) {
                ask_single(balance, limits, poses, group, lines);
            }
        }
    }
}

/// The products AᵀA of the first `dof` rows.
#[inline(always)]
fn normal_of<L: Lanes>(rows: &Rows<L>, dof: usize) -> Normal<L> {
    let mut products = [[rows[0][0].constant(0.0); 6]; 6];
    for i in 0..6 {
        for j in 0..i {
            products[i][j] = product::<L, 0>(&rows[i], &rows[j]);
        }
        if i < dof {
            products[i][i] = product::<L, 0>(&rows[i], &rows[i]);
        }
    }
    Normal::of(products, dof)
}

/// f ← f − A x.
#[inline(always)]
fn move_along<L: Lanes>(tensions: &mut [L; LANES], rows: &Rows<L>, x: [L; 6]) {
    for cable in 0..LANES {
        let mut column = x;
        for k in 0..6 {
            column[k] = rows[k][cable];
        }
        tensions[cable] = moved(tensions[cable], column, x);
    }
}

/// Aᵀ f + residual.
#[inline(always)]
fn left_over<L: Lanes>(tensions: &[L; LANES], rows: &Rows<L>, mut residual: [L; 6]) -> [L; 6] {
    for k in 0..6 {
        residual[k] = residual[k] + product::<L, 0>(&rows[k], tensions);
    }
    residual
}

/// Writes the tensions of one group, each pose solved on its own.
#[cold]
#[inline(never)]
fn ask_single(balance: &Balance<'_>, limits: &Limits, poses: &PoseBatch, group: usize, lines: &mut [Line]) {
    for lane in 0..LANES.min(poses.len() - group * LANES) {
        let pose = poses.get(group * LANES + lane);
        let matrix =
            balance.model.structure_matrix(&pose).ok().filter(|_| balance.model.cables().has_fixed_directions());
        let wrench = balance.load.in_pattern(balance.model, &pose);
        let solve = |matrix| closed_form::solve(&matrix, wrench.as_slice(), limits).ok();
        let found = matrix.and_then(solve);
        for (cable, line) in lines.iter_mut().enumerate() {
            line.0[lane] = found.as_ref().map_or(f64::NAN, |found| found.tensions[cable]);
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::geometry::{Pose, Wrench};
    use crate::model::Composition;
    use crate::robot::{Robot, builtin};

    #[test]
    fn tensions_are_those_of_singular_values_and_the_same_on_every_unit() {
        let load = Load::constant(Wrench::new(10.0, -20.0, -500.0, 5.0, 20.0, -3.0));
        for name in builtin::names() {
            let model = Model::new(Robot::builtin(name).unwrap(), Composition::STANDARD).unwrap();
            let limits = Limits::uniform(model.cable_count(), 50.0, 2000.0).unwrap();
            let home = model.robot().home_or_middle();
            let pose = |k: u8| {
                let t = f64::from(k);
                let shift = Vector3::new(0.3 * t.sin(), 0.2 * t.cos(), 0.1 * (2.0 * t).sin());
                let along = |k: usize| model.axes().get(k).map_or(Vector3::zeros(), |axis| axis * shift[k]);
                Pose { position: home.position + along(0) + along(1) + along(2), ..home }
            };
            let poses: PoseBatch = (0..21).map(pose).collect::<Vec<_>>().iter().collect();
            let mut tensions = LaneTable::default();
            solve_batch(&model, &load, &limits, &poses, &mut tensions).unwrap();
            for item in 0..poses.len() {
                let pose = poses.get(item);
                let matrix = model.structure_matrix(&pose).unwrap();
                let wrench = load.in_pattern(&model, &pose);
                let expected = closed_form::solve(&matrix, wrench.as_slice(), &limits).unwrap().tensions;
                for (cable, expected) in expected.iter().enumerate() {
                    // rounding of two different factorisations, times a condition of up to a thousand
                    let apart = (tensions.get(cable, item) - expected).abs();
                    assert!(apart < 1e-8 * expected.abs().max(1e3), "{name}: {apart:e} of {expected}");
                }
            }
            for unit in Unit::available() {
                let mut other = tensions.clone();
                let balance = Balance::new(&model, &load, &limits);
                Tensions { balance: &balance, limits: &limits, poses: &poses, first: 0, lines: other.lines_mut() }
                    .run_on(unit);
                assert_eq!(other, tensions, "{name} on {unit:?}");
            }
        }
    }
}
