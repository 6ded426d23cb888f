//! `cdpr robots`: what is built in.

use std::process::ExitCode;

use cdpr_model::robot::{Robot, builtin};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::inputs::help_for_unknown_robot;
use cdpr_reports::answers::RobotsAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr robots
  cdpr robots planar-example > my-robot.toml
  cdpr robots --format json";

/// List the built-in robots, or print the file of one to start your own from.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// A built-in robot, to print its file (TOML).
    #[arg(value_name = "NAME")]
    name: Option<String>,
}

/// File of a built-in robot.
#[derive(Serialize, JsonSchema)]
pub(super) struct RobotFile {
    name: String,
    /// Text of the file (TOML).
    toml: &'static str,
}

impl Answer for RobotFile {
    fn words(&self, _width: Option<usize>) -> String {
        self.toml.to_owned()
    }

    fn is_verbatim(&self) -> bool {
        true
    }
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    if let Some(name) = arguments.name {
        let toml = builtin::find(&name).ok_or_else(|| {
            let message = format!("there is no built-in robot named `{name}`");
            Failure::input("robot::unknown-name", message, help_for_unknown_robot(&name))
        })?;
        return output.answer(&RobotFile { name, toml });
    }
    output.answer(&RobotsAnswer::of(builtin::names().filter_map(Robot::builtin)))
}
