//! What `cdpr advise` answers, for programs and in words.

use cdpr::metamodel::advice::{Advice, Candidate};
use cdpr::metamodel::effects;
use cdpr::metamodel::errors::PoseError;
use cdpr::model::Model;
use cdpr::workspace::Bounds;
use serde::Serialize;

use crate::answer::Answer;
use crate::table::{Table, cell};
use cdpr_reports::number_format::significant;

#[derive(Serialize)]
pub(super) struct Advised {
    status: &'static str,
    reason: Option<String>,
    robot: String,
    machine: String,
    task_m: Vec<f64>,
    poses: usize,
    /// Poses that the errors are those of: every model has an answer there.
    compared_poses: usize,
    /// Poses that at least one model reaches.
    attainable_poses: usize,
    accuracy_m: f64,
    recommended: Option<String>,
    must_be_modelled: Vec<EffectAnswer>,
    may_be_left_out: Vec<EffectAnswer>,
    candidates: Vec<CandidateAnswer>,
    missing: Vec<String>,
    timing: Timing,
}

/// What differs from run to run.
#[derive(Serialize)]
pub(super) struct Timing {
    /// Mean time of one command of each candidate (ns), in their order.
    pub(super) command_ns: Vec<f64>,
}

/// One effect, left out of the machine's model on its own.
#[derive(Serialize)]
struct EffectAnswer {
    effect: &'static str,
    position_error_mean_m: f64,
    position_error_max_m: f64,
    rotation_error_max_rad: f64,
    #[serde(rename = "tension_error_N")]
    tension_error: Option<f64>,
    reached_share: f64,
    parameter_count: usize,
    cost: &'static str,
}

#[derive(Serialize)]
struct CandidateAnswer {
    model: String,
    left_out: Vec<&'static str>,
    position_error_m: PoseError,
    rotation_error_rad: PoseError,
    #[serde(rename = "tension_error_N")]
    tension_error: Option<f64>,
    answered_poses: usize,
    reached_poses: usize,
    /// Of the poses that any model reaches.
    reached_share: f64,
    share_within_tension_limits: f64,
    parameter_count: usize,
    reason: Option<String>,
}

impl Advised {
    pub(super) fn new(
        machine: &Model,
        advice: &Advice,
        task: &Bounds,
        accuracy: f64,
        missing: Vec<String>,
        timing: Timing,
    ) -> Self {
        let best = advice.like_the_machine().map_or(0, |full| full.reached);
        let recommended = advice.recommended.map(|index| advice.candidates[index].control.to_string());
        let mut effects = [Vec::new(), Vec::new()];
        for effect in advice.machine.words() {
            let without = advice.machine.without(effect);
            let Some(candidate) = advice.candidates.iter().find(|candidate| candidate.control == without) else {
                continue;
            };
            effects[usize::from(candidate.reached >= best)].push(EffectAnswer::new(effect, candidate, advice, machine));
        }
        let [must_be_modelled, may_be_left_out] = effects;
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
            must_be_modelled,
            may_be_left_out,
            candidates: advice.candidates.iter().map(|candidate| CandidateAnswer::new(candidate, advice)).collect(),
            missing,
            timing,
        }
    }

    /// Poses at which errors are compared, in words, where models lack answers.
    fn comparison(&self) -> Option<String> {
        let all = self.candidates.iter().all(|candidate| candidate.answered_poses == self.poses);
        let lacking = self.candidates.iter().find(|candidate| candidate.answered_poses < self.poses);
        (!all).then(|| {
            let why = lacking.and_then(|candidate| candidate.reason.as_ref().map(|reason| (&candidate.model, reason)));
            let why = why.map_or_else(String::new, |(model, reason)| format!("; `{model}`: {reason}"));
            match self.compared_poses {
                0 => format!("there is no pose at which every model has an answer, so that errors cannot be compared{why}"),
                compared => format!(
                    "errors are those at the {compared} of {} poses where every model that answers at all has an answer{why}",
                    self.poses
                ),
            }
        })
    }
}

/// Why not all of the task is reached.
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
            position_error_mean_m: without.position_error.mean,
            position_error_max_m: without.position_error.max,
            rotation_error_max_rad: without.rotation_error.max,
            tension_error: without.tension_error,
            reached_share: advice.reached_share(without),
            parameter_count: effects::parameter_count(effect, machine.robot()),
            cost: effects::cost(effect),
        }
    }

    fn sentence(&self) -> String {
        let turn = self.rotation_error_max_rad.to_degrees();
        let turn = if turn > 1e-6 { format!(", {}°", significant(turn, 2)) } else { String::new() };
        let tension =
            self.tension_error.map_or_else(String::new, |error| format!(", {} N of tension", significant(error, 3)));
        let parameters = match self.parameter_count {
            0 => String::new(),
            count => format!("{count} parameters, "),
        };
        format!(
            "  {}: left out it costs up to {} mm{turn}{tension} and leaves {:.0} % of what can be reached; with it: {parameters}{}\n",
            self.effect,
            significant(1e3 * self.position_error_max_m, 3),
            100.0 * self.reached_share,
            self.cost
        )
    }
}

impl CandidateAnswer {
    fn new(candidate: &Candidate, advice: &Advice) -> Self {
        Self {
            model: candidate.control.to_string(),
            left_out: candidate.left_out.clone(),
            position_error_m: candidate.position_error,
            rotation_error_rad: candidate.rotation_error,
            tension_error: candidate.tension_error,
            answered_poses: candidate.answered,
            reached_poses: candidate.reached,
            reached_share: advice.reached_share(candidate),
            share_within_tension_limits: candidate.commanded as f64 / advice.poses as f64,
            parameter_count: candidate.parameter_count,
            reason: candidate.reason.clone(),
        }
    }
}

impl Answer for Advised {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self) -> String {
        let mut text = format!(
            "{}: control models against the machine {}, {} poses of the task, {} mm required\n\n",
            self.robot,
            self.machine,
            self.poses,
            significant(1e3 * self.accuracy_m, 3)
        );
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}\n\n"));
        }
        let heading =
            ["control model", "mean mm", "max mm", "max °", "tension N", "answers", "reached", "parameters", "ns"];
        let mut table = Table::new(heading);
        for (candidate, time) in self.candidates.iter().zip(&self.timing.command_ns) {
            let finite = |number: f64| Some(number).filter(|number| number.is_finite());
            let mark = if self.recommended.as_ref() == Some(&candidate.model) { " ←" } else { "" };
            table.row(vec![
                format!("{}{mark}", candidate.model),
                cell(finite(1e3 * candidate.position_error_m.mean), 3),
                cell(finite(1e3 * candidate.position_error_m.max), 3),
                cell(finite(candidate.rotation_error_rad.max.to_degrees()), 4),
                cell(candidate.tension_error, 1),
                format!("{}/{}", candidate.answered_poses, self.poses),
                format!("{:.0} %", 100.0 * candidate.reached_share),
                candidate.parameter_count.to_string(),
                cell(finite(*time), 0),
            ]);
        }
        text.push_str(&table.text());
        if let Some(comparison) = self.comparison() {
            text.push_str(&format!("\n{comparison}\n"));
        }
        if self.attainable_poses < self.poses && self.attainable_poses > 0 {
            text.push_str(&format!(
                "\nreached: of the {} poses that any of the models reaches\n",
                self.attainable_poses
            ));
        }
        if let Some(recommended) = &self.recommended {
            text.push_str(&format!(
                "\nrecommended: {recommended}, the simplest that reaches as much as a model like the machine\n"
            ));
        }
        for (title, effects) in
            [("must be modelled", &self.must_be_modelled), ("may be left out", &self.may_be_left_out)]
        {
            if !effects.is_empty() {
                text.push_str(&format!("\n{title}\n"));
                effects.iter().for_each(|effect| text.push_str(&effect.sentence()));
            }
        }
        if !self.missing.is_empty() {
            text.push_str(&format!(
                "\nnot judged, since the robot file lacks their keys\n  {}\n",
                self.missing.join("\n  ")
            ));
        }
        text
    }
}
