//! The start of a machine: in equilibrium at a pose with given tensions.

use super::cable_motion::CableMotion;
use super::error::{PlantError, StepError};
use super::plant::Plant;
use super::pulls::Pulls;
use super::state::{Added, PlantState};
use cdpr_model::equilibrium;
use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::statics::StaticsError;

impl Plant {
    /// The machine at rest at a pose, with its winches set for these tensions (N, where the robot measures them): in
    /// equilibrium if they balance the load.
    pub fn at_rest(&self, pose: &Pose, tensions: &[f64]) -> Result<PlantState, PlantError> {
        let mut settled = equilibrium::State::at(&self.model, pose);
        let command = self.model.inverse(pose, tensions, &mut settled)?;
        let lengths = command.controlled_lengths()?;
        settled.settle_inverse(&self.model);
        self.holding(pose, &lengths, settled.memories())
    }

    /// The machine at rest at a pose with these controlled lengths (m) and cables that were never loaded; in general
    /// not in equilibrium.
    pub fn with_lengths(&self, pose: &Pose, lengths: &[f64]) -> Result<PlantState, PlantError> {
        let settled = equilibrium::State::at(&self.model, pose);
        let (expected, found) = (self.model.cable_count(), lengths.len());
        if expected != found {
            return Err(StaticsError::TensionCount { expected, found }.into());
        }
        self.holding(pose, lengths, settled.memories())
    }

    fn holding(
        &self,
        pose: &Pose,
        lengths: &[f64],
        memories: &[cdpr_model::cable::stretch::hysteresis::Memory],
    ) -> Result<PlantState, PlantError> {
        let cable = |(index, &length): (usize, &f64)| -> Result<CableMotion, PlantError> {
            let drum_angle = match self.drums.is_empty() {
                true => 0.0,
                false => self.drum_angle(index, length)?,
            };
            Ok(CableMotion {
                controlled_length: length,
                controlled_length_rate: 0.0,
                tension: 0.0,
                length: 0.0,
                drum_angle,
                drum_speed: 0.0,
                is_stuck: false,
                is_broken: false,
                is_stopped: false,
                slip: 0.0,
                memory: memories.get(index).copied(),
                span: None,
            })
        };
        let cables = lengths.iter().enumerate().map(cable).collect::<Result<Vec<_>, _>>()?;
        let mut state = PlantState {
            time: 0.0,
            pose: *pose,
            momentum: Default::default(),
            inertia: self.inertia,
            added: Added::default(),
            friction: self.drums.iter().map(|drum| drum.friction).collect(),
            external: Wrench::zeros(),
            pulls: Pulls::new(cables.len(), self.drums.len()),
            cables,
        };
        self.observe(&mut state)?;
        self.hold_by_motors(&mut state)?;
        Ok(state)
    }

    /// Drum angle at a controlled length (m → rad).
    fn drum_angle(&self, cable: usize, length: f64) -> Result<f64, PlantError> {
        let gear = self.model.robot().cables[cable].winch.gear_ratio.unwrap_or(1.0);
        Ok(self.model.motor_angle(cable, length)? / gear)
    }

    /// Torques of the motors that hold the tensions of a state (N·m); empty for ideal winches.
    pub fn holding_torques(&self, state: &PlantState) -> Result<Vec<f64>, StepError> {
        let torque = |(index, drum): (usize, &super::plant::Drum)| {
            let cable = &state.cables[index];
            let (_, radius) = self.drum_length(index, cable.drum_angle)?;
            Ok(cable.tension * radius / drum.gear)
        };
        self.drums.iter().enumerate().map(torque).collect()
    }
}
