//! Command lines that cannot be understood, and the help that was asked for.

use std::env;
use std::io::{self, IsTerminal, Write};
use std::process::ExitCode;

use clap::error::ErrorKind;

use crate::answer::{Format, Output};
use crate::console::{self, Console};
use crate::failure::Failure;

/// Help and version are answers; anything else that stops the parser is a usage error.
pub(crate) fn exit(error: &clap::Error) -> ExitCode {
    let color = console::color_asked_for(env::args());
    console::settle(Console { color, quiet: false });
    if !error.use_stderr() {
        write(io::stdout(), error);
        return ExitCode::SUCCESS;
    }
    write(io::stderr(), error);
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => ExitCode::SUCCESS,
        _ => {
            let failure = Failure::usage(first_paragraph(&error.to_string()));
            Output::new(Format::asked_for(env::args())).mirror(&failure)
        }
    }
}

fn write(mut stream: impl Write + IsTerminal, error: &clap::Error) {
    let styled = error.render();
    let text = if console::has_colour(&stream) { styled.ansi().to_string() } else { styled.to_string() };
    // when the stream is gone there is nobody to tell
    let _ = stream.write_all(text.as_bytes());
}

/// What clap says before its usage lines, as one line.
fn first_paragraph(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim).take_while(|line| !line.is_empty()).collect();
    let line = lines.join(" ");
    line.strip_prefix("error: ").unwrap_or(&line).to_owned()
}
