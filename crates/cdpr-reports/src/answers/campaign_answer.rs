//! Rounds of planned measurements: errors, reach and uncertainty over the rounds.

use cdpr_calibration::fit::Status;
use cdpr_study::Experiment;
use cdpr_study::accuracy::Accuracy;
use cdpr_study::campaign::{self as study, Campaign, CampaignStatus, Repetition, Round};
use minijinja::{Value, context};
use schemars::JsonSchema;
use serde::Serialize;

use super::{Answer, title};
use crate::figures::{CourseHeight, CoursePanel, Figure, rounds};
use crate::html_page::{Page, PageError, PageKind, plain, prose};
use crate::keys::{AccuracyKeys, Each, Maybe, RoundKeys, Word};
use crate::number_format::{NONE, significant};
use crate::table::Table;

const TEMPLATE: &str = include_str!("campaign.html");

/// Rounds of a campaign.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Campaign")]
pub struct CampaignAnswer {
    #[serde(with = "Word")]
    status: CampaignStatus,
    reason: String,
    control: String,
    machine: String,
    seed: u64,
    /// Accuracy at which the campaign ends (m); null without one.
    accuracy_m: Option<f64>,
    /// Poses of the study.
    candidates: usize,
    /// The first controller.
    nominal: Nominal,
    /// Rounds so far.
    #[serde(with = "Each::<RoundKeys>")]
    rounds: Vec<Round>,
    /// The campaign with other seeds, where it was repeated.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    repeats: Vec<Repeated>,
    /// Poses that the campaign waits for.
    waits_for: usize,
    out: String,
    warnings: Vec<String>,
}

/// The campaign with another seed.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "RepeatedCampaign")]
struct Repeated {
    /// Seed of the exchanges and of the noise.
    seed: u64,
    /// Word for its end; `failed` where it could not be run.
    status: String,
    /// Reason for which it could not be run.
    reason: Option<String>,
    /// Rounds, in order.
    rounds: Vec<RepeatedRound>,
}

/// A round with another seed.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "RepeatedRound")]
struct RepeatedRound {
    /// Samples measured so far.
    poses: usize,
    /// Mean position error on held-out samples (m); null with too few samples.
    validation_position_mean_m: Option<f64>,
    /// Mean position error of the driven machine (m).
    driven_position_mean_m: Option<f64>,
    /// Fraction of the study's poses that the identified controller reaches.
    reach_share: Option<f64>,
}

impl From<Repetition> for Repeated {
    fn from(own: Repetition) -> Self {
        let round = |round: &study::RepeatedRound| RepeatedRound {
            poses: round.poses,
            validation_position_mean_m: round.validation_position_mean_m,
            driven_position_mean_m: round.driven_position_mean_m,
            reach_share: Some(round.reach_share),
        };
        Self { seed: own.seed, status: own.status, reason: own.reason, rounds: own.rounds.iter().map(round).collect() }
    }
}

/// The controller before the first round.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "CampaignStart")]
struct Nominal {
    /// Errors with which it drives the machine; null if records come from files.
    #[serde(with = "Maybe::<AccuracyKeys>")]
    driven: Option<Accuracy>,
    /// Fraction of the poses that it reaches.
    reach_share: f64,
}

impl CampaignAnswer {
    /// The answer for an experiment over so many poses, in a folder.
    pub fn new(experiment: &Experiment, campaign: Campaign, candidates: usize, out: &str, seed: u64) -> Self {
        let mut answer = Self {
            status: campaign.status,
            reason: String::new(),
            control: title(&experiment.control),
            machine: title(&experiment.machine),
            seed,
            accuracy_m: campaign.accuracy_m,
            candidates,
            nominal: Nominal { driven: campaign.driven_at_first, reach_share: campaign.reach_at_first },
            waits_for: campaign.waits_for.len(),
            repeats: Vec::new(),
            warnings: warnings(&campaign.rounds),
            rounds: campaign.rounds,
            out: out.to_owned(),
        };
        answer.reason = answer.why();
        answer
    }

    /// The answer beside the same campaign with other seeds.
    #[must_use]
    pub fn repeated(mut self, repetitions: Vec<Repetition>) -> Self {
        let failed = repetitions.iter().filter_map(|own| Some(format!("seed {}: {}", own.seed, own.reason.as_ref()?)));
        self.warnings.extend(failed);
        self.repeats = repetitions.into_iter().map(Repeated::from).collect();
        self
    }

    /// A sentence on the campaign with other seeds; empty where it was not repeated.
    fn repeats_in_words(&self) -> String {
        let last = |own: &Repeated| own.rounds.last().and_then(|round| round.driven_position_mean_m);
        let mut errors: Vec<f64> = self.repeats.iter().filter_map(last).filter(|error| error.is_finite()).collect();
        errors.sort_unstable_by(f64::total_cmp);
        let (Some(least), Some(largest)) = (errors.first(), errors.last()) else { return String::new() };
        let mm = |error: f64| significant(1e3 * error, 3);
        format!(
            "\nwith {} other seeds the mean driven error after the last round is {} to {} mm, in half of them at most {} mm\n",
            errors.len(),
            mm(*least),
            mm(*largest),
            mm(errors[(errors.len() - 1) / 2])
        )
    }

    fn measured(&self) -> usize {
        self.rounds.last().map_or(0, |round| round.poses)
    }

    fn why(&self) -> String {
        let (poses, rounds) = (self.measured(), self.rounds.len());
        let asked = self.accuracy_m.map(|accuracy| format!("{} mm", significant(1e3 * accuracy, 3)));
        let missed = match &asked {
            Some(asked) => format!("; the error on held-out samples is not down to {asked}"),
            None => String::new(),
        };
        match self.status {
            CampaignStatus::AccuracyReached => format!(
                "the mean position error on held-out samples is within {} after {poses} poses",
                asked.unwrap_or_default()
            ),
            CampaignStatus::BudgetSpent => format!("all {poses} poses of the budget are measured{missed}"),
            CampaignStatus::RoundsOver => format!("all {rounds} rounds are over{missed}"),
            CampaignStatus::NothingLeft => format!(
                "no pose is left that the controller reaches and that has not been measured, after {poses} of {}{missed}",
                self.candidates
            ),
            CampaignStatus::Waiting => format!(
                "the record of round {next} is waited for: let the controller of {out}/round-{next}/controller.toml drive to the {} poses of poses.csv \
                 there, write what the sensors see to record.csv beside it, and run the command again",
                self.waits_for,
                next = rounds + 1,
                out = self.out
            ),
        }
    }

    /// Cells of the nominal controller and of every round.
    fn rows(&self) -> Vec<Vec<String>> {
        let figure = |value: Option<f64>, scale: f64| {
            value.filter(|value| value.is_finite()).map_or(NONE.to_owned(), |value| significant(scale * value, 3))
        };
        let driven =
            |driven: &Option<Accuracy>| figure(driven.as_ref().map(|driven| driven.position_error_m.mean), 1e3);
        let percent = |share: f64| significant(1e2 * share, 3);
        let none = || NONE.to_owned();
        let Nominal { driven: at_first, reach_share } = &self.nominal;
        let mut rows = vec![vec![
            "nominal".to_owned(),
            "0".to_owned(),
            none(),
            none(),
            driven(at_first),
            percent(*reach_share),
            none(),
        ]];
        for round in &self.rounds {
            rows.push(vec![
                round.round.to_string(),
                round.poses.to_string(),
                figure(Some(round.predicted.position_error_m.mean), 1e3),
                figure(round.validation.map(|errors| errors.position_error_m.mean), 1e3),
                driven(&round.driven),
                percent(round.reach_share),
                figure(round.deviation_m, 1e3),
            ]);
        }
        rows
    }

    /// Errors, reach and uncertainty over the rounds; `None` before the first.
    fn figure(&self) -> Option<Figure> {
        let over = |first: Option<f64>, own: &dyn Fn(&Round) -> Option<f64>, scale: f64| -> Vec<f64> {
            let all = std::iter::once(first).chain(self.rounds.iter().map(own));
            all.map(|value| value.map_or(f64::NAN, |value| scale * value)).collect()
        };
        let driven = |driven: &Option<Accuracy>| driven.as_ref().map(|driven| driven.position_error_m.mean);
        let curves = vec![
            (
                "held out".to_owned(),
                over(None, &|round| round.validation.map(|errors| errors.position_error_m.mean), 1e3),
            ),
            ("driven".to_owned(), over(driven(&self.nominal.driven), &|round| driven(&round.driven), 1e3)),
        ];
        let panel = |title: &str, label: &str, curves: Vec<(String, Vec<f64>)>, height| {
            // a curve without a number has nothing to show
            let curves =
                curves.into_iter().filter(|(_, values)| values.iter().any(|value| value.is_finite())).collect();
            CoursePanel { title: title.to_owned(), label: label.to_owned(), curves, height }
        };
        let alone = |values: Vec<f64>| vec![(String::new(), values)];
        rounds(&[
            panel("Mean position error", "mm", curves, CourseHeight::Size),
            panel(
                "Poses in reach",
                "%",
                alone(over(Some(self.nominal.reach_share), &|round| Some(round.reach_share), 1e2)),
                CourseHeight::Value,
            ),
            panel(
                "Deviation of the driven position by the parameters (1 σ)",
                "mm",
                alone(over(None, &|round| round.deviation_m, 1e3)),
                CourseHeight::Size,
            ),
            panel(
                "Samples",
                "measured",
                alone(over(Some(0.0), &|round| Some(round.poses as f64), 1.0)),
                CourseHeight::Value,
            ),
        ])
    }

    /// The page; `command` makes it again.
    pub fn page(&self, command: &str, version: &str) -> Result<String, PageError> {
        let cells = |cells: Vec<String>| context! { cells => cells.iter().map(|cell| prose(cell)).collect::<Vec<_>>() };
        let rows: Vec<Value> = self.rows().into_iter().map(cells).collect();
        let last = self.rows().pop().unwrap_or_default();
        let headline = [4, 3].into_iter().find(|column| last.get(*column).is_some_and(|cell| cell != NONE));
        let values = context! {
            headline => headline.map_or(self.reason.clone(), |column| format!("{} mm", last[column])),
            of => format!("{} after {} samples", if headline == Some(4) { "driven" } else { "on held-out samples" }, self.measured()),
            facts => [("Controller", &self.control), ("Machine", &self.machine)]
                .map(|(term, text)| context! { term, text => plain(text) }).to_vec(),
            columns => COLUMNS,
            figure => self.figure().map(|figure| Value::from_safe_string(figure.inline())),
            rows,
            reason => prose(&self.reason),
            warnings => self.warnings.iter().map(|words| prose(words)).collect::<Vec<_>>(),
            command => plain(command),
            seed => self.seed,
        };
        let title = "Measurements in rounds";
        Page { kind: PageKind::Campaign, title, class: "wide", template: TEMPLATE, values, data: None, version }
            .render()
    }
}

const COLUMNS: [&str; 7] = ["round", "samples", "predicted mm", "held out mm", "driven mm", "reach %", "deviation mm"];

fn warnings(rounds: &[Round]) -> Vec<String> {
    let Some(last) = rounds.last() else { return Vec::new() };
    let mut warnings = Vec::new();
    if last.rank < last.parameter_count {
        warnings.push(format!(
            "the samples determine {} of {} parameters: poses in more orientations, or fewer free parameters",
            last.rank, last.parameter_count
        ));
    }
    if last.fit == Status::NotConverged {
        warnings.push("the last fit did not settle".to_owned());
    }
    if let Some(before) = rounds.iter().rev().nth(1)
        && last.reach_share < before.reach_share - 0.05
    {
        warnings.push("the last round's controller reaches less than the one before".to_owned());
    }
    warnings
}

impl Answer for CampaignAnswer {
    fn is_negative(&self) -> bool {
        let is_missed = self.accuracy_m.is_some()
            && !matches!(self.status, CampaignStatus::AccuracyReached | CampaignStatus::Waiting);
        is_missed || (self.rounds.is_empty() && self.status != CampaignStatus::Waiting)
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut table = Table::new(COLUMNS);
        table.rows(self.rows());
        let warnings: String = self.warnings.iter().map(|warning| format!("caution: {warning}\n")).collect();
        format!(
            "{} on {}, {} poses to choose among\n{warnings}{}\n\nmean position errors; predicted: of the round before on the new samples; held out: by parts in turn\n\n{}{}\nrounds, \
             calibrated.toml, result.json and report.html in {}\n",
            self.control,
            self.machine,
            self.candidates,
            self.reason,
            table.text(width),
            self.repeats_in_words(),
            self.out
        )
    }
}
