//! How the owner of the terminal wants to be talked to: colour, quiet, width.

use std::env;

use clap::ValueEnum;

use crate::stream::Stream;

/// When escape sequences for colour are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum ColorChoice {
    /// On terminals, as the environment wishes: NO_COLOR, CLICOLOR_FORCE, CLICOLOR=0, TERM=dumb.
    #[default]
    Auto,
    /// Into files and pipes too.
    Always,
    /// Not at all.
    Never,
}

/// Signs of life of work that takes long.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Signs {
    /// A line that moves, on a terminal.
    Line,
    /// Now and then a plain line, where the messages of the process go to a file or a pipe.
    Lines,
    /// None: quiet is asked for, or a caller of the library has the messages.
    #[default]
    Nothing,
}

/// Wishes of a run about what is written besides the answer.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Console {
    /// When to colour.
    pub(crate) color: ColorChoice,
    /// True when only answers and errors are wanted.
    pub(crate) quiet: bool,
    /// True when all that there is to say is wanted, not what fits on one screen.
    pub(crate) verbose: bool,
}

/// Columns of a line at least and at most: fewer cut tables, more are hard to read.
const WIDTHS: (usize, usize) = (80, 100);

impl Console {
    /// Columns of a line on this stream.
    pub(crate) fn width(stream: &dyn Stream) -> usize {
        columns(stream.width(), env::var("COLUMNS").ok().as_deref())
    }

    /// True when this stream takes colour.
    pub(crate) fn has_colour(self, stream: &dyn Stream) -> bool {
        coloured(self.color, stream.is_terminal(), |name| env::var(name).ok())
    }
}

/// The choice of a command line that could not be parsed.
pub(crate) fn color_asked_for(words: &[String]) -> ColorChoice {
    let given = |choice: &str| {
        words.iter().any(|word| word.strip_prefix("--color=") == Some(choice))
            || words.windows(2).any(|pair| pair[0] == "--color" && pair[1] == choice)
    };
    match (given("always"), given("never")) {
        (true, false) => ColorChoice::Always,
        (false, true) => ColorChoice::Never,
        _ => ColorChoice::Auto,
    }
}

/// The option wins over NO_COLOR, that over CLICOLOR_FORCE, that over what the stream is (no-color.org, bixense.com/clicolors).
fn coloured(choice: ColorChoice, is_terminal: bool, variable: impl Fn(&str) -> Option<String>) -> bool {
    let is_set = |name: &str| variable(name).is_some_and(|value| !value.is_empty());
    match choice {
        ColorChoice::Always => true,
        ColorChoice::Never => false,
        ColorChoice::Auto if is_set("NO_COLOR") => false,
        ColorChoice::Auto if variable("CLICOLOR_FORCE").is_some_and(|value| !value.is_empty() && value != "0") => true,
        ColorChoice::Auto => {
            let is_dumb = variable("TERM").is_some_and(|terminal| terminal == "dumb");
            let is_off = variable("CLICOLOR").is_some_and(|value| value == "0");
            is_terminal && !is_dumb && !is_off
        }
    }
}

/// The same of a stream of messages, whose lines stay whole in files and pipes where nobody states a width: a search for a sentence finds it.
pub(crate) fn message_width(stream: &dyn Stream) -> Option<usize> {
    let is_asked = stream.is_terminal() || env::var_os("COLUMNS").is_some_and(|columns| !columns.is_empty());
    is_asked.then(|| Console::width(stream))
}

/// The width of the terminal, else that of the variable COLUMNS, else the most.
fn columns(terminal: Option<usize>, variable: Option<&str>) -> usize {
    let (least, most) = WIDTHS;
    let asked = || variable.and_then(|text| text.trim().parse().ok()).filter(|columns| *columns > 0);
    terminal.or_else(asked).map_or(most, |columns| columns.clamp(least, most))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_as_wide_as_the_terminal_between_80_and_100_columns() {
        for (terminal, variable, expected) in [
            (None, None, 100),
            (None, Some("90"), 90),
            (None, Some("40"), 80),
            (None, Some("many"), 100),
            (Some(85), Some("95"), 85),
            (Some(60), None, 80),
            (Some(220), None, 100),
        ] {
            assert_eq!(columns(terminal, variable), expected, "{terminal:?} {variable:?}");
        }
    }

    fn decided(choice: ColorChoice, is_terminal: bool, variables: &[(&str, &str)]) -> bool {
        let variable =
            |name: &str| variables.iter().find(|(known, _)| *known == name).map(|(_, value)| (*value).to_owned());
        coloured(choice, is_terminal, variable)
    }

    #[test]
    fn colour_is_for_terminals_unless_the_environment_or_the_option_says_otherwise() {
        use ColorChoice::{Always, Auto, Never};
        for (choice, is_terminal, variables, expected) in [
            (Auto, true, &[][..], true),
            (Auto, false, &[], false),
            (Auto, true, &[("NO_COLOR", "1")], false),
            (Auto, true, &[("NO_COLOR", "")], true),
            (Auto, false, &[("CLICOLOR_FORCE", "1")], true),
            (Auto, false, &[("CLICOLOR_FORCE", "0")], false),
            (Auto, false, &[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")], false),
            (Auto, true, &[("CLICOLOR", "0")], false),
            (Auto, true, &[("TERM", "dumb")], false),
            (Always, false, &[("NO_COLOR", "1")], true),
            (Never, true, &[("CLICOLOR_FORCE", "1")], false),
        ] {
            assert_eq!(decided(choice, is_terminal, variables), expected, "{choice:?} {is_terminal} {variables:?}");
        }
    }

    #[test]
    fn a_broken_command_line_still_tells_its_wish_for_colour() {
        let asked = |line: &str| color_asked_for(&line.split_whitespace().map(str::to_owned).collect::<Vec<_>>());
        assert_eq!(asked("cdpr nonsense --color=always"), ColorChoice::Always);
        assert_eq!(asked("cdpr --color never nonsense"), ColorChoice::Never);
        assert_eq!(asked("cdpr nonsense always"), ColorChoice::Auto);
    }
}
