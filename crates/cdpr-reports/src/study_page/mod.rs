//! The page of a study: one HTML file with the errors of its poses and of regions around them.
//!
//! Everything the page shows was computed here: its program draws, and subtracts vectors that it shows side by side.

mod contents;
mod field_tables;
pub(crate) mod page_data;
mod region;
mod tables;
#[cfg(test)]
mod tests;

use cdpr_model::model::Model;
use cdpr_study::Experiment;
use cdpr_study::field::{Field, Sample, Summary};
use minijinja::{Value, context};

use crate::html_page::{Page, PageKind, plain, prose};
use crate::number_format::{short, significant};
pub use contents::{StudyPage, StudyPageError};
pub(crate) use field_tables::{SAME_HEIGHT, levels};
pub use field_tables::{error_maps, errors_table, tracking_figure};
use region::Region;

const TEMPLATE: &str = include_str!("study.html");

/// Computes the regions; HTML of the page.
pub fn render(page: &StudyPage<'_>) -> Result<String, StudyPageError> {
    let regions = region::regions(page.experiment, page.found)?;
    let machine = &page.experiment.machine;
    let robot = machine.robot();
    let title = format!("Study {}", page.name);
    let is_planar = robot.motion_pattern.is_planar();
    let data = Some(page_data::json(page, &regions));
    let values = context! {
        is_planar,
        turns => robot.motion_pattern.has_rotation(),
        has_tensions => page.experiment.tensions_emerge(),
        headline => headline(&page.found.summary),
        comparison => comparison(&page.found.summary),
        facts => facts(page),
        regions => regions.iter().map(Region::statement).collect::<Vec<_>>(),
        has_physical => regions.iter().any(|region| region.physical.is_some()),
        reached => regions.iter().find_map(|region| region.reachable.as_ref()).map(|_| reached_words(page.experiment)),
        errors => tables::errors(&page.found.summary, robot.motion_pattern.has_rotation()),
        poses => tables::poses(page),
        tracking => tracking_figure(page.found, machine).map(|figure| Value::from_safe_string(figure.inline())),
        more_poses => page.found.samples.len().saturating_sub(tables::MOST_POSES),
        warnings => warnings(page).iter().map(|warning| prose(warning)).collect::<Vec<_>>(),
        command => plain(page.command),
        seed => page.seed,
    };
    let page = Page {
        kind: PageKind::Study,
        title: &title,
        class: "wide",
        template: TEMPLATE,
        values,
        data,
        version: page.version,
    };
    Ok(page.render()?)
}

fn headline(summary: &Summary) -> String {
    match summary.converged {
        0 => "No pose has an answer".to_owned(),
        _ => format!("{} mm", significant(1e3 * summary.position_error_m.mean, 4)),
    }
}

/// Sentence below the headline.
fn comparison(summary: &Summary) -> String {
    let poses = match (summary.converged, summary.samples) {
        (answered, all) if answered < all => format!("{answered} of {all} poses; the others have no answer"),
        (_, 1) => "1 pose".to_owned(),
        (_, all) => format!("{all} poses"),
    };
    let relative = summary.relative_position_error.map(|share| {
        format!(", {} % of the {} m across them", significant(100.0 * share, 3), significant(summary.diameter_m, 3))
    });
    let linear = significant(1e3 * summary.linear_position_error_m.mean, 4);
    let alone = summary.compensation.as_ref().map(|map| 1e3 * map.without.position_error_m.mean);
    let alone = alone.filter(|mean| mean.is_finite());
    let alone = alone.map(|mean| format!(" Without its map the control model misses by {} mm.", significant(mean, 4)));
    let (relative, alone) = (relative.unwrap_or_default(), alone.unwrap_or_default());
    format!("Over {poses}{relative}. One linear step says {linear} mm.{alone}")
}

fn facts(page: &StudyPage<'_>) -> Value {
    let experiment = page.experiment;
    let title = |model: &Model| {
        let robot = model.robot();
        let name = robot.title.as_ref().map_or_else(|| robot.name.clone(), |title| format!("{} ({title})", robot.name));
        format!("{name}, model {}", model.composition())
    };
    let map = experiment.study.control.compensation.as_ref();
    let corrected = map.map_or_else(String::new, |file| format!(", corrected by {file}"));
    let offsets: Vec<String> = experiment.offsets.iter().map(|offset| significant(1e3 * offset, 3)).collect();
    let mut facts = vec![
        ("Control model", title(&experiment.control) + &corrected),
        ("Machine", title(&experiment.machine)),
        ("Poses", page.found.samples.len().to_string()),
        ("Winch offsets", format!("{} mm", offsets.join(", "))),
    ];
    if let Some(limits) = experiment.requirements().tensions {
        let same = |values: &[f64]| values.iter().all(|value| Some(value) == values.first());
        let words = match (limits.minimum(), limits.maximum()) {
            ([low, ..], [high, ..]) if same(limits.minimum()) && same(limits.maximum()) => {
                format!("{} N to {} N", short(*low), short(*high))
            }
            _ => "of each cable".to_owned(),
        };
        facts.push(("Tension limits", words));
    }
    facts.into_iter().map(|(term, text)| context! { term, text => plain(&text) }).collect()
}

/// Rule by which a pose counts as reached.
fn reached_words(experiment: &Experiment) -> String {
    let limits = experiment.study.limits.as_ref();
    let most = limits.and_then(|limits| limits.position_error_max_m);
    let tracked = limits.and_then(|limits| limits.tension_error_max_N);
    let rule = match (most, experiment.requirements().tensions.is_some()) {
        (Some(most), true) => format!(
            "the tensions that emerge keep the limits and the position error is at most {} mm",
            short(1e3 * most)
        ),
        (Some(most), false) => format!("the position error is at most {} mm", short(1e3 * most)),
        (None, _) => "the tensions that emerge keep the limits".to_owned(),
    };
    let tracked =
        tracked.map(|most| format!(", and no tension is farther than {} N from the commanded one", short(most)));
    rule + &tracked.unwrap_or_default()
}

fn warnings(page: &StudyPage<'_>) -> Vec<String> {
    let Field { samples, summary } = page.found;
    let mut warnings = page.warnings.to_vec();
    let poses = |count: usize| format!("{count} of {} poses", samples.len());
    if let Some(limits) = page.experiment.limits() {
        let is_outside = |sample: &&Sample| {
            let tensions = sample.outcome.tensions.as_deref().unwrap_or(&[]);
            let ends = limits.minimum().iter().zip(limits.maximum());
            sample.exact.is_some() && tensions.iter().zip(ends).any(|(f, (low, high))| f < low || f > high)
        };
        let outside = samples.iter().filter(is_outside).count();
        if outside > 0 {
            warnings.push(format!("tensions leave their limits at {}", poses(outside)));
        }
    }
    if summary.converged > 0 && summary.linear_trusted_share < 0.5 {
        let share = 100.0 * (1.0 - summary.linear_trusted_share);
        warnings.push(format!(
            "the linear step misses the exact error by more than a tenth of it at {share:.0} % of the poses"
        ));
    }
    if page_data::is_thinned(page) {
        warnings.push("the drawing holds a part of the poses, evenly spaced and the worst one; tables and `errors.csv` are of all".to_owned());
    }
    warnings
}
