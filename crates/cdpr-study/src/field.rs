//! Pose errors over many poses: exact, and by one linear step (eq. 3.16–3.28).

pub(super) mod linear;
#[cfg(test)]
mod tests;

use super::accuracy::{force_tracking, outside_reach};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::Driving;
use cdpr_model::control::MapEffect;
use cdpr_model::control::Operation;
use cdpr_model::control::Outcome;
use cdpr_model::control::Status;
use cdpr_model::control::error_statistics::diagonal;
use cdpr_model::control::{PoseErrorStatistics, TensionErrorStatistics};
use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::model::Model;
use cdpr_model::tension::Limits;

/// Pose error at one commanded pose, exact and by one linear step.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The commanded pose.
    pub commanded: Pose,
    /// Outcome on the machine.
    pub outcome: Outcome,
    /// Displacement from the commanded to the emerging pose (m, rad; world axes); `None` if no answer was found.
    pub exact: Option<Twist>,
    /// The same by one linear step from the commanded pose; `None` if the machine cannot be held there or the stiffness
    /// is singular.
    pub linear: Option<Twist>,
    /// Residual wrench Aᵀ f + w of the cables held at the commanded pose (world; N, N·m), which moves the platform (eq.
    /// 3.23); `None` for a rigid machine, and if no lengths are sent.
    pub residual_wrench: Option<Wrench>,
}

/// Samples with their statistics.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Samples, pose by pose.
    pub samples: Vec<Sample>,
    /// Statistics of the samples.
    pub summary: Summary,
}

/// Statistics of a field (eq. 3.3–3.10), SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Number of commanded poses.
    pub samples: usize,
    /// Number of them at which the platform comes to rest.
    pub converged: usize,
    /// Distance between commanded and emerging position (m), exact.
    pub position_error_m: PoseErrorStatistics,
    /// Angle between commanded and emerging orientation (rad), exact.
    pub rotation_error_rad: PoseErrorStatistics,
    /// Emerging minus commanded tensions (N); `None` if control model or machine has no tensions.
    pub tension_error: Option<TensionErrorStatistics>,
    /// Residual force of the cables held at the commanded poses, without moments (N); `None` for a rigid machine.
    pub residual_force: Option<PoseErrorStatistics>,
    /// Mean position error as a fraction of the diameter of the sampled positions (eq. 3.5); `None` for one position.
    pub relative_position_error: Option<f64>,
    /// Diameter of the sampled positions: the diagonal of their box (m).
    pub diameter_m: f64,
    /// Distance between commanded and emerging position by the linear step (m).
    pub linear_position_error_m: PoseErrorStatistics,
    /// Distance between the positions of the linear step and of the exact solution (m): the error of the step.
    pub linear_residual_m: PoseErrorStatistics,
    /// Fraction of the poses at which that distance is at most a tenth of the exact error.
    pub linear_trusted_share: f64,
    /// Effect of the map that corrects the control model; `None` without one.
    pub compensation: Option<Box<MapEffect<Summary>>>,
}

/// Largest error of the linear step, as a fraction of the exact pose error, at which it counts as trusted.
const TRUSTED: f64 = 0.1;

/// Commands poses and computes the displacement at which the platform comes to rest, exactly and by one linear step.
pub fn field(driving: &Driving, poses: &[Pose]) -> Field {
    let samples = driving.each_share(poses, |poses| {
        let mut operation = driving.operation();
        poses.iter().map(|pose| sample(&mut operation, pose)).collect()
    });
    let operation = driving.operation();
    let beyond = || operation.beyond_map(poses.iter().copied());
    let effect = |alone: Driving| MapEffect { beyond: beyond(), without: field(&alone, poses).summary };
    let compensation = driving.without_map().map(|alone| Box::new(effect(alone)));
    let summary = Summary { compensation, ..Summary::of(&samples) };
    Field { samples, summary }
}

fn sample(operation: &mut Operation, commanded: &Pose) -> Sample {
    let outcome = operation.answer(&CommandedPose::at(*commanded));
    let exact = (outcome.status == Status::Converged).then(|| commanded.displacement_to(&outcome.pose));
    let linear = linear::displacement(operation, commanded);
    let residual_wrench = linear::held(operation, commanded).map(|held| held.residual_wrench);
    Sample { commanded: *commanded, outcome, exact, linear, residual_wrench }
}

impl Field {
    /// Remark for the user if the tensions break their limits at every pose; else `None`.
    pub fn remark(&self, machine: &Model) -> Option<String> {
        let limits = Limits::of(machine.robot(), None, None).ok()?;
        let settled = || self.samples.iter().filter(|sample| sample.exact.is_some());
        let mut tensions = settled().filter_map(|sample| sample.outcome.tensions.as_deref()).peekable();
        let is_outside = tensions.peek().is_some() && tensions.all(|row| !limits.contain(row, limits.tolerance()));
        is_outside.then(|| outside_reach(settled().count()))
    }
}

impl Summary {
    fn of(samples: &[Sample]) -> Self {
        let shift = |twist: &Twist| twist.fixed_rows::<3>(0).norm();
        let exact: Vec<&Twist> = samples.iter().filter_map(|sample| sample.exact.as_ref()).collect();
        let both = || samples.iter().filter_map(|sample| sample.exact.as_ref().zip(sample.linear.as_ref()));
        let position: Vec<f64> = exact.iter().map(|twist| shift(twist)).collect();
        let rotation: Vec<f64> = exact.iter().map(|twist| twist.fixed_rows::<3>(3).norm()).collect();
        let linear: Vec<f64> = samples.iter().filter_map(|sample| sample.linear.as_ref()).map(shift).collect();
        let residual: Vec<f64> = both().map(|(exact, linear)| shift(&(linear - exact))).collect();
        let residuals = samples.iter().filter_map(|sample| sample.residual_wrench.as_ref()).map(shift);
        let residuals: Vec<f64> = residuals.collect();
        let trusted = both().filter(|(exact, linear)| shift(&(*linear - *exact)) <= TRUSTED * shift(exact)).count();
        let (position_error_m, diameter_m) = (PoseErrorStatistics::of(&position), diameter(samples));
        Self {
            samples: samples.len(),
            converged: exact.len(),
            relative_position_error: (diameter_m > 0.0).then(|| position_error_m.mean / diameter_m),
            position_error_m,
            rotation_error_rad: PoseErrorStatistics::of(&rotation),
            residual_force: (!residuals.is_empty()).then(|| PoseErrorStatistics::of(&residuals)),
            tension_error: force_tracking(samples.iter().map(|sample| &sample.outcome)),
            diameter_m,
            linear_position_error_m: PoseErrorStatistics::of(&linear),
            linear_residual_m: PoseErrorStatistics::of(&residual),
            linear_trusted_share: trusted as f64 / samples.len().max(1) as f64,
            compensation: None,
        }
    }
}

fn diameter(samples: &[Sample]) -> f64 {
    diagonal(|| samples.iter().map(|sample| sample.commanded.position))
}
