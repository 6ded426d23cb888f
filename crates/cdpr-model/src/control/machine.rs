//! A machine: the model that answers to lengths.

use super::input_error::InputError;
use super::outcome::Outcome;
use super::status::Status;
use crate::equilibrium::{self, ForwardBatch, ForwardProblem, ForwardSettings, Solution, Solutions, State};
use crate::geometry::{Pose, PoseBatch};
use crate::model::Model;
use crate::scalar::LaneTable;

/// A machine and the settings of its forward problem.
#[derive(Clone, Debug)]
pub(super) struct Machine {
    model: Model,
    problem: ForwardProblem,
    settings: ForwardSettings,
}

impl Machine {
    pub(super) fn new(model: &Model) -> Result<Self, InputError> {
        let problem = model.forward_problem(None, &mut State::at_home(model))?;
        Ok(Self { model: model.clone(), problem, settings: ForwardSettings::default() })
    }

    pub(super) fn model(&self) -> &Model {
        &self.model
    }

    /// True if tensions emerge.
    pub(super) fn knows_tensions(&self) -> bool {
        self.problem == ForwardProblem::Equilibrium
    }

    /// True if the cables have a memory.
    pub(super) fn remembers(&self) -> bool {
        self.model.composition().stretch.remembers()
    }

    /// The machine with a forward problem that starts only from the commanded pose.
    pub(super) fn without_restarts(mut self) -> Self {
        self.settings.equilibrium.max_restarts = 0;
        self
    }

    /// Emerging poses and tensions for many controlled lengths at once (m; a row per cable), searched from these poses;
    /// with `only_taut` only equilibria in which every cable is taut. `None` if the machine fits lengths, or if lengths
    /// are not finite.
    pub(super) fn answer_all(
        &self,
        lengths: &LaneTable,
        guesses: &PoseBatch,
        only_taut: bool,
        state: &mut State,
    ) -> Option<Solutions> {
        let mut solutions = Solutions::default();
        let problems = ForwardBatch { lengths, guesses, load: None, only_taut };
        let answered = self.model.forward_batch(&self.settings, &problems, state, &mut solutions).is_ok();
        (answered && self.knows_tensions()).then_some(solutions)
    }

    /// Outcome for lengths sent to the winches (m, in the units of the encoders), searched from a pose.
    pub(super) fn answer(&self, sent: Vec<f64>, guess: &Pose, state: &mut State) -> Outcome {
        let controlled: Vec<f64> =
            sent.iter().enumerate().map(|(cable, &length)| self.model.controlled_length(cable, length)).collect();
        let mut outcome = Outcome {
            pose: *guess,
            recorded: sent.clone(),
            sent,
            tensions: None,
            commanded_tensions: None,
            status: Status::NotConverged,
            reason: None,
        };
        match self.model.forward_with(&self.settings, &controlled, None, Some(guess), state) {
            Ok(solution) => outcome.come_to(self, solution),
            Err(error) => outcome.reason = Some(error.to_string()),
        }
        outcome
    }
}

impl Outcome {
    fn come_to(&mut self, machine: &Machine, solution: &Solution) {
        self.pose = solution.pose;
        self.status = match solution.status {
            equilibrium::Status::Converged => Status::Converged,
            equilibrium::Status::NotConverged => Status::NotConverged,
            equilibrium::Status::Singular => Status::Singular,
            equilibrium::Status::Unstable => Status::Unstable,
        };
        // a solver's remark on a converged answer is not a reason
        self.reason = (self.status != Status::Converged).then(|| {
            solution.reason.clone().unwrap_or_else(|| "the machine's forward problem has no solution".to_owned())
        });
        let model = &machine.model;
        if machine.knows_tensions() {
            self.tensions = Some(solution.tensions.clone());
        } else if let Ok(lengths) = model.cable_lengths(&solution.pose) {
            // a rigid platform goes to the least-squares pose, and the winches take up the slack there
            let recorded = |(cable, &length): (usize, &f64)| model.recorded_length(cable, length);
            self.recorded = lengths.iter().enumerate().map(recorded).collect();
        }
    }
}
