//! Comparison of a controller's errors with those of another at the same poses of one machine (Figs. 4.1, 4.7).

use super::accuracy::Assessment;
use cdpr_model::control::CommandedPose;
use cdpr_model::control::Outcome;
use cdpr_model::control::PoseErrorStatistics;
use cdpr_model::control::Status;
use cdpr_model::control::error_statistics::{mean, norm};

/// Differences below this are rounding (m, rad).
const ROUNDING: f64 = 1e-9;

/// Errors of one controller minus those of another, over the poses at which both bring the platform to rest; negative
/// is better.
#[derive(Clone, Debug, PartialEq)]
#[expect(non_snake_case, reason = "the fields are the keys of the answer, units included")]
pub struct Difference {
    /// Number of commanded poses.
    pub samples: usize,
    /// Number of them at which both have an answer.
    pub compared: usize,
    /// Number of poses at which the position error is smaller than with the other.
    pub better: usize,
    /// Number of poses at which it is larger.
    pub worse: usize,
    /// Distance between commanded and emerging position (m).
    pub position_error_m: ErrorChange,
    /// Angle between commanded and emerging orientation (rad).
    pub rotation_error_rad: ErrorChange,
    /// 2-norm over cables of emerging minus commanded tensions (N); `None` unless both controllers command tensions and
    /// the machine has its own.
    pub tension_error_N: Option<ErrorChange>,
    /// Change of the position error, pose by pose (m); `None` if one has no answer.
    pub position_change: Vec<Option<f64>>,
    /// Change of the rotation error, pose by pose (rad).
    pub rotation_change: Vec<Option<f64>>,
}

/// An error of two controllers at the same poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorChange {
    /// Error of this controller.
    pub own: PoseErrorStatistics,
    /// Error of the other one.
    pub other: PoseErrorStatistics,
    /// Mean of own minus other.
    pub mean_change: f64,
    /// Own mean divided by that of the other, minus 1; `None` if the other makes no error.
    pub relative_change: Option<f64>,
    /// Largest reduction at one pose; 0 if there is none.
    pub largest_gain: f64,
    /// Largest increase at one pose; 0 if there is none.
    pub largest_loss: f64,
}

impl Assessment {
    /// Errors of this controller minus those of another that commanded the same poses.
    pub fn difference(&self, poses: &[CommandedPose], other: &Self) -> Difference {
        let both = || poses.iter().zip(self.outcomes.iter().zip(&other.outcomes));
        let errors = |read: fn(&CommandedPose, &Outcome) -> Option<f64>| -> Vec<Option<[f64; 2]>> {
            let at_rest = |(pose, (own, other)): (&CommandedPose, (&Outcome, &Outcome))| {
                let rests = own.status == Status::Converged && other.status == Status::Converged;
                let [own, other] = [own, other].map(|outcome| rests.then(|| read(pose, outcome)).flatten());
                Some([own?, other?])
            };
            both().map(at_rest).collect()
        };
        let position = errors(|command, outcome| Some((outcome.pose.position - command.pose.position).norm()));
        let rotation = errors(|command, outcome| Some(outcome.pose.angle_to(&command.pose)));
        let tension = errors(|_, outcome| outcome.tension_errors().map(|errors| norm(&errors)));
        let changes = |errors: &[Option<[f64; 2]>]| -> Vec<Option<f64>> {
            errors.iter().map(|both| both.map(|[own, other]| own - other)).collect()
        };
        let position_change = changes(&position);
        let known = || position_change.iter().flatten();
        Difference {
            samples: poses.len(),
            compared: known().count(),
            better: known().filter(|change| **change < -ROUNDING).count(),
            worse: known().filter(|change| **change > ROUNDING).count(),
            position_error_m: ErrorChange::of(&position),
            rotation_error_rad: ErrorChange::of(&rotation),
            tension_error_N: tension.iter().any(Option::is_some).then(|| ErrorChange::of(&tension)),
            rotation_change: changes(&rotation),
            position_change,
        }
    }
}

impl ErrorChange {
    fn of(errors: &[Option<[f64; 2]>]) -> Self {
        let [own, other] =
            [0, 1].map(|which| -> Vec<f64> { errors.iter().flatten().map(|both| both[which]).collect() });
        let changes: Vec<f64> = own.iter().zip(&other).map(|(own, other)| own - other).collect();
        let (before, after) = (mean(&other), mean(&own));
        Self {
            own: PoseErrorStatistics::of(&own),
            other: PoseErrorStatistics::of(&other),
            mean_change: mean(&changes),
            relative_change: (before > ROUNDING).then(|| after / before - 1.0),
            largest_gain: -changes.iter().copied().fold(0.0, f64::min),
            largest_loss: changes.iter().copied().fold(0.0, f64::max),
        }
    }
}
