//! `cdpr identify`: optimal parameters of one model from measurements.

mod course;
mod driving;
mod path;
mod report;
mod scaling;
mod self_calibration;
mod task;
mod uncertainty;

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr::identification::Loss;
use cdpr::identification::fit::{self, Minimizer, Prior};
use cdpr::measurement::Split;
use cdpr::model::FreeParameters;
use cdpr::reading::Keyword;
use clap::Args;

use crate::answer::{Output, TrustArguments};
use crate::failure::Failure;
use crate::files;
use crate::inputs::ModelArguments;
use crate::keyword::{keyword, keyword_or_short};
use crate::measurements::DataArguments;
use crate::progress::Progress;
use crate::selecting::ObjectiveArguments;
use driving::DriveArguments;
use task::Task;

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

const FREE_HELP: &str = "\
Parameters to identify, separated by commas: frame-anchor, platform-anchor, length-offset, length-scale; \
with pulleys pulley-radius, swivel-axis; with recorded motor angles drum-radius, spool-build-up, start-length, with drums also drum-pitch, drum-axis, start-angle; \
with an elastic model and recorded tensions also compliance (1/EA), hidden-length, wrench (constant, weight included), \
tension-scale, tension-offset, without poses these three of rigid models, too; with times (t_s) clock-offset; of the tracker tracker-frame, marker-frame; `frame-anchor[1,3]` frees cables 1 and 3 only";

/// Identify the parameters of a model from measured poses and recorded lengths.
///
/// The exit code is 1 when the data do not determine all free parameters, when the fit did not converge, and when its errors are not to be trusted; the calibrated
/// file is written all the same, and `[calibration] status` in it says so.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    data: DataArguments,

    #[arg(long, value_name = "LIST", help = FREE_HELP)]
    free: FreeParameters,

    /// Parameters that stay as they are although --free names them, e.g. `frame-anchor[1]`.
    #[arg(long, value_name = "LIST", default_value = "", hide_default_value = true)]
    hold: FreeParameters,

    /// Ridges towards the file's values with these standard deviations, e.g. platform-anchor=0.02.
    #[arg(long, value_name = "NAME=SIGMA,…", value_delimiter = ',', allow_hyphen_values = true)]
    prior: Vec<Prior>,

    /// Measurements to judge the calibrated model by; they are not fitted to.
    #[arg(long, value_name = "FILE", conflicts_with = "split")]
    validation: Option<PathBuf>,

    /// Hold parts of DATA out to judge by: column (`set`), blocks:K, kfold:K or region:K.
    #[arg(long, value_name = "SPLIT")]
    split: Option<Split>,

    /// Starts: the file's values and others by a Sobol sequence (anchors up to 0.5 m away, compliances up to 10/3 times larger or
    /// smaller); the optima they lead to are listed.
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    starts: u32,

    /// Way to the optimum; all lead to the same one.
    #[arg(long, value_name = "METHOD", default_value = Minimizer::default().name(), value_parser = keyword_or_short(SHORT))]
    minimizer: Minimizer,

    /// Loss of a sample's residuals. Auto: squared, unless samples lie beyond 8 robust standard deviations; Huber then.
    #[arg(long, value_name = "LOSS", default_value = Loss::default().name(), value_parser = keyword::<Loss>())]
    loss: Loss,

    #[command(flatten)]
    objective: ObjectiveArguments,

    /// Fit by every objective and cost, and judge each optimum by all of them.
    #[arg(long)]
    compare_objectives: bool,

    #[command(flatten)]
    drive: DriveArguments,

    /// Seed of the split kfold:K and of other starts.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,

    /// Calibrated robot file to write.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,

    /// Samples to write with the poses that were found (CSV), where the data have none.
    #[arg(long, value_name = "FILE")]
    out_poses: Option<PathBuf>,

    #[command(flatten)]
    frame: Box<self_calibration::FrameArguments>,

    /// Report to write: tables and charts in one HTML file.
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,

    #[command(flatten)]
    uncertainty: uncertainty::UncertaintyArguments,

    #[command(flatten)]
    path: Box<path::PathArguments>,

    #[command(flatten)]
    scaling: Box<scaling::ScalingArguments>,

    #[command(flatten)]
    course: course::CourseArguments,

    #[command(flatten)]
    trust: TrustArguments,
}

impl Arguments {
    fn settings(&self) -> fit::Settings {
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

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    if arguments.data.lacks_poses(&model)? {
        return self_calibration::run(&arguments, &model, output);
    }
    if let Some(option) = arguments.frame.asked().or(arguments.out_poses.as_ref().map(|_| "--out-poses")) {
        return Err(poses_are_there(&arguments.data.name(), option));
    }
    let samples = arguments.data.read(&model, output)?;
    samples.check().map_err(|error| Failure::refused(&arguments.data.name(), &error))?;
    let other = arguments.validation.as_ref().map(|path| arguments.data.read_other(path, &model, output));
    let other = other.transpose()?;
    let drive = arguments.drive.read(arguments.seed)?;
    let progress = Progress::of(1, "identifying");
    let task =
        Task { model: &model, samples: &samples, arguments: &arguments, drive: drive.as_ref(), progress: &progress };
    progress.expect(task.descents(1));
    task.tell_about_unused_column(output);
    let result = task.identify(other.as_ref())?;
    let calibrated = result.fit.model.robot().clone();
    let uncertainty = uncertainty::find(&task, &result.fit)?;
    let files = uncertainty.files(&result.fit.model);
    let (scaling, map) = scaling::find(&task, &result.fit)?;
    let mut path = path::find(&task, &result.fit, other.as_ref())?;
    let found = (path.path.take(), path.reduction.take(), path.warning.take());
    let (course, course_files) = arguments.course.answer((result.course.clone(), &result.fit));
    let answer = task.answer(result, output.doubts())?.with_uncertainty(uncertainty).with_path(found);
    let answer = answer.with_scaling(scaling).with_course(course);
    let calibrated = calibrated.with_calibration(answer.verdict().fit_status()).to_toml();
    arguments.uncertainty.write(&files)?;
    let page = arguments
        .report
        .as_ref()
        .map(|_| report::page(&task, (other.as_ref(), None), answer.reason(), answer.warnings(), &answer.additions()))
        .transpose()?;
    drop(progress);
    let calibrated_file = arguments.out.as_deref().map(|path| (path, calibrated.as_bytes()));
    let report_file = arguments.report.as_deref().zip(page.as_deref().map(str::as_bytes));
    let further = map.iter().chain(&course_files).map(|(path, content)| (path.as_path(), &content[..]));
    files::write_all(
        &calibrated_file.into_iter().chain(report_file).chain(path.files()).chain(further).collect::<Vec<_>>(),
    )?;
    output.answer_accepting(&answer, arguments.trust)
}

/// Refuses options that are of poses nobody measured.
fn poses_are_there(data: &str, option: &str) -> Failure {
    let message = format!("{data}: {option} is of calibration without measured poses, and these data have them");
    Failure::input("data::has-poses", message, "leave it out")
}
