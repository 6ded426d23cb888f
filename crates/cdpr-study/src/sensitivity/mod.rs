//! Derivatives of the emerging pose and its tensions by every parameter: of the control model, of the machine, and of
//! the winch settings.
//!
//! The command is fixed, so ∂(pose error) is ∂x̂. A deviation changes the lengths sent (by its control model or its
//! winch offsets) or the machine; the rest follows from the implicit function theorem at the emerging state, dx̂ =
//! K_wx⁻¹ (∂r/∂p + ∂r/∂q_θ · ∂q_θ/∂p). Winch offsets are stored numbers and by default do not follow a deviation, see
//! [`Offsets`]. For machines with hysteresis the same holds along their whole path (`remembering`).

mod along;
mod cause;
mod choice;
mod command;
mod derivatives;
mod differences;
mod equilibrium;
mod kink;
mod memories;
mod offsets;
mod ranking;
mod remembering;
mod same_error;
mod setting;
mod windings;

use nalgebra::{DMatrix, DVector};

pub(crate) use cause::causes_of;
pub use cause::{Kind, ParameterDeviation, Side};
pub use derivatives::{Derivatives, Differentiation};
pub use kink::Kink;
pub use offsets::Offsets;
pub use ranking::{Influence, KindInfluence, rank, rank_kinds};
pub use same_error::counted_as;
pub use setting::Setting;

use cdpr_model::control::Control;
use cdpr_model::control::InputError;
use cdpr_model::control::Operation;
use cdpr_model::control::OperationError;
use cdpr_model::control::Outcome;
use cdpr_model::control::tension_model;
use cdpr_model::control::{CommandedPose, History};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::Load;
use command::{Command, Commanded};
use equilibrium::{Answer, Equilibrium};
use memories::{Motions, Remembered};
use windings::Windings;

/// Derivatives of pose and tensions by all deviations at one commanded pose.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseSensitivity {
    /// Outcome without deviations.
    pub outcome: Outcome,
    /// The derivatives, or the reason for which there are none.
    pub derivatives: Result<Derivatives, OperationError>,
}

/// A control model on a machine with set winches, and all numbers that may deviate.
pub struct Sensitivity<'a> {
    control: Control,
    machine: &'a Model,
    /// Path of a machine with memory to the poses, and its start.
    history: Option<(History, Pose)>,
    winch_offsets: Vec<f64>,
    operation: Operation,
    command: Command,
    load: Option<Load>,
    causes: Vec<ParameterDeviation>,
    /// Changes of the winch offsets per unit of each cause (m).
    offsets: Vec<DVector<f64>>,
}

impl<'a> Sensitivity<'a> {
    /// Sensitivity of a control model on a machine; errors as in [`Operation::new`], and for a control model with a
    /// map.
    ///
    /// `offsets` are the winch offsets in use; `setting` describes how they were found, for deviations that they may
    /// follow.
    pub fn new(
        control: impl Into<Control>,
        machine: &'a Model,
        offsets: &[f64],
        setting: &Setting<'a>,
    ) -> Result<Self, InputError> {
        let reason = "with numbers that deviate, its corrections would be those of another model";
        let control = control.into().without_map("sensitivity", reason)?;
        let operation = Operation::new(control.clone(), machine, offsets)?;
        let load = match operation.knows_tensions() {
            true => Some(Load::of(machine.robot())?),
            false => None,
        };
        let causes = causes(&control.model, machine, setting);
        let winch_offsets = offsets.to_vec();
        let offsets = setting.by_causes(&control.model, machine, &causes)?;
        let command = Command::new(control.clone())?;
        Ok(Self { control, machine, history: None, winch_offsets, operation, command, load, causes, offsets })
    }

    /// A machine with memory comes to the poses on this path from a start, as in [`Operation::with_history`]. Without a
    /// history every pose is reached at once by cables that were never loaded.
    #[must_use]
    pub fn with_history<'h>(mut self, history: impl Into<Option<&'h History>>, start: &Pose) -> Self {
        self.history = history.into().map(|history| (*history, *start));
        self
    }

    /// Deviations, in the order of the columns of all derivatives: control model, machine, winches.
    pub fn causes(&self) -> &[ParameterDeviation] {
        &self.causes
    }

    fn derivatives(&mut self, command: &CommandedPose, outcome: &Outcome) -> Result<Derivatives, OperationError> {
        let control = self.control.model.clone();
        let step = self.step(&command.pose, outcome, (&control, self.machine))?;
        let unmoved = Motions::default();
        let (pose, tensions, _) = self.columns(&step, [&unmoved, &unmoved], &Remembered::default());
        let tensions = outcome.tensions.is_some().then_some(tensions);
        Ok(Derivatives { pose, tensions, differentiation: Differentiation::Exact })
    }

    /// A command and its outcome, linearized at control model and machine with the present memories of their cables.
    fn step<'m>(
        &mut self,
        command: &Pose,
        outcome: &Outcome,
        (control, machine): (&'m Model, &'m Model),
    ) -> Result<Step<'m>, OperationError> {
        let windings = Windings::at(control, machine, &outcome.sent)?;
        let equilibrium = self.equilibrium(machine, outcome)?.ok_or(OperationError::Singular)?;
        let of_control: Vec<ParameterDeviation> =
            self.causes.iter().copied().filter(|cause| cause.side == Side::Control).collect();
        let commanded = self.command.by_causes(control, command, &of_control)?;
        Ok(Step { commanded, windings, equilibrium })
    }

    /// Changes of pose and tensions at a step by every cause, and of the memories after the motions to it.
    fn columns(
        &self,
        step: &Step<'_>,
        [control, machine]: [&Motions; 2],
        before: &Remembered,
    ) -> (DMatrix<f64>, DMatrix<f64>, Remembered) {
        let (n, m, count) = (self.machine.dof(), self.machine.cable_count(), self.causes.len());
        let (mut pose, mut tensions) = (DMatrix::zeros(n, count), DMatrix::zeros(m, count));
        let mut after = Remembered::default();
        for (column, (cause, offsets)) in self.causes.iter().zip(&self.offsets).enumerate() {
            let mut sent = offsets.clone();
            // the causes of the control model come first
            if let Some(lengths) = step.commanded.lengths.get(column) {
                let before = before.control.get(column).map_or(&[][..], Vec::as_slice);
                sent += lengths;
                control.lengths(before).iter().for_each(|lengths| sent += lengths);
                after.control.push(control.settled(&step.commanded.tension_changes[column], before));
            }
            let before = before.machine.get(column).map_or(&[][..], Vec::as_slice);
            let answer = step.answer(cause, &sent, machine.lengths(before));
            after.machine.push(machine.settled(&answer.tensions, before));
            pose.set_column(column, &answer.pose);
            tensions.set_column(column, &answer.tensions);
        }
        (pose, tensions, after)
    }

    fn equilibrium<'m>(&self, machine: &'m Model, outcome: &Outcome) -> Result<Option<Equilibrium<'m>>, InputError> {
        let pose = &outcome.pose;
        if let (Some(load), Some(tensions)) = (&self.load, &outcome.tensions) {
            return Ok(Equilibrium::elastic(machine, pose, tensions, load)?);
        }
        let controlled = |(cable, &length): (usize, &f64)| machine.controlled_length(cable, length);
        let paid_out: Vec<f64> = self.operation.paid_out(&outcome.sent).map_err(InputError::Winch)?;
        let lengths: Vec<f64> = paid_out.iter().enumerate().map(controlled).collect();
        Ok(Equilibrium::rigid(machine, pose, &lengths)?)
    }
}

/// A command and its outcome, linearized.
struct Step<'m> {
    commanded: Commanded,
    windings: Windings<'m>,
    equilibrium: Equilibrium<'m>,
}

impl Step<'_> {
    /// Change of pose and tensions by one unit of a cause, by the change of the lengths sent (m), and by that of the
    /// machine's own lengths with the memories of its cables, at fixed tensions (m).
    fn answer(&self, cause: &ParameterDeviation, sent: &DVector<f64>, remembered: Option<DVector<f64>>) -> Answer {
        let mut paid_out = self.windings.paid_out(sent);
        paid_out[cause.cable] += self.windings.by_cause(cause);
        remembered.iter().for_each(|lengths| paid_out -= lengths);
        match cause.side {
            Side::Machine => self.equilibrium.by_cause(cause, &paid_out),
            _ => self.equilibrium.by_sent(&paid_out),
        }
    }
}

/// Deviations possible on control model, machine and winches, in that order.
pub fn causes(control: &Model, machine: &Model, setting: &Setting<'_>) -> Vec<ParameterDeviation> {
    let elastic = tension_model(setting.set_with(control), machine);
    let mut causes = causes_of(Side::Control, control);
    causes.extend(causes_of(Side::Machine, machine));
    let winches = causes_of(Side::Winches, elastic.unwrap_or(machine));
    causes
        .extend(winches.into_iter().filter(|cause| cause.kind == Kind::WinchOffset || setting.has_computed_offsets()));
    causes
}
