//! One run of a command line, as the code far from its output needs it: the words that were given, and whether progress is shown.
//!
//! Kept by the thread that the command runs on, so that runs side by side do not meet.

use std::cell::RefCell;

use cdpr_plant::Controller;

use crate::console::Signs;
use crate::options;
use crate::surroundings::{Observer, PartsWanted, SharedFiles, Surroundings};

/// Words and wishes of a run.
#[derive(Default)]
pub(crate) struct Session {
    /// Program that the run goes on in.
    pub(crate) surroundings: Surroundings,
    /// Words of the command line after the name of the program.
    pub(crate) words: Vec<String>,
    /// Signs of life that are wanted.
    pub(crate) signs: Signs,
}

thread_local! {
    static SESSION: RefCell<Session> = RefCell::default();
}

/// Begins a run on this thread; it ends where the next one begins.
pub(crate) fn enter(session: Session) {
    SESSION.set(session);
}

/// Signs of life that are wanted.
pub(crate) fn signs() -> Signs {
    SESSION.with_borrow(|session| session.signs)
}

/// Files in memory that this run reads and writes; `None` if its files are those of the disk.
pub(crate) fn files() -> Option<SharedFiles> {
    SESSION.with_borrow(|session| session.surroundings.files.clone())
}

/// Taker of the run's progress, if there is one.
pub(crate) fn observer() -> Option<Observer> {
    SESSION.with_borrow(|session| session.surroundings.observe.clone())
}

/// Work that is wanted of a command's parts.
pub(crate) fn parts() -> PartsWanted {
    SESSION.with_borrow(|session| session.surroundings.parts.clone())
}

/// Place to note the files that are read, where they are noted.
pub(crate) fn notes() -> Option<SharedFiles> {
    SESSION.with_borrow(|session| session.surroundings.read.clone())
}

/// Controller that the run's program brings, if it does.
pub(crate) fn controller() -> Option<Box<dyn Controller>> {
    SESSION.with_borrow(|session| session.surroundings.controller.clone())
}

/// The command as it was given, quoted for a shell, without the options that do not touch the result.
pub(crate) fn command_line() -> String {
    SESSION.with_borrow(|session| {
        let words = options::that_matter(&session.words);
        ["cdpr".to_owned()].into_iter().chain(words.iter().map(|word| quoted(word))).collect::<Vec<_>>().join(" ")
    })
}

/// A word as a shell takes it for one.
pub(crate) fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,:".contains(c);
    match !word.is_empty() && word.chars().all(plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}
