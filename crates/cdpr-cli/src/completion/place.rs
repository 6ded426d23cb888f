//! Place of a word in a command line: what the words before it leave to stand there.

use clap::builder::ValueRange;
use clap::{Arg, ArgAction, Command, Id};

/// Kind of the word at a place.
pub(super) enum Place<'c, 't> {
    /// A subcommand of this command.
    Subcommand(&'c Command),
    /// One of these options.
    Option(Vec<&'c Arg>),
    /// A value.
    Value {
        /// The command that takes the argument.
        command: &'c Command,
        /// The argument.
        argument: &'c Arg,
        /// Number of the value among those of the argument, from 0.
        index: usize,
        /// Part of the word before the value, as `--model=`.
        before: &'t str,
    },
    /// Nothing that is known.
    Nothing,
}

/// State of a command line after some words.
pub(super) struct Walk<'c> {
    command: &'c Command,
    /// Options given so far.
    given: Vec<&'c Id>,
    /// Option that waits for a value, and how many it has.
    waiting: Option<(&'c Arg, usize)>,
    /// Values without an option so far.
    positionals: usize,
    /// No more options, after `--`.
    are_options_over: bool,
}

/// State of a command line after these words.
pub(super) fn after<'c>(root: &'c Command, words: &[String]) -> Walk<'c> {
    let mut walk = Walk { command: root, given: Vec::new(), waiting: None, positionals: 0, are_options_over: false };
    words.iter().for_each(|word| walk.step(word));
    walk
}

impl<'c> Walk<'c> {
    /// Goes on over a whole word.
    fn step(&mut self, word: &str) {
        if let Some((option, taken)) = self.waiting.take() {
            self.waiting = (taken + 1 < most_values(option)).then_some((option, taken + 1));
        } else if self.are_options_over {
            self.positionals += 1;
        } else if word == "--" {
            self.are_options_over = true;
        } else if let Some(long) = word.strip_prefix("--") {
            let (name, has_value) = long.split_once('=').map_or((long, false), |(name, _)| (name, true));
            self.give(self.option(name), has_value);
        } else if let Some(last) = word.strip_prefix('-').and_then(|letters| letters.chars().last()) {
            self.give(self.command.get_arguments().find(|option| option.get_short() == Some(last)), false);
        } else if let Some(inner) = self.command.find_subcommand(word).filter(|_| self.positionals == 0) {
            self.command = inner;
        } else {
            self.positionals += 1;
        }
    }

    fn give(&mut self, option: Option<&'c Arg>, has_value: bool) {
        let Some(option) = option else { return };
        self.given.push(option.get_id());
        self.waiting = (!has_value && most_values(option) > 0).then_some((option, 0));
    }

    fn option(&self, long: &str) -> Option<&'c Arg> {
        let is_named = |option: &&Arg| {
            let aliases = option.get_all_aliases().unwrap_or_default();
            option.get_long() == Some(long) || aliases.contains(&long)
        };
        self.command.get_arguments().find(is_named)
    }

    /// Place of the next word, of which this is typed.
    pub(super) fn of<'t>(&self, typed: &'t str) -> Place<'c, 't> {
        let value = |argument, index, before| Place::Value { command: self.command, argument, index, before };
        if let Some((option, taken)) = self.waiting {
            return value(option, taken, "");
        }
        if typed.starts_with('-') && !self.are_options_over {
            let assigned = typed.split_once('=').and_then(|(option, _)| {
                Some(value(self.option(option.strip_prefix("--")?)?, 0, &typed[..=option.len()]))
            });
            return assigned.unwrap_or_else(|| Place::Option(self.options()));
        }
        if self.positionals == 0 && self.command.has_subcommands() {
            return Place::Subcommand(self.command);
        }
        let mut positionals = self.command.get_positionals();
        match positionals.nth(self.positionals) {
            Some(argument) => value(argument, 0, ""),
            None if self.are_options_over => Place::Nothing,
            None => Place::Option(self.options()),
        }
    }

    /// Options that may be given yet.
    fn options(&self) -> Vec<&'c Arg> {
        let may_be_given = |option: &&Arg| {
            let is_repeated = matches!(option.get_action(), ArgAction::Append | ArgAction::Count);
            !option.is_positional() && !option.is_hide_set() && (is_repeated || !self.given.contains(&option.get_id()))
        };
        self.command.get_arguments().filter(may_be_given).collect()
    }
}

fn most_values(argument: &Arg) -> usize {
    argument.get_num_args().map_or(0, |range: ValueRange| range.max_values())
}
