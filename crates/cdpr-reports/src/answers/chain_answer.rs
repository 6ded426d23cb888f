//! The chain of chapter 6, stage by stage, beside the errors that its study quotes from a publication.

use cdpr_study::Experiment;
use cdpr_study::chain::{Chain, ChainStep};
use cdpr_study::study::PublishedStage;
use minijinja::{Value, context};
use schemars::JsonSchema;
use serde::Serialize;

use super::tracking_answer::TrackingAnswer;
use super::{Answer, title};
use crate::figures::{ErrorPanel, ErrorRows, Figure};
use crate::html_page::{Page, PageError, PageKind, plain, prose};
use crate::keys::adapters::keys;
use crate::keys::table_schema::nullable_numbers;
use crate::keys::{ChainStepKeys, Maybe};
use crate::number_format::{NONE, short, significant};
use crate::table::Table;

const TEMPLATE: &str = include_str!("chain.html");

/// All stages of the chain.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Chain")]
pub struct ChainAnswer {
    status: &'static str,
    control: String,
    machine: String,
    /// Effects of the model that predicts poses; null where none was named.
    prediction: Option<String>,
    seed: u64,
    /// Ends of the poses along each axis (m).
    region_m: Vec<[f64; 2]>,
    /// Stages in their order.
    steps: Vec<StepAnswer>,
    /// Smallest and largest change of a frame anchor's component by the first identification (m).
    first_change_m: [f64; 2],
    /// Smallest and largest change by the second identification (m).
    second_change_m: [f64; 2],
    /// Errors before stages divided by those after them.
    ratios: Vec<Ratio>,
    /// Force control by the identified elastostatic model beside that by the nominal one.
    #[serde(skip_serializing_if = "Option::is_none")]
    force_tracking: Option<TrackingAnswer>,
    /// Stages that were left out, with the reason.
    left_out: Vec<String>,
    /// The caution about force tracking; remarks follow it.
    warnings: Vec<String>,
    /// Page that was written.
    #[serde(skip_serializing_if = "Option::is_none")]
    report: Option<String>,
}

/// A stage beside its published errors.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ChainStage")]
struct StepAnswer {
    #[serde(flatten, with = "ChainStepKeys")]
    step: ChainStep,
    /// Errors that the study quotes.
    #[serde(with = "Maybe::<PublishedKeys>", skip_serializing_if = "Option::is_none")]
    printed: Option<PublishedStage>,
}

keys! {
    /// Errors that a study quotes of a stage.
    PublishedKeys of PublishedStage {
        /// Mean position error (m).
        position_mean_m,
        /// Mean rotation error (rad).
        rotation_mean_rad,
        /// Mean magnitude of the length errors (m).
        length_mean_abs_m,
        /// Mean over poses of the 2-norm of the tension errors (N).
        tension_mean_norm_N,
    }
}

/// Errors before a stage divided by those after it.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ChainRatio", transform = nullable_numbers)]
struct Ratio {
    /// Stage before.
    before: &'static str,
    /// Stage after.
    after: &'static str,
    /// Ratio of the mean position errors.
    position: f64,
    /// Ratio of the mean rotation errors.
    rotation: f64,
    /// Ratio of the mean tension errors; null where a stage has none.
    tension: Option<f64>,
}

impl ChainAnswer {
    /// The answer for an experiment with its chain.
    pub fn new(experiment: &Experiment, chain: Chain, region: &[[f64; 2]], seed: u64) -> Self {
        let ratios = ratios(&chain.steps);
        let published = &experiment.study.published;
        let step = |step: ChainStep| {
            let printed = published.iter().find(|own| own.stage == step.name).cloned();
            StepAnswer { step, printed }
        };
        let force_tracking = chain.force_tracking.zip(experiment.prediction.as_ref());
        let force_tracking = force_tracking.map(|(found, model)| TrackingAnswer::new(title(model), found));
        let warnings: Vec<String> = force_tracking.as_ref().and_then(TrackingAnswer::caution).into_iter().collect();
        Self {
            status: if warnings.is_empty() { "done" } else { "done-with-caution" },
            control: title(&experiment.control),
            machine: title(&experiment.machine),
            prediction: experiment.prediction.as_ref().map(title),
            seed,
            region_m: region.to_vec(),
            first_change_m: chain.first_change_m,
            second_change_m: chain.second_change_m,
            steps: chain.steps.into_iter().map(step).collect(),
            ratios,
            force_tracking,
            left_out: chain.left_out,
            warnings,
            report: None,
        }
    }

    /// The same with the name of the page that was written.
    #[must_use]
    pub fn with_report(self, report: Option<String>) -> Self {
        Self { report, ..self }
    }

    /// Cells of every stage: words, poses, the four errors with what is printed of them, parameters, tensions.
    fn rows(&self) -> Vec<Vec<String>> {
        let figure =
            |value: f64, scale: f64| if value.is_finite() { significant(scale * value, 3) } else { NONE.to_owned() };
        let row = |StepAnswer { step, printed }: &StepAnswer| {
            let beside = |own: Option<f64>, scale: f64, read: fn(&PublishedStage) -> Option<f64>| {
                let own = own.map_or_else(|| NONE.to_owned(), |value| figure(value, scale));
                match printed.as_ref().and_then(read) {
                    Some(value) => format!("{own} ({})", short(1e-4 * (1e4 * scale * value).round())),
                    None => own,
                }
            };
            let identified = step.identified.map(|one| match one.rank == one.parameter_count {
                true => one.parameter_count.to_string(),
                false => format!("{} of {}", one.rank, one.parameter_count),
            });
            let slack = step.slack_samples.filter(|slack| *slack > 0).map(|slack| format!(", slack at {slack}"));
            let tensions = step
                .tension_range
                .map(|[low, high]| format!("{}…{}{}", figure(low, 1.0), figure(high, 1.0), slack.unwrap_or_default()));
            vec![
                step.section.to_owned(),
                step.words.to_owned(),
                step.samples.to_string(),
                beside(Some(step.position_mean_m), 1e3, |one| one.position_mean_m),
                beside(Some(step.rotation_mean_rad).filter(|_| step.turns), 1.0_f64.to_degrees(), |one| {
                    one.rotation_mean_rad
                }),
                beside(Some(step.length_mean_abs_m), 1e3, |one| one.length_mean_abs_m),
                beside(step.tension_mean_norm, 1.0, |one| one.tension_mean_norm_N),
                identified.unwrap_or_else(|| NONE.to_owned()),
                tensions.unwrap_or_else(|| NONE.to_owned()),
            ]
        };
        self.steps.iter().map(row).collect()
    }

    fn words_of(&self, name: &str) -> String {
        let step = self.steps.iter().find(|one| one.step.name == name);
        step.map_or_else(String::new, |StepAnswer { step, .. }| format!("{} {}", step.section, step.words))
    }

    fn sentences(&self) -> Vec<String> {
        let range =
            |[low, high]: [f64; 2]| format!("{} to {} mm", significant(1e3 * low, 3), significant(1e3 * high, 3));
        let mut all = vec![format!(
            "Anchor components move by {} in the first identification, by {} in the second: another record of the same machine",
            range(self.first_change_m),
            range(self.second_change_m)
        )];
        for Ratio { before, after, position, rotation, tension } in &self.ratios {
            let tension =
                tension.map_or_else(String::new, |ratio| format!(", of tensions by {}", significant(ratio, 3)));
            let rotation = match rotation.is_finite() {
                true => format!(", of rotation by {}", significant(*rotation, 3)),
                false => String::new(),
            };
            all.push(format!(
                "From “{}” to “{}”: error of position divided by {}{rotation}{tension}",
                self.words_of(before),
                self.words_of(after),
                significant(*position, 3)
            ));
        }
        all
    }

    /// Errors of all stages, beside what is printed of them.
    fn figure(&self) -> Option<Figure> {
        let panel = |label: &str,
                     own: fn(&ChainStep) -> Option<f64>,
                     printed: fn(&PublishedStage) -> Option<f64>,
                     scale: f64| {
            let value = |one: &StepAnswer| {
                let printed = one.printed.as_ref().and_then(printed);
                [own(&one.step), printed].map(|value| value.map_or(f64::NAN, |value| scale * value))
            };
            ErrorPanel { label: label.to_owned(), values: self.steps.iter().map(value).collect(), like: None }
        };
        let turn = |step: &ChainStep| Some(step.rotation_mean_rad).filter(|_| step.turns);
        let panels = vec![
            panel("position, mm", |step| Some(step.position_mean_m), |one| one.position_mean_m, 1e3),
            panel("orientation, °", turn, |one| one.rotation_mean_rad, 1.0_f64.to_degrees()),
            panel("tensions, N", |step| step.tension_mean_norm, |one| one.tension_mean_norm_N, 1.0),
        ];
        let has_printed = self.steps.iter().any(|one| one.printed.is_some());
        let figure = ErrorRows {
            label: "Mean errors of every stage",
            names: self.steps.iter().map(|one| format!("{} {}", one.step.section, one.step.words)).collect(),
            series: ("here", has_printed.then_some("published")),
            panels,
        };
        figure.svg()
    }

    /// The page; `command` makes it again.
    pub fn page(&self, command: &str, version: &str) -> Result<String, PageError> {
        let rows: Vec<Value> = self
            .rows()
            .into_iter()
            .map(|cells| context! { cells => cells.iter().map(|cell| prose(cell)).collect::<Vec<_>>() })
            .collect();
        let last = self.steps.iter().find(|one| one.step.name == "force-control-edges");
        let shown = last.or(self.steps.last());
        let worse = self.force_tracking.as_ref().filter(|tracking| tracking.is_worse());
        let values = context! {
            worse => worse.map(TrackingAnswer::change),
            headline => shown.map(|one| format!("{} mm", significant(1e3 * one.step.position_mean_m, 3))),
            of => shown.map(|one| one.step.words),
            facts => [("Nominal controller", &self.control), ("Machine", &self.machine)]
                .map(|(term, text)| context! { term, text => plain(text) }).to_vec(),
            prediction => self.prediction.as_ref().map(|text| plain(text)),
            columns => COLUMNS,
            figure => self.figure().map(|figure| Value::from_safe_string(figure.inline())),
            rows,
            has_printed => self.steps.iter().any(|one| one.printed.is_some()),
            sentences => self.sentences().iter().map(|words| prose(words)).collect::<Vec<_>>(),
            warnings => self.warnings.iter().chain(&self.left_out).map(|words| prose(words)).collect::<Vec<_>>(),
            command => plain(command),
            seed => self.seed,
        };
        let title = "From the nominal controller to force control";
        Page { kind: PageKind::Chain, title, class: "wide", template: TEMPLATE, values, data: None, version }.render()
    }
}

const COLUMNS: [&str; 9] = [
    "section",
    "stage",
    "poses",
    "position mm",
    "rotation °",
    "length mm",
    "tension N",
    "parameters",
    "tension range N",
];

fn ratios(steps: &[ChainStep]) -> Vec<Ratio> {
    let find = |name: &str| steps.iter().find(|step| step.name == name);
    let pairs = [
        ("reference", "identified"),
        ("reference", "driven"),
        ("reduced-nominal", "reduced-identified"),
        ("elastostatic-nominal", "elastostatic-identified"),
        ("force-control-nominal", "force-control"),
        ("kinematic-edges", "force-control-edges"),
    ];
    let ratio = |(before, after): (&'static str, &'static str)| {
        let (first, second) = (find(before)?, find(after)?);
        let tension = first.tension_mean_norm.zip(second.tension_mean_norm).map(|(before, after)| before / after);
        let position = first.position_mean_m / second.position_mean_m;
        Some(Ratio { before, after, position, rotation: first.rotation_mean_rad / second.rotation_mean_rad, tension })
    };
    pairs.into_iter().filter_map(ratio).collect()
}

impl Answer for ChainAnswer {
    fn is_negative(&self) -> bool {
        false
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut table = Table::new(COLUMNS).left_column(1);
        table.rows(self.rows());
        let printed =
            if self.steps.iter().any(|one| one.printed.is_some()) { "; published errors in brackets" } else { "" };
        let mut text: String = self.warnings.iter().map(|caution| format!("Caution: {caution}.\n\n")).collect();
        text.push_str(&format!(
            "{} on {}\n\nmean errors; tension: mean of the 2-norm over cables{printed}\n\n{}\n",
            self.control,
            self.machine,
            table.text(width)
        ));
        self.sentences().iter().for_each(|words| text.push_str(&format!("{words}\n")));
        self.left_out.iter().for_each(|why| text.push_str(&format!("Left out: {why}\n")));
        if let Some(report) = &self.report {
            text.push_str(&format!("\npage written to {report}\n"));
        }
        text
    }
}
