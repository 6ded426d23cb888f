//! The answer in one line, the limits, the reason.

use cdpr::identification::selection::RequirementOutcome;
use minijinja::{Value, context};

use super::table::Cell;
use super::{Purpose, Report, Shown, criterion};
use crate::html_page::prose;
use crate::number_format as number;

/// The first thing a reader sees.
pub(super) fn verdict(report: &Report<'_>, shown: Option<&Shown<'_>>) -> Value {
    let reason = prose(report.selection.reason.trim_end_matches('.'));
    let Some(shown) = shown else {
        return context! { class => "bad", heading => "No candidate could be identified", name => "", line => "",
        comparison => "", doubts => no_values(), requirements => no_values(), reason };
    };
    let judgement = shown.judgement;
    let met = judgement.requirements.iter().all(|requirement| requirement.met);
    let single = report.selection.candidates.len() == 1 || report.purpose == Purpose::Identification;
    let mut doubts: Vec<String> = report.selection.outlier_warnings(report.samples);
    doubts.extend(report.selection.warnings.iter().cloned());
    let cautious = !doubts.is_empty() || !judgement.fit.cautions().is_empty() || judgement.validation.not_converged > 0;
    let trusted = judgement.distrust.reasons.is_empty();
    let (class, heading) = match (report.selection.recommended.is_some(), single) {
        (true, false) if !trusted => ("bad", "Recommended control model, not to be trusted"),
        (_, true) if met && !trusted => ("bad", "Identified control model, not to be trusted"),
        (true, false) if cautious => ("bad", "Recommended control model, with a caution"),
        (true, false) => ("good", "Recommended control model"),
        (_, true) if met && !cautious => ("good", "Identified control model"),
        (_, true) if met => ("bad", "Identified control model, with a caution"),
        (_, true) => ("bad", "Identified control model, which breaks a requirement"),
        (false, false) if report.selection.best.is_none() => ("bad", "No candidate can be judged; the first one"),
        (false, false) => ("bad", "No candidate recommended; the best on validation data"),
    };
    let requirements: Value = judgement.requirements.iter().map(requirement).collect();
    let name = Cell::code(shown.name).into_text();
    let doubts: Value = doubts.iter().map(|doubt| prose(doubt)).collect();
    context! { class, heading, name, doubts, line => line(report, shown), comparison => prose(&comparison(report, shown)), requirements,
    reason }
}

fn no_values() -> Value {
    Vec::<Value>::new().into_iter().collect()
}

/// The criterion, its limit where there is one, and whether it is kept, e.g. "Validation mean position error 4.1 mm, limit 5 mm:
/// pass". A limit on another figure decides where the criterion has none or keeps its own.
fn line(report: &Report<'_>, shown: &Shown<'_>) -> String {
    let judgement = shown.judgement;
    let words = report.criterion.to_string();
    let value = match judgement.validation.samples {
        0 => criterion::words(report.criterion, report.criterion.of_blocks(&judgement.train)),
        _ => criterion::with_error(report.criterion, judgement.criterion, judgement.standard_error),
    };
    let value = value.unwrap_or_else(|| "has no value: the forward problem has no answer".to_owned());
    let data = match (report.is_held_out, judgement.validation.samples) {
        (true, 1..) => "Validation",
        _ => "Data of the fit:",
    };
    let limits = &judgement.requirements;
    let own = limits.iter().find(|limit| limit.metric.starts_with(report.criterion.metric()));
    let limit = own.map_or_else(String::new, |own| format!(", limit {}", figure(own.metric, own.limit, number::short)));
    let broken: Vec<String> =
        limits.iter().filter(|limit| !limit.met).map(|limit| metric_words(limit.metric)).collect();
    let outcome = match (limits.is_empty(), broken.is_empty()) {
        (true, _) => "; no limit was set".to_owned(),
        (false, true) => ": pass".to_owned(),
        (false, false) if own.is_some_and(|own| !own.met) && broken.len() == 1 => ": fail".to_owned(),
        (false, false) => format!(": fail ({})", broken.join(", ")),
    };
    format!("{data} {words} {value}{limit}{outcome}")
}

fn comparison(report: &Report<'_>, shown: &Shown<'_>) -> String {
    let Some(given) = shown.before() else { return String::new() };
    let (before, after) = match shown.judgement.validation.samples {
        0 => {
            let of = |blocks| report.criterion.of_blocks(blocks);
            (of(&given.judgement.train), of(&shown.judgement.train))
        }
        _ => (given.judgement.criterion, shown.judgement.criterion),
    };
    let ratio = before / after;
    let before = criterion::words(report.criterion, before).unwrap_or_else(|| "no value".to_owned());
    format!("today, `{}` as given: {before}{}", given.name, times(ratio))
}

/// How an error compares with the one of the verdict, `ratio` times as large; nothing where one of them is unknown.
pub fn times(ratio: f64) -> String {
    match ratio.is_finite() && ratio > 0.0 {
        true if ratio >= 1.0 => format!(", {} times as large", number::significant(ratio, 2)),
        true => format!(", smaller by the factor {}", number::significant(1.0 / ratio, 2)),
        false => String::new(),
    }
}

fn requirement(outcome: &RequirementOutcome) -> Value {
    let (value, limit) = (
        figure(outcome.metric, outcome.value, |value| number::significant(value, 4)),
        figure(outcome.metric, outcome.limit, number::short),
    );
    let name = format!("{} ({})", metric_words(outcome.metric), outcome.metric);
    let text = match outcome.value.is_finite() {
        true if outcome.met => format!("{name} = {value}, within the limit {limit}"),
        true if outcome.value > outcome.limit => format!("{name} = {value}, above the limit {limit}"),
        true => format!(
            "{name} = {value} of the {} of {} samples that have an answer, limit {limit}",
            outcome.samples_with_value, outcome.samples
        ),
        false => format!("{name} has no value, limit {limit}"),
    };
    context! { met => outcome.met, text }
}

/// A figure in the unit that the end of its name tells, for people.
fn figure(metric: &str, value: f64, write: fn(f64) -> String) -> String {
    match metric {
        angle if angle.ends_with("_rad") => format!("{}°", write(value.to_degrees())),
        force if force.ends_with("_N") => format!("{} N", write(value)),
        _ => format!("{} mm", write(1e3 * value)),
    }
}

/// `position_p95_m` as "95 % position error".
fn metric_words(metric: &str) -> String {
    let (quantity, rest) = metric.split_once('_').unwrap_or((metric, ""));
    let statistic = rest.rsplit_once('_').map_or(rest, |(statistic, _)| statistic);
    let statistic = match statistic {
        "p95" => "95 %",
        "max" => "largest",
        "mean_abs" => "mean",
        "mean_norm" => "mean 2-norm of the",
        other => other,
    };
    let quantity = if quantity == "length" { "cable-length" } else { quantity };
    format!("{statistic} {quantity} error")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_the_unit_of_their_name() {
        let short = |metric, value| figure(metric, value, number::short);
        assert_eq!(short("position_mean_m", 0.005), "5 mm");
        assert_eq!(short("rotation_max_rad", std::f64::consts::PI / 180.0), "1°");
        assert_eq!(short("tension_rms_N", 50.0), "50 N");
        assert_eq!(metric_words("length_mean_abs_m"), "mean cable-length error");
        assert_eq!(metric_words("tension_mean_norm_N"), "mean 2-norm of the tension error");
    }
}
