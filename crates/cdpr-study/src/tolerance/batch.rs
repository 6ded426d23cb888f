//! Many poses of one robot at once, if control model and machine allow it.

use super::robots::Made;
use crate::sensitivity::PoseSensitivity;
use cdpr_model::control::CommandedPose;
use cdpr_model::control::Control;
use cdpr_model::control::InputError;
use cdpr_model::control::Status;
use cdpr_model::equilibrium::{self, ForwardBatch, ForwardError, ForwardSettings, Solutions, State, elastostatics};
use cdpr_model::geometry::{Pose, PoseBatch};
use cdpr_model::model::Model;
use cdpr_model::scalar::{LANES, LaneTable};

/// Inputs shared by all robots: poses, guesses, and the lengths that the control model without deviations sends.
pub(super) struct Batch {
    commanded: PoseBatch,
    guesses: PoseBatch,
    /// Lengths sent, in the units of the control model's encoders, without winch offsets (m).
    sent: LaneTable,
}

/// Work memory of one thread.
#[derive(Default)]
pub(super) struct Room {
    geometric: LaneTable,
    controlled: LaneTable,
    solutions: Solutions,
}

impl Batch {
    /// `None` if the lengths of a deviating control model depend on tensions, for drums and shortened cables, for
    /// machines whose cables are not straight and linear, and if a pose has no answer without deviations: these are
    /// solved pose by pose.
    pub(super) fn new(
        control: &Model,
        machine: &Model,
        poses: &[CommandedPose],
        nominal: &[PoseSensitivity],
        offsets: &[f64],
        deviates: bool,
    ) -> Option<Self> {
        let has_drums = control.composition().drum || machine.composition().drum;
        let is_shortened = poses.iter().any(|command| command.shortened.is_some());
        let chooses = deviates && Control::from(control).chooses_tensions();
        let is_answered = nominal.iter().all(|at| at.outcome.status == Status::Converged);
        if has_drums || is_shortened || chooses || !is_answered || !machine.has_forward_batch() {
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

    /// The emerging poses, each `None` without an answer; `None` in all if the batch does not apply.
    pub(super) fn answers(
        &self,
        machine: &Model,
        made: &Made,
        room: &mut Room,
    ) -> Result<Option<Vec<Option<Pose>>>, InputError> {
        let Room { geometric, controlled, solutions } = room;
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
        let settings = ForwardSettings::default();
        let problems = ForwardBatch { lengths: controlled, guesses: &self.guesses, load: None, only_taut: false };
        match machine.forward_batch(&settings, &problems, &mut State::at_home(machine), solutions) {
            // lengths that are not finite or not positive
            Err(ForwardError::Input(elastostatics::InputError::Kinematic(_))) => return Ok(None),
            other => other?,
        }
        let answer = |item| (solutions.status(item) == equilibrium::Status::Converged).then(|| solutions.pose(item));
        Ok(Some((0..count).map(answer).collect()))
    }
}
