//! How the owner of the terminal wants to be talked to: colour, quiet.

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

/// Wishes of a run about what is written besides the answer.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Console {
    /// When to colour.
    pub(crate) color: ColorChoice,
    /// True when only answers and errors are wanted.
    pub(crate) quiet: bool,
}

impl Console {
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

#[cfg(test)]
mod tests {
    use super::*;

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
