//! Lines beside the titles of folded parts: what each comes to.

use cdpr_calibration::selection::Judgement;
use minijinja::{Value, context};

use super::{Purpose, ReportPage, Shown, coverage, parameters, within};
use crate::html_page::plain;
use crate::number_format as number;

/// A line for every part, named like its section.
pub(super) fn all(page: &ReportPage<'_>, shown: Option<&Shown<'_>>) -> Value {
    let data =
        format!("{} samples of {}, {} cables", page.answer.samples, page.answer.data, page.report.robot.cable_count());
    let common = context! {
        data => plain(&data),
        candidates => candidates(page),
        reproduce => format!("the command, version {}", page.report.version),
    };
    let Some(shown) = shown else { return common };
    let fit = &shown.judgement.fit;
    let steps = if fit.iterations == 1 { "step" } else { "steps" };
    context! {
        scene => scene(shown),
        errors => errors(page, shown),
        parameters => parameters_words(shown),
        identifiability => identifiability(shown),
        residuals => residuals(shown),
        convergence => format!("{} after {} {steps}", parameters::status(fit.status), fit.iterations),
        coverage => coverage::gist(page),
        ..common
    }
}

/// Contents of the scene.
fn scene(shown: &Shown<'_>) -> &'static str {
    match shown.judgement.validation.position_error_m.mean.is_finite() {
        true => "as given and as calibrated, with the errors",
        false => "as given and as calibrated",
    }
}

/// The criterion of the model as given and of the one shown.
fn errors(page: &ReportPage<'_>, shown: &Shown<'_>) -> String {
    let kind = page.answer.criterion;
    let value = |judgement: &Judgement| match judgement.validation.samples {
        0 => within(kind, kind.of_blocks(&judgement.train), f64::NAN),
        _ => within(kind, judgement.criterion, judgement.standard_error),
    };
    let after = value(shown.judgement);
    match shown.before() {
        Some(given) => format!("{kind} {} as given, {after} calibrated", value(given.judgement)),
        None => format!("{kind} {after}"),
    }
}

fn candidates(page: &ReportPage<'_>) -> String {
    let all = &page.answer.candidates;
    let is_judged = |judged: Option<&Judgement>| judged.is_some_and(|judged| judged.disqualified.is_none());
    let unjudged = all.iter().filter(|candidate| !is_judged(candidate.judged)).count();
    let words = match (page.report.purpose, all.len()) {
        (Purpose::Identification, _) => "the model as given and the identified one".to_owned(),
        (_, 1) => "one was compared".to_owned(),
        (_, count) => format!("{count} were compared"),
    };
    let rest = if unjudged > 0 { format!(", {unjudged} of them cannot be judged") } else { String::new() };
    let untried = if page.answer.untried.is_empty() || page.report.purpose == Purpose::Identification {
        ""
    } else {
        "; what was not tried, and why"
    };
    format!("{words}{rest}{untried}")
}

fn parameters_words(shown: &Shown<'_>) -> String {
    let fit = &shown.judgement.fit;
    let at_bound = match fit.at_bound().count() {
        0 => String::new(),
        count => format!(", {count} at a bound"),
    };
    match fit.parameters.len() {
        0 => "none is free".to_owned(),
        1 => format!("one is free{at_bound}"),
        count => format!("{count} are free{at_bound}"),
    }
}

fn identifiability(shown: &Shown<'_>) -> String {
    let fit = &shown.judgement.fit;
    if fit.parameters.is_empty() {
        return format!("noise factor {}", number::significant(fit.noise_factor, 3));
    }
    let weak = match fit.analysis.weak_direction_count {
        0 => "no weak direction".to_owned(),
        1 => "one weak direction".to_owned(),
        count => format!("{count} weak directions"),
    };
    let condition = number::condition(fit.analysis.condition);
    format!("rank {} of {}, {weak}, condition {condition}", fit.analysis.rank, fit.parameters.len())
}

fn residuals(shown: &Shown<'_>) -> String {
    let errors = &shown.judgement.validation;
    let length = format!("cable length {} mm rms", number::significant(1e3 * errors.length_error_m.rms, 3));
    match errors.tension_error.filter(|error| error.rms.is_finite()) {
        Some(tension) => format!("{length}, tension {} N rms", number::significant(tension.rms, 3)),
        None => length,
    }
}
