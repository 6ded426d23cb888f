//! The self-contained report: one HTML file whose tables and figures need no script, and whose charts with choices and 3-D scene a script
//! draws from the data in the file; nothing comes from the network.

mod addition;
mod candidates;
mod coverage;
mod criterion;
mod errors;
mod figures;
mod gists;
mod page_data;
mod parameters;
mod rating;
mod table;
#[cfg(test)]
mod tests;
mod verdict;

pub use addition::Addition;
pub use criterion::value_and_error;
pub(crate) use criterion::within;
pub use verdict::times;

use cdpr::geometry::MotionPattern;
use cdpr::identification::Verdict;
use cdpr::identification::selection::{Judgement, Selection, SelectionCriterion, Warnings};
use cdpr::measurement::{Fold, Samples, SensorSigmas};
use cdpr::robot::Robot;
use minijinja::{Value, context};

use crate::html_page::{Page, PageError, PageKind, plain, prose};
use crate::number_format as number;

const TEMPLATE: &str = include_str!("report.html");

/// Question of a report: which model to take, or the parameters of one that was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Candidates were compared and one may be recommended.
    Selection,
    /// One model was identified; another candidate is there to compare it with.
    Identification,
}

/// Contents of a report.
pub struct Report<'a> {
    /// The question.
    pub purpose: Purpose,
    /// The command that makes the same result again.
    pub command: &'a str,
    /// The robot as given, before any fit.
    pub robot: &'a Robot,
    /// All samples, those of the fit and those of the validation.
    pub samples: &'a Samples,
    /// How many of the samples `data_name` has.
    pub data_count: usize,
    /// How the samples were parted.
    pub folds: &'a [Fold],
    /// False where the model is judged by the data that it was fitted to.
    pub is_held_out: bool,
    /// Origin of the samples.
    pub data_name: &'a str,
    /// How validation data were chosen.
    pub validation_name: &'a str,
    /// The candidates and the choice.
    pub selection: &'a Selection,
    /// The error that decides.
    pub criterion: SelectionCriterion,
    /// Seed of the bootstrap.
    pub seed: u64,
    /// Version of the program.
    pub version: &'a str,
    /// Warnings about the data, or all of an identification; text between backticks is shown as code.
    pub warnings: &'a Warnings,
    /// Parts that options of this run ask for.
    pub additions: &'a [Addition],
}

/// A candidate that was judged.
#[derive(Clone, Copy)]
struct Named<'a> {
    index: usize,
    name: &'a str,
    judgement: &'a Judgement,
}

/// The candidate that the details are about, and the one to compare it with.
struct Shown<'a> {
    index: usize,
    name: &'a str,
    judgement: &'a Judgement,
    /// The model that the robot runs without calibration, if that is a candidate.
    as_given: Option<Named<'a>>,
}

impl<'a> Shown<'a> {
    /// The recommended candidate, else the best, else the first that could be identified.
    fn of(selection: &'a Selection) -> Option<Self> {
        let judged = |index: usize| {
            let candidate = selection.candidates.get(index)?;
            Some(Named { index, name: &candidate.name, judgement: candidate.outcome.as_ref().ok()? })
        };
        let Named { index, name, judgement } = judged(selection.shown()?)?;
        let as_given = selection.as_given().and_then(judged);
        Some(Self { index, name, judgement, as_given })
    }
}

impl Report<'_> {
    fn title(&self) -> String {
        let name = &self.robot.name;
        match self.purpose {
            Purpose::Selection => format!("Control models for {name}"),
            Purpose::Identification => format!("Identification of {name}"),
        }
    }

    /// Warnings of text, JSON and page.
    pub(crate) fn told_warnings(&self) -> Warnings {
        match self.purpose {
            Purpose::Selection => self.selection.warnings(self.samples, self.warnings),
            Purpose::Identification => self.warnings.clone(),
        }
    }

    /// How far the recommended or identified model may be relied on, as text and JSON have it.
    pub(crate) fn verdict(&self, warnings: &Warnings) -> Verdict {
        match self.purpose {
            Purpose::Selection => Verdict::of_choice(&warnings.doubts),
            Purpose::Identification => Verdict::of_fit(&warnings.doubts),
        }
    }

    /// Word for a verdict on that model.
    pub(crate) fn status(&self, verdict: Verdict) -> &'static str {
        match self.purpose {
            Purpose::Selection => verdict.choice_status(),
            Purpose::Identification => verdict.fit_status(),
        }
    }

    /// Name of the data by which the models are judged.
    fn data_words(&self) -> &'static str {
        if self.is_held_out { "validation data" } else { "the data of the fit" }
    }
}

impl<'a> Shown<'a> {
    /// The robot as given where it is another candidate.
    fn before(&self) -> Option<Named<'a>> {
        self.as_given.filter(|given| given.index != self.index)
    }
}

/// HTML of the page.
pub fn render(input: &Report<'_>) -> Result<String, PageError> {
    let shown = Shown::of(input.selection);
    let values = context! {
        facts => facts(input),
        gists => gists::all(input, shown.as_ref()),
        verdict => verdict::verdict(input, shown.as_ref()),
        candidates => candidates::table(input),
        additions => addition::all(input.additions),
        rating => rating::rating(input),
        untried => input.selection.untried.iter().map(|words| prose(words)).collect::<Value>(),
        is_selection => input.purpose == Purpose::Selection,
        data_words => input.data_words(),
        shown => shown.as_ref().map(|shown| details(input, shown)),
        command => plain(input.command),
        seed => input.seed,
        criterion => input.criterion.to_string(),
    };
    let data = Some(page_data::json(input, shown.as_ref()));
    let (title, version) = (&input.title(), input.version);
    Page { kind: PageKind::Report, title, class: "wide", template: TEMPLATE, values, data, version }.render()
}

fn details(input: &Report<'_>, shown: &Shown<'_>) -> Value {
    let judgement = shown.judgement;
    context! {
        name => plain(shown.name),
        recommended => input.selection.recommended.is_some(),
        has_validation => judgement.validation.samples > 0,
        has_pose_errors => judgement.validation.position_error_m.mean.is_finite(),
        has_set_aside => !judgement.set_aside.is_empty(),
        has_tensions => judgement.validation.tension_error.is_some(),
        is_thinned => page_data::is_thinned(input, shown),
        errors => errors::before_and_after(input, shown),
        fold_count => judgement.folds.len(),
        folds => errors::folds(input, shown),
        parameter_count => judgement.fit.parameters.len(),
        parameters => parameters::table(shown),
        identifiability => parameters::identifiability(shown),
        coverage => coverage::coverage(input, shown),
        figures => figures::all(input, shown),
    }
}

/// Facts of the report, as pairs of words.
fn facts(input: &Report<'_>) -> Value {
    let robot = input.robot;
    let name = match &robot.title {
        Some(title) => format!("{} ({title})", robot.name),
        None => robot.name.clone(),
    };
    let facts = [
        ("Robot", name),
        ("Cables", robot.cable_count().to_string()),
        ("Motion pattern", pattern_words(robot.motion_pattern)),
        ("Data", input.data_name.to_owned()),
        ("Samples", input.data_count.to_string()),
        ("Validation", input.validation_name.to_owned()),
        ("Sensor accuracy", sigma_words(&input.samples.sigmas)),
        ("Criterion", format!("{} on {}", input.criterion, input.data_words())),
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
