//! Many poses of one robot at once, where control model and machine allow it.

use super::robots::Made;
use crate::equilibrium::{elastostatics, forward_kinematics};
use crate::geometry::{Pose, PoseBatch};
use crate::metamodel::input_error::InputError;
use crate::metamodel::operate::Status;
use crate::metamodel::sensitivity::PoseSensitivity;
use crate::metamodel::study::CommandedPose;
use crate::model::Model;
use crate::scalar::{LANES, LaneTable};
use crate::statics::Load;

/// What all robots share: poses, guesses, and what the control model without deviations sends.
pub(super) struct Batch {
    commanded: PoseBatch,
    guesses: PoseBatch,
    /// In the units of the control model's encoders, without winch offsets (m).
    sent: LaneTable,
}

/// Memory of one thread.
#[derive(Default)]
pub(super) struct Room {
    geometric: LaneTable,
    controlled: LaneTable,
    rigid: forward_kinematics::batch::Solutions,
    elastic: elastostatics::batch::Solutions,
}

impl Batch {
    /// `None` where the lengths of a deviating control model depend on tensions, for drums and shortened cables, for machines whose
    /// cables are not straight and linear, and where a pose is not answered without deviations: these are asked pose by pose.
    pub(super) fn new(
        (control, machine): (&Model, &Model),
        (poses, nominal): (&[CommandedPose], &[PoseSensitivity]),
        offsets: &[f64],
        deviates: bool,
    ) -> Option<Self> {
        let has_drums = control.composition().drum || machine.composition().drum;
        let is_shortened = poses.iter().any(|command| command.shortened.is_some());
        let chooses = deviates && control.composition().depends_on_tension();
        let is_answered = nominal.iter().all(|at| at.outcome.status == Status::Converged);
        // the batch of a rigid machine asks nothing of a robot with too few cables
        let is_plain = machine.composition().has_closed_form() && machine.cable_count() >= machine.dof();
        if has_drums || is_shortened || chooses || !is_answered || !is_plain {
            return None;
        }
        let mut sent = LaneTable::new(machine.cable_count());
        sent.resize(poses.len());
        let mut lengths = vec![0.0; machine.cable_count()];
        for (item, at) in nominal.iter().enumerate() {
            let without = at.outcome.sent.iter().zip(offsets).map(|(sent, offset)| sent - offset);
            lengths.iter_mut().zip(without).for_each(|(length, sent)| *length = sent);
            sent.write(item, &lengths);
        }
        let commanded = poses.iter().map(|command| &command.pose).collect();
        Some(Self { commanded, guesses: nominal.iter().map(|at| &at.outcome.pose).collect(), sent })
    }

    /// The emerging poses, `None` where there is no answer; nothing where the batch cannot be asked.
    pub(super) fn answers(
        &self,
        machine: &Model,
        made: &Made,
        room: &mut Room,
    ) -> Result<Option<Vec<Option<Pose>>>, InputError> {
        let Room { geometric, controlled, rigid, elastic } = room;
        if let Some(control) = &made.control {
            control.batch_cable_lengths(&self.commanded, geometric);
        }
        let machine = made.machine.as_ref().unwrap_or(machine);
        let count = self.sent.len();
        controlled.reshape(self.sent.rows(), count);
        for group in 0..controlled.groups() {
            for (cable, controlled) in controlled.group_mut(group).iter_mut().enumerate() {
                for lane in 0..LANES {
                    let sent = match &made.control {
                        Some(control) => control.recorded_length(cable, geometric.group(group)[cable].0[lane]),
                        None => self.sent.group(group)[cable].0[lane],
                    };
                    controlled.0[lane] = machine.controlled_length(cable, sent + made.offsets[cable]);
                }
            }
        }
        if machine.composition().depends_on_tension() {
            let load = Load::of(machine.robot())?;
            let mut solver = elastostatics::Solver::new(machine, &load, &elastostatics::Settings::default())?;
            let is_good = solver.solve_batch(controlled, &self.guesses, elastic).is_ok();
            let answer = |item| (elastic.status(item) == elastostatics::Status::Converged).then(|| elastic.pose(item));
            return Ok(is_good.then(|| (0..count).map(answer).collect()));
        }
        let settings = forward_kinematics::Settings::default();
        let mut solver =
            forward_kinematics::Solver::new(machine, &settings).map_err(elastostatics::InputError::from)?;
        let is_good = solver.solve_batch(controlled, &self.guesses, rigid).is_ok();
        let answer = |item| (rigid.status(item) == forward_kinematics::Status::Converged).then(|| rigid.pose(item));
        Ok(is_good.then(|| (0..count).map(answer).collect()))
    }
}
