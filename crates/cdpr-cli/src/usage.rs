//! Command lines that cannot be understood, and the help that was asked for.

use std::error::Error;
use std::process::ExitCode;

use cdpr_calibration::candidate::CandidateError;
use cdpr_calibration::fit;
use cdpr_calibration::selection::RequirementError;
use cdpr_model::measurement::{KnownError, SplitError};
use cdpr_model::model::{CompositionError, ParameterError};
use cdpr_model::reading::ErrorCode;
use cdpr_reports::paragraphs::Paragraphs;
use clap::error::ErrorKind;

use crate::answer::{Format, Output};
use crate::console::{self, Console};
use crate::failure::Failure;
use crate::stream::Stream;

/// Help and version are answers; anything else that stops the parser is a usage error.
pub(crate) fn exit(error: &clap::Error, words: &[String], out: &mut dyn Stream, err: &mut dyn Stream) -> ExitCode {
    let console = Console { color: console::color_asked_for(words), ..Console::default() };
    if !error.use_stderr() {
        write(out, console, error);
        return ExitCode::SUCCESS;
    }
    write(err, console, error);
    let failure = Failure::usage(code(error), first_paragraph(&error.to_string()));
    Output::new(Format::asked_for(words), console, out, err).mirror(&failure)
}

/// The library's code where the library refused a value, else one for the kind of mistake.
fn code(error: &clap::Error) -> &'static str {
    if let Some(code) = error.source().and_then(code_of_value) {
        return code;
    }
    match error.kind() {
        ErrorKind::UnknownArgument => "usage::unknown-option",
        ErrorKind::InvalidSubcommand => "usage::unknown-command",
        ErrorKind::MissingRequiredArgument
        | ErrorKind::MissingSubcommand
        | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => "usage::missing-argument",
        ErrorKind::ArgumentConflict => "usage::conflict",
        ErrorKind::InvalidUtf8 => "usage::not-utf8",
        _ => "usage::value",
    }
}

/// The code of an option's value that the library's own parsers refuse.
fn code_of_value(error: &(dyn Error + 'static)) -> Option<&'static str> {
    fn of<T: ErrorCode + 'static>(error: &(dyn Error + 'static)) -> Option<&'static str> {
        error.downcast_ref::<T>().map(ErrorCode::code)
    }
    of::<CompositionError>(error)
        .or_else(|| of::<ParameterError>(error))
        .or_else(|| of::<CandidateError>(error))
        .or_else(|| of::<RequirementError>(error))
        .or_else(|| of::<SplitError>(error))
        .or_else(|| of::<KnownError>(error))
        .or_else(|| of::<fit::InputError>(error))
}

fn write(stream: &mut dyn Stream, console: Console, error: &clap::Error) {
    let styled = error.render();
    let text = if console.has_colour(stream) { styled.ansi().to_string() } else { styled.to_string() };
    let text = if error.use_stderr() { text.replacen("error:", &format!("error[{}]:", code(error)), 1) } else { text };
    let width = console::message_width(stream).filter(|_| error.use_stderr());
    let text = width.map_or(text.clone(), |width| Paragraphs::of(&text).text(width, false));
    // when the stream is gone there is nobody to tell
    let _ = stream.write_all(text.as_bytes());
}

/// Words of clap before its usage lines, as one line.
fn first_paragraph(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim).take_while(|line| !line.is_empty()).collect();
    let line = lines.join(" ");
    line.strip_prefix("error: ").unwrap_or(&line).to_owned()
}
