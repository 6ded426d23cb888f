//! The `cdpr` command: calibration and model selection for cable-driven parallel robots.

mod answer;
mod commands;
mod compensation_option;
mod console;
mod diagnostics;
mod explanations;
mod failure;
mod files;
mod inputs;
mod interruption;
mod keyword;
mod measurements;
mod meshes;
mod numbers;
mod options;
mod progress;
mod scenario_file;
mod selecting;
mod sensitivities;
mod statics_failure;
mod study_file;
mod tension_choice;
mod tension_method;
mod usage;

use std::process::ExitCode;

use answer::Output;
use clap::{ArgMatches, CommandFactory, FromArgMatches, Parser};
use commands::Command;
use options::GlobalOptions;

/// Calibration and model selection for cable-driven parallel robots.
///
/// Numbers go in and out in SI units (m, rad, N). Answers go to stdout, everything else to stderr. Exit codes: 0 done,
/// 1 the answer is negative, 2 wrong usage or input, 3 numerical failure, 4 a file cannot be read or written,
/// 130 interrupted (Ctrl-C; no file is left half-written).
#[derive(Debug, Parser)]
#[command(name = "cdpr", version, propagate_version = false, after_help = EXAMPLES)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,

    #[command(flatten)]
    options: GlobalOptions,
}

const EXAMPLES: &str = "\
Examples:
  cdpr robots
  cdpr new suspended-camera --out my-robot
  cdpr ik planar-example --pose 0.5,4
  cdpr identify robot.toml samples.csv --free length-offset --out calibrated.toml
  cdpr identify --help";

fn main() -> ExitCode {
    let matches = match CommandLine::command().try_get_matches() {
        Ok(matches) => matches,
        Err(error) => return usage::exit(&error),
    };
    let parsed = match CommandLine::from_arg_matches(&matches) {
        Ok(parsed) => parsed,
        Err(error) => return usage::exit(&error),
    };
    interruption::watch();
    let mut output = Output::new(parsed.options.format);
    let exit = parsed.options.settle().and_then(|()| parsed.command.run(&mut output));
    exit.unwrap_or_else(|failure| match robot_argument(&matches) {
        Some(argument) => {
            if let Ok(robot) = inputs::read_robot(argument) {
                output.about(&robot.name);
            }
            output.fail(&failure.with_value("ROBOT", argument))
        }
        None => output.fail(&failure),
    })
}

/// `ROBOT` as it was given, a file or a name, of a command that takes one.
fn robot_argument(matches: &ArgMatches) -> Option<&String> {
    matches.subcommand().and_then(|(_, own)| own.try_get_one::<String>("robot").ok().flatten())
}

/// The command as it was given, quoted for a shell, without the options that do not touch the result.
fn command_line() -> String {
    let words: Vec<String> = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    let words = options::that_matter(&words);
    ["cdpr".to_owned()].into_iter().chain(words.iter().map(|word| quoted(word))).collect::<Vec<_>>().join(" ")
}

/// A word as a shell takes it for one.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,:".contains(c);
    match !word.is_empty() && word.chars().all(plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}
