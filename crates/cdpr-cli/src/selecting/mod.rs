//! The comparison of candidates that `select` and `demo` share: run it, answer it, write its folder.

mod folder;
mod objectives;

use std::time::Instant;

use cdpr::identification::Loss;
use cdpr::identification::candidate::{self, Candidate, CandidateError, Ladder};
use cdpr::identification::fit::{self, Prior};
use cdpr::identification::selection::{Requirement, SelectionCriterion, Settings, fit_count, select};
use cdpr::measurement::{Fold, Samples, Split};
use cdpr::model::FreeParameters;
use cdpr::robot::ParameterKind;
use cdpr_reports::comparison::{Comparison, ComparisonData};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

pub(crate) use folder::write_folder;
pub(crate) use objectives::ObjectiveArguments;

use crate::failure::Failure;
use crate::progress::Progress;

/// Options that say how candidates are compared.
#[derive(Clone, Debug, Args)]
pub(crate) struct SelectionArguments {
    /// Candidates from simple to complex: `MODEL` or `MODEL:FREE`, separated by semicolons; a ladder of defaults when left out.
    #[arg(long, value_name = "LIST", value_parser = candidate_list)]
    candidates: Option<CandidateList>,

    /// The error that decides, on validation data.
    #[arg(long, value_enum, default_value_t = CriterionName::Position, value_name = "NAME")]
    criterion: CriterionName,

    /// Limits that the recommended model must keep on validation data, e.g. position_mean_m=0.005,length_max_m=0.01.
    #[arg(long, value_name = "NAME=LIMIT,…", value_delimiter = ',')]
    require: Vec<Requirement>,

    /// Parameters that stay as they are in every candidate.
    #[arg(long, value_name = "LIST", default_value = "", hide_default_value = true)]
    hold: FreeParameters,

    /// Ridges towards the file's values with these standard deviations, e.g. platform-anchor=0.02.
    #[arg(long, value_name = "NAME=SIGMA,…", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) prior: Vec<Prior>,

    /// Loss of a sample's residuals in every fit. Auto: squared, unless samples lie beyond 8 robust standard deviations; Huber then.
    #[arg(long, value_name = "LOSS", default_value = Loss::default().name(), value_parser = losses())]
    loss: Loss,

    /// Leave K regions of the workspace out in turn besides: tells for every candidate how it extrapolates, beside the other criteria.
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u16).range(2..).map(usize::from))]
    regions: Option<usize>,

    #[command(flatten)]
    objective: ObjectiveArguments,

    /// Seed of the bootstrap and of random splits.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    pub(crate) seed: u64,
}

/// A list of candidates as one argument.
#[derive(Clone, Debug)]
struct CandidateList(Vec<Candidate>);

fn candidate_list(text: &str) -> Result<CandidateList, CandidateError> {
    candidate::parse_list(text).map(CandidateList)
}

/// Losses by their names.
pub(crate) fn losses() -> impl TypedValueParser<Value = Loss> {
    let named = |name: String| Loss::ALL.into_iter().find(|loss| loss.name() == name);
    PossibleValuesParser::new(Loss::ALL.map(Loss::name)).map(move |name| named(name).unwrap_or_default())
}

/// `--criterion`.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum CriterionName {
    /// Mean distance between predicted and measured position.
    Position,
    /// Mean angle between predicted and measured orientation.
    Rotation,
    /// Mean difference between modelled and recorded cable lengths.
    Length,
    /// Mean 2-norm of the differences between predicted and recorded tensions.
    Tension,
}

impl From<CriterionName> for SelectionCriterion {
    fn from(name: CriterionName) -> Self {
        match name {
            CriterionName::Position => Self::Position,
            CriterionName::Rotation => Self::Rotation,
            CriterionName::Length => Self::Length,
            CriterionName::Tension => Self::Tension,
        }
    }
}

impl SelectionArguments {
    /// The options as they are written on the command line, those left at their default left out.
    pub(crate) fn written(&self) -> String {
        let joined = |items: Vec<String>, separator: &str| items.join(separator);
        let candidates =
            self.candidates.iter().map(|list| joined(list.0.iter().map(ToString::to_string).collect(), ";"));
        let all = [
            ("candidates", candidates.map(|list| format!("'{list}'")).collect()),
            (
                "criterion",
                self.criterion.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default(),
            ),
            ("require", joined(self.require.iter().map(ToString::to_string).collect(), ",")),
            ("hold", self.hold.to_string()),
            ("prior", joined(self.prior.iter().map(|prior| format!("{}={}", prior.kind, prior.sigma)).collect(), ",")),
            ("loss", self.loss.name().to_owned()),
            ("regions", self.regions.map(|count| count.to_string()).unwrap_or_default()),
            ("seed", self.seed.to_string()),
        ];
        let is_default = |name: &str, value: &String| match name {
            "criterion" => value == "position",
            "loss" => self.loss == Loss::default(),
            "seed" => self.seed == 0,
            _ => value.is_empty(),
        };
        let of_objective = self.objective.written();
        let given = all.iter().chain(&of_objective).filter(|(name, value)| !is_default(name, value));
        given.map(|(name, value): &(&str, String)| format!(" --{name} {value}")).collect()
    }

    /// Which rungs the default ladder has.
    fn ladder(&self, samples: &Samples) -> Ladder {
        let has_prior = |prior: &Prior| prior.kind == ParameterKind::PlatformAnchor;
        Ladder { with_tensions: samples.tensions.is_some(), with_platform_anchors: self.prior.iter().any(has_prior) }
    }

    /// Identifies and judges every candidate.
    pub(crate) fn compare(&self, data: ComparisonData) -> Result<Comparison, Failure> {
        let candidates = match &self.candidates {
            Some(list) => list.0.clone(),
            None => candidate::defaults(&data.robot, self.ladder(&data.samples)),
        };
        let criterion = SelectionCriterion::from(self.criterion);
        if criterion == SelectionCriterion::Rotation && !data.robot.motion_pattern.has_rotation() {
            let message = "--criterion rotation: the platform of this robot does not turn";
            return Err(Failure::input("criterion::not-in-data", message, "use --criterion position or length"));
        }
        if criterion == SelectionCriterion::Tension && data.samples.tensions.is_none() {
            let message = format!("{}: --criterion tension needs recorded tensions", data.data_name);
            return Err(Failure::input(
                "criterion::not-in-data",
                &message,
                "add the columns tension_N_1, tension_N_2, …, or use another criterion",
            ));
        }
        let fit = self.objective.of(fit::Settings {
            hold: self.hold.clone(),
            priors: self.prior.clone(),
            loss: self.loss,
            ..fit::Settings::default()
        });
        let settings = Settings {
            criterion,
            requirements: self.require.clone(),
            fit,
            seed: self.seed,
            regions: self.regions.unwrap_or(0),
        };
        let progress = Progress::of(fit_count(&candidates, &data.folds, &settings), "comparing candidates");
        let start = Instant::now();
        let ComparisonData { robot, samples, folds, data_name, .. } = &data;
        let selection = select(robot, &candidates, samples, folds, &settings, &|| progress.step())
            .map_err(|error| Failure::refused(data_name, &error))?;
        let seconds = start.elapsed().as_secs_f64();
        let inverse_seconds = selection.candidates.iter().map(|judged| time_inverse(judged, samples)).collect();
        drop(progress);
        Ok(Comparison { data, candidates, settings, selection, seconds, inverse_seconds })
    }
}

/// Mean wall time of one pose's cable lengths (s).
fn time_inverse(judged: &cdpr::identification::selection::JudgedCandidate, samples: &Samples) -> Option<f64> {
    let model = &judged.outcome.as_ref().ok()?.fit.model;
    let poses = &samples.poses[..samples.len().min(200)];
    let start = Instant::now();
    let mut lengths = 0.0;
    for pose in poses {
        lengths += model.cable_lengths(pose).map_or(0.0, |lengths| lengths.iter().sum::<f64>());
    }
    // the sum keeps the work from being left out
    std::hint::black_box(lengths);
    Some(start.elapsed().as_secs_f64() / poses.len() as f64)
}

/// Samples, folds and words for the way validation data were chosen.
pub(crate) struct DataDivision {
    pub(crate) samples: Samples,
    /// How many of the samples are of the first file.
    pub(crate) data_count: usize,
    pub(crate) folds: Vec<Fold>,
    pub(crate) words: String,
}

/// Training and validation data from two files.
pub(crate) fn two_files(train: &Samples, validation: &Samples, name: &str) -> Result<DataDivision, Failure> {
    let samples = train.followed_by(validation).map_err(|error| Failure::refused(name, &error))?;
    let fold = Fold {
        name: name.to_owned(),
        train: (0..train.len()).collect(),
        validation: (train.len()..samples.len()).collect(),
    };
    let words = format!("{} samples of {name}", validation.len());
    Ok(DataDivision { samples, data_count: train.len(), folds: vec![fold], words })
}

/// Training and validation data from one file: by the split asked for, else by the column `set` where it tells, else by
/// five contiguous blocks.
pub(crate) fn one_file(samples: Samples, split: Option<Split>, seed: u64) -> Result<DataDivision, Failure> {
    let by_column = Split::Column.folds(&samples, seed);
    let split = match (split, &by_column) {
        (Some(split), _) => split,
        (None, Ok(_)) => Split::Column,
        (None, Err(_)) => Split::Blocks(samples.len().clamp(2, 5)),
    };
    let folds = split.folds(&samples, seed).map_err(|error| Failure::refused("--split", &error))?;
    let words = match split {
        Split::Column => "the rows that the column `set` names".to_owned(),
        Split::Blocks(count) => format!("{count} contiguous blocks, each held out in turn"),
        Split::KFold(count) => format!("{count} random parts, each held out in turn"),
        Split::Region(count) => format!("{count} regions of the workspace, each held out in turn"),
    };
    Ok(DataDivision { data_count: samples.len(), samples, folds, words })
}
