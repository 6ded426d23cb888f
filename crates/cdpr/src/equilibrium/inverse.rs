//! Inverse problem of a model: what winches are told so that the cables hold a pose with given tensions.

use super::State;
use crate::cable::law::CableLengths;
use crate::cable::winch::Winch;
use crate::geometry::Pose;
use crate::model::{Model, WinchError};
use crate::statics::{self, StaticsError};

/// One cable of an inverse problem; numbers are NaN where the cable has none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CableCommand {
    /// Strained length from frame anchor to platform anchor, wrapped part included (m).
    pub length: f64,
    /// Controlled length q_θ (m).
    pub controlled_length: f64,
    /// Length that the robot records: length_scale · q_θ + length_offset (m).
    pub recorded_length: f64,
    /// Direction of the pull at the platform anchor (unit vector, world).
    pub direction: [f64; 3],
    /// Wrap angle β on the pulley (rad); 0 without one.
    pub wrap_angle: f64,
    /// Tension at the outlet (N); NaN where none was given.
    pub outlet_tension: f64,
    /// Tension at the platform anchor (N) of a cable with weight; that of others is the one at the outlet.
    pub platform_tension: Option<f64>,
    /// Motor angle (rad); nothing without the effect `drum`.
    pub motor_angle: Option<f64>,
    /// Encoder counts of the motor angle; nothing where the file does not say how its encoder counts.
    pub encoder_counts: Option<f64>,
}

impl CableCommand {
    const NONE: Self = Self {
        length: f64::NAN,
        controlled_length: f64::NAN,
        recorded_length: f64::NAN,
        direction: [f64::NAN; 3],
        wrap_angle: f64::NAN,
        outlet_tension: f64::NAN,
        platform_tension: None,
        motor_angle: None,
        encoder_counts: None,
    };
}

/// Answer of an inverse problem.
#[must_use = "check `failures` before using the lengths"]
#[derive(Clone, Debug, PartialEq)]
pub struct InverseSolution {
    /// Pose that was asked.
    pub pose: Pose,
    /// Every cable.
    pub cables: Vec<CableCommand>,
    /// Why cables have no path, or no length for their tension; none where the problem is solved.
    pub failures: Vec<StaticsError>,
    /// Why drums have no angle for a length; none without the effect `drum`.
    pub winch_failures: Vec<WinchError>,
}

impl InverseSolution {
    /// Room for this many cables.
    pub(super) fn unsolved(cables: usize) -> Self {
        Self {
            pose: Pose::identity(),
            cables: vec![CableCommand::NONE; cables],
            failures: Vec::new(),
            winch_failures: Vec::new(),
        }
    }

    /// Controlled lengths q_θ of all cables (m), or why the first of them has none.
    pub fn controlled_lengths(&self) -> Result<Vec<f64>, StaticsError> {
        self.numbers(|cable| cable.controlled_length)
    }

    /// Recorded lengths of all cables (m), or why the first of them has none.
    pub fn recorded_lengths(&self) -> Result<Vec<f64>, StaticsError> {
        self.numbers(|cable| cable.recorded_length)
    }

    /// True where a cable on its path has no controlled length for want of a tension.
    pub fn needs_tensions(&self) -> bool {
        self.cables.iter().any(|cable| cable.length.is_finite() && cable.controlled_length.is_nan())
    }

    fn numbers(&self, of: impl Fn(&CableCommand) -> f64) -> Result<Vec<f64>, StaticsError> {
        match self.failures.first() {
            Some(failure) => Err(failure.clone()),
            None => Ok(self.cables.iter().map(of).collect()),
        }
    }
}

impl Model {
    /// Lengths, directions, wrap angles and motor angles with which the cables hold a pose with these tensions (N, one per cable, where
    /// the robot measures them), coming from the memories of the state.
    ///
    /// Rigid straight cables have their length whatever the tension; others have none without one, so that a tension of NaN leaves their
    /// controlled length out. Whether the tensions balance a load is not asked, nor whether they pull: sensors of slack cables read less than
    /// nothing. Refuses another number of tensions than cables, and infinite ones.
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
            match statics::cable_lengths(self, (pose, &rotation), index, tension, state.memories().get(index)) {
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

    /// Controlled lengths at a pose of cables whose lengths no tension changes (m); nothing where one belongs to a tension.
    pub fn lengths_without_tensions(&self, pose: &Pose) -> Option<Result<Vec<f64>, StaticsError>> {
        let mut state = State::at(self, pose);
        match self.inverse(pose, &vec![f64::NAN; self.cable_count()], &mut state) {
            Ok(command) if command.needs_tensions() => None,
            Ok(command) => Some(command.controlled_lengths()),
            Err(error) => Some(Err(error)),
        }
    }

    /// Tensions of cables, or NaN for those that have none.
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
