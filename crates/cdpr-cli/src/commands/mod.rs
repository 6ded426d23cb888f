//! The subcommands, one file each: arguments, run, answer.

use std::process::ExitCode;

use crate::answer::Output;
use crate::failure::Failure;

// Declared outside the macro, so that `cargo fmt` finds them.
mod accuracy;
mod advise;
mod benchmark;
mod campaign;
mod capability;
mod chain;
mod check;
mod compensate;
mod completions;
mod demo;
mod dynamics;
mod evaluate;
mod explain;
mod export;
mod fk;
mod frequency_response;
mod friction;
mod identify;
mod ik;
mod import;
pub(crate) mod initial_tension;
mod load;
mod man;
mod model;
mod modes;
pub(crate) mod new;
mod place_pulleys;
mod plan;
mod reachable;
mod robots;
mod run;
mod schema;
mod select;
mod sensitivity;
mod simulate;
mod stiffness;
mod study;
mod sweep;
mod tension;
mod test_bench;
mod workspace;

pub use sweep::{PlanRefused, PreparedPlan};

/// One line per subcommand, under the heading of `cdpr --help` that it stands under: its file and its name; the arguments and the help
/// are in the file.
macro_rules! commands {
    ($($heading:literal { $($module:ident: $name:ident,)* })*) => {
        #[derive(Debug, clap::Subcommand)]
        pub(crate) enum Command {
            $($($name($module::Arguments),)*)*
        }

        /// Headings of `cdpr --help` with the files of their subcommands.
        const HEADINGS: &[(&str, &[&str])] = &[$(($heading, &[$(stringify!($module)),*])),*];

        impl Command {
            /// Runs the subcommand; the answer goes to `output`.
            pub(crate) fn run(self, output: &mut Output) -> Result<ExitCode, Failure> {
                match self {
                    $($(Self::$name(arguments) => $module::run(arguments, output),)*)*
                }
            }
        }
    };
}

commands! {
    "Robots" {
        robots: Robots,
        new: New,
        check: Check,
        place_pulleys: PlacePulleys,
        import: Import,
    }
    "One pose" {
        ik: Ik,
        fk: Fk,
        tension: Tension,
        load: Load,
        stiffness: Stiffness,
        dynamics: Dynamics,
        modes: Modes,
        model: Model,
    }
    "Workspace" {
        workspace: Workspace,
        capability: Capability,
        reachable: Reachable,
        sweep: Sweep,
    }
    "A control model on a machine" {
        advise: Advise,
        accuracy: Accuracy,
        study: Study,
        sensitivity: Sensitivity,
        initial_tension: InitialTension,
        benchmark: Benchmark,
        chain: Chain,
    }
    "Measurements and calibration" {
        demo: Demo,
        plan: Plan,
        simulate: Simulate,
        identify: Identify,
        select: Select,
        evaluate: Evaluate,
        compensate: Compensate,
        campaign: Campaign,
        test_bench: TestBench,
        frequency_response: FrequencyResponse,
        friction: Friction,
    }
    "A machine in time" {
        run: Run,
    }
    "Files and help" {
        export: Export,
        schema: Schema,
        explain: Explain,
        completions: Completions,
        man: Man,
    }
}

/// Subcommands in groups with a line each, as `cdpr --help` lists them.
pub(crate) fn listed(command: &clap::Command, width: usize) -> String {
    let header = command.get_styles().get_header();
    let name = command.get_styles().get_literal();
    let longest = command.get_subcommands().map(|own| own.get_name().len()).max().unwrap_or(0);
    let mut text = String::new();
    for (heading, modules) in HEADINGS {
        text.push_str(&format!("{header}{heading}:{header:#}\n"));
        for module in *modules {
            let word = module.replace('_', "-");
            let about = command.find_subcommand(&word).and_then(|own| own.get_about()).map(ToString::to_string);
            let indent = longest + 4;
            let lines = filled(&about.unwrap_or_default(), width.saturating_sub(indent));
            let padding = " ".repeat(longest - word.len() + 2);
            let about = lines.join(&format!("\n{}", " ".repeat(indent)));
            text.push_str(&format!("  {name}{word}{name:#}{padding}{about}\n"));
        }
        text.push('\n');
    }
    text
}

/// Words in lines of at most this many characters, unless one word is longer.
fn filled(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut().filter(|line| line.chars().count() + 1 + word.chars().count() <= width) {
            Some(line) => line.extend([" ", word]),
            None => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;
    use crate::CommandLine;

    #[test]
    fn every_subcommand_is_listed_under_one_heading_and_lines_keep_the_width() {
        let command = CommandLine::command();
        let words: Vec<String> =
            HEADINGS.iter().flat_map(|(_, modules)| modules.iter().map(|module| module.replace('_', "-"))).collect();
        assert!(command.get_subcommands().map(clap::Command::get_name).eq(words.iter().map(String::as_str)));
        let plain = listed(&command.styles(clap::builder::Styles::plain()), 60);
        assert!(plain.lines().all(|line| line.chars().count() <= 60), "{plain}");
        assert!(plain.contains("\nOne pose:\n  ik                  Inverse kinematics: cable lengths,\n"), "{plain}");
    }
}
