//! Drums in time: I φ̈ = r f − τ − friction, with φ positive if cable is paid out and q_θ from the winch model.
//!
//! Dry friction has sticking as a state: a drum at rest is held while its torque is below the friction of drum and
//! pulley, and a drum whose speed changes sign within a step is at rest at its end.

use super::command::Command;
use super::error::StepError;
use super::friction::Friction;
use super::kicks::added;
use super::momentum::Momentum;
use super::plant::Plant;
use super::pulls::elongation_rate;
use super::state::PlantState;
use cdpr_model::geometry::{Twist, Wrench};

/// Stages of the classical Runge–Kutta rule: fraction of the time at which each stage lies, and its weight.
const STAGES: [(f64, f64); 4] = [(0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)];

impl Plant {
    /// Determines for the step which drums stand still (held by friction, a brake or a stop) and in which direction the others turn.
    pub(super) fn prepare_drums(&self, state: &mut PlantState, commands: &[Command]) -> Result<(), StepError> {
        state.pulls.find(self, &state.pose, &mut state.cables)?;
        self.look_at_drums(state)?;
        state.pulls.is_dry = state.friction.iter().any(Friction::is_dry);
        state.pulls.is_linear = !self.sags && state.friction.iter().all(Friction::is_linear);
        for index in 0..self.drums.len() {
            let cable = &mut state.cables[index];
            cable.check_length(index, cable.controlled_length)?;
            let motor = match commands[index] {
                Command::Torque(torque) => Some(torque * self.drums[index].gear),
                _ => None,
            };
            let is_held = cable.is_stopped || motor.is_none();
            (state.pulls.drums[index].is_held, state.pulls.drums[index].motor) = (is_held, motor.unwrap_or(0.0));
            cable.is_stuck = is_held;
            if is_held || cable.drum_speed == 0.0 {
                (cable.drum_speed, cable.controlled_length_rate) = (0.0, 0.0);
            }
            match (is_held, cable.drum_speed == 0.0) {
                (true, _) => {}
                (false, true) => self.settle(state, index),
                (false, false) => state.pulls.drums[index].direction = cable.drum_speed.signum(),
            }
        }
        Ok(())
    }

    /// How far a drum with dry friction is from its next switch, below 0 past it: the speed in its direction (rad/s) of one that turns, the torque
    /// (N·m) that is missing to the nearer end of what friction holds of one that stands. Infinite for drums that do not switch. At the pose for
    /// which the pulls were computed.
    #[inline]
    pub(super) fn margin(&self, state: &PlantState, drum: usize, twist: &Twist) -> f64 {
        let (work, friction) = (&state.pulls.drums[drum], &state.friction[drum]);
        if work.is_held || !friction.is_dry() {
            return f64::INFINITY;
        }
        let cable = &state.cables[drum];
        if !cable.is_stuck {
            return work.direction * cable.drum_speed;
        }
        let [out, back] = self.torques_at_rest(state, drum, twist);
        (friction.standing - out).min(back + friction.standing)
    }

    /// Torques at a drum that stands, of cable and motor, if the cable were about to be paid out and to be reeled in (N·m).
    #[inline]
    fn torques_at_rest(&self, state: &PlantState, drum: usize, twist: &Twist) -> [f64; 2] {
        let (law, column) = (&state.pulls.laws[drum], &state.pulls.columns[drum]);
        let outside = (law.clipped(elongation_rate(column, twist)) + law.weight).max(0.0);
        let (pull, motor) = (state.pulls.drums[drum].radius * outside, state.pulls.drums[drum].motor);
        [1.0, -1.0].map(|way| pull * state.friction[drum].passed_on(state.pulls.wraps[drum], way) - motor)
    }

    /// Holds a drum at rest, or lets it turn where its torques point if friction does not hold them.
    fn settle(&self, state: &mut PlantState, drum: usize) {
        let twist = state.twist();
        let [out, back] = self.torques_at_rest(state, drum, &twist);
        let (standing, is_dry) = (state.friction[drum].standing, state.friction[drum].is_dry());
        state.cables[drum].is_stuck = is_dry && out <= standing && back >= -standing;
        state.pulls.drums[drum].direction = if out > standing { 1.0 } else { -1.0 };
    }

    /// Torque (N·m, positive against paying out) with which friction of drum and pulley resist in an observed state: r f − τ − I φ̈. Of a drum
    /// that stands it is the reaction that holds it, under the torque of the last command; before the first command the motor holds the tensions
    /// of the start. `None` for ideal winches.
    pub fn friction_torque(&self, state: &PlantState, drum: usize) -> Option<f64> {
        let (work, friction) = (state.pulls.drums.get(drum)?, state.friction.get(drum)?);
        let cable = &state.cables[drum];
        let pull = work.radius * cable.tension;
        if cable.is_stuck {
            return Some(pull - work.motor);
        }
        let direction = if cable.drum_speed == 0.0 { work.direction } else { cable.drum_speed };
        let lost = 1.0 - friction.passed_on(state.pulls.wraps[drum], direction);
        Some(pull * lost + friction.torque(cable.drum_speed, direction))
    }

    /// Lets motors hold the tensions of an observed state until the first command.
    pub(super) fn hold_by_motors(&self, state: &mut PlantState) -> Result<(), StepError> {
        self.look_at_drums(state)?;
        for drum in 0..self.drums.len() {
            state.pulls.drums[drum].motor = state.pulls.drums[drum].radius * state.cables[drum].tension;
            self.settle(state, drum);
        }
        Ok(())
    }

    /// Holds drums that stand, or lets them turn where their torques point if friction does not hold them.
    pub(super) fn settle_all(&self, state: &mut PlantState) {
        for drum in 0..self.drums.len() {
            if state.cables[drum].drum_speed == 0.0 {
                self.settle(state, drum);
            }
        }
    }

    /// Brings a drum that turns to rest, and lets one that stands turn over the nearer end of what friction holds.
    pub(super) fn switch(&self, state: &mut PlantState, drum: usize) {
        let was_stuck = state.cables[drum].is_stuck;
        (state.cables[drum].drum_speed, state.cables[drum].controlled_length_rate) = (0.0, 0.0);
        if !was_stuck {
            return self.settle(state, drum);
        }
        let twist = state.twist();
        let ([out, back], standing) = (self.torques_at_rest(state, drum, &twist), state.friction[drum].standing);
        state.cables[drum].is_stuck = false;
        state.pulls.drums[drum].direction = if standing - out < back + standing { 1.0 } else { -1.0 };
    }

    /// Switches all drums whose margin is used up.
    pub(super) fn switch_what_is_used_up(&self, state: &mut PlantState) {
        for drum in 0..self.drums.len() {
            if self.margin(state, drum, &state.twist()) < 0.0 {
                self.switch(state, drum);
            }
        }
    }

    /// Applies the forces at the pose to platform and drums for a time (s), by the classical Runge–Kutta rule.
    pub(super) fn kick_drums_by_stages(&self, state: &mut PlantState, load: &Wrench, time: f64) {
        state.pulls.drums.iter_mut().for_each(|work| (work.acceleration, work.sum) = (0.0, 0.0));
        let (start, center) = (state.momentum, state.inertia.center(&state.pose));
        let (mut sum, mut rate) = (Momentum::default(), Momentum::default());
        for (fraction, weight) in STAGES {
            let momentum = added(&start, &rate, fraction * time);
            let twist = state.inertia.twist(&state.pose, &momentum);
            let wrench = self.accelerate(state, &twist, fraction * time) + load + state.inertia.drag(&twist);
            rate = state.inertia.rate(&center, &wrench);
            sum = added(&sum, &rate, weight);
            state.pulls.drums.iter_mut().for_each(|work| work.sum += weight * work.acceleration);
        }
        state.momentum = added(&start, &sum, time / 6.0);
        for (cable, work) in state.cables.iter_mut().zip(&state.pulls.drums) {
            cable.drum_speed += work.sum * time / 6.0;
            cable.controlled_length_rate = work.radius * cable.drum_speed;
        }
    }

    /// Computes the radii of the drums at their angles.
    pub(super) fn look_at_drums(&self, state: &mut PlantState) -> Result<(), StepError> {
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
    pub(super) fn driven(&self, state: &mut PlantState, twist: &Twist) -> Result<Wrench, StepError> {
        self.look_at_drums(state)?;
        Ok(self.accelerate(state, twist, 0.0))
    }

    /// Computes the accelerations of the drums at a stage; returns the wrench of the cables.
    pub(super) fn accelerate(&self, state: &mut PlantState, twist: &Twist, time: f64) -> Wrench {
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
            let outside = (tension + law.weight).max(0.0);
            let pull = outside * friction.passed_on(pulls.wraps[index], work.direction);
            let driven = work.radius * pull - work.motor;
            work.acceleration = (driven - friction.torque(work.trial, work.direction)) / drum.inertia;
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
