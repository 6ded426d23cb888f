//! `cdpr robots`: what is built in.

use std::process::ExitCode;

use cdpr::robot::{Robot, builtin};
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::table::Table;

/// List the built-in robots.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  cdpr robots\n  cdpr robots --format json")]
pub(crate) struct Arguments {}

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
    fn words(&self) -> String {
        let mut table = Table::new(["name", "pattern", "cables", "title"]);
        for entry in &self.robots {
            let title = entry.title.clone().unwrap_or_default();
            table.row(vec![entry.name.clone(), entry.motion_pattern.to_owned(), entry.cable_count.to_string(), title]);
        }
        table.left_column(3).text()
    }
}

pub(crate) fn run(_: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let entry = |robot: Robot| Entry {
        motion_pattern: robot.motion_pattern.name(),
        cable_count: robot.cable_count(),
        name: robot.name,
        title: robot.title,
    };
    let robots = builtin::names().filter_map(Robot::builtin).map(entry).collect();
    output.answer(&Robots { robots })
}
