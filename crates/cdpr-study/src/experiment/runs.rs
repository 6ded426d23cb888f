//! The machine under its control model: poses, records, accuracy.

use super::Experiment;
use crate::accuracy::{Assessment, assess_operation};
use crate::branches::{Branches, branches};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::Driving;
use cdpr_model::control::InputError;
use cdpr_model::control::Operation;
use cdpr_model::control::simulate::{Simulation, simulate_operation};
use cdpr_model::control::with_motor_angles;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Provenance, Samples, SensorSigmas, Sidecar};

/// Most poses at which branches are compared.
const BRANCHED: usize = 100;

impl Experiment {
    /// The machine under its control model, for poses in sequence.
    pub fn operation(&self) -> Result<Operation, InputError> {
        let operation = Operation::new(self.controller()?, &self.machine, &self.offsets)?;
        Ok(operation.with_history(self.history().as_ref(), &self.start))
    }

    /// The machine under its control model, for poses from several threads.
    pub fn driving(&self) -> Result<Driving, InputError> {
        let driving = Driving::new(self.controller()?, &self.machine, &self.offsets)?;
        Ok(driving.with_history(self.history().as_ref(), &self.start))
    }

    /// Commands of the study: the poses of the table that it names (`from_table`, as read by the caller), those of its
    /// grid, random ones by the seed, and tension tests; without those that `[poses] only` excludes.
    pub fn commands(&self, from_table: Vec<Pose>, seed: u64) -> Result<Vec<CommandedPose>, InputError> {
        let mut commands = self.study.commanded_poses(self.machine.robot(), from_table, seed)?;
        self.study.keep_wanted(&self.machine, &mut commands)?;
        Ok(commands)
    }

    /// [`Experiment::commands`] without tension tests, which leave their pose on purpose: the poses that count for
    /// accuracy.
    pub fn poses(&self, from_table: Vec<Pose>, seed: u64) -> Result<Vec<CommandedPose>, InputError> {
        let mut poses = self.commands(from_table, seed)?;
        poses.retain(|command| command.shortened.is_none());
        Ok(poses)
    }

    /// Virtual measurements with the sensor noise of the study.
    pub fn record(&self, commands: &[CommandedPose], seed: u64) -> Result<Simulation, InputError> {
        simulate_operation(&mut self.operation()?, commands, &self.study.noise.unwrap_or_default(), seed)
    }

    /// Virtual measurements by sensors without noise.
    pub fn record_exactly(&self, commands: &[CommandedPose]) -> Result<Simulation, InputError> {
        simulate_operation(&mut self.operation()?, commands, &SensorSigmas::default(), 0)
    }

    /// Recorded samples with the motor angles that were sent instead of the lengths.
    pub fn with_motor_angles(&self, samples: &Samples) -> Result<Samples, InputError> {
        with_motor_angles(&self.control, &self.machine, samples)
    }

    /// Sidecar of recorded samples; `source` is the name of the recording program or person.
    pub fn sidecar(&self, source: impl Into<String>, seed: u64) -> Sidecar {
        Sidecar {
            layout_version: 1,
            sigmas: self.study.noise.unwrap_or_default(),
            provenance: Some(Provenance {
                source: Some(source.into()),
                robot: Some(self.machine.robot().name.clone()),
                seed: Some(seed),
                ..Provenance::default()
            }),
            ..Sidecar::default()
        }
    }

    /// Accuracy with which the control model drives the machine to these poses, see [`Experiment::poses`].
    pub fn assess(&self, poses: &[CommandedPose]) -> Result<Assessment, InputError> {
        assess_operation(&mut self.operation()?, poses)
    }

    /// Distances between branches at the poses, at most a hundred of them, evenly chosen; `None` for a machine without
    /// history.
    pub fn branches(&self, poses: &[CommandedPose], stroke: f64) -> Result<Option<Branches>, InputError> {
        let Some(history) = self.history() else { return Ok(None) };
        let every = poses.len().div_ceil(BRANCHED).max(1);
        let poses: Vec<Pose> = poses.iter().step_by(every).map(|command| command.pose).collect();
        branches(self.controller()?, &self.machine, &self.offsets, &history, &self.start, &poses, stroke).map(Some)
    }
}
