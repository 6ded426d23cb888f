//! Accuracy with which a control model drives a machine (eq. 3.3–3.8, 6.6).

use std::collections::BTreeMap;

use cdpr_model::control::CommandedPose;
use cdpr_model::control::Control;
use cdpr_model::control::InputError;
use cdpr_model::control::MapEffect;
use cdpr_model::control::Operation;
use cdpr_model::control::Outcome;
use cdpr_model::control::Status;
use cdpr_model::control::{LengthErrorStatistics, PoseErrorStatistics, TensionErrorStatistics};
use cdpr_model::model::Model;

/// Errors of a control model on a machine over the commanded poses, SI units.
#[derive(Clone, Debug, PartialEq)]
#[expect(non_snake_case, reason = "the fields are the keys of the answer, units included")]
pub struct Accuracy {
    /// Number of commanded poses.
    pub samples: usize,
    /// Distance between commanded and emerging position (m).
    pub position_error_m: PoseErrorStatistics,
    /// Geodesic angle between commanded and emerging orientation (rad).
    pub rotation_error_rad: PoseErrorStatistics,
    /// Lengths that the control model computes for the emerging pose, minus those it sent for the commanded one (eq.
    /// 6.6; m).
    pub length_error_m: LengthErrorStatistics,
    /// Emerging minus commanded tensions (N); `None` if control model or machine has no tensions.
    pub tension_error_N: Option<TensionErrorStatistics>,
    /// Smallest emerging tension (N); `None` for a rigid machine.
    pub tension_min_N: Option<f64>,
    /// Largest emerging tension (N); `None` for a rigid machine.
    pub tension_max_N: Option<f64>,
    /// Number of poses by the status of their answer; only converged ones count in the errors.
    pub statuses: BTreeMap<&'static str, usize>,
    /// Poses at which at least one cable is slack.
    pub slack_samples: usize,
    /// Fraction of the converged poses with a tension outside the limits; `None` for a rigid machine or unknown limits.
    pub outside_limits_share: Option<f64>,
    /// Effect of the map that corrects the control model; `None` without one.
    pub compensation: Option<Box<MapEffect<Accuracy>>>,
}

impl Accuracy {
    /// Remark for the user if the tensions break their limits at every pose; else `None`.
    pub fn remark(&self) -> Option<String> {
        let settled = self.statuses.get(Status::Converged.name()).copied().unwrap_or(0);
        (settled > 0 && self.outside_limits_share == Some(1.0)).then(|| outside_reach(settled))
    }
}

/// Text for tensions that break their limits at every pose.
pub(super) fn outside_reach(poses: usize) -> String {
    format!(
        "the tensions break their limits at each of the {poses} poses that the machine comes to rest at: they lie outside its reach, \
         which `cdpr reachable` shows"
    )
}

/// Outcomes at every pose, with error statistics.
#[derive(Clone, Debug, PartialEq)]
pub struct Assessment {
    /// Outcomes, pose by pose.
    pub outcomes: Vec<Outcome>,
    /// Statistics of the errors.
    pub accuracy: Accuracy,
}

/// Commands poses through the control model to the machine and compares the emerging poses and tensions with the
/// commanded ones.
pub fn assess(
    control: impl Into<Control>,
    machine: &Model,
    offsets: &[f64],
    poses: &[CommandedPose],
) -> Result<Assessment, InputError> {
    assess_operation(&mut Operation::new(control, machine, offsets)?, poses)
}

/// [`assess`] for an operation, which may have a history.
pub fn assess_operation(operation: &mut Operation, poses: &[CommandedPose]) -> Result<Assessment, InputError> {
    if poses.is_empty() {
        return Err(InputError::NoPoses);
    }
    let alone = operation.without_map().map(|mut alone| assess_operation(&mut alone, poses)).transpose()?;
    let beyond = || operation.beyond_map(poses.iter().map(|command| command.pose));
    let compensation = alone.map(|alone| Box::new(MapEffect { beyond: beyond(), without: alone.accuracy }));
    let outcomes: Vec<Outcome> = poses.iter().map(|command| operation.answer(command)).collect();
    let mut errors = Errors::default();
    let mut statuses = BTreeMap::new();
    for (command, outcome) in poses.iter().zip(&outcomes) {
        *statuses.entry(outcome.status.name()).or_insert(0) += 1;
        if outcome.status == Status::Converged {
            errors.add(operation, command, outcome);
        }
    }
    let tensions = Tensions::of(operation.machine(), &outcomes);
    let accuracy = Accuracy {
        samples: poses.len(),
        position_error_m: PoseErrorStatistics::of(&errors.position),
        rotation_error_rad: PoseErrorStatistics::of(&errors.rotation),
        length_error_m: LengthErrorStatistics::of(&errors.length),
        tension_error_N: force_tracking(outcomes.iter()),
        tension_min_N: tensions.min,
        tension_max_N: tensions.max,
        statuses,
        slack_samples: tensions.slack_samples,
        outside_limits_share: tensions.outside_limits_share,
        compensation,
    };
    Ok(Assessment { outcomes, accuracy })
}

/// Emerging minus commanded tensions of all converged answers (N); `None` if control model or machine has no tensions.
pub(super) fn force_tracking<'o>(outcomes: impl Iterator<Item = &'o Outcome>) -> Option<TensionErrorStatistics> {
    let converged = outcomes.filter(|outcome| outcome.status == Status::Converged);
    let rows: Vec<Vec<f64>> = converged.filter_map(Outcome::tension_errors).collect();
    let cables = rows.first()?.len();
    Some(TensionErrorStatistics::of(&rows.concat(), cables))
}

/// Errors, pose by pose (m, rad, m).
#[derive(Default)]
struct Errors {
    position: Vec<f64>,
    rotation: Vec<f64>,
    length: Vec<f64>,
}

impl Errors {
    fn add(&mut self, operation: &mut Operation, command: &CommandedPose, outcome: &Outcome) {
        self.position.push((outcome.pose.position - command.pose.position).norm());
        self.rotation.push(outcome.pose.angle_to(&command.pose));
        // an elastic control model may have no tensions at an emerging pose
        if let (Ok(sent), Ok(emerging)) = (operation.command(&command.pose), operation.command(&outcome.pose)) {
            self.length.extend(emerging.iter().zip(&sent).map(|(emerging, sent)| emerging - sent));
        }
    }
}

/// Tensions over all converged poses.
#[derive(Default)]
struct Tensions {
    min: Option<f64>,
    max: Option<f64>,
    slack_samples: usize,
    outside_limits_share: Option<f64>,
}

impl Tensions {
    fn of(machine: &Model, outcomes: &[Outcome]) -> Self {
        let converged = outcomes.iter().filter(|outcome| outcome.status == Status::Converged);
        let rows: Vec<&[f64]> = converged.filter_map(|outcome| outcome.tensions.as_deref()).collect();
        let all = || rows.iter().flat_map(|row| row.iter().copied());
        let is_outside = |row: &&&[f64]| {
            row.iter().zip(&machine.robot().cables).any(|(&tension, cable)| {
                cable.tension_min.is_some_and(|min| tension < min) || cable.tension_max.is_some_and(|max| tension > max)
            })
        };
        let has_limits =
            machine.robot().cables.iter().any(|cable| cable.tension_min.is_some() || cable.tension_max.is_some());
        let fraction = || rows.iter().filter(is_outside).count() as f64 / rows.len() as f64;
        Self {
            min: all().reduce(f64::min),
            max: all().reduce(f64::max),
            slack_samples: rows.iter().filter(|row| row.contains(&0.0)).count(),
            outside_limits_share: (has_limits && !rows.is_empty()).then(fraction),
        }
    }
}
