//! A machine: what answers to lengths.

use super::input_error::InputError;
use super::operate::{Outcome, Status};
use crate::equilibrium::elastostatics::batch::Solutions;
use crate::equilibrium::forward_problem::ForwardSolver;
use crate::equilibrium::{elastostatics, forward_kinematics};
use crate::geometry::{Pose, PoseBatch};
use crate::model::{Model, StretchEffect};
use crate::scalar::LaneTable;

/// A machine with the forward problem that it answers by.
pub(super) struct Machine<'a> {
    model: &'a Model,
    forward: ForwardSolver<'a>,
}

impl<'a> Machine<'a> {
    pub(super) fn new(model: &'a Model) -> Result<Self, InputError> {
        let forward = ForwardSolver::new::<InputError>(model, &forward_kinematics::Settings::default())?;
        Ok(Self { model, forward })
    }

    pub(super) fn model(&self) -> &'a Model {
        self.model
    }

    /// True when tensions emerge.
    pub(super) fn knows_tensions(&self) -> bool {
        self.forward.knows_tensions()
    }

    /// True when the cables remember how they came to a tension.
    pub(super) fn remembers(&self) -> bool {
        self.model.composition().stretch == StretchEffect::Hysteresis
    }

    /// The cables remember the last answer.
    pub(super) fn remember(&mut self) {
        if let ForwardSolver::Equilibrium(solver) = &mut self.forward {
            solver.remember();
        }
    }

    /// The cables are as if they had never been loaded.
    pub(super) fn forget(&mut self) {
        if let ForwardSolver::Equilibrium(solver) = &mut self.forward {
            solver.forget();
        }
    }

    /// The forward problem starts from the commanded pose alone from now on.
    pub(super) fn without_restarts(mut self) -> Self {
        if let ForwardSolver::Equilibrium(solver) = self.forward {
            self.forward = ForwardSolver::Equilibrium(Box::new(solver.without_restarts()));
        }
        self
    }

    /// What emerges for many controlled lengths at once (m; a row per cable), sought from these poses; with `only_taut` where
    /// every cable pulls. False where the machine fits lengths, and where the lengths are no numbers.
    pub(super) fn answer_all(
        &mut self,
        lengths: &LaneTable,
        guesses: &PoseBatch,
        only_taut: bool,
        solutions: &mut Solutions,
    ) -> bool {
        match &mut self.forward {
            ForwardSolver::LeastSquares(_) => false,
            ForwardSolver::Equilibrium(solver) if only_taut => {
                solver.solve_taut_batch(lengths, guesses, solutions).is_ok()
            }
            ForwardSolver::Equilibrium(solver) => solver.solve_batch(lengths, guesses, solutions).is_ok(),
        }
    }

    /// What emerges when the winches are told these lengths (m, in the units of the encoders), sought from a pose.
    pub(super) fn answer(&mut self, sent: Vec<f64>, guess: &Pose) -> Outcome {
        let controlled: Vec<f64> =
            sent.iter().enumerate().map(|(cable, &length)| self.model.controlled_length(cable, length)).collect();
        let mut outcome = Outcome {
            pose: *guess,
            recorded: sent.clone(),
            sent,
            tensions: None,
            status: Status::NotConverged,
            reason: None,
        };
        let refused = match &mut self.forward {
            ForwardSolver::LeastSquares(solver) => solver
                .solve(&controlled, guess)
                .map(|solution| outcome.rigid(self.model, solution))
                .err()
                .map(|e| e.to_string()),
            ForwardSolver::Equilibrium(solver) => {
                solver.solve(&controlled, guess).map(|solution| outcome.elastic(solution)).err().map(|e| e.to_string())
            }
        };
        if refused.is_some() {
            outcome.reason = refused;
        }
        outcome
    }
}

impl Outcome {
    /// The platform of a rigid machine goes to the least-squares pose, and the winches take up what is slack there.
    fn rigid(&mut self, machine: &Model, solution: &forward_kinematics::Solution) {
        self.pose = solution.pose;
        self.status = match solution.status {
            forward_kinematics::Status::Converged => Status::Converged,
            forward_kinematics::Status::NotConverged => Status::NotConverged,
            forward_kinematics::Status::Singular => Status::Singular,
        };
        self.reason = self.reason_of(&solution.reason);
        if let Ok(lengths) = machine.cable_lengths(&solution.pose) {
            let recorded = |(cable, &length): (usize, &f64)| machine.recorded_length(cable, length);
            self.recorded = lengths.iter().enumerate().map(recorded).collect();
        }
    }

    fn elastic(&mut self, solution: &elastostatics::Solution) {
        self.pose = solution.pose;
        self.tensions = Some(solution.tensions.clone());
        self.status = match solution.status {
            elastostatics::Status::Converged => Status::Converged,
            elastostatics::Status::NotConverged => Status::NotConverged,
            elastostatics::Status::Singular => Status::Singular,
            elastostatics::Status::Unstable => Status::Unstable,
        };
        self.reason = self.reason_of(&solution.reason);
    }

    /// A solver's remark on a converged answer is no reason.
    fn reason_of(&self, remark: &Option<String>) -> Option<String> {
        match self.status {
            Status::Converged => None,
            _ => Some(remark.clone().unwrap_or_else(|| "the machine's forward problem has no solution".to_owned())),
        }
    }
}
