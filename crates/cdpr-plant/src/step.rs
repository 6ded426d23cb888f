//! One step in time of the machine.
//!
//! H = T(p, L) + V(x, R): forces at a fixed pose change the momentum (a *kick*), and the free body moves with it (a
//! *drift*, exact to rounding). Seven kicks and six drifts, symmetric, make a step of order four that is symplectic
//! (Blanes and Moan 2002, SRKN₆ᵇ); the last kick of a step and the first of the next one have the same pose, so that a
//! step evaluates the cables six times. Dampers and friction act within the [kicks](super::kicks).

use super::command::Command;
use super::error::StepError;
use super::momentum::LARGEST_TURN;
use super::plant::Plant;
use super::state::PlantState;

/// Fractions of the step for the kicks and for the drifts after them; the first kick is also the last.
const STAGES: [(f64, f64); 6] = [(B1, A1), (B2, A2), (B3, A3), (B4, A3), (B3, A2), (B2, A1)];
const B1: f64 = 0.082_984_406_417_405_2;
const B2: f64 = 0.396_309_801_498_368;
const B3: f64 = -0.039_056_304_922_348_6;
const A1: f64 = 0.245_298_957_184_271;
const A2: f64 = 0.604_872_665_711_080;
const B4: f64 = 1.0 - 2.0 * (B1 + B2 + B3);
const A3: f64 = 0.5 - (A1 + A2);

/// Index of the kick in the middle of a step.
const MIDDLE: usize = 3;
/// Excess by which a constant acceleration has moved the pose of the middle kick, over the acceleration and the square
/// of the step.
pub(super) const MIDDLE_AHEAD: f64 = B1 * 0.5 + B2 * (0.5 - A1) + B3 * (0.5 - A1 - A2) - 0.125;
/// The same of a speed in the middle: excess for a force that grows steadily, over the second derivative of the speed and the square of the step.
pub(super) const SPEED_AHEAD: f64 = -MIDDLE_AHEAD;

impl Plant {
    /// Advances a state by a time (s) under commands, one per cable. Allocates no memory.
    ///
    /// After an error the state is where the step failed; restore a snapshot taken before.
    pub fn step(&self, state: &mut PlantState, commands: &[Command], time: f64) -> Result<(), StepError> {
        self.check_commands(&state.cables, commands)?;
        let turn = state.inertia.angular_velocity(&state.pose.rotation, &state.momentum.angular).norm() * time;
        if turn > LARGEST_TURN {
            return Err(StepError::Spin { turn });
        }
        self.prepare(state, commands, time)?;
        self.pass_cuts(state, time)?;
        self.finish(state);
        state.time += time;
        match state.is_finite() {
            true => self.observe(state),
            false => Err(StepError::Overflow),
        }
    }

    /// Runs kicks and drifts over a time (s).
    #[inline]
    pub(super) fn stages(&self, state: &mut PlantState, time: f64) -> Result<(), StepError> {
        for (index, (kick, drift)) in STAGES.into_iter().enumerate() {
            if index == MIDDLE && self.dissipates {
                state.pulls.find(self, &state.pose, &mut state.cables)?;
                self.note_middle(state, |_, before| before);
            }
            self.kick(state, kick * time)?;
            if index == MIDDLE {
                // half of the kick lies before the middle
                let fraction = if self.dissipates { 0.5 } else { 0.0 };
                self.note_middle(state, |noted, after| after + fraction * (noted - after));
            }
            self.drift(state, drift * time)?;
        }
        self.kick(state, B1 * time)
    }

    /// Updates the middle values of every cable from the noted ones and the present ones.
    #[inline]
    fn note_middle(&self, state: &mut PlantState, note: impl Fn(f64, f64) -> f64) {
        let twist = self.twist_if_asked(state);
        for cable in 0..state.cables.len() {
            let now = self.unclipped(state, cable, &twist);
            let middle = &mut state.pulls.start.cables[cable].middle;
            *middle = note(*middle, now);
            if state.pulls.is_dry {
                let now = self.margin(state, cable, &twist);
                let middle = &mut state.pulls.start.cables[cable].middle_margin;
                *middle = note(*middle, now);
            }
        }
    }

    /// Determines the speeds of ideal winches over the step, or which drums stand still.
    pub(super) fn prepare(&self, state: &mut PlantState, commands: &[Command], time: f64) -> Result<(), StepError> {
        if !self.drums.is_empty() {
            return self.prepare_drums(state, commands);
        }
        for (index, cable) in state.cables.iter_mut().enumerate() {
            let start = cable.controlled_length;
            let (end, rate) = match commands[index] {
                Command::Length(end) if !cable.is_stopped => (end, (end - start) / time),
                Command::Speed(rate) if !cable.is_stopped => (start + rate * time, rate),
                _ => (start, 0.0),
            };
            cable.check_length(index, end)?;
            (cable.controlled_length_rate, state.pulls.ends[index]) = (rate, end);
        }
        Ok(())
    }

    /// Sets ideal winches to their commanded lengths.
    pub(super) fn finish(&self, state: &mut PlantState) {
        if !self.drums.is_empty() {
            return;
        }
        for (cable, end) in state.cables.iter_mut().zip(&state.pulls.ends) {
            cable.controlled_length = *end;
        }
    }

    /// Moves the free body and the winches for a time (s).
    #[inline]
    fn drift(&self, state: &mut PlantState, time: f64) -> Result<(), StepError> {
        let moved = state.inertia.drift(&state.pose, &state.momentum, time);
        state.pose = moved.map_err(|turn| StepError::Spin { turn })?;
        state.pulls.is_current = false;
        if !self.drums.is_empty() {
            return self.drift_drums(state, time);
        }
        for cable in &mut state.cables {
            cable.controlled_length += cable.controlled_length_rate * time;
        }
        Ok(())
    }

    /// Computes lengths and tensions for the state's pose and twist, and updates the memories of the cables.
    pub fn observe(&self, state: &mut PlantState) -> Result<(), StepError> {
        state.pulls.find(self, &state.pose, &mut state.cables)?;
        let twist = state.twist();
        for (index, cable) in state.cables.iter_mut().enumerate() {
            cable.check_length(index, cable.controlled_length)?;
            let (law, column) = (&state.pulls.laws[index], &state.pulls.columns[index]);
            let rate = super::pulls::elongation_rate(column, &twist) - cable.controlled_length_rate;
            cable.tension = if cable.is_broken { 0.0 } else { (law.clipped(rate) + law.weight).max(0.0) };
            cable.length = state.pulls.lengths[index];
            if let Some(memory) = &mut cable.memory {
                // dampers have no effect on the rope's memory
                let stretched = self.model.law(index).stretch.with_memory(memory);
                *memory = stretched.memory_at(law.tension + law.weight).unwrap_or(*memory);
            }
        }
        Ok(())
    }
}
