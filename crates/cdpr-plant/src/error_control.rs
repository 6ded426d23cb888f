//! Motion by a library's integrator with error control: the reference of the symplectic step, and free runs.
//!
//! Dormand and Prince's rule of order eight (crate `differential-equations`, decision 0042) on position, quaternion,
//! momentum per mass, and the angles and speeds of the drums, with the forces of [`Plant::step`].

use std::cell::RefCell;

use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::command::Command;
use super::error::StepError;
use super::momentum::Momentum;
use super::plant::Plant;
use super::state::PlantState;
use cdpr_model::geometry::{Pose, Wrench};

/// Most steps of a passage, about a second of work.
const STEPS: usize = 100_000;

/// Count of the platform's numbers, which precede those of the drums.
const PLATFORM: usize = 13;

/// Interval of time that a machine passes with error control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Passage {
    /// Length of the interval (s).
    pub(super) time: f64,
    /// Error that a step may have: absolute in m, rad, m/s and rad/s, and relative.
    pub(super) tolerance: f64,
    /// Wrenches in addition to that of the state at both ends, linear between them (world axes, moment about the
    /// platform origin; N, N·m).
    pub(super) wrenches: [Wrench; 2],
}

impl Plant {
    /// Advances a state with error control and passes it to `look` after every step but the last; returns the number of
    /// steps. Ideal winches approach the commanded lengths at a constant rate, as in [`Plant::step`].
    ///
    /// Forces must not jump, as they do with dry friction of drums; memories of cables change only at the end. After an
    /// error the state is unchanged.
    pub(super) fn advance(
        &self,
        state: &mut PlantState,
        commands: &[Command],
        passage: &Passage,
        look: &mut dyn FnMut(&PlantState),
    ) -> Result<u64, StepError> {
        self.check_commands(&state.cables, commands)?;
        let before = state.clone();
        let taken = self.pass(state, commands, passage, look);
        if taken.is_err() {
            *state = before;
        }
        taken
    }

    fn pass(
        &self,
        state: &mut PlantState,
        commands: &[Command],
        passage: &Passage,
        look: &mut dyn FnMut(&PlantState),
    ) -> Result<u64, StepError> {
        self.prepare(state, commands, passage.time)?;
        for (cable, command) in state.cables.iter_mut().zip(commands) {
            let is_braked = matches!(command, Command::Length(_));
            cable.is_stuck = !self.drums.is_empty() && (is_braked || cable.is_stopped);
        }
        let lengths = state.cables.iter().map(|cable| cable.controlled_length).collect();
        let work = RefCell::new(Work { state: state.clone(), error: None });
        let equations = Equations { plant: self, commands, passage, lengths, work };
        let start = numbers(self, state);
        equations.check(&start)?;
        let tolerance = passage.tolerance;
        let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(STEPS);
        let solved = IVP::ode(&equations, 0.0, passage.time, start).method(method).solve();
        let ended = solved.ok().and_then(|mut solution| Some((solution.y.pop()?, solution)));
        let Some((last, solution)) = ended else {
            // a cable without a path ends the motion, unless smaller steps lead past that pose
            return Err(equations.work.into_inner().error.unwrap_or(StepError::Tolerance { tolerance }));
        };
        let between = solution.t.iter().copied().zip(&solution.y).filter(|(time, _)| *time > 0.0);
        equations.show(between, look)?;
        equations.place(state, passage.time, &last)?;
        self.finish(state);
        state.time += passage.time;
        match state.is_finite() {
            true => self.observe(state).map(|()| solution.steps.accepted as u64),
            false => Err(StepError::Overflow),
        }
    }
}

/// Numbers of a state: position, quaternion, linear and angular momentum per mass, then angle and speed of every drum.
fn numbers(plant: &Plant, state: &PlantState) -> Vec<f64> {
    let mass = state.inertia.body.mass;
    let mut numbers = state.pose.numbers().to_vec();
    numbers.extend(state.momentum.linear.iter().chain(&state.momentum.angular).map(|part| part / mass));
    let drums = state.cables.iter().take(plant.drums.len());
    numbers.extend(drums.flat_map(|cable| [cable.drum_angle, cable.drum_speed]));
    numbers
}

/// Equations of motion, with a state as work memory.
struct Equations<'a> {
    plant: &'a Plant,
    commands: &'a [Command],
    passage: &'a Passage,
    /// Controlled lengths at the start (m).
    lengths: Vec<f64>,
    work: RefCell<Work>,
}

struct Work {
    state: PlantState,
    /// The first error in the evaluation of forces.
    error: Option<StepError>,
}

impl Equations<'_> {
    /// Checks that the rates at the start are finite: the library would search for a step forever.
    fn check(&self, start: &[f64]) -> Result<(), StepError> {
        let mut rates = vec![0.0; start.len()];
        self.rates(&mut self.work.borrow_mut().state, 0.0, start, &mut rates)?;
        if rates.iter().all(|rate| rate.is_finite()) { Ok(()) } else { Err(StepError::Overflow) }
    }

    /// Passes the machine at times of the passage to `look`.
    fn show<'n>(
        &self,
        times: impl Iterator<Item = (f64, &'n Vec<f64>)>,
        look: &mut dyn FnMut(&PlantState),
    ) -> Result<(), StepError> {
        let state = &mut self.work.borrow_mut().state;
        let start = state.time;
        for (time, numbers) in times {
            self.place(state, time, numbers)?;
            self.plant.observe(state)?;
            state.time = start + time;
            look(state);
        }
        Ok(())
    }

    /// Sets a state to a time of the passage.
    fn place(&self, state: &mut PlantState, time: f64, numbers: &[f64]) -> Result<(), StepError> {
        let vector = |first: usize| Vector3::new(numbers[first], numbers[first + 1], numbers[first + 2]);
        let pose = Pose::from_numbers(std::array::from_fn(|k| numbers[k]));
        // the integrator keeps the quaternion's norm only to the tolerance
        state.pose = Pose { rotation: UnitQuaternion::new_normalize(*pose.rotation.quaternion()), ..pose };
        let mass = state.inertia.body.mass;
        state.momentum = Momentum { linear: vector(7) * mass, angular: vector(10) * mass };
        state.pulls.is_current = false;
        for (index, cable) in state.cables.iter_mut().enumerate() {
            if self.plant.drums.is_empty() {
                cable.controlled_length = self.lengths[index] + cable.controlled_length_rate * time;
            } else if !cable.is_stuck {
                let drum = PLATFORM + 2 * index;
                (cable.drum_angle, cable.drum_speed) = (numbers[drum], numbers[drum + 1]);
                let (length, radius) = self.plant.drum_length(index, cable.drum_angle)?;
                (cable.controlled_length, cable.controlled_length_rate) = (length, radius * cable.drum_speed);
            }
        }
        Ok(())
    }

    fn rates(&self, state: &mut PlantState, time: f64, numbers: &[f64], rates: &mut [f64]) -> Result<(), StepError> {
        let plant = self.plant;
        self.place(state, time, numbers)?;
        state.pulls.find(plant, &state.pose, &mut state.cables)?;
        let twist = state.twist();
        let cables = match (plant.drums.is_empty(), plant.dissipates) {
            (false, _) => plant.driven(state, self.commands, &twist)?,
            (true, true) => state.pulls.wrench(&twist, |cable| state.cables[cable].controlled_length_rate),
            (true, false) => state.pulls.wrench_at_rest(),
        };
        let [from, to] = self.passage.wrenches;
        let further = from + (to - from) * (time / self.passage.time) + state.inertia.drag(&twist);
        let (inertia, mass) = (&state.inertia, state.inertia.body.mass);
        let rate = inertia.rate(&inertia.center(&state.pose), &(cables + state.load(plant) + further));
        // q̇ = ½ (0, ω) q
        let omega = Quaternion::from_imag(twist.fixed_rows::<3>(3).into_owned());
        let turn = omega * state.pose.rotation.quaternion() * 0.5;
        let moving = twist.iter().take(3).chain(turn.coords.iter()).copied();
        let driven = rate.linear.iter().chain(&rate.angular).map(|part| part / mass);
        let drums = state.cables.iter().zip(&state.pulls.drums);
        let drums = drums.flat_map(|(cable, work)| [cable.drum_speed, work.acceleration]);
        rates.iter_mut().zip(moving.chain(driven).chain(drums)).for_each(|(rate, value)| *rate = value);
        Ok(())
    }
}

impl ODE<f64, Vec<f64>> for Equations<'_> {
    fn diff(&self, time: f64, numbers: &Vec<f64>, rates: &mut Vec<f64>) {
        let work = &mut *self.work.borrow_mut();
        if let Err(error) = self.rates(&mut work.state, time, numbers, rates) {
            // NaN has no error small enough: the integrator tries the step again at half its length and less
            rates.fill(f64::NAN);
            work.error.get_or_insert(error);
        }
    }
}
