//! Options that every command takes.

use std::num::{NonZero, NonZeroU16};

use clap::Args;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::answer::{Format, Output};
use crate::console::{ColorChoice, Console};
use crate::failure::Failure;
use crate::option_headings::GENERAL;

/// Threads that any machine can start.
const MOST_THREADS: usize = 64;

/// Stack of a thread that a command runs on (bytes), as much as systems give to the first one.
const STACK: usize = 8 << 20;

/// How the run talks and how much of the computer it takes.
#[derive(Debug, Args)]
#[command(next_help_heading = GENERAL)]
pub(crate) struct GlobalOptions {
    /// Write the answer as tables for people, or as one JSON object (numbers that are not finite are null).
    #[arg(long, global = true, value_enum, default_value_t = Format::Text, value_name = "text|json")]
    #[arg(hide_possible_values = true, display_order = 900)]
    pub(crate) format: Format,

    /// Say nothing but the answer and errors: no notes, no progress.
    #[arg(short, long, global = true, display_order = 901)]
    quiet: bool,

    /// Show all that there is to say, where an answer is otherwise kept to one screen (`select`, `identify`, `demo`).
    #[arg(short, long, global = true, display_order = 902)]
    verbose: bool,

    /// Colour on terminals (auto; NO_COLOR and CLICOLOR_FORCE are heeded), everywhere, or nowhere.
    #[arg(long, global = true, value_enum, default_value_t = ColorChoice::Auto, value_name = "auto|always|never")]
    #[arg(hide_possible_values = true, display_order = 903)]
    color: ColorChoice,

    /// Threads to calculate with, at most; all processors when left out. The result is the same for any number, and more than 64 are
    /// started only where there are as many processors.
    #[arg(long, global = true, value_name = "N", display_order = 904)]
    threads: Option<NonZeroU16>,
}

impl GlobalOptions {
    /// Wishes about what is written besides the answer.
    pub(crate) fn console(&self) -> Console {
        Console { color: self.color, quiet: self.quiet, verbose: self.verbose }
    }

    /// The threads to calculate with; `None` if they are left to the process.
    pub(crate) fn pool(&self, output: &Output<'_>) -> Result<Option<ThreadPool>, Failure> {
        let Some(threads) = self.threads else { return Ok(None) };
        let processors = std::thread::available_parallelism().map_or(1, NonZero::get);
        let started = usize::from(threads.get()).min(processors.max(MOST_THREADS));
        if started < usize::from(threads.get()) {
            output.tell(&format!(
                "--threads {threads}: {started} are started; there are {processors} processors, and more threads would only wait for them"
            ));
        }
        ThreadPoolBuilder::new().num_threads(started).stack_size(STACK).build().map(Some).map_err(|error| {
            Failure::input(
                "usage::threads",
                format!("--threads {threads}: {error}"),
                "ask for fewer threads, or leave --threads out",
            )
        })
    }
}

/// The words of a command line without colour, quiet, verbose and threads, which do not touch the result.
pub(crate) fn that_matter(words: &[String]) -> Vec<&String> {
    let mut kept = Vec::new();
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        match word.as_str() {
            "--" => {
                kept.push(word);
                kept.extend(rest.by_ref());
            }
            "--quiet" | "-q" | "--verbose" | "-v" => {}
            "--color" | "--threads" => drop(rest.next()),
            other if other.starts_with("--color=") || other.starts_with("--threads=") => {}
            _ => kept.push(word),
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_touch_the_result_is_not_part_of_its_provenance() {
        let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        let given = words("--threads 3 select --color=never a.toml -q --verbose --threads=2 --seed 4 -- --quiet");
        assert_eq!(
            that_matter(&given).into_iter().cloned().collect::<Vec<_>>(),
            words("select a.toml --seed 4 -- --quiet")
        );
    }
}
