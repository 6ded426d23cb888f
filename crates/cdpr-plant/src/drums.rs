//! Drums in time: I φ̈ = r f − τ − friction, with φ positive if cable is paid out and q_θ from the winch model.
//!
//! Dry friction has sticking as a state: a drum at rest is held while its torque is below the friction of drum and
//! pulley, and a drum whose speed changes sign within a step is at rest at its end.

use super::command::Command;
use super::error::StepError;
use super::momentum::Momentum;
use super::plant::Plant;
use super::pulls::elongation_rate;
use super::state::PlantState;
use super::step::added;
use cdpr_model::geometry::{Twist, Wrench};

/// Stages of the classical Runge–Kutta rule: fraction of the time at which each stage lies, and its weight.
const STAGES: [(f64, f64); 4] = [(0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)];

impl Plant {
    /// Determines which drums stand still over the step: those held by friction, a brake or a stop.
    pub(super) fn prepare_drums(&self, state: &mut PlantState, commands: &[Command]) -> Result<(), StepError> {
        for (index, drum) in self.drums.iter().enumerate() {
            let cable = &mut state.cables[index];
            cable.check_length(index, cable.controlled_length)?;
            let (_, radius) = self.drum_length(index, cable.drum_angle)?;
            let is_held = match commands[index] {
                Command::Torque(torque) => {
                    let (pull, wrap) = (cable.tension * radius, state.pulls.wraps[index]);
                    cable.drum_speed == 0.0 && state.friction[index].holds(pull, wrap, torque * drum.gear)
                }
                _ => true,
            };
            cable.is_stuck = is_held || cable.is_stopped;
            if cable.is_stuck {
                (cable.drum_speed, cable.controlled_length_rate) = (0.0, 0.0);
            }
            state.pulls.drums[index].before = cable.drum_speed;
        }
        Ok(())
    }

    /// Brings drums to rest whose speed changed sign by friction.
    pub(super) fn finish_drums(&self, state: &mut PlantState) {
        for (index, friction) in state.friction.iter().enumerate() {
            let cable = &mut state.cables[index];
            if friction.is_dry() && cable.drum_speed * state.pulls.drums[index].before < 0.0 {
                (cable.drum_speed, cable.controlled_length_rate) = (0.0, 0.0);
            }
        }
    }

    /// Applies the forces at the pose to platform and drums for a time (s).
    pub(super) fn kick_drums(
        &self,
        state: &mut PlantState,
        commands: &[Command],
        load: &Wrench,
        time: f64,
    ) -> Result<(), StepError> {
        self.look_at_drums(state)?;
        let (start, center) = (state.momentum, state.inertia.center(&state.pose));
        let (mut sum, mut rate) = (Momentum::default(), Momentum::default());
        for (fraction, weight) in STAGES {
            let momentum = added(&start, &rate, fraction * time);
            let twist = state.inertia.twist(&state.pose, &momentum);
            let wrench = self.accelerate(state, commands, &twist, fraction * time) + load + state.inertia.drag(&twist);
            rate = state.inertia.rate(&center, &wrench);
            sum = added(&sum, &rate, weight);
            state.pulls.drums.iter_mut().for_each(|work| work.sum += weight * work.acceleration);
        }
        state.momentum = added(&start, &sum, time / 6.0);
        for (cable, work) in state.cables.iter_mut().zip(&state.pulls.drums) {
            cable.drum_speed += work.sum * time / 6.0;
            cable.controlled_length_rate = work.radius * cable.drum_speed;
        }
        Ok(())
    }

    /// Computes the radii of the drums at their angles.
    fn look_at_drums(&self, state: &mut PlantState) -> Result<(), StepError> {
        for index in 0..self.drums.len() {
            let (_, radius) = self.drum_length(index, state.cables[index].drum_angle)?;
            let work = &mut state.pulls.drums[index];
            (work.radius, work.acceleration, work.sum) = (radius, 0.0, 0.0);
        }
        Ok(())
    }

    /// Wrench of the cables on a platform with a twist (N, N·m); the accelerations of the drums are stored in the
    /// state's work memory.
    #[cfg(any(feature = "error-control", test))]
    pub(super) fn driven(
        &self,
        state: &mut PlantState,
        commands: &[Command],
        twist: &Twist,
    ) -> Result<Wrench, StepError> {
        self.look_at_drums(state)?;
        Ok(self.accelerate(state, commands, twist, 0.0))
    }

    /// Computes the accelerations of the drums at a stage; returns the wrench of the cables.
    fn accelerate(&self, state: &mut PlantState, commands: &[Command], twist: &Twist, time: f64) -> Wrench {
        let mut wrench = Wrench::zeros();
        let pulls = &mut state.pulls;
        for (index, (drum, cable)) in self.drums.iter().zip(&state.cables).enumerate() {
            let friction = &state.friction[index];
            let (law, column, work) = (&pulls.laws[index], &pulls.columns[index], &mut pulls.drums[index]);
            work.trial = cable.drum_speed + work.acceleration * time;
            let tension = law.clipped(elongation_rate(column, twist) - work.radius * work.trial);
            (0..6).for_each(|row| wrench[row] += tension * column[row]);
            if cable.is_stuck {
                work.acceleration = 0.0;
                continue;
            }
            let motor = match commands[index] {
                Command::Torque(torque) => torque * drum.gear,
                _ => 0.0,
            };
            let outside = (tension + law.weight).max(0.0);
            let direction = if work.trial == 0.0 { work.radius * outside - motor } else { work.trial };
            let pull = outside * friction.passed_on(pulls.wraps[index], direction);
            let driven = work.radius * pull - motor;
            work.acceleration = (driven - friction.torque(work.trial, direction)) / drum.inertia;
        }
        wrench
    }

    /// Controlled length at a drum angle (rad → m) and its derivative (m/rad).
    pub(super) fn drum_length(&self, cable: usize, angle: f64) -> Result<(f64, f64), StepError> {
        let gear = self.model.robot().cables[cable].winch.gear_ratio.unwrap_or(1.0);
        let drum = self.model.motor_angle_gradient(cable, angle * gear)?;
        let scale = self.model.law(cable).recording.length_scale;
        Ok((self.model.controlled_length(cable, drum.value), drum.by_angle / scale))
    }

    /// Turns the drums at their speeds for a time (s).
    pub(super) fn drift_drums(&self, state: &mut PlantState, time: f64) -> Result<(), StepError> {
        for index in 0..self.drums.len() {
            let cable = &mut state.cables[index];
            if cable.is_stuck {
                continue;
            }
            cable.drum_angle += cable.drum_speed * time;
            let (length, radius) = self.drum_length(index, cable.drum_angle)?;
            (cable.controlled_length, cable.controlled_length_rate) = (length, radius * cable.drum_speed);
        }
        Ok(())
    }
}
