//! The comparison of candidates that `select` and `demo` share: run it, answer it, write its folder.

mod folder;
mod objectives;

use std::time::Instant;

use cdpr_calibration::candidate::{self, Candidate, CandidateError, KnownTensions, Ladder, PlatformAnchors};
use cdpr_calibration::fit::{self, Prior};
use cdpr_calibration::selection::{
    JudgedCandidate, Requirement, SelectionCriterion, Settings, fit_count, select, select_without_poses,
};
use cdpr_calibration::{Loss, Objective};
use cdpr_model::measurement::{Samples, Split};
use cdpr_model::model::{Composition, FreeParameters, Model};
use cdpr_model::reading::Keyword;
use cdpr_model::robot::ParameterKind;
use cdpr_reports::comparison::{Comparison, ComparisonData};
use clap::Args;
use clap::builder::TypedValueParser;

pub(crate) use folder::write_folder;
pub(crate) use objectives::ObjectiveArguments;

use crate::failure::Failure;
use crate::keyword::keyword;
use crate::measurements::{BY_REGIONS, NO_OUTLIER, NO_POSE, refuse_without_poses};
use crate::progress::Progress;

/// Options that say how candidates are compared.
#[derive(Clone, Debug, Args)]
pub(crate) struct SelectionArguments {
    /// Candidates from simple to complex: `MODEL` or `MODEL:FREE`, separated by semicolons; a ladder of defaults when left out.
    #[arg(long, value_name = "LIST", value_parser = candidate_list)]
    candidates: Option<CandidateList>,

    /// The error that decides, its mean on validation data: of predicted positions or orientations, of modelled cable lengths, or of predicted
    /// tensions (2-norm). Default: position, without measured poses length.
    #[arg(long, value_name = "NAME", value_parser = keyword::<SelectionCriterion>())]
    criterion: Option<SelectionCriterion>,

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
    #[arg(long, value_name = "LOSS", default_value = Loss::default().name(), value_parser = keyword::<Loss>())]
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
pub(crate) struct CandidateList(Vec<Candidate>);

fn candidate_list(text: &str) -> Result<CandidateList, CandidateError> {
    candidate::parse_list(text).map(CandidateList)
}

impl SelectionArguments {
    /// The options as they are written on the command line, those left at their default left out.
    pub(crate) fn written(&self) -> String {
        let joined = |items: Vec<String>, separator: &str| items.join(separator);
        let candidates =
            self.candidates.iter().map(|list| joined(list.0.iter().map(ToString::to_string).collect(), ";"));
        let all = [
            ("candidates", candidates.map(|list| format!("'{list}'")).collect()),
            ("criterion", self.criterion.map(|criterion| criterion.name().to_owned()).unwrap_or_default()),
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

    /// Refuses what compares with measured poses, or parts samples by them.
    pub(crate) fn refuse_without_poses(&self, data: &str, split: Option<Split>) -> Result<(), Failure> {
        let of_poses = matches!(self.criterion, Some(SelectionCriterion::Position | SelectionCriterion::Rotation));
        let by_regions = self.regions.is_some() || matches!(split, Some(Split::Region(_)));
        let other = self.objective.of(fit::Settings::default()).objective != Objective::Length;
        refuse_without_poses(
            data,
            &[
                ("--criterion position or rotation", of_poses, NO_POSE),
                ("--regions or --split region:K", by_regions, BY_REGIONS),
                ("--objective other than length", other, NO_POSE),
                ("--loss huber or cauchy", !matches!(self.loss, Loss::Auto | Loss::Squared), NO_OUTLIER),
            ],
        )
    }

    /// The candidates: those of the list, else the default ladder, with the prior that it assumes.
    fn candidates(&self, data: &ComparisonData) -> (Vec<Candidate>, Option<Prior>) {
        if let Some(list) = &self.candidates {
            return (list.0.clone(), None);
        }
        let has_prior = |prior: &Prior| prior.kind == ParameterKind::PlatformAnchor;
        let is_given = self.prior.iter().any(has_prior);
        let model = Model::new(data.robot.clone(), Composition::STANDARD).ok();
        let tensions = KnownTensions::of(&data.robot, &data.samples);
        let is_elastic = tensions != KnownTensions::Unknown;
        let assumed = model.and_then(|model| candidate::assumed_prior(&model)).filter(|_| is_elastic && !is_given);
        let platform_anchors = match assumed {
            _ if is_given => PlatformAnchors::Free,
            Some(_) => PlatformAnchors::Elastic,
            None => PlatformAnchors::Held,
        };
        (candidate::defaults(&data.robot, Ladder { tensions, platform_anchors }), assumed)
    }

    /// Identifies and judges every candidate.
    pub(crate) fn compare(&self, mut data: ComparisonData) -> Result<Comparison, Failure> {
        let (candidates, assumed) = self.candidates(&data);
        let without = data.internal.as_ref().map_or(SelectionCriterion::Position, |_| SelectionCriterion::Length);
        let criterion = self.criterion.unwrap_or(without);
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
            priors: self.prior.iter().chain(&assumed).copied().collect(),
            loss: self.loss,
            ..fit::Settings::default()
        });
        let settings = Settings {
            criterion,
            decides_alone: self.criterion.is_some(),
            requirements: self.require.clone(),
            fit,
            seed: self.seed,
            regions: self.regions.unwrap_or(0),
            assumed: assumed.into_iter().collect(),
            tries_recording: self.candidates.is_none(),
        };
        let progress = Progress::of(fit_count(&candidates, &data.folds, &settings), "comparing candidates");
        let start = Instant::now();
        let ComparisonData { robot, samples, internal, folds, data_name, .. } = &data;
        let step = || progress.step_of_work();
        let selection = match internal {
            Some(internal) => select_without_poses(robot, &candidates, internal, folds, &settings, &step),
            None => select(robot, &candidates, samples, folds, &settings, &step).map(|own| (own, samples.clone())),
        };
        let (selection, samples) = selection.map_err(|error| Failure::refused(data_name, &error))?;
        let seconds = start.elapsed().as_secs_f64();
        let inverse_seconds = selection.candidates.iter().map(|judged| time_inverse(judged, &samples)).collect();
        data.samples = samples;
        drop(progress);
        Ok(Comparison { data, candidates, settings, selection, seconds, inverse_seconds })
    }
}

/// Mean wall time of one pose's cable lengths (s).
fn time_inverse(judged: &JudgedCandidate, samples: &Samples) -> Option<f64> {
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
