//! `cdpr accuracy`: how accurately a control model drives a machine.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::numbers::number_from_zero;
use crate::progress::Progress;
use crate::study_file::StudyFile;
use crate::tension_method::TensionMethodArgument;
use cdpr_reports::answers::{AccuracyAnswer, Assessed};

const EXAMPLES: &str = "\
Examples:
  cdpr accuracy study.toml
  cdpr accuracy studies/twin-nominal.toml --format json
  cdpr accuracy study.toml --seed 7";

/// Drive a machine by a control model through the poses of a study, and compare what emerges with what was commanded.
///
/// Position and rotation errors compare the emerging with the commanded pose; length errors compare what the control model
/// would send for the emerging pose with what it sent (eq. 6.6). With [prediction], another model is asked what emerges, and how
/// far it is from the machine's pose and tensions. Sensor noise and tension tests of the study do not count.
/// The answer is negative (exit code 1) when a pose has no answer; tensions outside the limits are told, not judged.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Study file (TOML); `cdpr schema study` describes it.
    #[arg(value_name = "STUDY")]
    study: PathBuf,

    /// Seed of random poses.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,

    #[command(flatten)]
    choice: TensionMethodArgument,

    /// Machines with hysteresis: how far to either side the platform comes from along each translation, to tell how far branches
    /// lie apart (m).
    #[arg(long, value_name = "M", default_value_t = 0.1, value_parser = number_from_zero, allow_hyphen_values = true)]
    stroke: f64,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let study_file = StudyFile::read(&arguments.study)?.with_tension_method(arguments.choice.tension_method);
    study_file.introduce(output);
    let progress = Progress::spinner("driving the machine");
    let poses = study_file.poses(arguments.seed)?;
    let assessment = study_file.accepted(study_file.assess(&poses))?;
    let prediction = study_file.predict(&poses).map_err(|error| study_file.refused(&error))?;
    let branches = study_file.accepted(study_file.branches(&poses, arguments.stroke))?;
    let initial_tensions = study_file.accepted(study_file.initial_tensions())?;
    drop(progress);
    let prediction = prediction.map(|found| found.blocks());
    let found = Assessed { assessment, prediction, branches, initial_tensions, seed: arguments.seed };
    let answer = AccuracyAnswer::new(&study_file, found);
    answer.remarks().iter().for_each(|remark| output.remark(remark));
    output.answer(&answer)
}
