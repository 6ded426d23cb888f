//! Choice of a control model: every composition is compared on the richest machine that a robot's file supports.

mod parameter_errors;
#[cfg(test)]
mod tests;

pub use parameter_errors::ParameterError;

use super::effects::parameter_count;
use cdpr_model::control::Control;
use cdpr_model::control::Driving;
use cdpr_model::control::History;
use cdpr_model::control::InputError;
use cdpr_model::control::Outcome;
use cdpr_model::control::PoseErrorStatistics;
use cdpr_model::control::Status;
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model, ModelError, StretchEffect, Supported};
use cdpr_model::tension::{Limits, Method};
use parameter_errors::{Judged, winches};

/// A control model judged on the machine over the poses of a task.
///
/// Errors are those at the compared poses, at which every candidate has an answer ([`Advice::compared`]), so that all
/// candidates are judged at the same poses.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Effects of the control model.
    pub control: Composition,
    /// Effects of the machine that the control model leaves out or has in a simpler form.
    pub left_out: Vec<&'static str>,
    /// Distance between commanded and emerging position (m).
    pub position_error: PoseErrorStatistics,
    /// Angle between commanded and emerging orientation (rad).
    pub rotation_error: PoseErrorStatistics,
    /// Emerging tensions minus those under a control model like the machine: mean over poses of the 2-norm (N); `None`
    /// for a rigid machine.
    pub tension_error: Option<f64>,
    /// Poses at which the platform comes to rest.
    pub answered: usize,
    /// Poses that are reached: the platform comes to rest with tensions within their limits and a position error of at
    /// most the required accuracy.
    pub reached: usize,
    /// The same for any position error.
    pub commanded: usize,
    /// Count of the numbers that its effects need from identification or a test bench, without anchors.
    pub parameter_count: usize,
    /// Reason for which the first unanswered pose has no answer; `None` if all are answered.
    pub reason: Option<String>,
}

/// Candidates with the recommended one.
#[derive(Clone, Debug, PartialEq)]
pub struct Advice {
    /// Effects of the machine.
    pub machine: Composition,
    /// Candidates from the simplest to the richest, which has the effects of the machine.
    pub candidates: Vec<Candidate>,
    /// Poses of the task.
    pub poses: usize,
    /// Poses at which every candidate has an answer; candidates without any answer do not count.
    pub compared: usize,
    /// Poses reached by at least one candidate.
    pub attainable: usize,
    /// Index of the simplest candidate that reaches as many poses as the one like the machine; `None` if that one
    /// reaches none.
    pub recommended: Option<usize>,
    /// Effects that the robot's file does not support, so that no candidate was judged with them.
    pub not_judged: Vec<&'static str>,
    /// Errors of the numbers of the recommended candidate, which come on top of its own; empty without one.
    pub parameter_errors: Vec<ParameterError>,
}

impl Advice {
    /// The candidate with the effects of the machine.
    pub fn like_the_machine(&self) -> Option<&Candidate> {
        self.candidates.iter().find(|candidate| candidate.control == self.machine)
    }

    /// Poses that a candidate reaches, as a fraction of those that any candidate reaches; 0 if none reaches any.
    pub fn reached_share(&self, candidate: &Candidate) -> f64 {
        candidate.reached as f64 / self.attainable.max(1) as f64
    }
}

/// Reason for which no advice can be given.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AdviceError {
    /// A model that cannot be built.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// Models that cannot be operated.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The task has no poses.
    #[error("the task has no poses")]
    NoPoses,
    /// The file has no home pose, at which the winches are set.
    #[error("the robot file has no home pose, at which the winches are set: add [home_pose]")]
    NoHome,
    /// The file supports only one model.
    #[error("the robot file supports no effect beyond `standard`, so that there is nothing to choose: {missing}")]
    NothingToChoose {
        /// Keys that the other effects lack.
        missing: String,
    },
}

/// Compares control models on the machine with the richest composition that the robot's file supports.
///
/// Winches are set at the home pose with the tensions nearest to the middle of the limits, once with each control
/// model: all have the same robot, so that they differ only in the effects that they leave out. A machine with
/// hysteresis comes to every pose from the home pose. `accuracy` is the largest position error (m); models that command
/// tensions choose them by `tension_method`.
pub fn advise(
    machine: &Model,
    supported: &Supported,
    poses: &[Pose],
    accuracy: f64,
    tension_method: Method,
) -> Result<Advice, AdviceError> {
    if poses.is_empty() {
        return Err(AdviceError::NoPoses);
    }
    let home = machine.robot().home.ok_or(AdviceError::NoHome)?;
    let full = machine.composition();
    if full == Composition::STANDARD {
        let missing = supported.missing.iter().map(|(effect, reason)| format!("{effect}: {reason}"));
        return Err(AdviceError::NothingToChoose { missing: missing.collect::<Vec<_>>().join("; ") });
    }
    let mut runs = Vec::new();
    for control in compositions(full, supported) {
        let model = Model::new(machine.robot().clone(), control)?;
        runs.push((control, outcomes(Control { tension_method, ..Control::from(&model) }, machine, &home, poses)?));
    }
    // for equal numbers of effects, the stretch law nearest to a real cable comes last: the machine's
    runs.sort_by_key(|(control, _)| (control.effect_count(), control.stretch.richness()));
    let task = Task::new(machine, poses, accuracy, &runs);
    let mut advice = task.advice(&runs);
    advice.not_judged = supported.missing.iter().map(|(effect, _)| *effect).collect();
    if let Some(recommended) = advice.recommended {
        let outcomes = &runs[recommended].1;
        let reached = (0..poses.len()).filter(|&pose| task.reaches(pose, &outcomes[pose])).map(|pose| poses[pose]);
        let reached: Vec<Pose> = reached.collect();
        let judged = Judged { machine, home: &home, poses: &reached, accuracy };
        advice.parameter_errors = judged.errors(advice.candidates[recommended].control, tension_method)?;
    }
    Ok(advice)
}

/// Emerging states at each pose under a control model, with which the winches were set at the home pose.
fn outcomes(control: Control, machine: &Model, home: &Pose, poses: &[Pose]) -> Result<Vec<Outcome>, InputError> {
    let offsets = winches(&control, machine, home)?;
    let driving = Driving::new(control, machine, &offsets)?;
    Ok(driving.with_history(History::of(machine, None).as_ref(), home).outcomes(poses))
}

/// Compositions of the machine's effects, each in the machine's form, in a simpler form, or left out.
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

/// A control model with its outcomes, pose by pose.
type Run = (Composition, Vec<Outcome>);

/// Task by which all candidates are judged.
struct Task<'a> {
    machine: &'a Model,
    poses: &'a [Pose],
    accuracy: f64,
    limits: Option<Limits>,
    /// Outcomes under a control model like the machine.
    reference: &'a [Outcome],
    /// Poses at which all candidates have an answer.
    compared: Vec<usize>,
}

impl<'a> Task<'a> {
    fn new(machine: &'a Model, poses: &'a [Pose], accuracy: f64, runs: &'a [Run]) -> Self {
        let is_settled = |outcome: &Outcome| outcome.status == Status::Converged;
        // a model that has no answer anywhere reports that itself, and does not prevent the comparison of the others
        let answering = || runs.iter().map(|(_, outcomes)| outcomes).filter(|outcomes| outcomes.iter().any(is_settled));
        let all_answer = |pose: &usize| answering().all(|outcomes| is_settled(&outcomes[*pose]));
        let full = machine.composition();
        Self {
            machine,
            poses,
            accuracy,
            limits: Limits::of(machine.robot(), None, None).ok(),
            reference: runs.iter().find(|(control, _)| *control == full).map_or(&[], |(_, outcomes)| outcomes),
            compared: (0..poses.len()).filter(all_answer).collect(),
        }
    }

    fn advice(&self, runs: &[Run]) -> Advice {
        let candidates: Vec<Candidate> =
            runs.iter().map(|(control, outcomes)| self.judge(*control, outcomes)).collect();
        let is_reached = |pose: usize| runs.iter().any(|(_, outcomes)| self.reaches(pose, &outcomes[pose]));
        let mut advice = Advice {
            machine: self.machine.composition(),
            poses: self.poses.len(),
            compared: self.compared.len(),
            attainable: (0..self.poses.len()).filter(|&pose| is_reached(pose)).count(),
            recommended: None,
            not_judged: Vec::new(),
            parameter_errors: Vec::new(),
            candidates,
        };
        let best = advice.like_the_machine().map_or(0, |full| full.reached);
        advice.recommended = advice.candidates.iter().position(|one| best > 0 && one.reached >= best);
        advice
    }

    fn judge(&self, control: Composition, outcomes: &[Outcome]) -> Candidate {
        let is_settled = |outcome: &&Outcome| outcome.status == Status::Converged;
        let answered = outcomes.iter().filter(is_settled).count();
        let compared = || self.compared.iter().copied().filter(|_| answered > 0);
        let errors: Vec<f64> = compared().map(|pose| self.position_error(pose, &outcomes[pose])).collect();
        let angles: Vec<f64> = compared().map(|pose| outcomes[pose].pose.angle_to(&self.poses[pose])).collect();
        let all = || outcomes.iter().enumerate();
        let words = self.machine.composition().effects();
        let left_out: Vec<&'static str> = words.filter(|word| !control.effects().any(|own| own == *word)).collect();
        let unanswered = outcomes.iter().find(|outcome| !is_settled(outcome));
        Candidate {
            control,
            left_out,
            position_error: PoseErrorStatistics::of(&errors),
            rotation_error: PoseErrorStatistics::of(&angles),
            tension_error: self.tension_error(outcomes).filter(|_| answered > 0),
            answered,
            reached: all().filter(|(pose, outcome)| self.reaches(*pose, outcome)).count(),
            commanded: all().filter(|(_, outcome)| self.keeps_limits(outcome)).count(),
            parameter_count: control.effects().map(|word| parameter_count(word, self.machine.robot())).sum(),
            reason: unanswered
                .map(|outcome| outcome.reason.clone().unwrap_or_else(|| "the machine comes to no rest".to_owned())),
        }
    }

    fn position_error(&self, pose: usize, outcome: &Outcome) -> f64 {
        (outcome.pose.position - self.poses[pose].position).norm()
    }

    /// True if the platform comes to rest with tensions within their limits.
    fn keeps_limits(&self, outcome: &Outcome) -> bool {
        let is_within = match (&self.limits, &outcome.tensions) {
            (Some(limits), Some(tensions)) => limits.contain(tensions, limits.tolerance()),
            _ => true,
        };
        outcome.status == Status::Converged && is_within
    }

    fn reaches(&self, pose: usize, outcome: &Outcome) -> bool {
        self.keeps_limits(outcome) && self.position_error(pose, outcome) <= self.accuracy
    }

    fn tension_error(&self, outcomes: &[Outcome]) -> Option<f64> {
        let norm = |&pose: &usize| {
            let (found, wanted) = (outcomes[pose].tensions.as_ref()?, self.reference.get(pose)?.tensions.as_ref()?);
            let squares: f64 =
                found.iter().zip(wanted).map(|(found, wanted)| (found - wanted) * (found - wanted)).sum();
            Some(squares.sqrt())
        };
        let norms: Vec<f64> = self.compared.iter().filter_map(norm).collect();
        (!norms.is_empty()).then(|| norms.iter().sum::<f64>() / norms.len() as f64)
    }
}
