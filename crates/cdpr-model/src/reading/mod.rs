//! Errors in a file written by a user: position, reason and advice.
//!
//! All text files that the library reads (robots, measurements, studies) share one error type, so that their errors
//! look alike.

mod error_code;
mod file;
mod keyword;
#[cfg(feature = "files")]
mod table_text;
#[cfg(feature = "files")]
mod toml_document;
#[cfg(feature = "files")]
mod xml_document;

pub use error_code::ErrorCode;
pub use file::{FileError, bytes_of};
pub use keyword::Keyword;
pub use keyword::keywords;
#[cfg(feature = "files")]
pub(crate) use table_text::table_text;
#[cfg(feature = "files")]
pub use toml_document::Step;
#[cfg(feature = "files")]
pub use toml_document::{Gathering, TomlDocument};
#[cfg(feature = "files")]
pub(crate) use xml_document::{Element, XmlDocument, numbers};

use std::fmt;
use std::ops::Range;

/// Largest number by amount that is accepted in files: its squares and cubes stay finite.
#[cfg(feature = "files")]
pub(crate) const MAGNITUDE_LIMIT: f64 = 1e30;

/// Kinds of files, with different largest sizes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// Written by hand: robots, studies, sidecars; 16 MiB.
    Text,
    /// A row for every pose: measurements, poses, records of a test bench, results; 256 MiB.
    Table,
}

impl Size {
    /// The largest size of a file of this kind (bytes).
    pub(crate) fn limit(self) -> usize {
        match self {
            Self::Text => 16 << 20,
            Self::Table => 256 << 20,
        }
    }

    /// Refuses files above the limit.
    pub(crate) fn check(self, bytes: u64, file_name: &str) -> Result<(), ReadError> {
        if bytes <= self.limit() as u64 {
            return Ok(());
        }
        let (what, help) = match self {
            Self::Text => ("of a file that is no table", "is this the right file?"),
            Self::Table => ("of a table", "thin it out: what counts is poses that differ, not many that are alike"),
        };
        let message = format!("the file has more than {} MiB, the most that is read {what}", self.limit() >> 20);
        Err(ReadError::new(file_name, "file::too-large", message).with_help(help))
    }
}

/// Largest number of characters of a source line in an error.
const SHOWN_WIDTH: usize = 160;

/// A file that cannot be accepted, with the error, its position, its reason, and advice.
///
/// `Display` prints `file:line:column: message` and, on a second line, the help.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub struct ReadError {
    /// The file as the caller named it.
    pub file_name: String,
    /// Position in the file; `None` if the error concerns the file as a whole.
    pub place: Option<TextPlace>,
    /// Error with its reason, in words.
    pub message: String,
    /// Advice on how to correct it.
    pub help: Option<String>,
    /// Stable short name of the error, e.g. `robot::unknown-key`.
    pub code: &'static str,
}

impl ReadError {
    /// An error about a file as a whole.
    pub fn new(file_name: impl Into<String>, code: &'static str, message: impl Into<String>) -> Self {
        Self { file_name: file_name.into(), place: None, message: message.into(), help: None, code }
    }

    /// The same error at a position.
    #[must_use]
    pub fn at(mut self, place: TextPlace) -> Self {
        self.place = Some(place);
        self
    }

    /// The same error with advice on how to correct it.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Line of the error, from 1.
    pub fn line(&self) -> Option<usize> {
        self.place.as_ref().map(TextPlace::line)
    }

    /// Column of the error in characters, from 1.
    pub fn column(&self) -> Option<usize> {
        self.place.as_ref().map(TextPlace::column)
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            Some(place) => write!(formatter, "{}:{}:{}: {}", self.file_name, place.line, place.column, self.message)?,
            None => write!(formatter, "{}: {}", self.file_name, self.message)?,
        }
        match &self.help {
            Some(help) => write!(formatter, "\n  help: {help}"),
            None => Ok(()),
        }
    }
}

/// A range of characters in one line of a text file, with the line itself for display.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextPlace {
    line: u32,
    column: u32,
    width: u32,
    caret: u32,
    source_line: Box<str>,
}

impl TextPlace {
    /// The position of a byte range of a text; a range beyond the end becomes the end, one over several lines ends with
    /// its first.
    pub fn of_span(text: &str, span: Range<usize>) -> Self {
        let start = character_boundary(text, span.start);
        let end = character_boundary(text, span.end).max(start);
        let line_start = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let line = text[..start].bytes().filter(|&byte| byte == b'\n').count() + 1;
        let line_end = text[start..].find('\n').map_or(text.len(), |length| start + length);
        let before = text[line_start..start].chars().count();
        let width = text[start..end.min(line_end)].trim_end().chars().count();
        Self::on_line(text[line_start..line_end].trim_end_matches('\r'), line, before + 1, width)
    }

    /// The position of `width` characters from a column of a line on; both count from 1, the column in characters.
    pub fn on_line(source_line: &str, line: usize, column: usize, width: usize) -> Self {
        // of a very long line only the part around the error is shown
        let skipped = if column > SHOWN_WIDTH { column - SHOWN_WIDTH / 2 } else { 0 };
        let shown: String = source_line.chars().skip(skipped).take(SHOWN_WIDTH).collect();
        let caret = column.saturating_sub(1 + skipped);
        let room = shown.chars().count().saturating_sub(caret);
        let narrow = |number: usize| u32::try_from(number).unwrap_or(u32::MAX);
        Self {
            line: narrow(line),
            column: narrow(column),
            width: narrow(width.min(room).max(1)),
            caret: narrow(caret),
            source_line: shown.into_boxed_str(),
        }
    }

    /// Line, from 1.
    pub fn line(&self) -> usize {
        self.line as usize
    }

    /// Column in characters, from 1.
    pub fn column(&self) -> usize {
        self.column as usize
    }

    /// Number of characters of the range, at least 1.
    pub fn width(&self) -> usize {
        self.width as usize
    }

    /// The line with the error; of a very long line the part around it.
    pub fn source_line(&self) -> &str {
        &self.source_line
    }

    /// Number of characters of [`Self::source_line`] before the error.
    pub fn caret(&self) -> usize {
        self.caret as usize
    }

    /// Two lines for display: the source line, and carets under the error.
    pub fn snippet(&self) -> String {
        let caret = self.caret as usize;
        let tab_or_space = |character: char| if character == '\t' { '\t' } else { ' ' };
        let mut padding: String = self.source_line.chars().take(caret).map(tab_or_space).collect();
        padding.extend(std::iter::repeat_n(' ', caret.saturating_sub(padding.chars().count())));
        format!("{}\n{padding}{}", self.source_line, "^".repeat(self.width()))
    }
}

/// The bytes as text; an error at the first byte that is not UTF-8, or for a file that is too large.
pub fn text_from_bytes<'a>(bytes: &'a [u8], size: Size, file_name: &str) -> Result<&'a str, ReadError> {
    size.check(bytes.len() as u64, file_name)?;
    std::str::from_utf8(bytes).map_err(|error| {
        let valid = std::str::from_utf8(&bytes[..error.valid_up_to()]).unwrap_or_default();
        let message = format!("byte {} is not UTF-8 text", error.valid_up_to() + 1);
        ReadError::new(file_name, "file::not-utf8", message)
            .at(TextPlace::of_span(valid, valid.len()..valid.len()))
            .with_help(match bytes {
                [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => {
                    "this is UTF-16, what spreadsheets call Unicode text: save the file as UTF-8"
                }
                _ => "save the file as UTF-8; a spreadsheet or archive is not a text file",
            })
    })
}

/// The known name that is most similar to a wrong one; `None` if none is similar enough.
pub fn did_you_mean<'a>(wrong: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = wrong.to_lowercase();
    let likeness = |name: &'a str| (strsim::jaro_winkler(&lower, &name.to_lowercase()), name);
    let best = known.into_iter().map(likeness).max_by(|one, other| one.0.total_cmp(&other.0))?;
    (best.0 > 0.8).then_some(best.1)
}

/// Largest number of names listed besides the most similar one.
#[cfg(feature = "files")]
const LISTED: usize = 12;

/// Advice for an unknown name: the most similar one, and all allowed names unless there are many.
#[cfg(feature = "files")]
pub fn help_for_unknown(wrong: &str, known: &[&str]) -> String {
    let allowed = format!("allowed: {}", known.join(", "));
    match did_you_mean(wrong, known.iter().copied()) {
        Some(meant) if known.len() > LISTED => format!("did you mean `{meant}`?"),
        Some(meant) => format!("did you mean `{meant}`? {allowed}"),
        None => allowed,
    }
}

/// The nearest character boundary at or before an index.
fn character_boundary(text: &str, index: usize) -> usize {
    let mut index = index.min(text.len());
    while !text.is_char_boundary(index) {
        index -= 1;
    }
    index
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_count_lines_and_characters_from_one() {
        let text = "ä = 1\r\nöö = wrong\r\n";
        let start = text.find("wrong").unwrap();
        let place = TextPlace::of_span(text, start..start + 5);
        assert_eq!((place.line(), place.column(), place.width()), (2, 6, 5));
        assert_eq!(place.source_line(), "öö = wrong");
        assert_eq!(place.snippet(), "öö = wrong\n     ^^^^^");
    }

    #[test]
    fn the_end_of_a_file_and_the_middle_of_a_character_are_places_too() {
        assert_eq!(TextPlace::of_span("", 5..9).snippet(), "\n^");
        let end = TextPlace::of_span("a\n", 2..2);
        assert_eq!((end.line(), end.column()), (2, 1));
        assert_eq!(TextPlace::of_span("ä", 1..2).column(), 1);
    }

    #[test]
    fn a_line_of_megabytes_is_shown_by_the_part_around_the_mistake() {
        let text = format!("{}x{}", "-".repeat(1_000_000), "-".repeat(1_000_000));
        let place = TextPlace::of_span(&text, 1_000_000..1_000_001);
        assert_eq!(place.column(), 1_000_001);
        let (line, caret) = (place.source_line().to_owned(), place.snippet().find('^').unwrap() - SHOWN_WIDTH - 1);
        assert_eq!(line.chars().nth(caret), Some('x'));
    }

    #[test]
    fn display_names_file_line_column_reason_and_cure() {
        let error = ReadError::new("a.toml", "robot::unknown-key", "unknown key `nam`")
            .at(TextPlace::on_line("nam = 1", 1, 1, 3))
            .with_help("did you mean `name`?");
        assert_eq!(error.to_string(), "a.toml:1:1: unknown key `nam`\n  help: did you mean `name`?");
    }

    #[test]
    fn tables_may_be_larger_than_what_is_written_by_hand() {
        let refused = |size: Size, bytes| size.check(bytes, "a.csv").err().map(|error| error.message);
        assert_eq!(refused(Size::Text, 16 << 20), None);
        assert_eq!(
            refused(Size::Text, (16 << 20) + 1).as_deref(),
            Some("the file has more than 16 MiB, the most that is read of a file that is no table")
        );
        assert_eq!(refused(Size::Table, 256 << 20), None);
        assert!(refused(Size::Table, (256 << 20) + 1).is_some_and(|message| message.contains("256 MiB")));
    }

    #[test]
    fn bytes_that_are_no_text_are_placed() {
        let error = text_from_bytes(b"ab\nc\xff", Size::Text, "a.toml").unwrap_err();
        assert_eq!((error.line(), error.column(), error.code), (Some(2), Some(2), "file::not-utf8"));
    }
}
