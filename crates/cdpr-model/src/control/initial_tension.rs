//! Initial tensions that suit a path, an area or a volume (eq. 3.42), and the stages in which a real robot is brought
//! to them.
//!
//! Winches are set once, at the initial pose; everywhere else tensions follow from the lengths that the control model
//! sends. [`optimum`] finds the f_ini, within limits and in balance with the load, for which the emerging tensions are
//! nearest to a target over given poses: min Σ ‖f_ref(x) − f̂(x, f_ini)‖². The sum over evenly spread poses of a path,
//! an area or a volume stands for the integral over it. [`approach`] leads there from slack winches.

mod approach;
mod descent;
mod starts;
#[cfg(test)]
mod tests;

pub use approach::{Approach, Move, Stage, approach};
pub use descent::optimum;

use super::driving::Driving;
use super::input_error::InputError;
use super::status::Status;
use super::winches::{initial_tensions, winch_offsets};
use crate::control::controller::Control;
use crate::control::{History, Initial};
use crate::geometry::Pose;
use crate::model::Model;
use crate::tension::Limits;

/// Setting of winches, as an optimization problem.
#[derive(Clone, Debug)]
pub struct Task<'a> {
    /// Control model, which sends the lengths.
    pub control: Control,
    /// Machine, which answers; its cables are elastic.
    pub machine: &'a Model,
    /// The model in use when the winches are set: the control model, unless it is calibrated afterwards.
    pub set_with: &'a Model,
    /// Pose at which the winches are set, x_ini.
    pub pose: Pose,
    /// Limits of f_ini (N).
    pub limits: &'a Limits,
    /// Path on which a machine with hysteresis comes to the poses.
    pub history: Option<History>,
    /// Tensions that are set now (N), if known: one more start of the search.
    pub now: Option<Vec<f64>>,
}

/// Target tensions at every pose, f_ref: given tensions (N), or those of a method, `closed-form` for the middle of the
/// limits (eq. 3.41), `minimum` for the least.
///
/// Given tensions are projected on those that balance the load at the pose, within the limits or not. A pose at which a
/// cable would then push has no target ([`Fit::without_target`]).
pub type Target = Initial;

/// Distance of emerging tensions from the target.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// Root of the mean squared distance of a cable's tension from its target (N).
    pub rms: f64,
    /// The largest distance of a tension from its target (N).
    pub largest: f64,
    /// Number of poses that count: the machine comes to rest there, and there is a target.
    pub poses: usize,
    /// Poses (0-based) that have no target.
    pub without_target: Vec<usize>,
    /// Reason that the first of those has none.
    pub no_target: Option<InputError>,
    /// Poses (0-based) at which the machine does not come to rest.
    pub without_rest: Vec<usize>,
    /// Number of poses at which a tension is outside its limits.
    pub outside: usize,
    /// The tension farthest outside its limits.
    pub worst: Option<Outside>,
}

/// A tension outside its limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outside {
    /// Pose (0-based).
    pub pose: usize,
    /// Cable (0-based).
    pub cable: usize,
    /// Tension (N).
    pub tension: f64,
}

/// Initial tensions with the resulting fit.
#[must_use = "check `is_settled` before using the tensions"]
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// f_ini (N).
    pub tensions: Vec<f64>,
    /// Winch offsets q_off, added to the control model's lengths (m).
    pub offsets: Vec<f64>,
    /// The fit with them.
    pub fit: Fit,
    /// Cables (0-based) with an initial tension at a limit.
    pub at_limits: Vec<usize>,
    /// Steps taken from the best start.
    pub iterations: u32,
    /// Number of starts of the search.
    pub starts: usize,
    /// Number of starts that led to these tensions.
    pub agreeing: usize,
    /// False if the steps did not converge: better tensions may exist.
    pub is_settled: bool,
}

/// Winch offsets that bring the machine to x_ini with these tensions (m).
pub(crate) fn offsets_of(task: &Task<'_>, tensions: &[f64]) -> Result<Vec<f64>, InputError> {
    winch_offsets(&given(tensions), task.set_with, task.machine, &task.pose)
}

/// The fit of emerging tensions with these winch offsets (m); no poses count if none has a target.
pub fn fit(task: &Task<'_>, offsets: &[f64], target: &Target, poses: &[Pose]) -> Result<Fit, InputError> {
    let wanted = wanted(task, target, poses)?;
    Ok(Fit::of(&emerging(task, offsets, poses)?, &wanted, task.limits))
}

/// Initial tensions that are given, without other entries.
fn given(tensions: &[f64]) -> Initial {
    Initial { tensions_N: Some(tensions.to_vec()), ..Initial::default() }
}

/// f_ref at a pose (N), or the reason that there is none.
type WantedTensions = Result<Vec<f64>, InputError>;

/// f_ref at each pose. An error if no pose has a target.
fn wanted(task: &Task<'_>, target: &Target, poses: &[Pose]) -> Result<Vec<WantedTensions>, InputError> {
    if !task.machine.needs_tensions() {
        return Err(InputError::RigidMachine);
    }
    let wanted: Vec<WantedTensions> = poses.iter().map(|pose| initial_tensions(target, task.machine, pose)).collect();
    match wanted.first() {
        None => Err(InputError::NoPoses),
        Some(Err(refused)) if wanted.iter().all(Result::is_err) => Err(refused.clone()),
        Some(_) => Ok(wanted),
    }
}

/// Tensions that emerge at each pose (N); `None` if the machine does not come to rest.
fn emerging(task: &Task<'_>, offsets: &[f64], poses: &[Pose]) -> Result<Vec<Option<Vec<f64>>>, InputError> {
    let driving = driving(task, offsets)?;
    let tensions = driving.outcomes(poses).into_iter();
    Ok(tensions.map(|outcome| outcome.tensions.filter(|_| outcome.status == Status::Converged)).collect())
}

fn driving<'a>(task: &Task<'a>, offsets: &[f64]) -> Result<Driving, InputError> {
    let driving = Driving::new(task.control.clone(), task.machine, offsets)?;
    Ok(driving.with_history(task.history.as_ref(), &task.pose))
}

impl Fit {
    fn of(emerging: &[Option<Vec<f64>>], wanted: &[WantedTensions], limits: &Limits) -> Self {
        let all = 0..wanted.len();
        let mut fit = Self {
            rms: f64::NAN,
            largest: 0.0,
            poses: 0,
            without_target: all.clone().filter(|&pose| wanted[pose].is_err()).collect(),
            no_target: wanted.iter().find_map(|wanted| wanted.as_ref().err().cloned()),
            without_rest: all.filter(|&pose| emerging[pose].is_none()).collect(),
            outside: 0,
            worst: None,
        };
        let (mut squares, mut count, mut worst_excess) = (0.0, 0, limits.tolerance());
        for (pose, (tensions, target)) in emerging.iter().zip(wanted).enumerate() {
            let Some(tensions) = tensions else { continue };
            fit.outside += usize::from(!limits.contain(tensions, limits.tolerance()));
            for (cable, &tension) in tensions.iter().enumerate() {
                let excess = (limits.minimum()[cable] - tension).max(tension - limits.maximum()[cable]);
                if excess > worst_excess {
                    (worst_excess, fit.worst) = (excess, Some(Outside { pose, cable, tension }));
                }
            }
            let Ok(target) = target else { continue };
            fit.poses += 1;
            for (tension, wanted) in tensions.iter().zip(target) {
                let away = (tension - wanted).abs();
                (squares, count) = (squares + away * away, count + 1);
                fit.largest = fit.largest.max(away);
            }
        }
        if count > 0 {
            fit.rms = (squares / f64::from(count)).sqrt();
        }
        fit
    }
}
