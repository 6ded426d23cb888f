//! `cdpr compensate`: a smooth correction of lengths where a model leaves errors that repeat.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_calibration::compensation::compensate;
use cdpr_model::measurement::Split;
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::inputs::ModelArguments;
use crate::measurements::DataArguments;
use crate::progress::Progress;
use cdpr_reports::answers::CompensationAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr compensate calibrated.toml samples.csv --out map.toml
  cdpr compensate calibrated.toml samples.csv --model pulley+elastic --split region:4 --out map.toml
  cdpr evaluate calibrated.toml validation.csv --compensation map.toml
  cdpr ik calibrated.toml --pose 0.5,0.3,1.6,0,0,0 --compensation map.toml";

/// Correct the lengths of a model over the workspace, where measurements show errors that repeat.
///
/// Give the best physical model, already calibrated: the correction is the smooth part of what it leaves, a Gaussian process of the pose. It is judged
/// on samples held out in turn. Where it does not help there, nothing is written and the exit code is 1; the answer says by which rules. The map fades over a margin around its samples and says nothing beyond it.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    data: DataArguments,

    /// Parts that are held out in turn: blocks:K, kfold:K, region:K or column. Default: blocks:5 where samples have times (t_s), kfold:5 elsewhere.
    #[arg(long, value_name = "SPLIT")]
    split: Option<Split>,

    /// Seed of random parts.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,

    /// File for the map (TOML), written where it helps.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    output.about(&model.robot().name);
    let samples = arguments.data.read(&model, output)?;
    let progress = Progress::spinner("making a map");
    let found = compensate(&model, &samples, arguments.split, arguments.seed)
        .map_err(|error| Failure::refused(&arguments.data.name(), &error))?;
    drop(progress);
    let written = arguments.out.as_ref().filter(|_| found.helps);
    if let Some(path) = written {
        files::write(path, found.map.to_toml().as_bytes())?;
    }
    let out = written.map(|path| path.display().to_string());
    output.answer(&CompensationAnswer::new(&model, arguments.data.name(), output.doubts(), found, out))
}
