//! The answer in one line, its warnings, the limits, the reason.

use cdpr_calibration::Verdict;
use cdpr_calibration::selection::{Judgement, RequirementOutcome};
use minijinja::{Value, context};

use super::table::Cell;
use super::{Purpose, ReportPage, Shown};
use crate::html_page::prose;
use crate::number_format as number;

/// A reason of more letters folds, so that the first screen has room for the figures.
const LONG_REASON: usize = 560;

/// The first thing a reader sees: the outcome, whose colour says how far to rely on it, and every warning.
pub(super) fn verdict(page: &ReportPage<'_>, shown: Option<&Shown<'_>>) -> Value {
    let reason = page.answer.reason.trim_end_matches('.');
    let is_long = reason.chars().count() > LONG_REASON;
    let reason = prose(reason);
    let warnings = &page.answer.warnings.list();
    let folded = warnings.len() - unfolded(warnings);
    let (class, heading) = match shown {
        None => ("bad", "No candidate could be identified".to_owned()),
        Some(shown) => outcome(page, shown),
    };
    let warnings: Value = warnings.iter().map(|warning| prose(warning)).collect();
    let Some(shown) = shown else {
        return context! { class, heading, name => "", label => "", line => "", comparison => "", requirements => no_values(), warnings, folded, reason, is_long };
    };
    let requirements: Value = shown.judgement.requirements.iter().map(requirement).collect();
    let name = Cell::code(shown.name).into_text();
    let label = prose(&page.answer.candidates[shown.index].label);
    let comparison = prose(&comparison(page, shown));
    context! { class, heading, name, label, line => line(page, shown), comparison, requirements, warnings, folded, reason, is_long }
}

/// Class and heading: good without any doubt only.
fn outcome(page: &ReportPage<'_>, shown: &Shown<'_>) -> (&'static str, String) {
    let judgement = shown.judgement;
    let is_met = judgement.requirements.iter().all(|requirement| requirement.met);
    let is_single = page.answer.candidates.len() == 1 || page.report.purpose == Purpose::Identification;
    let what = match (page.answer.places.recommended.is_some(), is_single) {
        (true, false) => "Recommended control model",
        (_, true) if is_met => "Identified control model",
        (_, true) => return ("bad", "Identified control model, which breaks a requirement".to_owned()),
        (false, false) if page.answer.places.best.is_none() => {
            return ("bad", "No candidate can be judged; the first one".to_owned());
        }
        (false, false) => return ("bad", "No candidate recommended; the best on validation data".to_owned()),
    };
    match page.answer.verdict {
        Verdict::Sound => ("good", what.to_owned()),
        Verdict::WithCaution => ("warned", format!("{what}, to be used with caution")),
        Verdict::NotIdentifiable => ("bad", format!("{what}, whose parameters the data do not determine")),
        Verdict::NotTrusted => ("bad", format!("{what}, not to be trusted")),
        Verdict::NotPredictive => ("bad", format!("{what}, which predicts no poses")),
        Verdict::NotConverged => ("bad", format!("{what}, whose fit did not converge")),
    }
}

/// Warnings that are shown before the others fold: what fits beside a verdict, and the first in any case.
fn unfolded(warnings: &[String]) -> usize {
    const MOST: usize = 3;
    const LETTERS: usize = 600;
    let mut letters = 0;
    let fits = |warning: &&String| {
        letters += warning.chars().count();
        letters <= LETTERS
    };
    let count = warnings.iter().take(MOST).take_while(fits).count();
    // one more line costs no more than to say that there is one more
    let rest = warnings.len() - count;
    if rest == 1 && count > 0 && warnings[count].chars().count() < 120 {
        count + 1
    } else {
        count.max(warnings.len().min(1))
    }
}

fn no_values() -> Value {
    Vec::<Value>::new().into_iter().collect()
}

/// The criterion, its limit where there is one, and whether it is kept, e.g. "Validation mean position error 4.1 mm, limit 5 mm:
/// pass". A limit on another figure decides where the criterion has none or keeps its own.
fn line(page: &ReportPage<'_>, shown: &Shown<'_>) -> String {
    let judgement = shown.judgement;
    let words = page.answer.criterion.to_string();
    let (value, error) = match judgement.validation.samples {
        0 => (page.answer.criterion.of_blocks(&judgement.train), f64::NAN),
        _ => (judgement.criterion, judgement.standard_error),
    };
    let value = match value.is_finite() {
        true => page.answer.criterion.format_with_error(value, error),
        false => "has no value: the forward problem has no answer".to_owned(),
    };
    let data = match (page.report.is_held_out, judgement.validation.samples) {
        (true, 1..) => "Validation",
        _ => "Data of the fit:",
    };
    let limits = &judgement.requirements;
    let own = limits.iter().find(|limit| limit.metric.starts_with(page.answer.criterion.metric()));
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

fn comparison(page: &ReportPage<'_>, shown: &Shown<'_>) -> String {
    let Some(given) = shown.before() else { return String::new() };
    let value = |judgement: &Judgement| match shown.judgement.validation.samples {
        0 => (page.answer.criterion.of_blocks(&judgement.train), f64::NAN),
        _ => (judgement.criterion, judgement.standard_error),
    };
    let ((before, error), (after, _)) = (value(given.judgement), value(shown.judgement));
    let words = page.answer.criterion.format_with_error(before, error);
    format!("today, `{}` as given: {words}{}", given.name, times(before / after))
}

/// How an error compares with the one of the verdict, `ratio` times as large; empty if one of them is unknown.
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
    fn the_first_warning_never_folds_and_long_lists_do() {
        let of = |lengths: &[usize]| unfolded(&lengths.iter().map(|&length| "a".repeat(length)).collect::<Vec<_>>());
        assert_eq!(
            [of(&[]), of(&[2000]), of(&[2000, 10]), of(&[100; 3]), of(&[100; 4]), of(&[150; 5])],
            [0, 1, 1, 3, 4, 3]
        );
    }

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
