//! Arguments of an identification, and the settings of its fits.

use std::path::PathBuf;

use cdpr_calibration::Loss;
use cdpr_calibration::fit::{self, Minimizer, Prior};
use cdpr_model::measurement::Split;
use cdpr_model::model::FreeParameters;
use cdpr_model::reading::Keyword;
use cdpr_model::robot::{LAWS, Law};
use clap::Args;

use super::course::CourseArguments;
use super::driving::DriveArguments;
use super::options::{FrameArguments, PathArguments, ScalingArguments, UncertaintyArguments};
use crate::answer::TrustArguments;
use crate::inputs::ModelArguments;
use crate::keyword::{keyword, keyword_or_short};
use crate::measurements::DataArguments;
use crate::selecting::ObjectiveArguments;

const EXAMPLES: &str = "\
Examples:
  cdpr identify robot.toml samples.csv --free length-offset --out calibrated.toml
  cdpr identify robot.toml samples.csv --free 'frame-anchor[1,3]' --split blocks:5
  cdpr identify robot.toml samples.csv --free pulley-radius --model pulley \\
      --validation other.csv --sigma position_m=0.001,length_m=0.0002
  cdpr identify robot.toml samples.csv --free frame-anchor,platform-anchor \\
      --prior platform-anchor=0.02
  cdpr identify robot.toml samples.csv --free frame-anchor --objective pose --drive study.toml
  cdpr identify robot.toml samples.csv --free frame-anchor,platform-anchor \\
      --path lasso --path-figure path.svg --out-path sparse.toml
  cdpr identify robot.toml lengths.csv --free frame-anchor --gauge least-change \
      --known 'distance[1,2]=2.412+-0.002' --out-poses found.csv
  cdpr identify robot.toml samples.csv --model elastic --starts 10 \\
      --free frame-anchor,platform-anchor,compliance,wrench --prior platform-anchor=0.02";

const FREE_HELP: [&str; 2] = [
    "\
Parameters to identify, separated by commas: frame-anchor, platform-anchor, length-offset, length-scale; \
with pulleys pulley-radius, swivel-axis; with recorded motor angles drum-radius, spool-build-up, start-length, with drums also drum-pitch, drum-axis, start-angle; \
with an elastic model and recorded tensions also compliance (1/EA), hidden-length, wrench (constant, weight included), \
tension-scale, tension-offset, without poses these three of rigid models, too; ",
    "\
with times (t_s) clock-offset; of the tracker tracker-frame, marker-frame; inside the record `length-offset[3]@52`, a step of cable 3 from \
line 52 on, and length-drift; `frame-anchor[1,3]` frees cables 1 and 3 only",
];

/// Parameters to identify, with the numbers of every law of stretch.
fn free_help() -> String {
    let [plain, of_recordings] = FREE_HELP;
    let with_numbers = LAWS.iter().filter(|law| !law.numbers.is_empty());
    let of_law = |law: &Law| {
        let names: Vec<&str> = law.numbers.iter().map(|number| number.name).collect();
        format!("with {} and tensions {}; ", law.word, names.join(", "))
    };
    format!("{plain}{}{of_recordings}", with_numbers.map(of_law).collect::<String>())
}

/// Identify the parameters of a model from measured poses and recorded lengths.
///
/// The exit code is 1 when the data do not determine all free parameters, when the fit did not converge, and when its errors are not to be trusted; the calibrated
/// file is written all the same, and `[calibration] status` in it says so.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    pub(super) model: ModelArguments,

    #[command(flatten)]
    pub(super) data: DataArguments,

    #[arg(long, value_name = "LIST", help = free_help())]
    pub(super) free: FreeParameters,

    /// Parameters that stay as they are although --free names them, e.g. `frame-anchor[1]`.
    #[arg(long, value_name = "LIST", default_value = "", hide_default_value = true)]
    pub(super) hold: FreeParameters,

    /// Ridges towards the file's values with these standard deviations, e.g. platform-anchor=0.02.
    #[arg(long, value_name = "NAME=SIGMA,…", value_delimiter = ',', allow_hyphen_values = true)]
    pub(super) prior: Vec<Prior>,

    /// Measurements to judge the calibrated model by; they are not fitted to.
    #[arg(long, value_name = "FILE", conflicts_with = "split")]
    pub(super) validation: Option<PathBuf>,

    /// Hold parts of DATA out to judge by: column (`set`), blocks:K, kfold:K or region:K.
    #[arg(long, value_name = "SPLIT")]
    pub(super) split: Option<Split>,

    /// Starts: the file's values and others by a Sobol sequence (anchors up to 0.5 m away, compliances up to 10/3 times larger or
    /// smaller); the optima they lead to are listed.
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(super) starts: u32,

    /// Way to the optimum; all lead to the same one.
    #[arg(long, value_name = "METHOD", default_value = Minimizer::default().name(), value_parser = keyword_or_short(SHORT))]
    pub(super) minimizer: Minimizer,

    /// Loss of a sample's residuals. Auto: squared, unless samples lie beyond 8 robust standard deviations; Huber then.
    #[arg(long, value_name = "LOSS", default_value = Loss::default().name(), value_parser = keyword::<Loss>())]
    pub(super) loss: Loss,

    #[command(flatten)]
    pub(super) objective: ObjectiveArguments,

    /// Fit by every objective and cost, and judge each optimum by all of them.
    #[arg(long)]
    pub(super) compare_objectives: bool,

    #[command(flatten)]
    pub(super) drive: DriveArguments,

    /// Seed of the split kfold:K and of other starts.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    pub(super) seed: u64,

    /// Calibrated robot file to write.
    #[arg(long, value_name = "FILE")]
    pub(super) out: Option<PathBuf>,

    /// Samples to write with the poses that were found (CSV), where the data have none.
    #[arg(long, value_name = "FILE")]
    pub(super) out_poses: Option<PathBuf>,

    #[command(flatten)]
    pub(super) frame: Box<FrameArguments>,

    /// Report to write: tables and charts in one HTML file.
    #[arg(long, value_name = "FILE")]
    pub(super) report: Option<PathBuf>,

    #[command(flatten)]
    pub(super) uncertainty: UncertaintyArguments,

    #[command(flatten)]
    pub(super) path: Box<PathArguments>,

    #[command(flatten)]
    pub(super) scaling: Box<ScalingArguments>,

    #[command(flatten)]
    pub(super) course: CourseArguments,

    #[command(flatten)]
    pub(super) trust: TrustArguments,
}

impl Arguments {
    pub(super) fn settings(&self) -> fit::Settings {
        let Arguments { hold, prior, starts, minimizer, loss, seed, .. } = self;
        self.scaling.of(self.objective.of(fit::Settings {
            hold: hold.clone(),
            priors: prior.clone(),
            starts: *starts,
            minimizer: *minimizer,
            loss: *loss,
            seed: *seed,
            keeps_course: self.course.is_asked(),
            gauge: self.frame.gauge,
            ..fit::Settings::default()
        }))
    }
}

/// Minimizers by the names that other programs have for them.
const SHORT: &[(&str, Minimizer)] = &[("lm", Minimizer::LevenbergMarquardt), ("trf", Minimizer::TrustRegion)];
