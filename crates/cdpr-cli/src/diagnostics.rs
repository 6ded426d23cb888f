//! How failures and remarks look on stderr: the message, the place, the line of the file with carets, the cure.

use cdpr_model::reading::{ReadError, TextPlace};

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

use cdpr_reports::paragraphs::folded;

use crate::failure::Failure;

/// Most characters of a source line that are shown: what leaves room for the margin in a wide terminal.
const SHOWN: usize = 90;

/// Columns for number and margin of a source line, and for the signs of what is left out.
const MARGIN: usize = 10;

/// Most carets: a mistake that is wider is meant as a whole.
const UNDERLINED: usize = 40;

/// Looks of messages on a stream.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Looks {
    /// True for a terminal with colour.
    pub(crate) has_colour: bool,
    /// Columns of a line; `None` where lines stay whole.
    pub(crate) width: Option<usize>,
}

/// Escape sequences, empty when colour is not wanted.
struct Colours {
    error: &'static str,
    remark: &'static str,
    place: &'static str,
    reset: &'static str,
}

impl Colours {
    const NONE: Self = Self { error: "", remark: "", place: "", reset: "" };
    const ANSI: Self = Self { error: "\x1b[1;31m", remark: "\x1b[1;33m", place: "\x1b[1;34m", reset: "\x1b[0m" };

    fn of(has_colour: bool) -> Self {
        if has_colour { Self::ANSI } else { Self::NONE }
    }
}

/// A failure as people read it.
pub(crate) fn failure(failure: &Failure, looks: Looks) -> String {
    failure_text(failure, &Colours::of(looks.has_colour), looks.width)
}

/// A remark, which stops no command, as people read it.
pub(crate) fn remark(text: &str, looks: Looks) -> String {
    let Colours { remark, reset, .. } = Colours::of(looks.has_colour);
    lines(&format!("note: {text}"), looks.width).replacen("note", &format!("{remark}note{reset}"), 1)
}

/// A sentence in lines of so many columns, each with a newline at its end.
fn lines(sentence: &str, width: Option<usize>) -> String {
    let fitted = |line: &str| width.map_or_else(|| vec![line.to_owned()], |width| folded(line, width));
    sentence.lines().flat_map(fitted).map(|line| line + "\n").collect()
}

fn failure_text(failure: &Failure, colours: &Colours, width: Option<usize>) -> String {
    let Colours { error, place, reset, .. } = colours;
    let head = format!("error[{}]", failure.code());
    let message = lines(&format!("{head}: {}", failure.message()), width);
    let mut text = message.replacen(&head, &format!("{error}{head}{reset}"), 1);
    if let Failure::File(read_error) = failure {
        text.push_str(&place_text(read_error, colours, width.map_or(SHOWN, |width| width - MARGIN)));
    }
    if let Some(help) = failure.help() {
        let help = lines(&format!("  = help: {help}"), width);
        text.push_str(&help.replacen('=', &format!("{place}={reset}"), 1));
    }
    text.push_str(&format!("  {place}={reset} more: cdpr explain {}\n", failure.code()));
    text
}

/// The place in the manner of compilers, which editors make clickable.
fn place_text(read_error: &ReadError, colours: &Colours, shown: usize) -> String {
    let Colours { error, place: blue, reset, .. } = colours;
    let file_name = &read_error.file_name;
    let Some(place) = &read_error.place else { return format!(" {blue}-->{reset} {file_name}\n") };
    let number = place.line().to_string();
    let margin = " ".repeat(number.len());
    let mut text = format!("{margin}{blue}-->{reset} {file_name}:{}:{}\n", place.line(), place.column());
    if !place.source_line().trim().is_empty() {
        let (source_line, carets) = snippet(place, shown);
        text.push_str(&format!("{margin} {blue}|{reset}\n{blue}{number} |{reset} {source_line}\n"));
        text.push_str(&format!("{margin} {blue}|{reset} {error}{carets}{reset}\n"));
    }
    text
}

/// The part of the source line, of so many characters, around the mistake that fits into a line of the terminal, and the carets below it, without
/// characters that would control the terminal.
fn snippet(place: &TextPlace, shown: usize) -> (String, String) {
    let plain = |character: char| if character.is_control() && character != '\t' { '\u{fffd}' } else { character };
    let line: Vec<char> = place.source_line().chars().map(plain).collect();
    let caret = place.caret().min(line.len());
    let skipped =
        if line.len() <= shown || caret <= shown / 2 { 0 } else { (caret - shown / 2).min(line.len() - shown) };
    let end = line.len().min(skipped + shown);
    let part = |from: usize, to: usize| line[from..to].iter().collect::<String>();
    let (before, after) = (if skipped > 0 { "…" } else { "" }, if end < line.len() { "…" } else { "" });
    let blank = |character: &char| match character {
        '\t' => "\t".to_owned(),
        wide => " ".repeat(wide.width().unwrap_or(0)),
    };
    let padding: String =
        before.chars().map(|_| ' ').collect::<String>() + &line[skipped..caret].iter().map(blank).collect::<String>();
    let meant = part(caret, end.min(caret + place.width())).width().clamp(1, UNDERLINED);
    (format!("{before}{}{after}", part(skipped, end)), padding + &"^".repeat(meant))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mistake_in_a_file_is_shown_with_its_line_and_the_cure() {
        let place = TextPlace::of_span("a = 1\nnam = \"x\"\n", 6..9);
        let error = ReadError::new("robot.toml", "toml::unknown-key", "unknown key `nam`")
            .at(place)
            .with_help("did you mean `name`?");
        let expected = "\
error[toml::unknown-key]: unknown key `nam`
 --> robot.toml:2:1
  |
2 | nam = \"x\"
  | ^^^
  = help: did you mean `name`?
  = more: cdpr explain toml::unknown-key
";
        assert_eq!(failure_text(&error.into(), &Colours::NONE, None), expected);
    }

    /// 30 columns of 22 characters, of which the twentieth is wrong, or the line as a whole.
    #[test]
    fn a_long_line_is_shown_around_the_mistake_and_carets_end() {
        let line = (1..=30).map(|cable| format!("cable_length_furlong_{cable:02}")).collect::<Vec<_>>().join(",");
        let middle = snippet(&TextPlace::on_line(&line[..150], 1, 121, 23), SHOWN);
        assert!(middle.0.starts_with('…') && middle.0.chars().count() <= SHOWN + 2, "{middle:?}");
        let caret = middle.1.find('^').unwrap();
        let marked: String = middle.0.chars().skip(caret).take(middle.1.len() - caret).collect();
        assert_eq!(marked, "cable_length_furlong_06");
        let whole = snippet(&TextPlace::on_line(&line, 1, 1, line.len()), SHOWN);
        assert_eq!(whole.1, "^".repeat(UNDERLINED));
        assert!(whole.0.ends_with('…') && whole.0.chars().count() == SHOWN + 1, "{whole:?}");
        let wide = snippet(&TextPlace::on_line("机器人 = 3", 1, 7, 1), SHOWN);
        assert_eq!(wide.1, "         ^", "each of the three characters takes two columns");
    }

    #[test]
    fn sentences_fold_at_the_width_and_the_line_of_the_file_does_not() {
        let line = format!("{} = 1", "n".repeat(66));
        let error = ReadError::new(
            "a.toml",
            "x",
            "there is a key that nobody knows of, neither in files of this version nor in those of any other",
        )
        .at(TextPlace::on_line(&line, 1, 1, 66));
        let text = failure_text(
            &error
                .with_help("write another one in its place, of those that `cdpr schema robot` lists with their meaning")
                .into(),
            &Colours::NONE,
            Some(80),
        );
        let (sentences, file): (Vec<&str>, Vec<&str>) = text.lines().partition(|line| !line.contains('|'));
        assert!(sentences.iter().all(|line| line.len() <= 80), "{text}");
        assert!(file.iter().any(|shown| shown.ends_with(&line)), "{text}");
        let coloured = remark("one two three four", Looks { has_colour: true, width: Some(14) });
        assert_eq!(coloured, "\x1b[1;33mnote\x1b[0m: one two\n  three four\n");
    }

    #[test]
    fn a_file_cannot_control_the_terminal() {
        let error = ReadError::new("a.csv", "x", "y").at(TextPlace::on_line("\x1b[2J1,2", 3, 5, 1));
        assert!(!failure_text(&error.into(), &Colours::NONE, None).contains('\x1b'));
    }
}
