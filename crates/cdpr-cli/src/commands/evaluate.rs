//! `cdpr evaluate`: how well a model predicts measurements.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_calibration::compensation::evaluate_compensated;
use cdpr_calibration::{Evaluation, evaluate, evaluate_lengths};
use cdpr_model::compensation::Beyond;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use clap::Args;

use crate::answer::{Output, TrustArguments};
use crate::compensation_option::CompensationOption;
use crate::failure::Failure;
use crate::files;
use crate::inputs::ModelArguments;
use crate::measurements::{DataArguments, refuse_without_poses};
use crate::progress::Progress;
use cdpr_reports::answers::{EvaluationAnswer, errors_csv};

const EXAMPLES: &str = "\
Examples:
  cdpr evaluate robot.toml samples.csv
  cdpr evaluate calibrated.toml validation.csv --model pulley --format json
  cdpr evaluate robot.toml samples.csv --model elastic --out-errors errors.csv
  cdpr evaluate calibrated.toml validation.csv --compensation map.toml";

/// Compare a model with measurements: predicted against measured poses, modelled against recorded lengths.
///
/// Position and rotation errors compare the pose that the model predicts from the recorded lengths with the measured one;
/// length errors compare the model's lengths at the measured pose with the recorded ones. An elastic model predicts under the
/// load that the robot's file states, and so does a rigid one of fewer cables than degrees of freedom; tension errors compare
/// predicted with recorded tensions. Data without poses are compared at the poses where the lengths fit best, with no error of the pose. A sample whose forward problem has no answer has no error, and the exit code is 1, as it is where errors are not to be trusted.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    data: DataArguments,

    #[command(flatten)]
    compensation: CompensationOption,

    #[command(flatten)]
    trust: TrustArguments,

    /// Write the errors of every sample to this CSV file.
    #[arg(long, value_name = "FILE")]
    out_errors: Option<PathBuf>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let map = arguments.compensation.read(&model)?;
    let mut beyond = Beyond::default();
    let (samples, evaluation) = match arguments.data.lacks_poses(&model)? {
        true => {
            let asked = ("--compensation", map.is_some(), "there is no error of the pose to correct");
            refuse_without_poses(&arguments.data.name(), &[asked])?;
            at_best_poses(&arguments.data, &model, output)?
        }
        false => {
            let samples = arguments.data.read(&model, output)?;
            let progress = Progress::spinner("predicting poses");
            let evaluation = match &map {
                Some((map, _)) => evaluate_compensated(&model, &samples, map).map(|(evaluation, of_map)| {
                    beyond = of_map;
                    evaluation
                }),
                None => evaluate(&model, &samples),
            };
            let evaluation = evaluation.map_err(|error| Failure::refused(&model.robot().name, &error))?;
            drop(progress);
            (samples, evaluation)
        }
    };
    if let Some(path) = &arguments.out_errors {
        files::write(path, errors_csv(&model, &evaluation).as_bytes())?;
    }
    let out_errors = arguments.out_errors.map(|path| path.display().to_string());
    let answer =
        EvaluationAnswer::new(&model, arguments.data.name(), &samples, output.doubts(), &evaluation, out_errors);
    let answer = answer.with_compensation(map.map(|(_, file)| file), beyond);
    output.answer_accepting(&answer, arguments.trust)
}

/// Samples without measured poses, and the errors of their lengths at the poses where these fit best.
fn at_best_poses(data: &DataArguments, model: &Model, output: &Output) -> Result<(Samples, Evaluation), Failure> {
    let internal = data.read_internal(model, output)?;
    let evaluation = evaluate_lengths(model, &internal).map_err(|error| Failure::refused(&data.name(), &error))?;
    output.remark(&format!(
        "{}: poses are not measured: lengths are compared at the poses where they fit best, and errors of poses are unknown",
        data.name()
    ));
    Ok((internal.samples, evaluation))
}
