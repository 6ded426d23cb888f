//! What a command answers, and how it is written.

use std::io::{self, Write};
use std::process::ExitCode;

use clap::ValueEnum;
use serde::Serialize;

use crate::diagnostics;
use crate::failure::Failure;

/// How an answer is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Tables and sentences for people.
    Text,
    /// One JSON object for scripts; numbers that are not finite are null.
    Json,
}

impl Format {
    /// The format that a command line asks for which could not be parsed.
    pub(crate) fn asked_for(arguments: impl Iterator<Item = String>) -> Self {
        let words: Vec<String> = arguments.collect();
        let json = words.iter().any(|word| word == "--format=json")
            || words.windows(2).any(|pair| pair[0] == "--format" && pair[1] == "json");
        if json { Self::Json } else { Self::Text }
    }
}

/// The result of a command: the fields for scripts, words for people.
pub(crate) trait Answer: Serialize {
    /// The answer for people.
    fn words(&self) -> String;

    /// True when the answer is a no: exit code 1.
    fn is_negative(&self) -> bool {
        false
    }
}

/// Where answers and remarks go.
pub(crate) struct Output {
    format: Format,
}

impl Output {
    pub(crate) fn new(format: Format) -> Self {
        Self { format }
    }

    /// Writes the answer to stdout and tells the exit code.
    pub(crate) fn answer(&self, answer: &impl Answer) -> Result<ExitCode, Failure> {
        let text = match self.format {
            Format::Text => answer.words(),
            Format::Json => json(answer)?,
        };
        to_stdout(&text)?;
        Ok(ExitCode::from(u8::from(answer.is_negative())))
    }

    /// Tells something that is not part of the answer, on stderr.
    pub(crate) fn remark(&self, text: &str) {
        diagnostics::remark(text);
    }

    /// Tells the failure on stderr, and as an object on stdout when JSON was asked for.
    pub(crate) fn fail(&self, failure: &Failure) -> ExitCode {
        diagnostics::failure(failure);
        self.mirror(failure)
    }

    /// The failure as an object on stdout when JSON was asked for.
    pub(crate) fn mirror(&self, failure: &Failure) -> ExitCode {
        if self.format == Format::Json
            && let Ok(text) = json(&failure.object())
        {
            // the exit code already tells that something failed
            let _ = to_stdout(&text);
        }
        ExitCode::from(failure.exit_code())
    }
}

fn json(value: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string(value).map_err(|error| Failure::unwritable("the answer", &error))
}

fn to_stdout(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    let end = if text.ends_with('\n') { "" } else { "\n" };
    match write!(stdout, "{text}{end}").and_then(|()| stdout.flush()) {
        // the reader, `head` for one, has seen enough
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        Err(error) => Err(Failure::io("write to", "stdout", &error)),
        Ok(()) => Ok(()),
    }
}
