//! Inverse problem of a model: the commands to the winches with which the cables hold a pose with given tensions.

use super::State;
use super::inverse_solution::{CableCommand, InverseSolution};
use crate::cable::law::CableLengths;
use crate::cable::winch::Winch;
use crate::geometry::Pose;
use crate::model::Model;
use crate::statics::{self, StaticsError};

impl Model {
    /// Lengths, directions, wrap angles and motor angles with which the cables hold a pose with these tensions (N, one
    /// per cable, at the point where the robot measures them), starting from the memories of the state.
    ///
    /// Rigid straight cables have the same length at any tension; the length of others depends on it, so that a tension
    /// of NaN leaves their controlled length NaN. Tensions need not balance a load, and need not be positive: sensors
    /// of slack cables may read below zero. Errors are another number of tensions than cables, and infinite tensions.
    pub fn inverse<'s>(
        &self,
        pose: &Pose,
        tensions: &[f64],
        state: &'s mut State,
    ) -> Result<&'s InverseSolution, StaticsError> {
        self.check_commanded(tensions)?;
        let mut solution = std::mem::replace(&mut state.inverse, InverseSolution::unsolved(0));
        solution.pose = *pose;
        solution.failures.clear();
        solution.winch_failures.clear();
        solution.cables.resize(self.cable_count(), CableCommand::NONE);
        let rotation = pose.rotation_rows();
        for (index, (command, &tension)) in solution.cables.iter_mut().zip(tensions).enumerate() {
            match statics::cable_lengths(self, pose, &rotation, index, tension, state.memories().get(index)) {
                Ok(lengths) => *command = self.commanded(index, &lengths),
                Err(failure) => {
                    *command = CableCommand::NONE;
                    solution.failures.push(failure);
                }
            }
            if self.composition().drum && command.controlled_length.is_finite() {
                match self.motor_angle(index, command.controlled_length) {
                    Ok(angle) => {
                        command.motor_angle = Some(angle);
                        command.encoder_counts =
                            self.winch(index).and_then(|winch: &Winch| winch.encoder_counts(angle));
                    }
                    Err(failure) => solution.winch_failures.push(failure),
                }
            }
        }
        state.inverse = solution;
        Ok(&state.inverse)
    }

    /// Controlled lengths at a pose (m), for cables whose lengths do not depend on tensions; `None` if the length of
    /// one does.
    pub fn lengths_without_tensions(&self, pose: &Pose) -> Option<Result<Vec<f64>, StaticsError>> {
        let mut state = State::at(self, pose);
        match self.inverse(pose, &vec![f64::NAN; self.cable_count()], &mut state) {
            Ok(command) if command.needs_tensions() => None,
            Ok(command) => Some(command.controlled_lengths()),
            Err(error) => Some(Err(error)),
        }
    }

    /// Checks that there is one tension per cable, finite or NaN.
    fn check_commanded(&self, tensions: &[f64]) -> Result<(), StaticsError> {
        let (expected, found) = (self.cable_count(), tensions.len());
        if expected != found {
            return Err(StaticsError::TensionCount { expected, found });
        }
        match tensions.iter().position(|tension| tension.is_infinite()) {
            Some(index) => Err(StaticsError::NotFinite { cable: index + 1, value: tensions[index] }),
            None => Ok(()),
        }
    }

    fn commanded(&self, index: usize, lengths: &CableLengths) -> CableCommand {
        CableCommand {
            length: lengths.length,
            controlled_length: lengths.controlled_length,
            recorded_length: self.recorded_length(index, lengths.controlled_length),
            direction: lengths.direction,
            wrap_angle: lengths.wrap_angle,
            outlet_tension: lengths.outlet_tension,
            platform_tension: lengths.platform_tension,
            ..CableCommand::NONE
        }
    }
}
