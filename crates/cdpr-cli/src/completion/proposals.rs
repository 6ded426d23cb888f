//! Words and files proposed for a place of a command line, and how the scripts read them.

/// Marks after which a word goes on.
const MARKS: [char; 5] = ['=', ':', '[', ',', '+'];

/// A word and what it is.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Proposal {
    pub(super) word: String,
    pub(super) help: String,
}

/// Files that may stand at a place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Files {
    #[default]
    None,
    Any,
    Folders,
    /// Those with this ending, and the folders on the way to them.
    Ending(&'static str),
}

/// Words and files that may stand at a place.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Proposals {
    pub(super) words: Vec<Proposal>,
    pub(super) files: Files,
    /// A word may go on after the proposed one, as a list does.
    pub(super) is_open: bool,
}

impl Proposal {
    pub(super) fn new(word: impl Into<String>, help: impl Into<String>) -> Self {
        Self { word: word.into(), help: help.into() }
    }
}

impl Proposals {
    pub(super) fn of(words: impl IntoIterator<Item = Proposal>) -> Self {
        Self { words: words.into_iter().collect(), ..Self::default() }
    }

    pub(super) fn files(files: Files) -> Self {
        Self { files, ..Self::default() }
    }

    pub(super) fn with_files(self, files: Files) -> Self {
        Self { files, ..self }
    }

    /// Those that begin with what is typed already, as the scripts read them.
    pub(super) fn written(mut self, typed: &str) -> String {
        self.words.retain(|proposal| proposal.word.starts_with(typed));
        let files = match self.files {
            Files::None => "none",
            Files::Any => "any",
            Files::Folders => "folders",
            Files::Ending(ending) => ending,
        };
        let is_open = self.is_open || self.words.iter().any(|proposal| proposal.word.ends_with(MARKS));
        let lines = self.words.iter().map(|Proposal { word, help }| format!("{word}\t{help}\n"));
        format!("{files} {}\n{}", if is_open { "open" } else { "space" }, lines.collect::<String>())
    }
}

/// A word that needs no help.
pub(super) fn plain(word: impl Into<String>) -> Proposal {
    Proposal::new(word, "")
}

/// The first sentence of a help in one line, without its full stop.
pub(super) fn first_sentence(help: impl ToString) -> String {
    let line = help.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
    let sentence = line.split_once(". ").map_or(line.as_str(), |(first, _)| first);
    sentence.strip_suffix('.').unwrap_or(sentence).to_owned()
}
