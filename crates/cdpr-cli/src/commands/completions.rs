//! `cdpr completions`: what a shell needs to complete commands, options and their values.

use std::process::ExitCode;

use clap::{Args, CommandFactory};
use clap_complete::Shell;
use schemars::JsonSchema;
use serde::Serialize;

use crate::CommandLine;
use crate::answer::{Answer, Output};
use crate::completion;
use crate::failure::Failure;

const EXAMPLES: &str = "\
Examples:
  cdpr completions bash > ~/.local/share/bash-completion/completions/cdpr
  cdpr completions zsh > ~/.zfunc/_cdpr      # with fpath+=~/.zfunc before compinit in ~/.zshrc
  cdpr completions fish > ~/.config/fish/completions/cdpr.fish
  cdpr completions powershell >> $PROFILE";

/// Print the completions of a shell: its script completes commands, options, their values and file names.
///
/// The scripts of bash, zsh and fish ask `cdpr` itself: names of built-in robots, effects of a model after each `+`, parameters of a list
/// after each comma, criteria with their numbers, methods, error codes. They need not be printed anew for a new version. Those of elvish and
/// PowerShell know commands, options and short lists of choices.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The shell.
    #[arg(value_enum, value_name = "SHELL")]
    shell: Shell,
}

/// Script by which a shell completes commands.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "CompletionScript")]
pub(super) struct Completions {
    /// Name of the shell.
    shell: String,
    /// The script.
    script: String,
}

impl Answer for Completions {
    fn words(&self, _width: Option<usize>) -> String {
        self.script.clone()
    }

    fn is_verbatim(&self) -> bool {
        true
    }
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let script = match arguments.shell {
        Shell::Bash => completion::BASH.to_owned(),
        Shell::Zsh => completion::ZSH.to_owned(),
        Shell::Fish => completion::FISH.to_owned(),
        other => without_values(other),
    };
    output.answer(&Completions { shell: arguments.shell.to_string(), script })
}

/// A script that knows commands, options and the choices of short lists.
fn without_values(shell: Shell) -> String {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut CommandLine::command(), "cdpr", &mut script);
    String::from_utf8_lossy(&script).into_owned()
}
