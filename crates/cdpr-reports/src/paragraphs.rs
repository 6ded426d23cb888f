//! Text for a terminal: paragraphs that fold to its width, each in a tone that colour may show.

use unicode_width::UnicodeWidthStr;

/// Weight of a paragraph, which terminals with colour show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// Tables, numbers and sentences.
    Plain,
    /// The outcome, and headings.
    Bold,
    /// Doubts about the outcome.
    Caution,
    /// A no, or an outcome that nobody should rely on.
    Refusal,
}

impl Tone {
    /// The sequence that begins it on a terminal with colour.
    fn escape(self) -> &'static str {
        match self {
            Self::Plain => "",
            Self::Bold => "\x1b[1m",
            Self::Caution => "\x1b[33m",
            Self::Refusal => "\x1b[1;31m",
        }
    }
}

/// Lines in their order, each with its tone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Paragraphs {
    lines: Vec<(Tone, String)>,
}

impl Paragraphs {
    /// Lines of a text; those that begin with `caution:` have the tone of one.
    pub fn of(text: &str) -> Self {
        let is_caution = |line: &str| ["caution: ", "Caution: "].iter().any(|word| line.starts_with(word));
        let tone = |line: &str| if is_caution(line) { Tone::Caution } else { Tone::Plain };
        Self { lines: text.lines().map(|line| (tone(line), line.to_owned())).collect() }
    }

    /// Adds the lines of a text in one tone.
    pub fn add(&mut self, tone: Tone, text: &str) {
        self.lines.extend(text.lines().map(|line| (tone, line.to_owned())));
    }

    /// Adds an empty line.
    pub fn gap(&mut self) {
        self.lines.push((Tone::Plain, String::new()));
    }

    /// The text in lines of at most so many columns, each with a newline at its end.
    pub fn text(&self, width: usize, has_colour: bool) -> String {
        let mut text = String::new();
        for (tone, line) in &self.lines {
            for piece in folded(line, width) {
                match tone.escape() {
                    "" => text.push_str(&piece),
                    escape if has_colour => text.push_str(&format!("{escape}{piece}\x1b[0m")),
                    _ => text.push_str(&piece),
                }
                text.push('\n');
            }
        }
        text
    }
}

/// Columns by which the lines that continue one are indented further.
const HANGING: usize = 2;

/// End of a line that goes on, for a shell.
const CONTINUED: &str = " \\";

/// A line in lines of at most so many columns, broken at spaces; what follows the first hangs below its words. Of words that are wider
/// than a line only lists are broken, behind their commas: names and paths stay whole, and a command of ours is continued as a shell takes it, so that
/// all can be copied.
pub fn folded(line: &str, width: usize) -> Vec<String> {
    if columns(line) <= width {
        return vec![line.to_owned()];
    }
    let indent = line.len() - line.trim_start_matches(' ').len();
    match line[indent..].starts_with("cdpr ") {
        true => {
            let mut lines = folded_words(&shell_words(&line[indent..]), indent, width - CONTINUED.len(), false);
            let last = lines.len() - 1;
            lines[..last].iter_mut().for_each(|line| line.push_str(CONTINUED));
            lines
        }
        false => folded_words(&line[indent..].split(' ').collect::<Vec<_>>(), indent, width, true),
    }
}

/// Columns that a text takes on a terminal; sequences of colour take none.
fn columns(text: &str) -> usize {
    let mut pieces = text.split('\x1b');
    let first = pieces.next().map_or(0, |piece| piece.width());
    first + pieces.map(|piece| piece.split_once('m').map_or(0, |(_, shown)| shown.width())).sum::<usize>()
}

/// Words of a command; blanks in quotation marks part none.
fn shell_words(command: &str) -> Vec<&str> {
    let mut quote = None;
    command
        .split(|letter: char| {
            quote = match (quote, letter) {
                (None, '\'' | '"') => Some(letter),
                (Some(open), close) if open == close => None,
                (kept, _) => kept,
            };
            letter == ' ' && quote.is_none()
        })
        .collect()
}

/// Words in lines behind an indentation; lists wider than a line may be broken where that is asked for.
fn folded_words(words: &[&str], indent: usize, width: usize, breaks_lists: bool) -> Vec<String> {
    let hang = " ".repeat((indent + HANGING).min(width / 2));
    let mut lines = vec![" ".repeat(indent)];
    let mut is_empty = true;
    for word in words {
        let is_list = breaks_lists && hang.len() + columns(word) > width;
        let pieces: Vec<&str> = if is_list { word.split_inclusive([',', ';']).collect() } else { vec![word] };
        for (place, piece) in pieces.into_iter().enumerate() {
            // blanks stand between words, and none begins a line
            let blank = if is_empty || place > 0 { "" } else { " " };
            let last = lines.last().map_or(0, |last| columns(last));
            if !is_empty && last + blank.len() + columns(piece) > width {
                lines.push(hang.clone());
                is_empty = true;
            }
            let blank = if is_empty { "" } else { blank };
            if let Some(last) = lines.last_mut().filter(|_| !(is_empty && piece.is_empty())) {
                last.push_str(blank);
                last.push_str(piece);
                is_empty = false;
            }
        }
    }
    lines.into_iter().map(|line| line.trim_end().to_owned()).filter(|line| !line.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_fold_at_words_and_hang_below_their_beginning() {
        let line = "  the simplest candidate that is as good as the best on the same samples";
        let expected =
            ["  the simplest candidate", "    that is as good as the", "    best on the same", "    samples"];
        assert_eq!(folded(line, 26), expected);
        assert_eq!(folded(line, 100), [line]);
    }

    /// Folding keeps every letter but blanks at any width, and breaks every line that is wider and can be broken.
    #[test]
    fn nothing_is_lost_and_lines_fit_wherever_a_word_does() {
        let line = "caution: 3 of 20 samples count less; lines 4,17,20, σ = 1.2 mm (a²) – 机器人 in /tmp/a/long/path/to/a/file.toml";
        let letters = |text: &str| text.replace(' ', "");
        for width in 8..120 {
            let lines = folded(line, width);
            assert_eq!(letters(&lines.concat()), letters(line), "{width}");
            let fits = |line: &String| line.width() <= width || !line.trim().contains(' ');
            assert!(lines.iter().all(fits), "{width}: {lines:?}");
        }
    }

    #[test]
    fn lists_break_behind_commas_and_paths_stay_whole() {
        let name = "standard:frame-anchor,platform-anchor,length-offset";
        assert_eq!(
            folded(&format!("is {name}"), 30),
            ["is standard:frame-anchor,", "  platform-anchor,", "  length-offset"]
        );
        assert_eq!(
            folded("see /a/very/long/path/of/one/word.html", 20),
            ["see", "  /a/very/long/path/of/one/word.html"]
        );
    }

    #[test]
    fn commands_go_on_as_a_shell_reads_them() {
        let command = "  cdpr select robot.toml samples.csv --candidates 'standard; pulley' --out result";
        let expected = [
            "  cdpr select robot.toml \\",
            "    samples.csv --candidates \\",
            "    'standard; pulley' --out \\",
            "    result",
        ];
        assert_eq!(folded(command, 30), expected);
    }

    #[test]
    fn colour_wraps_each_line_and_is_absent_without_it() {
        let mut paragraphs = Paragraphs::of("caution: two words\nplain");
        paragraphs.add(Tone::Refusal, "no");
        assert_eq!(paragraphs.text(12, false), "caution: two\n  words\nplain\nno\n");
        let coloured = "\x1b[33mcaution: two\x1b[0m\n\x1b[33m  words\x1b[0m\nplain\n\x1b[1;31mno\x1b[0m\n";
        assert_eq!(paragraphs.text(12, true), coloured);
        // what is coloured already has the same lines
        assert_eq!(folded("\x1b[1mone\x1b[0m two three", 8), ["\x1b[1mone\x1b[0m two", "  three"]);
    }
}
