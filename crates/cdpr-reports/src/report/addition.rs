//! Parts of a report that options of one run ask for.

use minijinja::{Value, context};

use crate::figures::Figure;
use crate::html_page::prose;

/// One part: a heading with its gist, sentences, and a drawing.
pub struct Addition {
    /// Name within the page.
    pub id: &'static str,
    /// Heading.
    pub title: &'static str,
    /// The part in a few words.
    pub gist: String,
    /// Sentences; text between backticks is shown as code.
    pub sentences: Vec<String>,
    /// Drawing with its caption.
    pub figure: Option<(Figure, &'static str)>,
}

pub(super) fn all(additions: &[Addition]) -> Value {
    let value = |addition: &Addition| {
        context! {
            id => addition.id,
            title => addition.title,
            gist => prose(&addition.gist),
            sentences => addition.sentences.iter().map(|words| prose(words)).collect::<Value>(),
            figure => addition.figure.as_ref().map(|(figure, _)| Value::from_safe_string(figure.inline())),
            caption => addition.figure.as_ref().map(|(_, caption)| *caption),
        }
    };
    additions.iter().map(value).collect()
}
