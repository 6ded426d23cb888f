//! Answers for scripts and for people.

use serde::Serialize;

use crate::paragraphs::Paragraphs;

/// A result: fields for scripts, words for people.
pub trait Answer: Serialize {
    /// Sentences and tables for people; tables fit lines of this many columns, where there is a limit.
    fn words(&self, width: Option<usize>) -> String;

    /// The outcome on one screen of so many columns, of answers whose words say more than that; `None` where the words are all there is.
    fn summary(&self, _width: usize) -> Option<Paragraphs> {
        None
    }

    /// True where the words are a file, a script or a table for another program: none of their lines is folded.
    fn is_verbatim(&self) -> bool {
        false
    }

    /// True when the answer is a no.
    fn is_negative(&self) -> bool {
        false
    }

    /// True for a no that a user may overrule by `--accept-untrusted`: the answer is there, only not to be relied on.
    fn may_be_accepted(&self) -> bool {
        false
    }
}
