//! The answer of what control model a task needs.

use cdpr_model::model::Model;
use cdpr_model::reading::Keyword;
use cdpr_study::advice::{Advice, Candidate, ParameterError};
use cdpr_study::effects;
use cdpr_workspace::Bounds;
use schemars::JsonSchema;
use serde::Serialize;

use crate::keys::adapters::keys;
use crate::keys::{Each, PoseErrorKeys};

/// Control models for a task, judged against a machine; keys and units as in JSON.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Advice")]
pub struct AdviceAnswer {
    /// Outcome in a word.
    pub status: &'static str,
    /// Reason why poses are out of reach, or have no answer.
    pub reason: Option<String>,
    /// Name of the robot.
    pub robot: String,
    /// Effects of the machine.
    pub machine: String,
    /// Box of the task.
    pub task_m: Vec<f64>,
    /// Poses of the task.
    pub poses: usize,
    /// Poses that the errors are those of: every model has an answer there.
    pub compared_poses: usize,
    /// Poses that at least one model reaches.
    pub attainable_poses: usize,
    /// Required accuracy.
    pub accuracy_m: f64,
    /// The simplest model that reaches as much as one like the machine.
    pub recommended: Option<String>,
    /// Effects that no model was judged with, since the robot file lacks their keys.
    pub not_judged: Vec<&'static str>,
    /// Errors of the recommended model's numbers, which come on top of its own.
    #[serde(with = "Each::<ParameterErrorKeys>")]
    pub parameter_errors: Vec<ParameterError>,
    /// Effects without which less is reached.
    #[serde(with = "Each::<EffectKeys>")]
    pub must_be_modelled: Vec<EffectAnswer>,
    /// Effects without which as much is reached.
    #[serde(with = "Each::<EffectKeys>")]
    pub may_be_left_out: Vec<EffectAnswer>,
    /// Models, from simple to complex.
    #[serde(with = "Each::<AdvisedModelKeys>")]
    pub candidates: Vec<AdvisedModel>,
    /// Effects that the robot does not support.
    pub missing: Vec<String>,
    /// Times.
    pub timing: AdviceTiming,
}

/// Numbers that differ from run to run.
#[derive(Serialize, JsonSchema)]
pub struct AdviceTiming {
    /// Mean time of one command of each candidate (ns), in their order.
    pub command_ns: Vec<f64>,
}

/// One effect, left out of the machine's model on its own.
pub struct EffectAnswer {
    /// Name of the effect.
    pub effect: &'static str,
    /// Control model without it.
    pub without: Candidate,
    /// Share of the attainable poses that are reached.
    pub reached_share: f64,
    /// Number of parameters.
    pub parameter_count: usize,
    /// Cost of computing, in words.
    pub cost: &'static str,
}

/// A control model.
pub struct AdvisedModel {
    /// The model with its errors.
    pub candidate: Candidate,
    /// Of the poses that any model reaches.
    pub reached_share: f64,
    /// Share of the poses that can be commanded within the limits.
    pub share_within_tension_limits: f64,
}

keys! {
    /// One effect.
    EffectKeys as "AdvisedEffect" of EffectAnswer {
        /// Name of the effect.
        effect,
        /// Mean position error of the model without it (m).
        without.position_error.mean = "position_error_mean_m",
        /// Largest position error of the model without it (m).
        without.position_error.max = "position_error_max_m",
        /// Largest rotation error of the model without it (rad).
        without.rotation_error.max = "rotation_error_max_rad",
        /// Mean over poses of the 2-norm of the tension errors of the model without it (N); null where it commands no tensions.
        without.tension_error = "tension_error_N",
        /// Fraction of the poses that the model reaches.
        reached_share,
        /// Free parameters that the effect adds.
        parameter_count,
        /// Cost of modelling the effect, in words.
        cost,
    }
    /// Errors of one kind of number, in its `unit`.
    ParameterErrorKeys of ParameterError {
        /// Side under whose name the error counts.
        side.name(),
        /// Kind of the numbers.
        kind.to_string(),
        /// Unit of the kind; empty for a ratio.
        kind.unit() = "unit",
        /// Root mean square over the poses of the displacement of the platform by errors of one standard deviation in all numbers of the kind (m per unit).
        position_rms = "position_rms_m_per_unit",
        /// The same at the worst pose (m per unit).
        position_max = "position_max_m_per_unit",
        /// Standard deviation up to which two of them stay within the required accuracy if all else is exact, in the unit of the kind; null if the error without deviations uses up the accuracy.
        allowed = "sigma_alone",
    }
    /// A control model.
    AdvisedModelKeys of AdvisedModel {
        /// Effects of the control model.
        candidate.control.to_string() = "model",
        /// Effects of the machine that the model leaves out.
        candidate.left_out = "left_out",
        /// Distance between commanded and emerging position (m).
        candidate.position_error = "position_error_m" by PoseErrorKeys,
        /// Angle between commanded and emerging orientation (rad).
        candidate.rotation_error = "rotation_error_rad" by PoseErrorKeys,
        /// Mean over poses of the 2-norm of the tension errors (N); null where the model commands no tensions.
        candidate.tension_error = "tension_error_N",
        /// Poses at which the machine comes to rest.
        candidate.answered = "answered_poses",
        /// Poses that are reached with the required accuracy.
        candidate.reached = "reached_poses",
        /// Fraction of the poses that the model reaches.
        reached_share,
        /// Fraction of the poses with all tensions within their limits; null where there are none.
        share_within_tension_limits,
        /// Free parameters of the model.
        candidate.parameter_count = "parameter_count",
        /// Reason why poses have no answer.
        candidate.reason = "reason",
    }
}

impl AdviceAnswer {
    /// The answer with its status.
    pub fn new(
        machine: &Model,
        advice: &Advice,
        task: &Bounds,
        accuracy: f64,
        missing: Vec<String>,
        timing: AdviceTiming,
    ) -> Self {
        let best = advice.like_the_machine().map_or(0, |full| full.reached);
        let recommended = advice.recommended.map(|index| advice.candidates[index].control.to_string());
        let mut effects = [Vec::new(), Vec::new()];
        for effect in advice.machine.effects() {
            let without = advice.machine.without(effect);
            let Some(candidate) = advice.candidates.iter().find(|candidate| candidate.control == without) else {
                continue;
            };
            effects[usize::from(candidate.reached >= best)].push(EffectAnswer::new(effect, candidate, advice, machine));
        }
        let [must_be_modelled, may_be_left_out] = effects;
        let advised = |candidate: &Candidate| AdvisedModel {
            reached_share: advice.reached_share(candidate),
            share_within_tension_limits: candidate.commanded as f64 / advice.poses as f64,
            candidate: candidate.clone(),
        };
        let reason = (best < advice.poses).then(|| out_of_reach(advice, best));
        Self {
            status: if reason.is_none() { "advised" } else { "out-of-reach" },
            reason,
            robot: machine.robot().name.clone(),
            machine: advice.machine.to_string(),
            task_m: task.ends(),
            poses: advice.poses,
            compared_poses: advice.compared,
            attainable_poses: advice.attainable,
            accuracy_m: accuracy,
            recommended,
            not_judged: advice.not_judged.clone(),
            parameter_errors: advice.parameter_errors.clone(),
            must_be_modelled,
            may_be_left_out,
            candidates: advice.candidates.iter().map(advised).collect(),
            missing,
            timing,
        }
    }
}

/// Reason why not all of the task is reached.
fn out_of_reach(advice: &Advice, best: usize) -> String {
    let Advice { poses, attainable, .. } = *advice;
    let why = advice.like_the_machine().and_then(|full| full.reason.clone());
    let why = why.map_or_else(String::new, |why| format!(": {why}"));
    match attainable {
        0 => format!("no control model reaches any of the {poses} poses of the task{why}"),
        _ if best == attainable => {
            format!("{} of the {poses} poses of the task are out of reach of every control model{why}", poses - best)
        }
        _ => format!("even a control model like the machine reaches only {best} of the {poses} poses of the task{why}"),
    }
}

impl EffectAnswer {
    fn new(effect: &'static str, without: &Candidate, advice: &Advice, machine: &Model) -> Self {
        Self {
            effect,
            reached_share: advice.reached_share(without),
            without: without.clone(),
            parameter_count: effects::parameter_count(effect, machine.robot()),
            cost: effects::cost(effect),
        }
    }
}
