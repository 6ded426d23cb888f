//! Control models for a task, in words.

use cdpr_model::reading::Keyword;
use cdpr_study::advice::ParameterError;

use crate::number_format::significant;

use super::{AdviceAnswer, Answer, EffectAnswer};
use crate::number_format::{NONE, cell};
use crate::sensitivity::{amount, step};
use crate::table::Table;

impl Answer for AdviceAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
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
        for (own, time) in self.candidates.iter().zip(&self.timing.command_ns) {
            let candidate = &own.candidate;
            let model = candidate.control.to_string();
            let finite = |number: f64| Some(number).filter(|number| number.is_finite());
            let mark = if self.recommended.as_ref() == Some(&model) { " ←" } else { "" };
            table.row(vec![
                format!("{model}{mark}"),
                cell(finite(1e3 * candidate.position_error.mean), 3),
                cell(finite(1e3 * candidate.position_error.max), 3),
                cell(finite(candidate.rotation_error.max.to_degrees()), 4),
                cell(candidate.tension_error, 1),
                format!("{}/{}", candidate.answered, self.poses),
                format!("{:.0} %", 100.0 * own.reached_share),
                candidate.parameter_count.to_string(),
                cell(finite(*time), 0),
            ]);
        }
        text.push_str(&table.text(width));
        if let Some(comparison) = comparison(self) {
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
                "\nrecommended: {recommended}, the simplest that reaches as much as a model like the machine{}\n",
                self.without()
            ));
            text.push_str(&self.numbers(width));
        }
        for (title, effects) in
            [("must be modelled", &self.must_be_modelled), ("may be left out", &self.may_be_left_out)]
        {
            if !effects.is_empty() {
                text.push_str(&format!("\n{title}\n"));
                effects.iter().for_each(|effect| text.push_str(&sentence(effect)));
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

/// Kinds of numbers in the words, the most influential.
const MOST_KINDS: usize = 6;

impl AdviceAnswer {
    /// Effects that nothing was judged with, behind the verdict.
    fn without(&self) -> String {
        match self.not_judged.as_slice() {
            [] => String::new(),
            effects => format!("; not judged: {}, whose keys the robot file lacks", effects.join(", ")),
        }
    }

    /// Errors of the recommended model's numbers.
    fn numbers(&self, width: Option<usize>) -> String {
        let moves = |error: &ParameterError| step(error.kind).0 * error.position_max;
        let mut kinds: Vec<&ParameterError> = self.parameter_errors.iter().collect();
        kinds.sort_by(|a, b| moves(b).total_cmp(&moves(a)));
        let mut table =
            Table::new(["all of a kind off", "by (σ)", "moves rms mm", "worst pose mm", "may be off by (σ)"])
                .left_column(1);
        for error in kinds.iter().take(MOST_KINDS) {
            let (factor, each) = step(error.kind);
            let moved = |way: f64| significant(1e3 * factor * way, 3);
            table.row(vec![
                format!("{} {}", error.side.name(), error.kind),
                each.to_owned(),
                moved(error.position_rms),
                moved(error.position_max),
                error.allowed.map_or_else(|| NONE.to_owned(), |sigma| amount(sigma, error.kind.unit())),
            ]);
        }
        match kinds.is_empty() {
            true => String::new(),
            false => format!(
                "\nerrors of its numbers come on top, to first order; each kind alone may be off so far that two deviations keep {} mm\n{}",
                significant(1e3 * self.accuracy_m, 3),
                table.text(width)
            ),
        }
    }
}

/// Poses at which errors are compared, in words, where models lack answers.
fn comparison(answer: &AdviceAnswer) -> Option<String> {
    let mut candidates = answer.candidates.iter().map(|own| &own.candidate);
    let all = candidates.clone().all(|candidate| candidate.answered == answer.poses);
    let lacking = candidates.find(|candidate| candidate.answered < answer.poses);
    (!all).then(|| {
        let why = lacking.and_then(|candidate| candidate.reason.as_ref().map(|reason| (&candidate.control, reason)));
        let why = why.map_or_else(String::new, |(model, reason)| format!("; `{model}`: {reason}"));
        match answer.compared_poses {
            0 => format!("there is no pose at which every model has an answer, so that errors cannot be compared{why}"),
            compared => format!(
                "errors are those at the {compared} of {} poses where every model that answers at all has an answer{why}",
                answer.poses
            ),
        }
    })
}

/// The effect in one line.
fn sentence(effect: &EffectAnswer) -> String {
    let turn = effect.without.rotation_error.max.to_degrees();
    let turn = if turn > 1e-6 { format!(", {}°", significant(turn, 2)) } else { String::new() };
    let tension = effect
        .without
        .tension_error
        .map_or_else(String::new, |error| format!(", {} N of tension", significant(error, 3)));
    let parameters = match effect.parameter_count {
        0 => String::new(),
        count => format!("{count} parameters, "),
    };
    format!(
        "  {}: left out it costs up to {} mm{turn}{tension} and leaves {:.0} % of what can be reached; with it: {parameters}{}\n",
        effect.effect,
        significant(1e3 * effect.without.position_error.max, 3),
        100.0 * effect.reached_share,
        effect.cost
    )
}
