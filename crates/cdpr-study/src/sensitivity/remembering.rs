//! Machines whose cables remember: exact derivatives along the path.
//!
//! At every step of the way the implicit function theorem gives the change of pose and tensions, with what the cables of control model
//! and machine remember as further right side, and their law that of the memories after it. No derivative leads on from a step at which
//! the law is not smooth (a [`Kink`]), until all of the hysteresis of all cables slides: then nothing is left of what was before. Poses
//! to which none leads have differences ([`Differences`]).

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

/// Outcome at a pose, with its exact derivatives where they lead there.
type Passed = (Outcome, Result<Derivatives, Kink>);

/// Outcomes at all poses, with exact derivatives where they lead there.
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

/// Goes along with an operation, and knows how what its cables remember follows every cause.
struct Companion<'s, 'a> {
    sensitivity: &'s mut Sensitivity<'a>,
    /// Cables that were never loaded.
    unloaded: Remembered,
    /// Memories at the start of every way.
    start: Result<Remembered, Kink>,
    /// Memories where control model and machine are.
    here: Result<Remembered, Kink>,
}

impl<'s, 'a> Companion<'s, 'a> {
    fn new(sensitivity: &'s mut Sensitivity<'a>) -> Self {
        let (control, machine, causes) = (&sensitivity.control.model, sensitivity.machine, sensitivity.causes());
        let of_control = causes.iter().filter(|cause| cause.side == Side::Control).count();
        let unloaded = Remembered::nothing(control, of_control, machine, causes.len());
        Self { sensitivity, start: Ok(unloaded.clone()), here: Ok(unloaded.clone()), unloaded }
    }

    /// The derivatives at a place; `None` for a new way.
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

    /// The derivatives at a place, and the changes of the memories after it.
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

    /// Refuses cables within rounding of being slack.
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

/// The motions of a model, and the model itself, with no stop in doubt.
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
