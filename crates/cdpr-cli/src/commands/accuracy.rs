//! `cdpr accuracy`: how accurately a control model drives a machine.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_model::control::CommandedPose;
use cdpr_study::accuracy::Assessment;
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::numbers::number_from_zero;
use crate::progress::Progress;
use crate::study_file::StudyFile;
use crate::tension_method::TensionMethodArgument;
use cdpr_reports::answers::{AccuracyAnswer, Assessed, DifferenceAnswer};

const EXAMPLES: &str = "\
Examples:
  cdpr accuracy study.toml
  cdpr accuracy studies/twin-nominal.toml --format json
  cdpr accuracy study.toml --seed 7
  cdpr accuracy studies/planar-wide-calibrated.toml --against studies/planar-wide-grid.toml --map difference.svg";

/// Drive a machine by a control model through the poses of a study, and compare what emerges with what was commanded.
///
/// Position and rotation errors compare the emerging with the commanded pose; length errors compare what the control model
/// would send for the emerging pose with what it sent (eq. 6.6). With [prediction], another model is asked what emerges, and how
/// far it is from the machine's pose and tensions. Sensor noise and tension tests of the study do not count.
/// Force control that follows the commanded tensions worse than the control model by which the winches were set (offset_robot), or than
/// that of --against, is a caution before all else (status converged-with-caution, exit code 0).
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

    /// Another study of the same machine, whose controller is driven to the same poses: the difference of the errors beside them.
    #[arg(long, value_name = "STUDY")]
    against: Option<PathBuf>,

    /// File for a map of the difference (SVG): discs where this controller is better, triangles where it is worse.
    #[arg(long, value_name = "FILE", requires = "against")]
    map: Option<PathBuf>,
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
    let force_tracking = study_file.force_tracking(&poses, &assessment);
    drop(progress);
    let prediction = prediction.map(|found| found.blocks());
    let difference = difference(&arguments, &study_file, (&poses, &assessment), output)?;
    let found = Assessed { assessment, prediction, branches, initial_tensions, force_tracking, seed: arguments.seed };
    let answer = AccuracyAnswer::new(&study_file, found).against(difference);
    answer.remarks().iter().for_each(|remark| output.remark(remark));
    output.answer(&answer)
}

/// The difference to the controller of another study, and its map.
fn difference(
    arguments: &Arguments,
    study_file: &StudyFile,
    (poses, assessment): (&[CommandedPose], &Assessment),
    output: &mut Output,
) -> Result<Option<DifferenceAnswer>, Failure> {
    let Some(path) = &arguments.against else { return Ok(None) };
    let other = StudyFile::read(path)?.with_tension_method(arguments.choice.tension_method);
    let machine = |file: &StudyFile| (file.machine.robot().clone(), file.machine.composition());
    if machine(&other) != machine(study_file) {
        output.remark(&format!(
            "{}: the machine is another one, so that more than the controller differs",
            path.display()
        ));
    }
    let found = assessment.difference(poses, &other.accepted(other.assess(poses))?);
    let answer = DifferenceAnswer::new(study_file, &path.display().to_string(), &other, found);
    if let Some(file) = &arguments.map {
        let svg = answer.map(study_file, poses).ok_or_else(|| {
            let message = "--map: no pose is reached by both controllers, so there is nothing to draw";
            Failure::input("workspace::mesh", message, "leave --map out")
        })?;
        files::write(file, svg.as_bytes())?;
    }
    Ok(Some(answer))
}
