//! Motion by a library's integrator with error control: the reference of the symplectic step, and free runs.
//!
//! Dormand and Prince's rule of order eight (crate `differential-equations`, decision 0042) on position, quaternion,
//! momentum per mass, and the angles and speeds of the drums, with the forces of [`Plant::step`]. It begins anew where a drum with dry friction
//! switches: begins to turn, turns round or comes to rest.

use std::cell::RefCell;

use differential_equations::prelude::{ControlFlag, ExplicitRungeKutta, IVP, Interpolation, ODE, Solout, Solution};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::command::Command;
use super::cuts::crossing;
use super::error::StepError;
use super::momentum::Momentum;
use super::plant::Plant;
use super::state::PlantState;
use cdpr_model::geometry::{Pose, Wrench};

/// Most steps of a passage, about a second of work.
const STEPS: usize = 100_000;

/// Longest step where drums have dry friction (s): none sticks and slides within one unseen.
const LONGEST: f64 = 1e-3;

/// Accuracy of the time of a switch, as a fraction of the step in which it lies.
const SWITCH: f64 = 1e-10;

/// Most evaluations for the time of a switch.
const LOOKS: usize = 60;

/// Most switches of a passage, a minute of a machine that chatters.
const SWITCHES: usize = 10_000;

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
    /// Memories of cables change only at the end. After an error the state is unchanged.
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
        let lengths = state.cables.iter().map(|cable| cable.controlled_length).collect();
        let work = RefCell::new(Work { state: state.clone(), error: None });
        let equations = Equations { plant: self, passage, lengths, work };
        let (mut start, mut steps) = ((0.0, numbers(self, state)), 0);
        equations.check(&start.1)?;
        for _ in 0..SWITCHES {
            let Some(solution) = equations.solve(&start, passage.time) else { break };
            steps += solution.steps.accepted as u64;
            let switch = equations.first_switch(&solution)?;
            let end = switch.as_ref().map_or(passage.time, |switch| switch.0);
            let between = solution.t.iter().copied().zip(&solution.y);
            equations.show(between.filter(|(time, _)| *time > start.0 && *time < end), look)?;
            if let Some((time, numbers, drum)) = switch {
                start = (time, equations.switch(&numbers, time, drum)?);
                continue;
            }
            let Some(last) = solution.y.last() else { break };
            equations.place(&mut equations.work.borrow_mut().state, passage.time, last)?;
            let time = state.time;
            *state = equations.work.into_inner().state;
            self.finish(state);
            state.time = time + passage.time;
            return match state.is_finite() {
                true => self.observe(state).map(|()| steps),
                false => Err(StepError::Overflow),
            };
        }
        // a cable without a path ends the motion, unless smaller steps lead past that pose
        Err(equations.work.into_inner().error.unwrap_or(StepError::Tolerance { tolerance: passage.tolerance }))
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

    /// Steps from a time and numbers to a time, or to the end of the first one that leads past a switch; `None` if the tolerance is out of reach.
    fn solve(&self, (from, numbers): &(f64, Vec<f64>), until: f64) -> Option<Solution<f64, Vec<f64>>> {
        let tolerance = self.passage.tolerance;
        let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(STEPS);
        let method = if self.work.borrow().state.pulls.is_dry { method.h_max(LONGEST) } else { method };
        let steps =
            IVP::ode(self, *from, until, numbers.clone()).method(method).solout(UntilSwitch { equations: self });
        steps.solve().ok()
    }

    /// The first drum that switches in the last step of a solution, with time and numbers there; `None` if none does.
    fn first_switch(&self, solution: &Solution<f64, Vec<f64>>) -> Result<Option<(f64, Vec<f64>, usize)>, StepError> {
        let count = solution.t.len();
        if !self.work.borrow().state.pulls.is_dry || count < 2 {
            return Ok(None);
        }
        let before = (solution.t[count - 2], &solution.y[count - 2]);
        let (mut after, mut found) = ((solution.t[count - 1], solution.y[count - 1].clone()), None);
        let begin = self.margins(before.1)?;
        loop {
            let ends = self.margins(&after.1)?;
            let place = |drum: &usize| (begin[*drum] / (begin[*drum] - ends[*drum])).max(0.0);
            let used = (0..ends.len()).filter(|drum| ends[*drum] < 0.0 && Some(*drum) != found);
            let Some(drum) = used.min_by(|a, b| place(a).total_cmp(&place(b))) else { break };
            // what switches at the same time is found at the start of the next steps
            if found.is_some() && place(&drum) > 1.0 - SWITCH {
                break;
            }
            after = self.time_of_switch(before, (begin[drum], ends[drum]), after.0, drum)?;
            found = Some(drum);
        }
        Ok(found.map(|drum| (after.0, after.1, drum)))
    }

    /// Time and numbers at which the margin of a drum is used up, between those of a time before and a time after.
    fn time_of_switch(
        &self,
        start: (f64, &Vec<f64>),
        (begin, end): (f64, f64),
        until: f64,
        drum: usize,
    ) -> Result<(f64, Vec<f64>), StepError> {
        let (mut before, mut after) = ((0.0, begin), (1.0, end));
        let straight = |before: (f64, f64), after: (f64, f64)| match before.1 > 0.0 {
            true => before.0 + (after.0 - before.0) * before.1 / (before.1 - after.1),
            // a drum that begins at its limit has margin a little later
            false => 0.25 * after.0,
        };
        let mut fraction = straight(before, after);
        for _ in 0..LOOKS {
            if !(fraction > 1e-3 * SWITCH) {
                break;
            }
            let time = start.0 + fraction * (until - start.0);
            let Some(numbers) = self.through(start, time) else { break };
            let (found, is_between) = ((fraction, self.margins(&numbers)?[drum]), before.1 > 0.0);
            let bent = if is_between { crossing(before, found, after) } else { f64::INFINITY };
            if found.1 == 0.0 || (bent - fraction).abs() < SWITCH {
                return Ok((time, numbers));
            }
            match found.1 > 0.0 {
                true => before = found,
                false => after = found,
            }
            fraction = if is_between { bent } else { straight(before, after) };
        }
        Ok((start.0, start.1.clone()))
    }

    /// Numbers at a time, from those at an earlier one, whatever switches between; `None` if the tolerance is out of reach.
    fn through(&self, (from, numbers): (f64, &Vec<f64>), until: f64) -> Option<Vec<f64>> {
        let tolerance = self.passage.tolerance;
        let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(STEPS);
        let mut solution = IVP::ode(self, from, until, numbers.clone()).method(method).solve().ok()?;
        solution.y.pop()
    }

    /// Margins of the drums.
    fn margins(&self, numbers: &[f64]) -> Result<Vec<f64>, StepError> {
        let state = &mut self.work.borrow_mut().state;
        self.look(state, 0.0, numbers)?;
        let twist = state.twist();
        Ok((0..self.plant.drums.len()).map(|drum| self.plant.margin(state, drum, &twist)).collect())
    }

    /// Sets a state to a time of the passage and computes its pulls.
    fn look(&self, state: &mut PlantState, time: f64, numbers: &[f64]) -> Result<(), StepError> {
        self.place(state, time, numbers)?;
        state.pulls.find(self.plant, &state.pose, &mut state.cables)?;
        self.plant.look_at_drums(state)
    }

    /// Numbers after a drum switched, with all others whose margin is used up.
    fn switch(&self, numbers_there: &[f64], time: f64, drum: usize) -> Result<Vec<f64>, StepError> {
        let state = &mut self.work.borrow_mut().state;
        self.look(state, time, numbers_there)?;
        self.plant.switch(state, drum);
        self.plant.switch_what_is_used_up(state);
        Ok(numbers(self.plant, state))
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
            (false, _) => plant.driven(state, &twist)?,
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

/// Ends the steps where the margin of a drum is used up.
struct UntilSwitch<'a, 'b> {
    equations: &'a Equations<'b>,
}

impl Solout<f64, Vec<f64>> for UntilSwitch<'_, '_> {
    fn solout<I>(
        &mut self,
        time: f64,
        _: f64,
        numbers: &Vec<f64>,
        _: &Vec<f64>,
        _: &mut I,
        solution: &mut Solution<f64, Vec<f64>>,
    ) -> ControlFlag<f64, Vec<f64>>
    where
        I: Interpolation<f64, Vec<f64>> + ?Sized,
    {
        solution.push(time, numbers.clone());
        let is_dry = self.equations.work.borrow().state.pulls.is_dry;
        let is_used_up =
            || self.equations.margins(numbers).is_ok_and(|margins| margins.iter().any(|margin| *margin < 0.0));
        if is_dry && is_used_up() { ControlFlag::Terminate } else { ControlFlag::Continue }
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
