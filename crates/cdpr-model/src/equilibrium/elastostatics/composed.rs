//! The forward problem for cables of any effects: sagging, stiffening, with a memory.
//!
//! Each cable is solved for its controlled length at the pose, so that the residual wrench is a function of the pose.
//! Newton steps with the tangents ∂t/∂p_B of the cables, shortened until the residual falls, find its zero. The first
//! start is the guess; if it leads to no stable equilibrium, the next is that of straight linear cables. Sagging cables
//! that do not stretch start with a compliance that is reduced in stages, since too short ones have no shape, and start
//! again with a larger one if that fails.

use nalgebra::{Matrix6, Vector3, Vector6};

use super::straight_machine::{FIRST_COMPLIANCE, straight_model};
use super::verdict::INDIFFERENT;
use super::{InputError, Load, Model, Settings, Solution, Status};
use crate::cable::law::CableLaw;
use crate::cable::span::SpanState;
use crate::cable::stretch::Stretch;
use crate::cable::stretch::hysteresis::Memory;
use crate::cable::{CableInput, CableState, CableStateError};
use crate::geometry::{Pose, Twist};
use crate::model::{Cables, StretchEffect};
use crate::scalar::eigenvalue::smallest_eigenvalue_of;
use crate::solve::{self, Control, Rules, Step, StepRule, Stop, Trial, descend};
use crate::statics::{Stability, axial_stiffness, indifferent_stiffness};

/// Smallest compliance before zero in the search for cables that do not stretch (1/N).
const LAST_COMPLIANCE: f64 = 1e-14;
/// First compliance of a second search for them (1/N).
const SOFT_COMPLIANCE: f64 = 1e-5;
/// Longest step, relative to the mean cable length.
const LONGEST_STEP: f64 = 0.1;

/// Cables of any effects under a load.
#[derive(Clone, Debug)]
pub(super) struct Composed {
    laws: Vec<CableLaw>,
    states: Vec<Option<SpanState<f64>>>,
    trial_states: Vec<Option<SpanState<f64>>>,
    accepted: Vec<CableState>,
    trial: Vec<CableState>,
    /// True for sagging cables without any stretch.
    is_rigid: bool,
}

/// State of a search: pose with its residual wrench.
#[derive(Clone, Copy)]
struct Point {
    pose: Pose,
    /// Residual wrench in the pattern's rows, moments divided by the platform radius (N).
    residual: Vector6<f64>,
    size: f64,
}

/// Reason that a search ended without an equilibrium.
enum Failure {
    /// A cable has no shape at the start.
    Cable(usize, CableStateError),
    /// Forces are not finite.
    Overflow,
    /// No shortened step decreased the residual.
    Stalled,
    /// The limit of iterations was reached.
    Iterations,
}

/// Solver for straight elastic cables, near whose pose other cables are sought.
pub(super) type SolveStraight = fn(&Model, &[f64], &Load, &Pose, &Settings) -> Result<Solution, InputError>;

/// Model, load and settings of a forward problem.
pub(super) struct Question<'a> {
    pub(super) model: &'a Model,
    pub(super) load: &'a Load,
    pub(super) settings: &'a Settings,
    pub(super) solve_straight: SolveStraight,
}

/// Forward problem of one search: lengths (m), load, and scales of the residual (m).
struct Problem<'a> {
    model: &'a Model,
    load: &'a Load,
    settings: &'a Settings,
    solve_straight: SolveStraight,
    lengths: &'a [f64],
    radius: f64,
    mean_length: f64,
}

/// Balance of the cables, as a problem of the common descent loop.
struct Descent<'a, 'p> {
    cables: &'a mut Composed,
    problem: &'a Problem<'p>,
    start: Pose,
    /// Newton's step, rotations times the platform radius (m).
    step: Vector6<f64>,
    /// `None` before the start was evaluated.
    point: Option<Point>,
    /// `None` if a cable has no shape.
    trial: Option<Point>,
    failure: Option<Failure>,
}

impl solve::Problem for Descent<'_, '_> {
    type Number = f64;

    fn step(&mut self, _: &Control<f64>) -> Step<f64> {
        let found = self.point.as_ref().and_then(|point| self.cables.step(self.problem, point));
        let is_regular = found.is_some();
        let step = found.unwrap_or_else(Vector6::zeros);
        self.step = step * f64::min(1.0, LONGEST_STEP * self.problem.mean_length / step.norm());
        Step::whole(self.step.norm(), is_regular)
    }

    /// A step helps if it decreases the residual as much as Armijo (1966) requires, or if it is the last one.
    fn evaluate(&mut self, fraction: f64, is_last: bool) -> Trial<f64> {
        let pose = self
            .point
            .as_ref()
            .map_or(self.start, |point| self.problem.displaced(&point.pose, &(self.step * fraction)));
        self.cables.trial_states.copy_from_slice(&self.cables.states);
        match self.cables.try_at(self.problem, &pose) {
            Ok(trial) => self.trial = Some(trial),
            Err(failure) => (self.trial, self.failure) = (None, Some(failure)),
        }
        let most = self.point.as_ref().map_or(f64::INFINITY, |point| point.size * (1.0 - 1e-4 * fraction));
        let helps = self.trial.as_ref().is_some_and(|trial| is_last || trial.size < most);
        Trial::new(1.0, helps)
    }

    fn accept(&mut self, helps: bool, _: f64) {
        if helps {
            self.cables.accept();
            self.point = self.trial.take();
        }
    }

    /// True if the residual is rounding.
    fn rests(&mut self, size: f64, _: f64) -> bool {
        size <= 1e-9 * self.problem.mean_length.max(1.0)
    }
}

impl Composed {
    /// True for models that need this search.
    pub(super) fn serves(model: &Model) -> bool {
        matches!(model.cables(), Cables::Stretching | Cables::Sagging)
    }

    /// Memory for such a model; `None` for others.
    pub(super) fn new(model: &Model) -> Option<Self> {
        if !Self::serves(model) {
            return None;
        }
        let count = model.cable_count();
        Some(Self {
            laws: (0..count).map(|cable| model.law(cable).clone()).collect(),
            states: vec![None; count],
            trial_states: vec![None; count],
            accepted: Vec::with_capacity(count),
            trial: Vec::with_capacity(count),
            is_rigid: false,
        })
    }

    /// Takes the cables of a model, never loaded.
    pub(super) fn take_laws(&mut self, model: &Model) {
        self.laws.iter_mut().enumerate().for_each(|(cable, law)| law.clone_from(model.law(cable)));
        self.is_rigid = model.composition().stretch == StretchEffect::Rigid;
    }

    /// Sets the memories of the cables.
    pub(super) fn set_memories(&mut self, memories: &[Memory]) {
        for (law, memory) in self.laws.iter_mut().zip(memories) {
            law.stretch = law.stretch.with_memory(memory);
        }
    }

    /// Writes pose and tensions for controlled lengths (m).
    pub(super) fn solve(
        &mut self,
        question: Question<'_>,
        lengths: &[f64],
        guess: &Pose,
        solution: &mut Solution,
    ) -> Result<(), InputError> {
        let Question { model, load, settings, solve_straight } = question;
        let mean_length = lengths.iter().sum::<f64>() / lengths.len() as f64;
        let radius = model.platform_radius();
        let problem = Problem { model, load, settings, solve_straight, lengths, radius, mean_length };
        (solution.iterations, solution.restarts, solution.reason) = (0, 0, None);
        let (mut best, failure) = match self.search(&problem, guess, FIRST_COMPLIANCE, solution) {
            Ok(status) if status == Status::Converged || settings.max_restarts == 0 => return Ok(()),
            Ok(_) => (Some(solution.clone()), None),
            Err(failure) => (None, Some(failure)),
        };
        let straight = straight_pose(&problem, guess)?;
        let softer = self.is_rigid && settings.max_restarts > 0;
        let starts = [(&straight, FIRST_COMPLIANCE), (&straight, SOFT_COMPLIANCE), (guess, SOFT_COMPLIANCE)];
        for (start, softest) in starts.into_iter().take(if softer { 3 } else { 1 }) {
            solution.restarts += 1;
            match self.search(&problem, start, softest, solution) {
                Ok(Status::Converged) => return Ok(()),
                Ok(_) if best.is_none() => best = Some(solution.clone()),
                _ => {}
            }
        }
        let (iterations, restarts) = (solution.iterations, solution.restarts);
        if let Some(best) = best {
            *solution = Solution { iterations, restarts, ..best };
        } else if let Some(failure) = failure {
            self.give_up(&problem, guess, failure, solution);
        }
        Ok(())
    }

    /// Searches from one start and writes the solution.
    fn search(
        &mut self,
        problem: &Problem<'_>,
        start: &Pose,
        softest: f64,
        solution: &mut Solution,
    ) -> Result<Status, Failure> {
        self.states.fill(None);
        let mut pose = *start;
        if self.is_rigid {
            let mut compliance = softest;
            while compliance > LAST_COMPLIANCE {
                self.laws.iter_mut().for_each(|law| law.stretch = Stretch::Linear(compliance));
                let reached = self.newton(problem, &pose, &mut solution.iterations);
                self.laws.iter_mut().for_each(|law| law.stretch = Stretch::Rigid);
                pose = reached?.pose;
                compliance *= 0.1;
            }
        }
        let point = self.newton(problem, &pose, &mut solution.iterations)?;
        self.judge(problem, &point, solution);
        Ok(solution.status)
    }

    fn newton(&mut self, problem: &Problem<'_>, start: &Pose, iterations: &mut u32) -> Result<Point, Failure> {
        let rules = Rules {
            tolerance: problem.settings.pose_tolerance * problem.mean_length.max(1.0),
            max_iterations: problem.settings.max_iterations,
            least_gain: 0.0,
            rule: StepRule::Shortening,
        };
        let none = Vector6::zeros();
        let mut descent =
            Descent { cables: self, problem, start: *start, step: none, point: None, trial: None, failure: None };
        let end = descend(&mut descent, &rules);
        *iterations += end.iterations as u32;
        match (descent.point, end.stop()) {
            (Some(point), Stop::Stationary) => Ok(point),
            (_, Stop::IterationLimit) => Err(Failure::Iterations),
            (None, _) => Err(descent.failure.unwrap_or(Failure::Overflow)),
            _ => Err(Failure::Stalled),
        }
    }

    /// Evaluates all cables at a pose, into `trial`.
    fn try_at(&mut self, problem: &Problem<'_>, pose: &Pose) -> Result<Point, Failure> {
        self.trial.clear();
        let (mut wrench, rotation) = (problem.load.wrench(pose), pose.rotation_rows());
        for (cable, law) in self.laws.iter().enumerate() {
            let end = problem.model.cable_end(cable, pose.position.into(), &rotation);
            let input = CableInput::ControlledLength(problem.lengths[cable]);
            let state =
                law.state_from(end, input, self.trial_states[cable]).map_err(|error| Failure::Cable(cable, error))?;
            wrench += state.wrench();
            self.trial_states[cable] = Some(state.span);
            self.trial.push(state);
        }
        let residual = problem.scaled(&wrench);
        let size = residual.norm();
        if !size.is_finite() {
            return Err(Failure::Overflow);
        }
        Ok(Point { pose: *pose, residual, size })
    }

    fn accept(&mut self) {
        std::mem::swap(&mut self.accepted, &mut self.trial);
        std::mem::swap(&mut self.states, &mut self.trial_states);
    }

    /// K_wx of the accepted cables, rotations divided by the platform radius; the identity in rows without a motion.
    fn stiffness(&self, problem: &Problem<'_>, pose: &Pose) -> Matrix6<f64> {
        let whole = self.accepted.iter().fold(-problem.load.gradient(pose), |sum, cable| sum + cable.stiffness());
        let basis = problem.model.twist_basis();
        let mut scaled = Matrix6::identity();
        for (i, row) in basis.iter().enumerate() {
            for (j, column) in basis.iter().enumerate() {
                scaled[(i, j)] = row.dot(&(whole * column)) / (problem.unit(i) * problem.unit(j));
            }
        }
        scaled
    }

    /// Newton's step δx = K_wx⁻¹ (Aᵀf + w), rotations times the platform radius (m).
    fn step(&self, problem: &Problem<'_>, point: &Point) -> Option<Vector6<f64>> {
        let stiffness = self.stiffness(problem, &point.pose);
        let plain = stiffness.lu().solve(&point.residual).filter(|step| step.norm().is_finite());
        plain.or_else(|| {
            // singular directions get a small fraction of the largest stiffness
            let floor = 1e-9 * stiffness.diagonal().amax().max(1e-6);
            (stiffness + Matrix6::identity() * floor).lu().solve(&point.residual)
        })
    }

    fn judge(&self, problem: &Problem<'_>, point: &Point, solution: &mut Solution) {
        solution.pose = point.pose;
        solution.wrench_residual = point.size;
        solution.slack = 0;
        for (cable, state) in self.accepted.iter().enumerate() {
            solution.tensions[cable] = state.outlet_tension;
            solution.residuals[cable] = state.controlled_length - problem.lengths[cable];
            let weight = Vector3::from(self.laws[cable].weight).norm() * state.span.length;
            solution.slack += usize::from(state.platform_tension <= 0.5 * weight);
        }
        let stiffness = self.stiffness(problem, &point.pose);
        solution.stability = smallest(&((stiffness + stiffness.transpose()) * 0.5), problem.model.dof());
        let cables = self.accepted.iter().map(axial_stiffness).sum();
        let indifferent = indifferent_stiffness(cables, problem.load.force(), problem.mean_length);
        (solution.status, solution.reason) = match Stability::of(solution.stability, indifferent) {
            Stability::Stable => (Status::Converged, None),
            Stability::Unstable => {
                let reason = format!(
                    "forces balance, but the stiffness has the eigenvalue {:.3e} N/m: the platform would leave this pose at the \
                     smallest disturbance",
                    solution.stability
                );
                (Status::Unstable, Some(reason))
            }
            Stability::Indifferent => (Status::Singular, Some(INDIFFERENT.to_owned())),
        };
    }

    fn give_up(&mut self, problem: &Problem<'_>, guess: &Pose, failure: Failure, solution: &mut Solution) {
        solution.pose = *guess;
        solution.tensions.fill(f64::NAN);
        solution.residuals.fill(f64::NAN);
        (solution.stability, solution.wrench_residual, solution.slack) = (f64::NAN, f64::NAN, 0);
        solution.status = Status::NotConverged;
        solution.reason = Some(match failure {
            Failure::Cable(cable, error) => format!("cable {}: {error}", cable + 1),
            Failure::Overflow => "the forces at the start are not finite numbers; check units and magnitudes".to_owned(),
            Failure::Stalled => {
                "no shorter step brings forces nearer to balance, from the guess and from the equilibrium of straight cables; \
                 do lengths and load belong to this robot?"
                    .to_owned()
            }
            Failure::Iterations => format!("the limit of {} iterations was reached", problem.settings.max_iterations),
        });
    }
}

impl Problem<'_> {
    /// 1 for a translation, the platform radius for a rotation (m).
    fn unit(&self, entry: usize) -> f64 {
        if entry < self.model.axes().len() { 1.0 } else { self.radius }
    }

    fn scaled(&self, wrench: &Twist) -> Vector6<f64> {
        let mut scaled = Vector6::zeros();
        for (index, twist) in self.model.twist_basis().iter().enumerate() {
            scaled[index] = twist.dot(wrench) / self.unit(index);
        }
        scaled
    }

    fn displaced(&self, pose: &Pose, step: &Vector6<f64>) -> Pose {
        let mut twist = Twist::zeros();
        for (index, direction) in self.model.twist_basis().iter().enumerate() {
            twist += direction * (step[index] / self.unit(index));
        }
        pose.displaced(&twist)
    }
}

fn smallest(symmetric: &Matrix6<f64>, dof: usize) -> f64 {
    fn lower<const N: usize>(matrix: &Matrix6<f64>) -> f64 {
        smallest_eigenvalue_of(std::array::from_fn::<[f64; N], N, _>(|row| {
            std::array::from_fn(|column| matrix[(row, column)])
        }))
    }
    match dof {
        2 => lower::<2>(symmetric),
        3 => lower::<3>(symmetric),
        _ => lower::<6>(symmetric),
    }
}

/// Equilibrium pose of the [straight machine](straight_model); the guess if none is found.
fn straight_pose(problem: &Problem<'_>, guess: &Pose) -> Result<Pose, InputError> {
    let Some(model) = straight_model(problem.model) else { return Ok(*guess) };
    let solution = (problem.solve_straight)(&model, problem.lengths, problem.load, guess, problem.settings)?;
    match solution.status {
        Status::NotConverged => Ok(*guess),
        _ => Ok(solution.pose),
    }
}
