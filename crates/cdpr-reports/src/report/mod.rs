//! The self-contained report: one HTML file whose tables and figures need no script, and whose charts with choices and 3-D scene a script
//! draws from the data in the file; nothing comes from the network.

mod addition;
mod candidates;
mod contents;
mod coverage;
mod criterion;
mod errors;
mod figures;
mod gists;
pub(crate) mod page_data;
mod parameters;
mod rating;
mod shown;
mod table;
#[cfg(test)]
mod tests;
mod verdict;

pub use addition::Addition;
pub use contents::{Purpose, Report};
pub use criterion::value_and_error;
pub(crate) use criterion::within;
use shown::{ReportPage, Shown};
pub use verdict::times;

use cdpr_calibration::selection::{Judgement, SelectionCriterion};
use cdpr_model::geometry::MotionPattern;
use cdpr_model::measurement::SensorSigmas;
use minijinja::{Value, context};

use crate::answers::SelectionAnswer;
use crate::html_page::{Page, PageError, PageKind, plain, prose};
use crate::number_format as number;

const TEMPLATE: &str = include_str!("report.html");

/// HTML of the page.
pub fn render(input: &Report<'_>) -> Result<String, PageError> {
    let page = ReportPage { report: input, answer: SelectionAnswer::new(input) };
    let (shown, answer) = (Shown::of(&page.answer), &page.answer);
    let values = context! {
        facts => facts(&page),
        gists => gists::all(&page, shown.as_ref()),
        verdict => verdict::verdict(&page, shown.as_ref()),
        candidates => candidates::table(&page),
        additions => addition::all(input.additions),
        rating => rating::rating(&page),
        untried => answer.untried.iter().map(|words| prose(words)).collect::<Value>(),
        is_selection => input.purpose == Purpose::Selection,
        data_words => input.data_words(),
        shown => shown.as_ref().map(|shown| details(&page, shown)),
        command => plain(input.command),
        seed => answer.seed,
        criterion => answer.criterion.to_string(),
    };
    let data = Some(page_data::json(&page, shown.as_ref()));
    let (title, version) = (&input.title(), input.version);
    Page { kind: PageKind::Report, title, class: "wide", template: TEMPLATE, values, data, version }.render()
}

fn details(page: &ReportPage<'_>, shown: &Shown<'_>) -> Value {
    let judgement = shown.judgement;
    context! {
        name => plain(shown.name),
        recommended => page.answer.recommended.is_some(),
        has_validation => judgement.validation.samples > 0,
        has_pose_errors => judgement.validation.position_error_m.mean.is_finite(),
        ladder_words => ladder_words(page.answer.criterion, judgement),
        has_pose_band => judgement.pose_band.is_some(),
        has_set_aside => !judgement.set_aside.is_empty(),
        has_tensions => judgement.validation.tension_error.is_some(),
        is_thinned => page_data::is_thinned(page, shown),
        errors => errors::before_and_after(page, shown),
        fold_count => judgement.folds.len(),
        folds => errors::folds(page, shown),
        parameter_count => judgement.fit.parameters.len(),
        parameters => parameters::table(shown),
        identifiability => parameters::identifiability(shown),
        coverage => coverage::coverage(page, shown),
        figures => figures::all(page, shown),
    }
}

/// Error by which the ladder compares candidates.
fn ladder_words(criterion: SelectionCriterion, judgement: &Judgement) -> String {
    match judgement.is_compared_by_pose {
        true => "mean pose error (distance and turn of the platform anchors together, so that it is more than the position error alone)".to_owned(),
        false => criterion.to_string(),
    }
}

/// Facts of the report, as pairs of words.
fn facts(ReportPage { report, answer }: &ReportPage<'_>) -> Value {
    let robot = report.robot;
    let name = match &robot.title {
        Some(title) => format!("{} ({title})", robot.name),
        None => robot.name.clone(),
    };
    let facts = [
        ("Robot", name),
        ("Cables", robot.cable_count().to_string()),
        ("Motion pattern", pattern_words(robot.motion_pattern)),
        ("Data", answer.data.clone()),
        ("Samples", answer.samples.to_string()),
        ("Validation", answer.validation.clone()),
        ("Sensor accuracy", sigma_words(&report.samples.sigmas)),
        ("Criterion", format!("{} on {}", answer.criterion, report.data_words())),
    ];
    facts.into_iter().map(|(term, text)| context! { term, text => plain(&text) }).collect()
}

fn pattern_words(pattern: MotionPattern) -> String {
    let words = match pattern {
        MotionPattern::PlanarPoint => "a point in a plane",
        MotionPattern::SpatialPoint => "a point in space",
        MotionPattern::Planar => "a platform in a plane",
        MotionPattern::Spatial => "all six degrees of freedom",
        _ => "see the robot's file",
    };
    format!("{}: {words}", pattern.name())
}

fn sigma_words(sigmas: &SensorSigmas) -> String {
    let known = [
        sigmas.position.map(|sigma| format!("position {} mm per axis", number::short(1e3 * sigma))),
        sigmas.rotation.map(|sigma| format!("rotation {}° per axis", number::significant(sigma.to_degrees(), 3))),
        sigmas.length.map(|sigma| format!("cable length {} mm", number::short(1e3 * sigma))),
        sigmas.tension.map(|sigma| format!("tension {} N", number::short(sigma))),
    ];
    let known: Vec<String> = known.into_iter().flatten().collect();
    if known.is_empty() { "not known".to_owned() } else { format!("{} (standard deviations)", known.join(", ")) }
}
