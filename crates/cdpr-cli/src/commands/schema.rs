//! `cdpr schema`: JSON Schemas of the file formats.

mod answers;
mod command_line;

use std::process::ExitCode;

use clap::{Args, CommandFactory, ValueEnum};
use serde::Serialize;

use crate::CommandLine;
use crate::answer::{Answer, Output};
use crate::failure::Failure;

const EXAMPLES: &str = "\
Examples:
  cdpr schema robot > robot.schema.json
  cdpr schema measurement";

/// Print the JSON Schema of a file format, for editors and other programs.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The file format.
    #[arg(value_enum, value_name = "FILE-FORMAT")]
    of: FileFormat,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum FileFormat {
    /// Robot description (TOML).
    Robot,
    /// Study (TOML): control model, machine, poses and noise.
    Study,
    /// Scenario (TOML): a machine in time, its start, commands and events.
    Scenario,
    /// Sweep (TOML): a study and the parameters that change.
    Sweep,
    /// Answers of all commands (JSON), as `--format json` writes them.
    Answers,
    /// Data block of a page (JSON).
    Page,
    /// All commands with their arguments, from which other languages make functions (JSON, no schema).
    CommandLine,
    #[value(help = "What is known about a measurement file (TOML beside the CSV, whose columns the description tells)")]
    Measurement,
}

#[derive(Serialize)]
#[serde(transparent)]
struct Schema {
    schema: serde_json::Value,
    #[serde(skip)]
    words: String,
}

impl Answer for Schema {
    fn words(&self, _width: Option<usize>) -> String {
        self.words.clone()
    }

    fn is_verbatim(&self) -> bool {
        true
    }
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let value = match arguments.of {
        FileFormat::Robot => cdpr_model::robot::schema().to_value(),
        FileFormat::Study => cdpr_study::study::schema().to_value(),
        FileFormat::Scenario => cdpr_plant::scenario::schema().to_value(),
        FileFormat::Sweep => cdpr_study::sweep::schema().to_value(),
        FileFormat::Answers => answers::schema().to_value(),
        FileFormat::Page => cdpr_reports::page_schema().to_value(),
        FileFormat::CommandLine => command_line::described(&CommandLine::command()),
        FileFormat::Measurement => cdpr_model::measurement::schema().to_value(),
    };
    let words = serde_json::to_string_pretty(&value).map_err(|error| Failure::unwritable("the schema", &error))?;
    output.answer(&Schema { schema: value, words })
}
