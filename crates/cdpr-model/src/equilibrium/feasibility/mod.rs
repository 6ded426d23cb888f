//! Whether tensions within limits balance the load, at many poses at once: the exact verdict of [`quadratic`].
//!
//! Eight poses are decided side by side, a pose per lane. Orthogonal factors give the solutions f = f₀ + H λ of the
//! balance; the limits are strips in the m − n coordinates λ, and strips have a common point exactly when every m − n +
//! 1 of them have one (Helly's theorem): for redundancy 2, with Dᵢⱼ = det(hᵢ, hⱼ) and the limits f_m ± ρ,
//!
//! |Dⱼₖ f₀ᵢ + Dₖᵢ f₀ⱼ + Dᵢⱼ f₀ₖ| ≤ |Dⱼₖ| ρᵢ + |Dₖᵢ| ρⱼ + |Dᵢⱼ| ρₖ for all i < j < k (f₀ counted from f_m),
//!
//! for redundancy 1 the same with pairs, and without redundancy f₀ itself must keep the limits. These are the facets of
//! the available wrench set (Bouchard, Gosselin and Moore 2010). If a verdict depends on less than 1e-4 of the largest
//! tension, if rows of the structure matrix are nearly dependent, if a cable may have no path, and for all other robots
//! and effects, the pose is solved on its own.

pub(super) mod balance;
pub(super) mod factors;
mod strips;
#[cfg(test)]
mod tests;

use nalgebra::DMatrix;

use super::distribution;
use crate::geometry::{POSE_ROWS, Pose, in_lanes, transpose};
use crate::model::Model;
use crate::scalar::{Kernel, LANES, Lanes, Line, Unit, dispatch_on, over_parts};
use crate::statics::Load;
use crate::tension::quadratic::{self, Status};
use crate::tension::{InputError, Limits};
use balance::Balance;
use strips::Strips;

/// Writes for each pose whether tensions within limits balance the load; false if a cable has no path.
///
/// Every answer is that of [`quadratic::solve`] with the structure matrix and the load at the pose, and for sagging
/// cables that of [`distribution::solve`]. Many poses per call, in order, are fastest; [`Solver`] keeps its memory.
pub fn feasible(
    model: &Model,
    load: &Load,
    limits: &Limits,
    poses: &[Pose],
    answers: &mut [bool],
) -> Result<(), InputError> {
    Solver::new(model, load, limits)?.solve(poses, answers)
}

/// Number of poses decided in lanes before those in doubt are solved one by one.
const CHUNK: usize = 32;

/// A solver for many poses of one model: its memory is claimed once and reused.
#[derive(Clone, Debug)]
pub struct Solver<'a> {
    model: &'a Model,
    load: Load,
    limits: Limits,
    /// Memory for poses solved one by one; most calls have none.
    alone: Option<Box<Alone>>,
    /// Number of poses solved one by one, if one thread did all.
    single_poses: usize,
}

/// Memory of the search at a single pose.
#[derive(Clone, Debug)]
struct Alone {
    solver: quadratic::Solver,
    matrix: DMatrix<f64>,
}

impl Alone {
    fn new(cables: usize, dof: usize) -> Box<Self> {
        Box::new(Self { solver: quadratic::Solver::new(cables, dof), matrix: DMatrix::zeros(dof, cables) })
    }
}

impl<'a> Solver<'a> {
    /// A solver for this model, load and limits.
    pub fn new(model: &'a Model, load: &Load, limits: &Limits) -> Result<Self, InputError> {
        let cables = model.cable_count();
        if limits.cable_count() != cables {
            return Err(InputError::LimitCount { expected: cables, found: limits.cable_count() });
        }
        let wrench = load.constant_part();
        if !(wrench.norm_squared() + load.weight().0.norm_squared() + load.weight().1.norm_squared()).is_finite() {
            return Err(InputError::NotFinite { what: "wrench" });
        }
        Ok(Self { model, load: *load, limits: limits.clone(), alone: None, single_poses: 0 })
    }

    /// Writes one answer per pose, as [`feasible`] does.
    pub fn solve(&mut self, poses: &[Pose], answers: &mut [bool]) -> Result<(), InputError> {
        if poses.len() != answers.len() {
            return Err(InputError::AnswerCount { expected: poses.len(), found: answers.len() });
        }
        over_parts(answers, LANES, self, |solver, first, answers| {
            solver.solve_part(&poses[first..first + answers.len()], answers);
        });
        Ok(())
    }

    fn solve_part(&mut self, poses: &[Pose], answers: &mut [bool]) {
        let (cables, dof) = (self.model.cable_count(), self.model.dof());
        let in_lanes = Balance::serves(self.model) && cables <= dof + 2;
        for (poses, answers) in poses.chunks(CHUNK).zip(answers.chunks_mut(CHUNK)) {
            let mut verdicts = [Verdict::Doubt; CHUNK];
            if in_lanes {
                Chunk { solver: self, poses, verdicts: &mut verdicts }.run_on(Unit::widest());
            }
            for ((pose, answer), verdict) in poses.iter().zip(answers).zip(verdicts) {
                *answer = match verdict {
                    Verdict::Feasible => true,
                    Verdict::Infeasible => false,
                    Verdict::Doubt => self.ask_one(pose),
                };
            }
        }
    }

    /// The verdict on a single pose; false without a verdict.
    fn ask_one(&mut self, pose: &Pose) -> bool {
        self.single_poses += 1;
        if !self.model.cables().has_fixed_directions() {
            let found = distribution::solve(self.model, pose, &self.load, &self.limits);
            return found.is_ok_and(|found| found.reason.is_none());
        }
        let (cables, dof) = (self.model.cable_count(), self.model.dof());
        let alone = self.alone.get_or_insert_with(|| Alone::new(cables, dof));
        if self.model.write_structure_matrix(pose, &mut alone.matrix).is_err() {
            return false;
        }
        let wrench = self.load.wrench(pose);
        let mut components = [0.0; 6];
        for (component, twist) in components.iter_mut().zip(self.model.twist_basis()) {
            *component = twist.dot(&wrench);
        }
        // the answer at a pose must not depend on earlier poses
        alone.solver.forget();
        let found = alone.solver.solve(&alone.matrix, &components[..dof], &self.limits, None);
        found.is_ok_and(|found| found.status == Status::Feasible)
    }
}

/// Verdict on a pose from the lanes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Verdict {
    Feasible,
    Infeasible,
    /// The pose must be solved on its own.
    Doubt,
}

/// Up to [`CHUNK`] poses of a robot with at most eight cables and redundancy 0 to 2.
struct Chunk<'a> {
    solver: &'a Solver<'a>,
    poses: &'a [Pose],
    verdicts: &'a mut [Verdict; CHUNK],
}

impl Chunk<'_> {
    /// Runs on an available unit; compiled only here, for library and tests.
    #[inline(never)]
    fn run_on(self, unit: Unit) {
        dispatch_on(unit, self).unwrap_or_default();
    }
}

impl Kernel for Chunk<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { solver, poses, verdicts } = self;
        let balance = Balance::new(solver.model, &solver.load, &solver.limits);
        let strips = Strips::new(&solver.limits, solver.model.dof());
        let mut rows = [[lanes.constant(0.0); LANES]; 6];
        for (poses, verdicts) in poses.chunks(LANES).zip(verdicts.chunks_mut(LANES)) {
            let mut numbers = [Line::default(); POSE_ROWS];
            transpose(poses, &mut numbers);
            let (position, rotation) = in_lanes(lanes, &numbers);
            let needs_scalar = balance.fill(&mut rows, position, &rotation);
            let residual = balance.residual(&rotation, &rows);
            let codes = strips.verdicts(lanes, &mut rows, residual, needs_scalar).to_array();
            for (verdict, code) in verdicts.iter_mut().zip(codes) {
                *verdict = match code {
                    1.0 => Verdict::Feasible,
                    -1.0 => Verdict::Infeasible,
                    _ => Verdict::Doubt,
                };
            }
        }
    }
}
