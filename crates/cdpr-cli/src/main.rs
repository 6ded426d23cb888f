//! The `cdpr` command: calibration and model selection for cable-driven parallel robots.

mod answer;
mod commands;
mod diagnostics;
mod error_table;
mod failure;
mod figures;
mod files;
mod inputs;
mod laboratory;
mod measurements;
mod numbers;
mod pose_answer;
mod progress;
mod report;
mod selecting;
mod statics_failure;
mod table;
mod tension_choice;
mod wrench_answer;

use std::process::ExitCode;

use answer::{Format, Output};
use clap::Parser;
use clap::error::ErrorKind;
use commands::Command;
use failure::Failure;

/// Calibration and model selection for cable-driven parallel robots.
///
/// Numbers go in and out in SI units (m, rad, N). Answers go to stdout, everything else to stderr. Exit codes: 0 done,
/// 1 the answer is negative, 2 wrong usage or input, 3 numerical failure, 4 a file cannot be read or written.
#[derive(Debug, Parser)]
#[command(name = "cdpr", version, propagate_version = false, disable_help_subcommand = true, after_help = EXAMPLES)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,

    /// Write the answer as tables for people, or as one JSON object (numbers that are not finite are null).
    #[arg(long, global = true, value_enum, default_value_t = Format::Text, value_name = "text|json")]
    #[arg(hide_possible_values = true, display_order = 900)]
    format: Format,
}

const EXAMPLES: &str = "\
Examples:
  cdpr robots
  cdpr ik planar-example --pose 0.5,4
  cdpr identify robot.toml samples.csv --free length-offset --out calibrated.toml
  cdpr identify --help";

fn main() -> ExitCode {
    let parsed = match CommandLine::try_parse() {
        Ok(parsed) => parsed,
        Err(error) => return usage_exit(&error),
    };
    let mut output = Output::new(parsed.format);
    let exit = parsed.command.run(&mut output);
    match exit {
        Ok(exit) => exit,
        Err(failure) => output.fail(&failure),
    }
}

/// Help and version are answers; anything else that stops the parser is a usage error.
fn usage_exit(error: &clap::Error) -> ExitCode {
    // when stdout or stderr is gone there is nobody to tell
    let _ = error.print();
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => ExitCode::SUCCESS,
        _ => {
            let failure = Failure::usage(first_paragraph(&error.to_string()));
            Output::new(Format::asked_for(std::env::args())).mirror(&failure)
        }
    }
}

/// What clap says before its usage lines, as one line.
fn first_paragraph(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim).take_while(|line| !line.is_empty()).collect();
    let line = lines.join(" ");
    line.strip_prefix("error: ").unwrap_or(&line).to_owned()
}

/// The command as it was given, quoted for a shell.
fn command_line() -> String {
    let quoted = |word: String| {
        let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,:".contains(c);
        if !word.is_empty() && word.chars().all(plain) { word } else { format!("'{}'", word.replace('\'', r"'\''")) }
    };
    let words = std::env::args_os().skip(1).map(|word| quoted(word.to_string_lossy().into_owned()));
    ["cdpr".to_owned()].into_iter().chain(words).collect::<Vec<_>>().join(" ")
}
