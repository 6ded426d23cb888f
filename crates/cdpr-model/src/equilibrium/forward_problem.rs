//! Forward problem of a model: the choice between its two solvers, and the functions through which both are called.
//!
//! Elastic cables, and fewer rigid ones than degrees of freedom under a known load, rest where cables and load are in
//! equilibrium ([`elastostatics`]). Otherwise rigid cables fit their lengths as well as possible
//! ([`forward_kinematics`]); with fewer cables than degrees of freedom that determines no pose.

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
    /// The pose with the best fit of the lengths, for any load.
    LeastSquares,
    /// Pose and tensions in equilibrium with the load.
    Equilibrium,
}

impl ForwardProblem {
    /// Forward problem of a model with a known or unknown load.
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
    /// Settings of [`ForwardProblem::LeastSquares`].
    pub least_squares: forward_kinematics::Settings,
    /// Settings of [`ForwardProblem::Equilibrium`].
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
    /// Invalid lengths, guess or settings, or cables whose tensions do not follow from lengths.
    #[error(transparent)]
    Input(#[from] elastostatics::InputError),
}

impl Model {
    /// Finds pose and tensions for controlled lengths q_θ (m, one per cable), starting from a guess.
    ///
    /// The model decides the problem ([`ForwardProblem::of`]). The answer is the solution to which the guess leads;
    /// coordinates outside the motion pattern keep the guess's value. `None` as load takes that of the robot's file;
    /// `None` as guess starts at the home pose, see [`State::start`]. Cables start from the memories of the state,
    /// which do not change.
    ///
    /// Allocates nothing once the state has solved a problem of the model, except for a reason in words.
    pub fn forward<'s>(
        &self,
        lengths: &[f64],
        load: Option<&Load>,
        guess: Option<&Pose>,
        state: &'s mut State,
    ) -> Result<&'s Solution, ForwardError> {
        self.forward_with(&ForwardSettings::default(), lengths, load, guess, state)
    }

    /// [`Model::forward`] with the given settings.
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

    /// A pose that fits the lengths better than the answer to which the guess leads, if the residual of that answer is
    /// larger than errors of measurement explain; `None` if there is none, and for equilibria.
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

    /// [`Model::forward_with`] for many controlled lengths at once (m; a row per cable), each from its own guess and
    /// with the same bits as the single problem. With `only_taut` only equilibria in which every cable pulls are
    /// sought.
    ///
    /// This search ends with [`Status::NotConverged`](super::Status) if a cable pushes in the equilibrium of bars, ten
    /// times sooner than the search for slack cables.
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

    /// True if [`Model::forward_batch`] solves many problems side by side: straight cables, rigid or linear, and no
    /// fewer than degrees of freedom. Others are solved one by one.
    pub fn has_forward_batch(&self) -> bool {
        matches!(self.cables(), Cables::Rigid | Cables::Linear) && self.cable_count() >= self.dof()
    }

    /// Forward problem of the model under a load (`None`: that of the robot's file), or the reason that it cannot be
    /// posed.
    pub fn forward_problem(&self, load: Option<&Load>, state: &mut State) -> Result<ForwardProblem, ForwardError> {
        state.solve(self, &ForwardSettings::default(), load, |solver| {
            Ok(match solver {
                ForwardSolver::LeastSquares(_) => ForwardProblem::LeastSquares,
                ForwardSolver::Equilibrium(_) => ForwardProblem::Equilibrium,
            })
        })
    }
}

/// Solver of either problem.
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
    /// Runs `work` on a solver in the memory of the state, with cables that start from its memories.
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
            // too few rigid cables with an unknown load fit their lengths, which determine no pose
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

    /// Adds the missing load to the reason, for a platform on too few rigid cables: its pose depends on the load.
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
