//! The answer in one line, the limits, the reason.

use cdpr::identification::fit::Status;
use cdpr::identification::selection::RequirementOutcome;
use minijinja::{Value, context};

use super::table::{Cell, prose};
use super::{Purpose, Report, Shown, criterion, number};

/// The first thing a reader sees.
pub(super) fn verdict(report: &Report<'_>, shown: Option<&Shown<'_>>) -> Value {
    let reason = prose(report.selection.reason.trim_end_matches('.'));
    let Some(shown) = shown else {
        return context! { class => "bad", heading => "No candidate could be identified", name => "", figure => "",
        comparison => "", requirements => Value::from_iter(Vec::<Value>::new()), reason };
    };
    let judgement = shown.judgement;
    let met = judgement.requirements.iter().all(|requirement| requirement.met);
    let single = report.selection.candidates.len() == 1 || report.purpose == Purpose::Identification;
    let (class, heading) = match (report.selection.recommended.is_some(), single) {
        (true, false) => ("good", "Recommended control model"),
        (_, true) if met && judgement.fit.status == Status::Converged => ("good", "Identified control model"),
        (_, true) if met => ("bad", "Identified control model, with a caution"),
        (_, true) => ("bad", "Identified control model, which breaks a requirement"),
        (false, false) => ("bad", "No candidate recommended; the best on validation data"),
    };
    let requirements: Value = judgement.requirements.iter().map(requirement).collect();
    let name = Cell::code(shown.name).into_text();
    context! { class, heading, name, figure => figure(report, shown), comparison => comparison(report, shown), requirements,
    reason }
}

fn figure(report: &Report<'_>, shown: &Shown<'_>) -> String {
    let judgement = shown.judgement;
    let words = report.criterion.words();
    match judgement.validation.samples {
        0 => {
            let value = report.criterion.of_blocks(&judgement.train);
            format!("{words} on training data: {}", criterion::words(report.criterion, value))
        }
        _ => {
            let value = criterion::with_error(report.criterion, judgement.criterion, judgement.standard_error);
            format!("{words} on validation data: {value}")
        }
    }
}

fn comparison(report: &Report<'_>, shown: &Shown<'_>) -> String {
    let Some(given) = shown.as_given.filter(|given| given.name != shown.name) else { return String::new() };
    let (before, after) = match shown.judgement.validation.samples {
        0 => {
            let of = |blocks| report.criterion.of_blocks(blocks);
            (of(&given.judgement.train), of(&shown.judgement.train))
        }
        _ => (given.judgement.criterion, shown.judgement.criterion),
    };
    let ratio = before / after;
    let times = match ratio.is_finite() && ratio > 0.0 {
        true if ratio >= 1.0 => format!(", {} times as large", number::significant(ratio, 2)),
        true => format!(", smaller by the factor {}", number::significant(ratio, 2)),
        false => String::new(),
    };
    format!("as given: {}{times}", criterion::words(report.criterion, before))
}

fn requirement(outcome: &RequirementOutcome) -> Value {
    let is_angle = outcome.metric.ends_with("_rad");
    let (value, limit) = match is_angle {
        true => {
            (format!("{}°", number::degrees(outcome.value)), format!("{}°", number::short(outcome.limit.to_degrees())))
        }
        false => {
            (format!("{} mm", number::millimetres(outcome.value)), format!("{} mm", number::short(1e3 * outcome.limit)))
        }
    };
    let relation = if outcome.met { "within" } else { "above" };
    let text = format!("{} = {value}, {relation} the limit {limit}", outcome.metric);
    context! { met => outcome.met, text }
}
