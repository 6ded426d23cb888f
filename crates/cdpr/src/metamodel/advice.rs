//! Which control model is good enough: every composition against the richest machine that a robot's file supports.

#[cfg(test)]
mod tests;

use super::control::Control;
use super::driving::Driving;
use super::effects;
use super::errors::PoseError;
use super::input_error::InputError;
use super::operate::{Outcome, Status};
use super::study::{Initial, TensionMethod};
use super::winches::winch_offsets;
use crate::geometry::Pose;
use crate::model::{Composition, Model, ModelError, StretchEffect, Supported};
use crate::tension::Limits;

/// What a control model does on the machine over the poses of a task.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Effects of the control model.
    pub control: Composition,
    /// Effects of the machine that it leaves out, or has in a simpler form.
    pub left_out: Vec<&'static str>,
    /// Distance between commanded and emerging position (m) over the poses at which the platform comes to rest.
    pub position_error: PoseError,
    /// Angle between commanded and emerging orientation (rad).
    pub rotation_error: PoseError,
    /// Emerging tensions minus those that a control model like the machine brings about: mean over poses of the 2-norm (N);
    /// nothing for a rigid machine.
    pub tension_error: Option<f64>,
    /// Share of the poses that are reached: the platform comes to rest with tensions within their limits and a position error of
    /// at most the accuracy.
    pub reached_share: f64,
    /// The same, whatever the error.
    pub commanded_share: f64,
    /// Parameters that its effects leave to be identified, anchors not counted.
    pub parameter_count: usize,
    /// Why no pose has an answer, if none has.
    pub reason: Option<String>,
}

/// Candidates with the one to take.
#[derive(Clone, Debug, PartialEq)]
pub struct Advice {
    /// Effects of the machine.
    pub machine: Composition,
    /// From the simplest to the richest.
    pub candidates: Vec<Candidate>,
    /// Index of the simplest candidate that reaches as many poses as the one like the machine; nothing where that one reaches
    /// none.
    pub recommended: Option<usize>,
}

/// What cannot be advised on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AdviceError {
    /// A model that cannot be built.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// Models that cannot be operated.
    #[error(transparent)]
    Input(#[from] InputError),
    /// No poses to judge by.
    #[error("the task has no poses")]
    NoPoses,
    /// There is nowhere to set the winches.
    #[error("the robot file has no home pose, at which the winches are set: add [home_pose]")]
    NoHome,
    /// Only one model can be built of the file.
    #[error("the robot file supports no effect beyond `standard`, so that there is nothing to choose: {missing}")]
    NothingToChoose {
        /// What the effects lack.
        missing: String,
    },
}

/// Compares control models on the machine with the richest composition that the robot's file supports.
///
/// Winches are set at the home pose with the tensions nearest to the middle of the limits, with each control model in its turn:
/// all have the same robot, so that what differs is what they leave out. `accuracy` is the largest position error (m); those
/// that command tensions choose them by `tension_method`.
pub fn advise(
    machine: &Model,
    supported: &Supported,
    poses: &[Pose],
    accuracy: f64,
    tension_method: TensionMethod,
) -> Result<Advice, AdviceError> {
    if poses.is_empty() {
        return Err(AdviceError::NoPoses);
    }
    let robot = machine.robot();
    let home = robot.home.ok_or(AdviceError::NoHome)?;
    let full = machine.composition();
    if full == Composition::STANDARD {
        let missing = supported.missing.iter().map(|(effect, reason)| format!("{effect}: {reason}"));
        return Err(AdviceError::NothingToChoose { missing: missing.collect::<Vec<_>>().join("; ") });
    }
    let initial = Initial {
        tension_method: Some(TensionMethod::Qp),
        offset: (!full.depends_on_tension()).then(|| "none".to_owned()),
        ..Initial::default()
    };
    let limits = Limits::of(robot, None, None).ok();
    let outcomes = |control: &Model| -> Result<Vec<Outcome>, InputError> {
        let offsets = winch_offsets(&initial, control, machine, &home)?;
        Ok(Driving::new(Control { model: control, tension_method }, machine, &offsets)?.outcomes(poses))
    };
    let reference = outcomes(machine)?;
    let task = Task { poses, accuracy, limits: limits.as_ref(), reference: &reference };
    let mut candidates = Vec::new();
    for control in compositions(full, supported) {
        let model = Model::new(robot.clone(), control)?;
        let outcomes = if control == full { reference.clone() } else { outcomes(&model)? };
        candidates.push(task.judge(machine, control, &outcomes));
    }
    candidates.sort_by_key(|candidate| (candidate.control.effect_count(), candidate.parameter_count));
    let best = candidates.last().map_or(0.0, |full| full.reached_share);
    let recommended = candidates.iter().position(|candidate| best > 0.0 && candidate.reached_share >= best);
    Ok(Advice { machine: full, candidates, recommended })
}

/// Compositions of effects that the machine has, each as the machine has it, in a simpler form, or not at all.
fn compositions(full: Composition, supported: &Supported) -> impl Iterator<Item = Composition> {
    let stretches: Vec<StretchEffect> = [StretchEffect::Rigid, full.stretch]
        .into_iter()
        .chain(supported.alternatives.iter().map(|(alternative, _)| supported.with_alternative(alternative).stretch))
        .collect();
    Composition::all().filter(move |control| {
        (full.pulley || !control.pulley)
            && (full.drum || !control.drum)
            && stretches.contains(&control.stretch)
            && (control.span == Default::default() || control.span == full.span)
    })
}

/// What all candidates are judged by.
struct Task<'a> {
    poses: &'a [Pose],
    accuracy: f64,
    limits: Option<&'a Limits>,
    /// What emerges under a control model like the machine.
    reference: &'a [Outcome],
}

impl Task<'_> {
    fn judge(&self, machine: &Model, control: Composition, outcomes: &[Outcome]) -> Candidate {
        let answered = || {
            let all = self.poses.iter().zip(outcomes);
            all.filter(|(_, outcome)| outcome.status == Status::Converged)
        };
        let position = |pose: &Pose, outcome: &Outcome| (outcome.pose.position - pose.position).norm();
        let errors: Vec<f64> = answered().map(|(pose, outcome)| position(pose, outcome)).collect();
        let angles: Vec<f64> = answered().map(|(pose, outcome)| outcome.pose.angle_to(pose)).collect();
        let is_within = |outcome: &Outcome| match (self.limits, &outcome.tensions) {
            (Some(limits), Some(tensions)) => limits.contain(tensions, limits.tolerance()),
            _ => true,
        };
        let commanded: Vec<bool> = answered().map(|(_, outcome)| is_within(outcome)).collect();
        let reached =
            commanded.iter().zip(&errors).filter(|(within, error)| **within && **error <= self.accuracy).count();
        let share = |count: usize| count as f64 / self.poses.len() as f64;
        let words = machine.composition().words();
        let left_out: Vec<&'static str> = words.filter(|word| !control.words().any(|own| own == *word)).collect();
        let per_cable: usize = control.words().map(|effect| effects::cost(effect).0).sum();
        Candidate {
            control,
            left_out,
            position_error: PoseError::of(&errors),
            rotation_error: PoseError::of(&angles),
            tension_error: self.tension_error(outcomes),
            reached_share: share(reached),
            commanded_share: share(commanded.iter().filter(|within| **within).count()),
            parameter_count: per_cable * machine.cable_count(),
            reason: errors.is_empty().then(|| outcomes.iter().find_map(|outcome| outcome.reason.clone())).flatten(),
        }
    }

    fn tension_error(&self, outcomes: &[Outcome]) -> Option<f64> {
        let pairs = outcomes.iter().zip(self.reference).filter_map(|(outcome, reference)| {
            let is_settled = outcome.status == Status::Converged && reference.status == Status::Converged;
            let (found, wanted) = (outcome.tensions.as_ref()?, reference.tensions.as_ref()?);
            let squares: f64 =
                found.iter().zip(wanted).map(|(found, wanted)| (found - wanted) * (found - wanted)).sum();
            is_settled.then(|| squares.sqrt())
        });
        let norms: Vec<f64> = pairs.collect();
        (!norms.is_empty()).then(|| norms.iter().sum::<f64>() / norms.len() as f64)
    }
}
