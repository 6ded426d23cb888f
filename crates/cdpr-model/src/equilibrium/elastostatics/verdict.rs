//! Verdict on the best attempt: status and reason in words.

use super::attempt::Attempt;
use super::descent::Stop;
use super::rigid::Rigid;
use super::{Problem, Solution, Status};
use crate::statics::Stability;

/// Reason of an equilibrium whose pose is not unique.
pub(super) const INDIFFERENT: &str = "the equilibrium is indifferent: the platform can move without resistance from here, lengths and load do not \
                                      determine its pose";

impl Problem<'_> {
    /// Writes the solution from the best attempt; it already has the tensions, and in place of the residuals the
    /// lengths.
    pub(super) fn judge(&self, best: &Attempt, rigid: &Rigid<'_>, solution: &mut Solution) {
        solution.pose = best.end.pose;
        solution.stability = best.stability;
        solution.wrench_residual = self.wrench_size(&best.end.residual);
        for (cable, residual) in solution.residuals.iter_mut().enumerate() {
            // a pose polished for rigid cables is not the one of the descent
            let length = match rigid.any() {
                true => self.model.path_or_nan(cable, &best.end.pose).0.length,
                false => *residual,
            };
            let tension = solution.tensions[cable];
            *residual = self.model.elasticity(cable).controlled_length(length, tension) - rigid.lengths[cable];
        }
        solution.slack = solution.tensions.iter().filter(|tension| !(**tension > 0.0)).count();
        (solution.status, solution.reason) = self.verdict(best, rigid, solution);
    }

    fn verdict(&self, best: &Attempt, rigid: &Rigid<'_>, solution: &Solution) -> (Status, Option<String>) {
        let all_slack = solution.slack == solution.tensions.len();
        if best.is_good(self) {
            return (Status::Converged, self.remark(rigid, solution));
        }
        if best.is_equilibrium(self) {
            return match Stability::of(best.stability, self.indifferent_stiffness()) {
                Stability::Unstable => (Status::Unstable, Some(self.unstable(best, solution))),
                _ => (Status::Singular, Some(indifferent(all_slack))),
            };
        }
        (Status::NotConverged, Some(self.failure(best, rigid, solution)))
    }

    fn unstable(&self, best: &Attempt, solution: &Solution) -> String {
        format!(
            "forces balance, but the stiffness has the eigenvalue {:.3e} N/m: the platform would leave this pose at the \
             smallest disturbance, and {} other starts led to no stable equilibrium",
            best.stability, solution.restarts
        )
    }

    fn failure(&self, best: &Attempt, rigid: &Rigid<'_>, solution: &Solution) -> String {
        let starts = solution.restarts + 1;
        let residual = solution.wrench_residual;
        if best.end.stop == Stop::Degenerate {
            let cables = 0..self.model.cable_count();
            let found = cables.into_iter().find_map(|cable| self.model.path(cable, &best.end.pose).err());
            return found.map_or_else(
                || "the cable lengths cannot be computed at the start".to_owned(),
                |reason| format!("at the start, {reason}"),
            );
        }
        if solution.slack == solution.tensions.len() {
            return format!(
                "all cables are slack where the best of {starts} starts ended: nothing holds the platform against its load"
            );
        }
        if best.excess > self.settings.length_tolerance {
            let (cable, excess) = rigid
                .cables()
                .map(|cable| (cable, solution.residuals[cable]))
                .fold((0, f64::NEG_INFINITY), |a, b| if b.1 > a.1 { b } else { a });
            return format!(
                "the rigid cables are too short to meet at the platform: the best of {starts} starts leaves cable {} \
                 {excess:.3e} m longer than its length allows",
                cable + 1
            );
        }
        if best.pushes {
            return "some cable is slack where the platform comes to rest".to_owned();
        }
        let stop = match best.end.stop {
            Stop::IterationLimit => format!("the limit of {} iterations was reached", self.settings.max_iterations),
            _ => "no shorter step helped".to_owned(),
        };
        format!("{stop}; the best of {starts} starts leaves a wrench of {residual:.3e} N out of balance")
    }

    /// Remark on a converged answer with cables that stretch implausibly far.
    fn remark(&self, rigid: &Rigid<'_>, solution: &Solution) -> Option<String> {
        let strain = |cable: usize| self.model.path_or_nan(cable, &solution.pose).0.length / rigid.lengths[cable] - 1.0;
        let strains = (0..rigid.lengths.len()).map(|cable| (cable, strain(cable)));
        let (cable, strain) = strains.fold((0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
        (strain > self.settings.remarkable_strain).then(|| {
            format!(
                "cable {} is stretched by {:.1} %: this is the equilibrium of the given lengths, but do they belong to this \
                 robot? Check order, units, scale and offset",
                cable + 1,
                100.0 * strain
            )
        })
    }
}

fn indifferent(all_slack: bool) -> String {
    match all_slack {
        true => "all cables are slack and no load acts: the platform rests anywhere within their reach".to_owned(),
        false => INDIFFERENT.to_owned(),
    }
}
