//! `cdpr robots`: what is built in.

use std::process::ExitCode;

use cdpr::robot::{Robot, builtin};
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::inputs::help_for_unknown_robot;
use cdpr_reports::table::Table;

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

#[derive(Serialize)]
struct RobotFile {
    name: String,
    toml: &'static str,
}

impl Answer for RobotFile {
    fn words(&self, _width: Option<usize>) -> String {
        self.toml.to_owned()
    }
}

#[derive(Serialize)]
struct Robots {
    robots: Vec<Entry>,
}

#[derive(Serialize)]
struct Entry {
    name: String,
    motion_pattern: &'static str,
    cable_count: usize,
    title: Option<String>,
}

impl Answer for Robots {
    fn words(&self, width: Option<usize>) -> String {
        let mut table = Table::new(["name", "pattern", "cables", "title"]);
        for entry in &self.robots {
            let title = entry.title.clone().unwrap_or_default();
            table.row(vec![entry.name.clone(), entry.motion_pattern.to_owned(), entry.cable_count.to_string(), title]);
        }
        table.left_column(3).text(width)
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
    let entry = |robot: Robot| Entry {
        motion_pattern: robot.motion_pattern.name(),
        cable_count: robot.cable_count(),
        name: robot.name,
        title: robot.title,
    };
    let robots = builtin::names().filter_map(Robot::builtin).map(entry).collect();
    output.answer(&Robots { robots })
}
