//! Kinematic forward problem: the pose whose cable lengths fit given ones best (eq. 2.10–2.15).
//!
//! min over x of ½ ‖q(x) − q_θ‖², by a damped Gauss–Newton iteration on the manifold of poses. With more cables than
//! degrees of freedom (m > n) there is no exact solution in general and the least-squares pose is the answer; with m =
//! n only a pose with zero residual is; with m < n lengths do not determine the pose.
//!
//! The answer is the pose to which the descent from the guess leads: lengths have errors, so that a residual alone is
//! no reason to prefer a pose elsewhere that happens to fit better. `Solver::alternative` returns such a pose. Only if
//! the descent from the guess ends without an answer, the search starts again from other poses.

mod alternative;
pub mod batch;
mod curvature;
mod descent;
mod settings;
#[cfg(test)]
mod tests;
mod verdict;

pub use super::{Solution, Status};
pub use alternative::Alternative;
use descent::{Problem, Residuals};
pub use settings::Settings;
use thiserror::Error;

use super::restarts::restart_poses;
use crate::geometry::Pose;
use crate::model::Model;
use crate::scalar::LANES;
use crate::solve::not_positive;

/// Input that no forward problem can accept.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum InputError {
    /// Not one length per cable.
    #[error("expected {expected} cable lengths, one per cable, got {found}")]
    LengthCount {
        /// Number of cables.
        expected: usize,
        /// Number of lengths.
        found: usize,
    },
    /// A length that is not finite or not positive.
    #[error("cable {cable}: a length must be a finite number above 0 m, got {length}")]
    Length {
        /// Number of the cable, from 1.
        cable: usize,
        /// The length given (m).
        length: f64,
    },
    /// Not one guess per set of lengths.
    #[error("expected {expected} guesses, one per set of lengths, got {found}")]
    GuessCount {
        /// Sets of lengths.
        expected: usize,
        /// Guesses.
        found: usize,
    },
    /// A guess with NaN or infinity in it.
    #[error("the guess of the pose contains a number that is not finite")]
    Guess,
    /// A tolerance that is not above 0.
    #[error("the setting `{name}` is {value}; it must be a number above 0")]
    Setting {
        /// Field of [`Settings`].
        name: &'static str,
        /// Its value.
        value: f64,
    },
}

impl Settings {
    /// Refuses tolerances that are not positive numbers.
    pub(crate) fn validate(&self) -> Result<(), InputError> {
        let refused = not_positive([
            ("pose_tolerance", self.pose_tolerance),
            ("length_tolerance", self.length_tolerance),
            ("suspicious_residual", self.suspicious_residual),
            ("plausible_residual", self.plausible_residual),
        ]);
        refused.map_or(Ok(()), |(name, value)| Err(InputError::Setting { name, value }))
    }
}

/// Finds the pose for controlled lengths q_θ (m, one per cable) from a guess.
///
/// Lengths are those of the model, without the recorded scale and offset ([`Model::controlled_length`] removes them).
/// Coordinates outside the motion pattern keep the guess's value.
///
/// Many poses of one model are faster with one [`Solver`].
pub fn solve(model: &Model, lengths: &[f64], guess: &Pose, settings: &Settings) -> Result<Solution, InputError> {
    let mut solver = Solver::new(model, settings)?;
    solver.solve(lengths, guess)?;
    Ok(solver.scratch.solution)
}

/// A solver for many poses of one model: its memory is claimed once and reused.
#[derive(Clone, Debug)]
pub struct Solver<'a> {
    model: &'a Model,
    settings: Settings,
    platform_radius: f64,
    mean_length: f64,
    scratch: Scratch,
}

/// Memory of a [`Solver`] without its model.
#[derive(Clone, Debug)]
pub(super) struct Scratch {
    /// Given lengths, packed like the model's groups.
    targets: Vec<[f64; LANES]>,
    residuals: Residuals,
    /// Lengths of one problem of a batch (m).
    lengths: Vec<f64>,
    pub(super) solution: Solution,
}

impl Scratch {
    pub(super) fn new(model: &Model) -> Self {
        let room = vec![[0.0; LANES]; model.groups().len()];
        Self {
            targets: room.clone(),
            residuals: Residuals { accepted: room.clone(), trial: room },
            lengths: vec![f64::NAN; model.cable_count()],
            solution: Solution::unsolved(model.cable_count(), 0),
        }
    }

    /// True if the memory fits the cables of a model.
    pub(super) fn fits(&self, model: &Model) -> bool {
        self.lengths.len() == model.cable_count()
    }
}

impl<'a> Solver<'a> {
    /// A solver for this model.
    pub fn new(model: &'a Model, settings: &Settings) -> Result<Self, InputError> {
        Self::with(model, settings, Scratch::new(model))
    }

    /// [`Solver::new`] with the memory of an earlier solver, which fits the model.
    pub(super) fn with(model: &'a Model, settings: &Settings, scratch: Scratch) -> Result<Self, InputError> {
        settings.validate()?;
        let platform_radius = model.platform_radius();
        Ok(Self { model, settings: settings.clone(), platform_radius, mean_length: f64::NAN, scratch })
    }

    /// Returns the memory, with the last solution in it.
    pub(super) fn into_scratch(self) -> Scratch {
        self.scratch
    }

    /// Finds one pose as [`solve`] does; allocates nothing except for a reason in words.
    pub fn solve(&mut self, lengths: &[f64], guess: &Pose) -> Result<&Solution, InputError> {
        check_input(self.model, lengths, guess)?;
        let Scratch { targets, residuals, solution, .. } = &mut self.scratch;
        if self.model.cable_count() < self.model.dof() {
            *solution = underdetermined(self.model, lengths, guess);
            return Ok(solution);
        }
        for (target, chunk) in targets.iter_mut().zip(lengths.chunks(LANES)) {
            for lane in 0..LANES {
                target[lane] = chunk[lane.min(chunk.len() - 1)];
            }
        }
        self.mean_length = lengths.iter().sum::<f64>() / lengths.len() as f64;
        let problem = Problem {
            model: self.model,
            settings: &self.settings,
            targets,
            mean_length: self.mean_length,
            platform_radius: self.platform_radius,
        };
        search(&problem, guess, residuals, solution);
        Ok(solution)
    }
}

/// Descends from the guess, and from other starts if that gives no answer.
fn search(problem: &Problem<'_>, guess: &Pose, residuals: &mut Residuals, solution: &mut Solution) {
    let mut best = problem.descend(guess, residuals);
    residuals.unpack(&mut solution.residuals);
    (solution.iterations, solution.restarts) = (best.iterations, 0);
    if !problem.is_answer(&best) {
        for start in restart_poses(problem.model, guess).take(problem.settings.max_restarts as usize) {
            let other = problem.descend(&start, residuals);
            solution.iterations += other.iterations;
            solution.restarts += 1;
            if other.rms < best.rms || (best.rms.is_nan() && other.rms.is_finite()) {
                best = other;
                residuals.unpack(&mut solution.residuals);
            }
            if problem.is_good(&best) {
                break;
            }
        }
    }
    (solution.pose, solution.residual_rms) = (best.pose, best.rms);
    (solution.status, solution.reason) = problem.judge(&best, solution.restarts);
}

pub(super) fn check_input(model: &Model, lengths: &[f64], guess: &Pose) -> Result<(), InputError> {
    let (expected, found) = (model.cable_count(), lengths.len());
    if expected != found {
        return Err(InputError::LengthCount { expected, found });
    }
    for (index, &length) in lengths.iter().enumerate() {
        if !(length > 0.0 && length.is_finite()) {
            return Err(InputError::Length { cable: index + 1, length });
        }
    }
    if guess.is_finite() { Ok(()) } else { Err(InputError::Guess) }
}

fn underdetermined(model: &Model, lengths: &[f64], guess: &Pose) -> Solution {
    // modelled minus given; NaN for a cable without a path
    let residual =
        |(cable, length): (usize, &f64)| model.path(cable, guess).map_or(f64::NAN, |(c, _)| c.length - length);
    let residuals: Vec<f64> = lengths.iter().enumerate().map(residual).collect();
    let reason = format!(
        "{} cables cannot determine {} degrees of freedom by their lengths alone; the pose also depends on the load",
        model.cable_count(),
        model.dof()
    );
    Solution {
        pose: *guess,
        status: Status::Singular,
        residual_rms: (residuals.iter().map(|x| x * x).sum::<f64>() / residuals.len() as f64).sqrt(),
        residuals,
        reason: Some(reason),
        ..Solution::unsolved(0, 0)
    }
}
