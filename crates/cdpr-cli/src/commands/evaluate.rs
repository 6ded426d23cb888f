//! `cdpr evaluate`: how well a model predicts measurements.

use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;

use cdpr::geometry::MotionPattern;
use cdpr::identification::{ErrorBlocks, Evaluation, evaluate};
use cdpr::model::Model;
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::error_table::error_table;
use crate::failure::Failure;
use crate::files;
use crate::inputs::ModelArguments;
use crate::measurements::DataArguments;
use crate::progress::Progress;

const EXAMPLES: &str = "\
Examples:
  cdpr evaluate robot.toml samples.csv
  cdpr evaluate calibrated.toml validation.csv --model pulley --format json
  cdpr evaluate robot.toml samples.csv --model elastic --out-errors errors.csv";

/// Compare a model with measurements: predicted against measured poses, modelled against recorded lengths.
///
/// Position and rotation errors compare the pose that the model predicts from the recorded lengths with the measured one;
/// length errors compare the model's lengths at the measured pose with the recorded ones. An elastic model predicts under the
/// load that the robot's file states, and so does a rigid one of fewer cables than degrees of freedom; tension errors compare
/// predicted with recorded tensions. A sample whose forward problem has no answer has no error, and the exit code is 1.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    data: DataArguments,

    /// Write the errors of every sample to this CSV file.
    #[arg(long, value_name = "FILE")]
    out_errors: Option<PathBuf>,
}

#[derive(Serialize)]
struct Evaluated {
    robot: String,
    model: String,
    data: String,
    status: &'static str,
    reason: Option<String>,
    #[serde(flatten)]
    blocks: ErrorBlocks,
    #[serde(skip_serializing_if = "Option::is_none")]
    out_errors: Option<String>,
    #[serde(skip)]
    pattern: MotionPattern,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let samples = arguments.data.read(&model, output)?;
    let progress = Progress::spinner("predicting poses");
    let evaluation = evaluate(&model, &samples).map_err(|error| Failure::refused(&model.robot().name, &error))?;
    drop(progress);
    if let Some(path) = &arguments.out_errors {
        files::write(path, errors_csv(&model, &evaluation).as_bytes())?;
    }
    let reason = reason(&evaluation);
    output.answer(&Evaluated {
        robot: model.robot().name.clone(),
        model: model.composition().to_string(),
        data: arguments.data.name(),
        status: if reason.is_none() { "converged" } else { "not-converged" },
        reason,
        blocks: evaluation.blocks(),
        out_errors: arguments.out_errors.map(|path| path.display().to_string()),
        pattern: model.robot().motion_pattern,
    })
}

/// Why the forward problem failed, by the first sample at which it did.
fn reason(evaluation: &Evaluation) -> Option<String> {
    let (sample, why) = evaluation.not_converged.first()?;
    let (failed, all) = (evaluation.not_converged.len(), evaluation.len());
    Some(format!(
        "the forward problem of {failed} of {all} samples has no answer, first at sample {}: {why}",
        sample + 1
    ))
}

/// One line for each sample; a number that does not exist is left empty.
fn errors_csv(model: &Model, evaluation: &Evaluation) -> String {
    let cables = model.cable_count();
    let mut text = "sample,position_error_m,error_x_m,error_y_m,error_z_m,rotation_error_rad".to_owned();
    (1..=cables).for_each(|cable| text.push_str(&format!(",length_error_m_{cable}")));
    let has_tensions = !evaluation.tension.is_empty();
    (1..=cables).filter(|_| has_tensions).for_each(|cable| text.push_str(&format!(",tension_error_N_{cable}")));
    text.push_str(",converged\n");
    let failed: Vec<usize> = evaluation.not_converged.iter().map(|(sample, _)| *sample).collect();
    for sample in 0..evaluation.len() {
        let mut numbers = vec![evaluation.position[sample]];
        numbers.extend(evaluation.position_vector[sample]);
        numbers.push(evaluation.rotation[sample]);
        numbers.extend(&evaluation.length[sample * cables..][..cables]);
        if has_tensions {
            numbers.extend(&evaluation.tension[sample * cables..][..cables]);
        }
        text.push_str(&(sample + 1).to_string());
        for number in numbers {
            // writing to a String cannot fail
            let _ = if number.is_finite() { write!(text, ",{number}") } else { write!(text, ",") };
        }
        text.push_str(if failed.binary_search(&sample).is_ok() { ",false\n" } else { ",true\n" });
    }
    text
}

impl Answer for Evaluated {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self) -> String {
        let Self { robot, model, data, blocks, .. } = self;
        let mut text = format!("{robot}, model {model}, on {data} ({} samples)\n", blocks.samples);
        if let Some(reason) = &self.reason {
            let answered = match blocks.answered {
                0 => "there is no error of the pose to tell".to_owned(),
                count => format!("errors of the pose are those of the other {count}"),
            };
            text.push_str(&format!("{reason}; {answered}\n"));
        }
        text.push_str(&format!("\n{}", error_table(self.pattern, &[("value", blocks)])));
        if let Some(path) = &self.out_errors {
            text.push_str(&format!("\nerrors of every sample written to {path}\n"));
        }
        text
    }
}
