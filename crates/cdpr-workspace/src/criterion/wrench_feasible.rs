//! Wrench feasibility: tensions within their limits balance the load.

use super::narrowing::{Closing, Narrowing, largest};
use super::{Criterion, Verdict};
use crate::WorkspaceError;
use cdpr_model::equilibrium::distribution::{self, Balance, DistributionError};
use cdpr_model::equilibrium::feasibility;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::{Load, StaticsError};
use cdpr_model::tension::quadratic::Solver;
use cdpr_model::tension::{InputError, Limits};

/// Name of the criterion.
pub(super) const WRENCH_FEASIBLE: &str = "wrench-feasible";

/// Tensions f with f_min ≤ f ≤ f_max balance the load, Aᵀ f + w = 0 (Verhoeven 2004; Pott 2018, ch. 5): exact.
///
/// The margin (N) is the largest t for which limits narrowed by t on both sides, f_min + t ≤ f ≤ f_max − t, still leave
/// tensions: the distance that every tension can keep from its limits. Below zero it is minus the amount by which the
/// limits would have to be widened. It is continuous in the pose, the load and the limits while the structure matrix
/// keeps its rank, at most half the narrowest range, and −∞ if no tensions at all balance the load. With sagging cables
/// it is that of the directions at which tensions and shapes agree, or at which the iteration ended.
#[derive(Clone, Debug)]
pub struct WrenchFeasible<'a> {
    model: &'a Model,
    load: Load,
    limits: Limits,
}

impl<'a> WrenchFeasible<'a> {
    /// The criterion for this model, load and limits.
    pub fn new(model: &'a Model, load: &Load, limits: &Limits) -> Result<Self, WorkspaceError> {
        let (expected, found) = (model.cable_count(), limits.cable_count());
        if expected != found {
            return Err(InputError::LimitCount { expected, found }.into());
        }
        Ok(Self { model, load: *load, limits: limits.clone() })
    }

    fn qp(&self) -> Solver {
        Solver::new(self.model.cable_count(), self.model.dof())
    }

    fn margin(&self, qp: &mut Solver, balance: &Balance, is_feasible: bool) -> Narrowing {
        let closing = Closing { limits: &self.limits, rise: 1.0, fall: 1.0 };
        let start = if is_feasible { closing.end() } else { Narrowing { amount: 0.0, cable: None } };
        largest(qp, &balance.matrix, &balance.wrench, &closing, start)
            .unwrap_or(Narrowing { amount: f64::NEG_INFINITY, cable: None })
    }
}

impl Criterion for WrenchFeasible<'_> {
    fn name(&self) -> &str {
        WRENCH_FEASIBLE
    }

    fn unit(&self) -> &str {
        "N"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let wrench = self.load.in_pattern(self.model, pose);
        let mut qp = self.qp();
        let mut infeasible = None;
        let balance = distribution::balance(self.model, pose, wrench.as_slice(), &mut |matrix, wrench| {
            qp.forget();
            let found = qp.solve(matrix, wrench, &self.limits, None)?;
            infeasible = found.reason();
            Ok(infeasible.is_none().then(|| found.tensions.clone()))
        });
        let balance = match balance {
            Ok(Balance { reason: Some(reason), .. }) => return Verdict::impossible(reason.to_string(), None),
            Ok(balance) => balance,
            Err(error) => return Verdict::impossible(error.to_string(), cable_of(&error)),
        };
        let Narrowing { amount, cable } = self.margin(&mut qp, &balance, infeasible.is_none());
        match infeasible {
            None => Verdict::held(amount, cable),
            Some(reason) => Verdict::failed(amount, reason, cable),
        }
    }

    fn effort(&self) -> f64 {
        distribution::effort(self.model, 1.0)
    }

    fn holds(&self, pose: &Pose) -> bool {
        let mut answer = [false];
        self.holds_all(std::slice::from_ref(pose), &mut answer);
        answer[0]
    }

    fn holds_all(&self, poses: &[Pose], answers: &mut [bool]) {
        if feasibility::feasible(self.model, &self.load, &self.limits, poses, answers).is_err() {
            // a load that has no numbers
            answers.fill(false);
        }
    }
}

/// The cable (from 0) without a path or state at the pose.
pub(super) fn cable_of(error: &DistributionError) -> Option<usize> {
    match error {
        DistributionError::Statics(StaticsError::CablePath(path)) => Some(path.cable() - 1),
        DistributionError::Statics(StaticsError::CableState { cable, .. }) => Some(cable - 1),
        _ => None,
    }
}
