//! Machines with hysteresis: exact derivatives along the path.
//!
//! At every step of the path the implicit function theorem gives the changes of pose and tensions, with the memories of
//! the cables of control model and machine in the right-hand side, and their law gives the changes of the memories
//! after it. No derivative continues from a step at which the law is not smooth (a [`Kink`]), until all stops of all
//! cables slide: then the earlier memories have no effect any more. Poses without an exact derivative have differences
//! ([`Differences`]).

use super::cause::Side;
use super::differences::Differences;
use super::kink::Kink;
use super::memories::{Motions, Remembered};
use super::{Derivatives, Differentiation, PoseSensitivity, Sensitivity};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::InputError;
use cdpr_model::control::OperationError;
use cdpr_model::control::Outcome;
use cdpr_model::control::Status;
use cdpr_model::control::{Arrival, Operation, PathPoint};
use cdpr_model::model::Model;
use cdpr_model::statics::StaticsError;

/// The derivatives at each pose of a path.
pub(super) fn along(
    sensitivity: &mut Sensitivity<'_>,
    commands: &[CommandedPose],
) -> Result<Vec<PoseSensitivity>, InputError> {
    let passed = passed(sensitivity, commands)?;
    let is_kinked = |&place: &usize| {
        let (outcome, exact) = &passed[place];
        outcome.status == Status::Converged && exact.is_err()
    };
    let kinked: Vec<usize> = (0..passed.len()).filter(is_kinked).collect();
    let differences = Differences::new(sensitivity, commands, kinked)?;
    let derivatives = |place: usize, outcome: &Outcome, exact: Result<Derivatives, Kink>| {
        outcome.at_rest()?;
        exact.or_else(|kink| differences.derivatives(place, kink))
    };
    let at = |(place, (outcome, exact)): (usize, Passed)| PoseSensitivity {
        derivatives: derivatives(place, &outcome, exact),
        outcome,
    };
    Ok(passed.into_iter().enumerate().map(at).collect())
}

/// Outcome at a pose, with its exact derivatives if there are any.
type Passed = (Outcome, Result<Derivatives, Kink>);

/// Outcomes at all poses, with exact derivatives if there are any.
fn passed(sensitivity: &mut Sensitivity<'_>, commands: &[CommandedPose]) -> Result<Vec<Passed>, InputError> {
    let operation = Operation::new(sensitivity.control.clone(), sensitivity.machine, &sensitivity.winch_offsets)?;
    let history = sensitivity.history;
    let history = history.as_ref().map(|(history, start)| (history, start));
    let mut companion = Companion::new(sensitivity);
    let mut operation = operation.with_history_along(history, &mut |lent| {
        companion.pass(lent);
    });
    companion.start.clone_from(&companion.here);
    let answer = |command: &CommandedPose| {
        let mut exact = None;
        let outcome = operation.answer_along(command, &mut |lent| exact = companion.pass(lent));
        let exact = exact.unwrap_or(Err(Kink::NoRest(outcome.status)));
        (outcome, exact)
    };
    Ok(commands.iter().map(answer).collect())
}

/// Follows an operation and computes the changes of the memories of its cables by every cause.
struct Companion<'s, 'a> {
    sensitivity: &'s mut Sensitivity<'a>,
    /// Cables that were never loaded.
    unloaded: Remembered,
    /// Changes of the memories at the start of every path.
    start: Result<Remembered, Kink>,
    /// Changes of the memories at the present state of control model and machine.
    here: Result<Remembered, Kink>,
}

impl<'s, 'a> Companion<'s, 'a> {
    fn new(sensitivity: &'s mut Sensitivity<'a>) -> Self {
        let (control, machine, causes) = (&sensitivity.control.model, sensitivity.machine, sensitivity.causes());
        let of_control = causes.iter().filter(|cause| cause.side == Side::Control).count();
        let unloaded = Remembered::nothing(control, of_control, machine, causes.len());
        Self { sensitivity, start: Ok(unloaded.clone()), here: Ok(unloaded.clone()), unloaded }
    }

    /// The derivatives at a pose; `None` at the start of a new path.
    fn pass(&mut self, point: PathPoint<'_>) -> Option<Result<Derivatives, Kink>> {
        let PathPoint::Arrival(place) = point else {
            self.here.clone_from(&self.start);
            return None;
        };
        match self.linearized(&place) {
            Ok((derivatives, after)) => {
                self.here = Ok(after);
                Some(Ok(derivatives))
            }
            Err(kink) => {
                self.here = Err(kink.clone());
                Some(Err(kink))
            }
        }
    }

    /// The derivatives at a pose, and the changes of the memories after it.
    fn linearized(&mut self, place: &Arrival<'_>) -> Result<(Derivatives, Remembered), Kink> {
        let (outcome, pose) = (place.outcome, &place.command.pose);
        let Some(tensions) = outcome.tensions.as_ref().filter(|_| outcome.status == Status::Converged) else {
            return Err(Kink::NoRest(outcome.status));
        };
        let control = self.sensitivity.control.model.with_memories(place.control);
        let machine = self.sensitivity.machine.with_memories(place.machine);
        let chosen = self.sensitivity.command.tensions(pose)?;
        let (control, of_control) = motions(control, &|model| Motions::to(model, pose, &chosen))?;
        let (machine, of_machine) = motions(machine, &|model| Motions::to(model, &outcome.pose, tensions))?;
        self.check_slack(outcome, &of_control, &of_machine)?;
        let motions = [&of_control, &of_machine];
        let before = match &self.here {
            Ok(before) => before,
            Err(_) if motions.iter().all(|motions| motions.forget()) => &self.unloaded,
            Err(kink) => return Err(kink.clone()),
        };
        let step = self.sensitivity.step(pose, outcome, (&control, &machine))?;
        let (pose, tensions, after) = self.sensitivity.columns(&step, motions, before);
        before.check(motions, &after)?;
        let differentiation = Differentiation::Exact;
        Ok((Derivatives { pose, tensions: Some(tensions), differentiation }, after))
    }

    /// Checks that no cable is within rounding of becoming slack.
    fn check_slack(&self, outcome: &Outcome, control: &Motions, machine: &Motions) -> Result<(), Kink> {
        let model = self.sensitivity.machine;
        let paid_out = self.sensitivity.operation.paid_out(&outcome.sent).map_err(OperationError::from)?;
        let courses =
            model.cable_lengths(&outcome.pose).map_err(|error| OperationError::from(StaticsError::from(error)))?;
        let loose = |cable: usize| model.controlled_length(cable, paid_out[cable]) / courses[cable] - 1.0;
        let found = [
            (Side::Control, control.between_taut_and_slack(|_| 0.0)),
            (Side::Machine, machine.between_taut_and_slack(loose)),
        ];
        match found.into_iter().find_map(|(side, cable)| Some((side, cable?))) {
            Some((side, cable)) => Err(Kink::Slack { side, cable }),
            None => Ok(()),
        }
    }
}

/// The motions of a model, and the model itself, with no cable near the end of a branch.
fn motions(model: Model, to: &dyn Fn(&Model) -> Result<Motions, Kink>) -> Result<(Model, Motions), Kink> {
    let found = to(&model)?;
    match found.pushed_on(&model) {
        None => Ok((model, found)),
        Some(model) => {
            let found = to(&model)?;
            Ok((model, found))
        }
    }
}
