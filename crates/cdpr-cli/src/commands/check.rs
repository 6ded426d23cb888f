//! `cdpr check`: what can be said about a robot file without moving the robot.

use std::process::ExitCode;

use cdpr_model::model::{Composition, Model};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::inputs::RobotArgument;
use cdpr_reports::answers::CheckAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr check planar-example
  cdpr check robot.toml --format json";

/// Read a robot file, judge the geometry at the home pose, list the models that the file supports and tell what is missing.
///
/// Rank and condition are those of the structure matrix at home, moment rows divided by the mean platform radius. The answer
/// is negative (exit code 1) when the home pose is singular.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    robot: RobotArgument,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let robot = arguments.robot.read()?;
    let supported = Composition::supported(&robot).map_err(|error| Failure::refused("ROBOT", &error))?;
    let model = Model::new(robot, Composition::STANDARD).map_err(|error| Failure::refused("ROBOT", &error))?;
    output.answer(&CheckAnswer::of(&model, &supported))
}
