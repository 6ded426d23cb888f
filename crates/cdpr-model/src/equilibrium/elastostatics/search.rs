//! Search from one start, and the best of the searches from several starts.

use super::attempt::Attempt;
use super::descent::{EquilibriumEnd, Stop, Tensions};
use super::multipliers;
use super::rigid::Rigid;
use super::springs::Springs;
use super::{LoadParts, Problem, Scratch, Solver, stability};
use crate::equilibrium::restarts::restart_poses;
use crate::geometry::Pose;
use crate::scalar::LANES;
use crate::statics::indifferent_stiffness;

/// Relative error of a length, a few roundings, in [`Problem::undecided`].
pub(super) const ROUNDING: f64 = 1e-14;

impl Problem<'_> {
    /// Size of a wrench, moments divided by the platform radius (N).
    pub(super) fn wrench_size(&self, wrench: &[f64; 6]) -> f64 {
        let basis = self.model.twist_basis();
        let translations = self.model.axes().len();
        let mut sum = 0.0;
        for (index, direction) in basis.iter().enumerate() {
            let entry: f64 = direction.iter().zip(wrench).map(|(d, w)| d * w).sum();
            let entry = if index < translations { entry } else { entry / self.platform_radius };
            sum += entry * entry;
        }
        sum.sqrt()
    }

    /// Residual wrench that counts as balance (N): a fraction of the acting forces, plus the effect of rounding of the
    /// lengths through the stiffness of the cables.
    pub(super) fn undecided(&self, tensions: &Tensions) -> f64 {
        let pull: f64 = tensions.accepted.as_flattened().iter().map(|tension| tension.abs()).sum();
        let stiffness: f64 = self.springs.iter().flat_map(|springs| springs.stiffness).sum();
        self.settings.wrench_tolerance * (pull + self.force()) + ROUNDING * stiffness * self.mean_length
    }

    /// Sum of the forces that load the platform (N).
    pub(super) fn force(&self) -> f64 {
        let size = |force: &[f64]| force.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        size(&self.load.constant[..3]) + size(&self.load.weight)
    }

    /// Stiffness below which an equilibrium is indifferent (N/m).
    pub(super) fn indifferent_stiffness(&self) -> f64 {
        indifferent_stiffness(self.stiffness_scale, self.force(), self.mean_length)
    }

    /// Descends from one start, first with cables that may push, then as cables.
    fn elastic_attempt(&self, start: &Pose, tensions: &mut Tensions) -> Attempt {
        let mut iterations = 0;
        let mut from = *start;
        if self.model.cable_count() >= self.model.dof() {
            let bars = Self { floor: f64::NEG_INFINITY, ..*self };
            let end = bars.descend(start, tensions);
            iterations = end.iterations;
            if end.stop == Stop::Stationary {
                if tensions.accepted.as_flattened().iter().all(|&tension| tension >= 0.0) {
                    return self.attempt(end, iterations, tensions);
                }
                if self.only_taut {
                    return Attempt { pushes: true, ..self.attempt(end, iterations, tensions) };
                }
                from = end.pose;
            }
        }
        let mut end = self.descend(&from, tensions);
        iterations += end.iterations;
        if end.stop != Stop::Stationary && from != *start {
            end = self.descend(start, tensions);
            iterations += end.iterations;
        }
        self.attempt(end, iterations, tensions)
    }

    pub(super) fn attempt(&self, end: EquilibriumEnd, iterations: u32, tensions: &Tensions) -> Attempt {
        let undecided = self.undecided(tensions);
        let stability = stability::of_cables(self, tensions, &end, undecided);
        Attempt { end: EquilibriumEnd { iterations, ..end }, stability, excess: 0.0, undecided, pushes: false }
    }
}

/// First stiffness of the cables in a search from one start.
#[derive(Clone, Copy)]
enum Approach {
    Direct,
    /// Soft at first, then stiffer in stages.
    FromSoft,
}

impl Solver<'_> {
    /// Starts from the guess, and from other poses while no stable equilibrium is found.
    pub(super) fn search(&mut self, lengths: &[f64], guess: &Pose) {
        let mean_length = lengths.iter().sum::<f64>() / lengths.len() as f64;
        self.set_springs(lengths, mean_length);
        let Self { model, settings, scratch, .. } = self;
        let Scratch { springs, tensions, solution, is_rigid, .. } = scratch;
        let stiffness_scale = springs.iter().flat_map(|springs| springs.stiffness).sum();
        let load = LoadParts::of(&self.load);
        let base = Problem {
            model,
            settings,
            load,
            full_load: &self.load,
            has_moment: load.constant[3..].iter().any(|&moment| moment != 0.0),
            springs: &[],
            floor: 0.0,
            stiffness_scale,
            mean_length,
            platform_radius: self.platform_radius,
            only_taut: self.only_taut,
        };
        let rigid = Rigid { lengths, is_rigid };
        let mut attempt = |start: &Pose, approach: Approach, tensions: &mut Tensions| match approach {
            _ if rigid.any() => Some(multipliers::attempt(&base, &rigid, start, springs, tensions)),
            Approach::Direct => Some(Problem { springs, ..base }.elastic_attempt(start, tensions)),
            Approach::FromSoft => Problem { springs, ..base }.attempt_from_soft(start, tensions),
        };
        let Some(mut best) = attempt(guess, Approach::Direct, tensions) else { return };
        solution.take_tensions(tensions);
        (solution.iterations, solution.restarts) = (best.end.iterations, 0);
        if !best.is_good(&base) && !best.pushes {
            let from_soft = (!rigid.any()).then_some((*guess, Approach::FromSoft));
            let escapes = stability::escapes(&base, &best).into_iter().flatten();
            let starts = from_soft
                .into_iter()
                .chain(escapes.chain(restart_poses(model, guess)).map(|pose| (pose, Approach::Direct)));
            for (start, approach) in starts.take(settings.max_restarts as usize) {
                let Some(other) = attempt(&start, approach, tensions) else { continue };
                solution.iterations += other.end.iterations;
                solution.restarts += 1;
                if other.is_better(&best, &base) {
                    best = other;
                    solution.take_tensions(tensions);
                }
                if best.is_good(&base) {
                    break;
                }
            }
        }
        base.judge(&best, &rigid, solution);
    }

    /// Sets the cables' springs; rigid cables get a virtual stiffness, which the multipliers correct.
    fn set_springs(&mut self, lengths: &[f64], mean_length: f64) {
        let mut stiffest = 0.0_f64;
        for (cable, &length) in lengths.iter().enumerate() {
            let law = self.model.elasticity(cable);
            let lane = &mut self.scratch.springs[cable / LANES];
            let at = cable % LANES;
            lane.rest_length[at] = length;
            if !self.scratch.is_rigid[cable] {
                lane.stiffness[at] = 1.0 / law.compliance(length, length);
                stiffest = stiffest.max(lane.stiffness[at]);
            }
        }
        // stiff compared with the deflection under the load, soft enough for the descent
        let force = self.load.constant_part().fixed_rows::<3>(0).norm() + self.load.weight().0.norm();
        let virtual_stiffness = f64::max(1e3 * force / mean_length, 10.0 * stiffest).max(1.0);
        for cable in (0..lengths.len()).filter(|&cable| self.scratch.is_rigid[cable]) {
            self.scratch.springs[cable / LANES].stiffness[cable % LANES] = virtual_stiffness;
        }
        self.fill(lengths.len());
    }

    /// Copies the last cable's length into the lanes that pad a group, whose stiffness is zero.
    fn fill(&mut self, cables: usize) {
        if let Some(Springs { rest_length, .. }) = self.scratch.springs.last_mut() {
            let last = (cables - 1) % LANES;
            for lane in last + 1..LANES {
                rest_length[lane] = rest_length[last];
            }
        }
    }
}

impl super::Solution {
    /// Unpacks the tensions of the last descent, and its lengths, from which the residuals follow.
    fn take_tensions(&mut self, tensions: &Tensions) {
        for (chunk, lanes) in self.tensions.chunks_mut(LANES).zip(&tensions.accepted) {
            chunk.copy_from_slice(&lanes[..chunk.len()]);
        }
        for (chunk, lanes) in self.residuals.chunks_mut(LANES).zip(&tensions.accepted_lengths) {
            chunk.copy_from_slice(&lanes[..chunk.len()]);
        }
    }
}
