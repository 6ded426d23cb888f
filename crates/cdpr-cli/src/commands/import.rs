//! `cdpr import`: robots of other tools.

mod caspr;

use std::process::ExitCode;

use clap::{Args, Subcommand};

use crate::answer::Output;
use crate::failure::Failure;

const EXAMPLES: &str = "\
Examples:
  cdpr import caspr CoGiRo_bodies.xml CoGiRo_cables.xml --out cogiro.toml
  cdpr import caspr --help";

/// Make a robot file of another tool's model.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    tool: Tool,
}

#[derive(Debug, Subcommand)]
enum Tool {
    Caspr(caspr::Arguments),
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    match arguments.tool {
        Tool::Caspr(arguments) => caspr::run(&arguments, output),
    }
}
