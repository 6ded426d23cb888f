//! Forward statics: the pose at which given tensions balance the load (sec. 2.1).
//!
//! Find x with Aᵀ(x) f + w(x) = 0 for constant tensions f, at any lengths: Newton steps on the residual wrench with the
//! stiffness −K_G − ∂w/∂x, damped until the residual falls. Weights over pulleys instead of winches act like this. The
//! pose need not be stable: tensions that do not change with motion hold a platform weakly or not at all.

use nalgebra::{DMatrix, DVector};
use thiserror::Error;

pub use super::Status;
use super::forward_kinematics::InputError as LengthError;
use super::pose_step::{Measure, displaced};
use super::restarts::restart_poses;
use crate::geometry::Pose;
use crate::model::Model;
use crate::scalar::decomposition::smallest_eigenvalue;
use crate::solve::{self, Control, Rules, Step, StepRule, Trial, descend, not_positive};
use crate::statics::{Load, Stability, StaticsError, geometric_stiffness, indifferent_stiffness, wrench_residual};

/// Settings of forward statics.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The search stops once a step is shorter than this (m, relative to the mean cable length; angles times the
    /// platform radius).
    pub pose_tolerance: f64,
    /// Residual wrench up to which tensions and load are in balance, relative to the sum of the tensions; moments
    /// divided by the platform radius.
    pub wrench_tolerance: f64,
    /// Steps allowed for each start.
    pub max_iterations: u32,
    /// Further starts allowed if the guess leads to no equilibrium.
    pub max_restarts: u32,
}

impl Default for Settings {
    fn default() -> Self {
        Self { pose_tolerance: 1e-11, wrench_tolerance: 1e-9, max_iterations: 200, max_restarts: 16 }
    }
}

/// Outcome of forward statics; `pose` is the best one found even when it did not converge.
#[must_use = "check `status` before using the pose"]
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Platform pose.
    pub pose: Pose,
    /// Why the search stopped.
    pub status: Status,
    /// Size of Aᵀ f + w, moments divided by the platform radius (N).
    pub wrench_residual: f64,
    /// Steps of all starts, accepted and rejected.
    pub iterations: u32,
    /// Starts tried beyond the guess.
    pub restarts: u32,
    /// Smallest eigenvalue of the symmetric part of −K_G − ∂w/∂x, rotations times the platform radius (N/m).
    pub stability: f64,
    /// The reason in words unless converged.
    pub reason: Option<String>,
}

/// Input that forward statics cannot accept.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum InputError {
    /// Invalid tensions, or a guess at which a cable has no path.
    #[error(transparent)]
    Statics(#[from] StaticsError),
    /// Invalid guess or settings.
    #[error(transparent)]
    Kinematic(#[from] LengthError),
}

/// Finds the pose at which tensions (N, one per cable) and load are in equilibrium, from a guess.
///
/// If there are several such poses, it is the one to which the steps from the guess lead.
pub fn solve(
    model: &Model,
    tensions: &[f64],
    load: &Load,
    guess: &Pose,
    settings: &Settings,
) -> Result<Solution, InputError> {
    settings.validate()?;
    if !guess.is_finite() {
        return Err(LengthError::Guess.into());
    }
    let problem = Problem::new(model, tensions, load, settings, guess)?;
    let mut best = problem.descend(problem.point(guess)?);
    let (mut iterations, mut restarts) = (best.iterations, 0);
    for start in restart_poses(model, guess).take(settings.max_restarts as usize) {
        if problem.is_balanced(&best.point) {
            break;
        }
        restarts += 1;
        let Ok(start) = problem.point(&start) else { continue };
        let other = problem.descend(start);
        iterations += other.iterations;
        if other.point.size < best.point.size {
            best = other;
        }
    }
    let stability = best.point.stability();
    let (status, reason) = problem.verdict(&best.point, stability, restarts);
    let Point { pose, size: wrench_residual, .. } = best.point;
    Ok(Solution { pose, status, wrench_residual, iterations, restarts, stability, reason })
}

impl Settings {
    /// Refuses tolerances that are not positive numbers.
    pub(crate) fn validate(&self) -> Result<(), InputError> {
        let refused =
            not_positive([("pose_tolerance", self.pose_tolerance), ("wrench_tolerance", self.wrench_tolerance)]);
        refused.map_or(Ok(()), |(name, value)| Err(LengthError::Setting { name, value }.into()))
    }
}

/// Tensions and load on a model.
struct Problem<'a> {
    model: &'a Model,
    tensions: &'a [f64],
    load: &'a Load,
    settings: &'a Settings,
    mean_length: f64,
    /// 1 for translations, 1/ρ for rotations.
    scaling: DVector<f64>,
}

/// Balance at one pose, scaled so that all entries are N or N/m.
#[derive(Clone)]
struct Point {
    pose: Pose,
    residual: DVector<f64>,
    size: f64,
    /// −K_G − ∂w/∂x.
    stiffness: DMatrix<f64>,
}

struct End {
    point: Point,
    iterations: u32,
}

impl Point {
    fn stability(&self) -> f64 {
        let symmetric = (&self.stiffness + self.stiffness.transpose()) * 0.5;
        smallest_eigenvalue(symmetric)
    }

    /// Solves min ‖r − K s‖² + damping² ‖s‖² in units of K; without damping a plain Newton step.
    fn step(&self, damping: f64) -> Option<DVector<f64>> {
        if damping == 0.0 {
            return self.stiffness.clone().lu().solve(&self.residual);
        }
        let mut normal = self.stiffness.tr_mul(&self.stiffness);
        let unit = normal.trace() / normal.nrows() as f64;
        for k in 0..normal.nrows() {
            normal[(k, k)] += damping * damping * unit;
        }
        normal.cholesky().map(|factors| factors.solve(&self.stiffness.tr_mul(&self.residual)))
    }
}

/// Balance of constant tensions, as a problem of the common descent loop.
struct Descent<'a> {
    problem: &'a Problem<'a>,
    point: Point,
    /// `None` if a cable has no path.
    trial: Option<Point>,
}

impl solve::Problem for Descent<'_> {
    type Number = f64;

    fn step(&mut self, control: &Control<f64>) -> Step<f64> {
        let Some(step) = self.point.step(control.damping).filter(|step| step.norm().is_finite()) else {
            return Step::whole(0.0, false);
        };
        let (pose, size) = self.problem.displaced(&self.point.pose, step);
        self.trial = self.problem.point(&pose).ok();
        Step::whole(size, true)
    }

    fn evaluate(&mut self, _: f64, _: bool) -> Trial<f64> {
        let helps = self.trial.as_ref().is_some_and(|trial| trial.size < self.point.size);
        Trial::new(1.0, helps)
    }

    fn accept(&mut self, helps: bool, _: f64) {
        if helps && let Some(trial) = self.trial.take() {
            self.point = trial;
        }
    }

    /// True if the residual is at the tolerance, so that no further decrease is needed.
    fn rests(&mut self, _: f64, _: f64) -> bool {
        self.problem.is_balanced(&self.point)
    }
}

impl<'a> Problem<'a> {
    fn new(
        model: &'a Model,
        tensions: &'a [f64],
        load: &'a Load,
        settings: &'a Settings,
        guess: &Pose,
    ) -> Result<Self, InputError> {
        let lengths = model.cable_lengths(guess).map_err(StaticsError::from)?;
        let radius = model.platform_radius();
        let scaling = DVector::from_fn(model.dof(), |row, _| if row < model.axes().len() { 1.0 } else { 1.0 / radius });
        let mean_length = lengths.iter().sum::<f64>() / lengths.len() as f64;
        Ok(Self { model, tensions, load, settings, mean_length, scaling })
    }

    fn point(&self, pose: &Pose) -> Result<Point, StaticsError> {
        let residual = wrench_residual(self.model, pose, self.tensions, self.load)?.component_mul(&self.scaling);
        let geometric = geometric_stiffness(self.model, pose, self.tensions)?;
        let gradient = self.load.gradient(pose);
        let basis = self.model.twist_basis();
        let stiffness = DMatrix::from_fn(basis.len(), basis.len(), |i, j| {
            -(geometric[(i, j)] + basis[i].dot(&(gradient * basis[j]))) * self.scaling[i] * self.scaling[j]
        });
        Ok(Point { pose: *pose, size: residual.norm(), residual, stiffness })
    }

    fn force_scale(&self) -> f64 {
        self.tensions.iter().sum::<f64>() + self.load.force()
    }

    fn is_balanced(&self, point: &Point) -> bool {
        point.size <= self.settings.wrench_tolerance * self.force_scale()
    }

    /// Takes steps from one start until they are short or do not decrease the residual.
    fn descend(&self, start: Point) -> End {
        let from = Point { size: f64::INFINITY, ..start.clone() };
        let mut descent = Descent { problem: self, point: from, trial: Some(start) };
        let rules = Rules {
            tolerance: self.settings.pose_tolerance * self.mean_length,
            max_iterations: self.settings.max_iterations,
            least_gain: 0.0,
            rule: StepRule::Damping,
        };
        let end = descend(&mut descent, &rules);
        End { point: descent.point, iterations: end.iterations as u32 }
    }

    /// The pose after a scaled step, and the step's size (m).
    fn displaced(&self, pose: &Pose, step: DVector<f64>) -> (Pose, f64) {
        let amounts = step.component_mul(&self.scaling);
        let measure = Measure {
            translations: self.model.axes().len(),
            mean_length: self.mean_length,
            platform_radius: self.model.platform_radius(),
        };
        match self.model.dof() {
            2 => stepped::<2>(self.model, &measure, pose, amounts.as_slice()),
            3 => stepped::<3>(self.model, &measure, pose, amounts.as_slice()),
            _ => stepped::<6>(self.model, &measure, pose, amounts.as_slice()),
        }
    }

    fn verdict(&self, point: &Point, stability: f64, restarts: u32) -> (Status, Option<String>) {
        if !self.is_balanced(point) {
            let text = format!(
                "the best of {} starts leaves a wrench of {:.3e} N out of balance: no pose near it balances these tensions",
                restarts + 1,
                point.size
            );
            return (Status::NotConverged, Some(text));
        }
        let indifferent = indifferent_stiffness(point.stiffness.amax(), self.load.force(), self.mean_length);
        match Stability::of(stability, indifferent) {
            Stability::Stable => (Status::Converged, None),
            Stability::Unstable => {
                let text = format!(
                    "tensions and load balance here, but with constant tensions the platform would leave: the stiffness has the \
                     eigenvalue {stability:.3e} N/m"
                );
                (Status::Unstable, Some(text))
            }
            Stability::Indifferent => {
                let text = "the equilibrium is indifferent: tensions and load balance here and beside, they do not determine the pose";
                (Status::Singular, Some(text.to_owned()))
            }
        }
    }
}

/// The pose after a step, shortened if it is too long, and the step's size (m).
fn stepped<const N: usize>(model: &Model, measure: &Measure<f64>, pose: &Pose, step: &[f64]) -> (Pose, f64) {
    let mut amounts = [0.0; N];
    amounts.copy_from_slice(&step[..N]);
    let size = measure.shorten(&mut amounts);
    (displaced(model, pose, &amounts), size)
}
