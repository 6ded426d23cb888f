//! Answers for scripts and for people.

use serde::Serialize;

/// A result: fields for scripts, words for people.
pub trait Answer: Serialize {
    /// Sentences and tables for people; tables fit lines of this many columns, where there is a limit.
    fn words(&self, width: Option<usize>) -> String;

    /// True when the answer is a no.
    fn is_negative(&self) -> bool {
        false
    }

    /// True for a no that a user may overrule by `--accept-untrusted`: the answer is there, only not to be relied on.
    fn may_be_accepted(&self) -> bool {
        false
    }
}
