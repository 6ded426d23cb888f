//! Forward problem of a model: one rule and one door for everything that asks where a platform goes.
//!
//! Elastic cables, and fewer rigid ones than degrees of freedom under a known load, rest where cables and load are in
//! equilibrium ([`elastostatics`]). Rigid cables otherwise fit their lengths as well as possible ([`forward_kinematics`]);
//! with fewer cables than degrees of freedom that determines no pose.

use thiserror::Error;

use super::forward_kinematics::Alternative;
use super::scratch::Scratch;
use super::start::Start;
use super::{Solution, Solutions, State, elastostatics, forward_kinematics};
use crate::geometry::{Pose, PoseBatch};
use crate::model::{Cables, Model};
use crate::scalar::LaneTable;
use crate::statics::{Load, LoadError};

/// Forward problem of a composition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForwardProblem {
    /// The pose whose lengths fit best, whatever the load.
    LeastSquares,
    /// Pose and tensions in equilibrium with the load.
    Equilibrium,
}

impl ForwardProblem {
    /// Forward problem of a model whose load is known or not.
    pub fn of(model: &Model, is_load_known: bool) -> Self {
        let is_underactuated = model.cable_count() < model.dof();
        match model.cables() {
            Cables::Rigid if !(is_underactuated && is_load_known) => Self::LeastSquares,
            _ => Self::Equilibrium,
        }
    }
}

/// Settings of both forward problems.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForwardSettings {
    /// Of [`ForwardProblem::LeastSquares`].
    pub least_squares: forward_kinematics::Settings,
    /// Of [`ForwardProblem::Equilibrium`].
    pub equilibrium: elastostatics::Settings,
}

/// Many forward problems of one model.
#[derive(Clone, Copy, Debug)]
pub struct ForwardBatch<'a> {
    /// Controlled lengths (m), a row per cable.
    pub lengths: &'a LaneTable,
    /// The pose from which each problem is sought.
    pub guesses: &'a PoseBatch,
    /// The load on the platform; `None`: that of the robot's file.
    pub load: Option<&'a Load>,
    /// Only equilibria in which every cable pulls.
    pub only_taut: bool,
}

/// Input that no forward problem of a model can accept.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ForwardError {
    /// The load on cables whose lengths depend on their tensions is unknown.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// Lengths, guess or settings, or cables whose tensions do not follow from lengths.
    #[error(transparent)]
    Input(#[from] elastostatics::InputError),
}

impl Model {
    /// Pose and tensions that belong to controlled lengths q_θ (m, one per cable), sought from a guess.
    ///
    /// The model decides the problem ([`ForwardProblem::of`]); the answer is the solution to which the guess leads, and the motion pattern
    /// holds: what it cannot move keeps the guess's value. Without a load it is that of the robot's file; without a guess the search
    /// begins at the home pose, see [`State::start`]. Cables come from the memories of the state, which stay as they are.
    ///
    /// Allocates nothing once the state has solved a problem of the model, unless there is a reason to tell.
    pub fn forward<'s>(
        &self,
        lengths: &[f64],
        load: Option<&Load>,
        guess: Option<&Pose>,
        state: &'s mut State,
    ) -> Result<&'s Solution, ForwardError> {
        self.forward_with(&ForwardSettings::default(), lengths, load, guess, state)
    }

    /// [`Model::forward`] with settings of one's own.
    pub fn forward_with<'s>(
        &self,
        settings: &ForwardSettings,
        lengths: &[f64],
        load: Option<&Load>,
        guess: Option<&Pose>,
        state: &'s mut State,
    ) -> Result<&'s Solution, ForwardError> {
        let (start, pose) = Start::of(self.robot(), guess);
        state.start = start;
        state.solve(self, settings, load, |solver| match solver {
            ForwardSolver::LeastSquares(solver) => Ok(solver.solve(lengths, &pose).map(|_| ())?),
            ForwardSolver::Equilibrium(solver) => solver.solve(lengths, &pose).map(|_| ()),
        })?;
        state.tell_unknown_load(self);
        Ok(state.forward_solution().expect("a solved problem leaves its solution"))
    }

    /// The pose that fits lengths better than the answer that belongs to the guess does, where the residual of that answer is more than
    /// errors of measurement explain; `None` if there is none, and for equilibria.
    ///
    /// It takes as many descents as `max_restarts`, each as long as that of [`Model::forward`].
    pub fn forward_alternative(
        &self,
        settings: &ForwardSettings,
        lengths: &[f64],
        guess: Option<&Pose>,
        state: &mut State,
    ) -> Result<Option<Alternative>, ForwardError> {
        let (_, pose) = Start::of(self.robot(), guess);
        state.solve(self, settings, None, |solver| match solver {
            ForwardSolver::LeastSquares(solver) => {
                solver.solve(lengths, &pose)?;
                Ok(solver.alternative())
            }
            ForwardSolver::Equilibrium(_) => Ok(None),
        })
    }

    /// [`Model::forward_with`] for many problems at once, with the bits of the single one.
    ///
    /// The search for taut cables ends with [`Status::NotConverged`](super::Status) where the equilibrium of bars has one that pushes, ten times
    /// sooner than the search for the cables that hang slack.
    pub fn forward_batch(
        &self,
        settings: &ForwardSettings,
        problems: &ForwardBatch<'_>,
        state: &mut State,
        solutions: &mut Solutions,
    ) -> Result<(), ForwardError> {
        let ForwardBatch { lengths, guesses, load, only_taut } = *problems;
        state.solve(self, settings, load, |solver| match solver {
            ForwardSolver::LeastSquares(solver) => Ok(solver.solve_batch(lengths, guesses, solutions)?),
            ForwardSolver::Equilibrium(solver) if only_taut => solver.solve_taut_batch(lengths, guesses, solutions),
            ForwardSolver::Equilibrium(solver) => solver.solve_batch(lengths, guesses, solutions),
        })
    }

    /// True where [`Model::forward_batch`] solves many problems side by side: of straight, linear or rigid cables, no fewer than degrees of
    /// freedom. Others are solved one by one.
    pub fn has_forward_batch(&self) -> bool {
        matches!(self.cables(), Cables::Rigid | Cables::Linear) && self.cable_count() >= self.dof()
    }

    /// Forward problem of the model under a load, that of the robot's file without one; or why it cannot be posed.
    pub fn forward_problem(&self, load: Option<&Load>, state: &mut State) -> Result<ForwardProblem, ForwardError> {
        state.solve(self, &ForwardSettings::default(), load, |solver| {
            Ok(match solver {
                ForwardSolver::LeastSquares(_) => ForwardProblem::LeastSquares,
                ForwardSolver::Equilibrium(_) => ForwardProblem::Equilibrium,
            })
        })
    }
}

/// Solver of one of the problems.
#[expect(
    clippy::large_enum_variant,
    reason = "it lives on the stack for one problem, and a box would be claimed for each"
)]
enum ForwardSolver<'a> {
    LeastSquares(forward_kinematics::Solver<'a>),
    Equilibrium(elastostatics::Solver<'a>),
}

impl ForwardSolver<'_> {
    fn into_scratch(self) -> Scratch {
        match self {
            Self::LeastSquares(solver) => Scratch::LeastSquares(solver.into_scratch()),
            Self::Equilibrium(solver) => Scratch::Equilibrium(solver.into_scratch()),
        }
    }
}

impl State {
    /// Solves in the memory of the state, with cables that come from its memories.
    fn solve<T>(
        &mut self,
        model: &Model,
        settings: &ForwardSettings,
        load: Option<&Load>,
        work: impl FnOnce(&mut ForwardSolver<'_>) -> Result<T, elastostatics::InputError>,
    ) -> Result<T, ForwardError> {
        let known_load = || load.map_or_else(|| Load::of(model.robot()), |load| Ok(*load));
        let load = match [false, true].map(|is_load_known| ForwardProblem::of(model, is_load_known)) {
            [_, ForwardProblem::LeastSquares] => None,
            [ForwardProblem::Equilibrium, _] => Some(known_load()?),
            // too few rigid cables of unknown load fit their lengths, which determine no pose
            [ForwardProblem::LeastSquares, ForwardProblem::Equilibrium] => known_load().ok(),
        };
        let mut solver = match load {
            Some(load) => {
                let scratch = match self.scratch.take() {
                    Some(Scratch::Equilibrium(scratch)) if scratch.fits(model) => scratch,
                    _ => elastostatics::Scratch::new(model),
                };
                let solver = elastostatics::Solver::with(model, &load, &settings.equilibrium, scratch)?;
                ForwardSolver::Equilibrium(solver.with_memories(self.memories()))
            }
            None => {
                let scratch = match self.scratch.take() {
                    Some(Scratch::LeastSquares(scratch)) if scratch.fits(model) => scratch,
                    _ => forward_kinematics::Scratch::new(model),
                };
                let solver = forward_kinematics::Solver::with(model, &settings.least_squares, scratch);
                ForwardSolver::LeastSquares(solver.map_err(elastostatics::InputError::from)?)
            }
        };
        let answer = work(&mut solver);
        self.scratch = Some(solver.into_scratch());
        Ok(answer?)
    }

    /// Says of a platform on too few rigid cables, which has a pose under its load, what is missing for it.
    fn tell_unknown_load(&mut self, model: &Model) {
        let Some(Scratch::LeastSquares(scratch)) = &mut self.scratch else { return };
        if model.cable_count() >= model.dof() {
            return;
        }
        if let (Some(reason), Err(unknown)) = (&mut scratch.solution.reason, Load::of(model.robot())) {
            *reason = format!("{reason}; {unknown}");
        }
    }
}
