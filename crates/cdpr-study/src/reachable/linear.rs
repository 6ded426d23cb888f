//! The reachable workspace by one linear step from the commanded pose (eq. 3.34, 3.35).

use super::Reachable;
use crate::field::linear::held;
use cdpr_model::control::Outcome;
use cdpr_model::control::Status;
use cdpr_model::geometry::Pose;
use cdpr_workspace::Verdict;
use cdpr_workspace::criterion::Criterion;

/// Poses reached within the requirements of a reachable workspace if the machine answers by one linear step: δx =
/// K_wx⁻¹ (Aᵀ f + w) and f̂ ≈ f − K A δx, both from the tensions f = f(q_θ) of the cables held at the commanded pose.
/// For a rigid machine no pose is reached in this way.
struct ByLinearStep<'r>(&'r Reachable);

impl Reachable {
    /// The same criterion by one linear step, without a forward problem.
    pub fn by_linear_step(&self) -> impl Criterion {
        ByLinearStep(self)
    }

    /// Answer to a command by one linear step.
    fn linear_outcome(&self, commanded: &Pose) -> Option<Outcome> {
        let mut operation = self.driving.operation();
        let held = held(&mut operation, commanded)?;
        let machine = operation.machine();
        Some(Outcome {
            pose: commanded.displaced(&held.displacement(machine)),
            sent: Vec::new(),
            recorded: Vec::new(),
            tensions: Some(held.tensions(machine)),
            commanded_tensions: operation.commanded_tensions(),
            status: Status::Converged,
            reason: None,
        })
    }
}

impl Criterion for ByLinearStep<'_> {
    fn name(&self) -> &str {
        "reachable-by-linear-step"
    }

    fn unit(&self) -> &str {
        "1"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        match self.0.linear_outcome(pose) {
            Some(outcome) => self.0.verdict(pose, &outcome),
            None => Verdict::impossible("the machine cannot be held at the commanded pose", None),
        }
    }
}
