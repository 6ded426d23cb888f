//! Words that a shell proposes while a command line of `cdpr` is typed.
//!
//! The scripts of `cdpr completions` ask `cdpr complete -- WORDS`, the last word up to the cursor. The first line of
//! the answer says which files may stand there besides (`none`, `any`, `folders`, or an ending as `.toml`), and whether
//! a blank follows a proposed word (`space`) or the word may go on (`open`). Then a line comes for every word: the
//! word, a tabulator, a few words on it.

mod lists;
mod place;
mod proposals;
mod values;

use std::ffi::OsString;

use clap::{Arg, Command};

use place::Place;
use proposals::{Proposal, Proposals, first_sentence};

/// The scripts by their shells; other shells have those of `clap_complete`, which know no values.
pub(crate) const BASH: &str = include_str!("cdpr.bash");
pub(crate) const ZSH: &str = include_str!("cdpr.zsh");
pub(crate) const FISH: &str = include_str!("cdpr.fish");

/// The word that a script asks with. It is no command of the parser: nobody types it.
const ASKED_BY: &str = "complete";

/// The words of a command line to complete, the last one up to the cursor; `None` if the command line asks for
/// something else.
pub(crate) fn asked(arguments: &[OsString]) -> Option<Vec<String>> {
    match arguments {
        [_, complete, dashes, words @ ..] if complete == ASKED_BY && dashes == "--" => {
            Some(words.iter().map(|word| word.to_string_lossy().into_owned()).collect())
        }
        _ => None,
    }
}

/// Words that may stand in place of the last of these, as the scripts read them.
pub(crate) fn answer(mut root: Command, words: &[String]) -> String {
    root.build();
    let (typed, before) = words.split_last().map_or(("", &[][..]), |(last, before)| (last.as_str(), before));
    // a word whose quotation is not closed
    let typed = typed.strip_prefix(['\'', '"']).unwrap_or(typed);
    let proposals = match place::after(&root, before).of(typed) {
        Place::Subcommand(command) => Proposals::of(subcommands(command)),
        Place::Option(options) => Proposals::of(options.into_iter().flat_map(written_options)),
        Place::Value { command, argument, index, before } => {
            let mut values = values::of(command.get_name(), argument, index, &typed[before.len()..]);
            values.words.iter_mut().for_each(|proposal| proposal.word.insert_str(0, before));
            values
        }
        Place::Nothing => Proposals::default(),
    };
    proposals.written(typed)
}

fn subcommands(command: &Command) -> impl Iterator<Item = Proposal> {
    let shown = command.get_subcommands().filter(|inner| !inner.is_hide_set());
    shown.map(|inner| Proposal::new(inner.get_name(), inner.get_about().map(first_sentence).unwrap_or_default()))
}

/// An option by its long name, else by its short one.
fn written_options(option: &Arg) -> Option<Proposal> {
    let word = option.get_long().map(|long| format!("--{long}"));
    let word = word.or_else(|| option.get_short().map(|short| format!("-{short}")))?;
    Some(Proposal::new(word, option.get_help().map(first_sentence).unwrap_or_default()))
}

#[cfg(test)]
mod tests;
