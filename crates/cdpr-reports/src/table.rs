//! Tables for people: columns aligned by spaces, fitted to a width.

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// Rows of cells under a heading; the first column is aligned left, the others right unless asked for.
pub struct Table {
    heading: Vec<String>,
    rows: Vec<Vec<String>>,
    left: Vec<usize>,
}

impl Table {
    /// A table without rows.
    pub fn new<const N: usize>(heading: [&str; N]) -> Self {
        Self::with_heading(heading.into_iter().map(str::to_owned).collect())
    }

    /// The same with a heading of any length.
    pub fn with_heading(heading: Vec<String>) -> Self {
        Self { heading, rows: Vec::new(), left: vec![0] }
    }

    /// The same table with this column aligned left too.
    pub fn left_column(mut self, column: usize) -> Self {
        self.left.push(column);
        self
    }

    /// Adds a row.
    pub fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// Adds several rows.
    pub fn rows(&mut self, rows: impl IntoIterator<Item = Vec<String>>) {
        self.rows.extend(rows);
    }

    /// Lines that end with a newline; headings and the widest columns of words are wrapped to fit a limit (columns).
    pub fn text(&self, limit: Option<usize>) -> String {
        let widths = self.widths(limit);
        let lines = std::iter::once(&self.heading).chain(&self.rows);
        lines.map(|line| self.line_text(line, &widths)).collect()
    }

    /// Columns as wide as their widest cells; where the line has no room, headings of numbers give way, then the widest
    /// columns of words.
    fn widths(&self, limit: Option<usize>) -> Vec<usize> {
        let columns = 0..self.heading.len();
        let mut widths: Vec<usize> =
            columns.clone().map(|column| length(&self.heading[column]).max(self.body_width(column))).collect();
        let gaps = GAP * widths.len().saturating_sub(1);
        let Some(limit) = limit else { return widths };
        let least: Vec<usize> = columns.clone().map(|column| self.least_width(column).min(widths[column])).collect();
        while widths.iter().sum::<usize>() + gaps > limit {
            let wide = |left: bool| {
                let may_give = |column: &usize| self.left.contains(column) == left && widths[*column] > least[*column];
                columns.clone().filter(may_give).max_by_key(|column| widths[*column])
            };
            let Some(column) = wide(false).or_else(|| wide(true)) else { break };
            widths[column] -= 1;
        }
        widths
    }

    fn body_width(&self, column: usize) -> usize {
        self.rows.iter().filter_map(|row| row.get(column)).map(|cell| length(cell)).max().unwrap_or(0)
    }

    /// Numbers stay whole, and so do the words of their headings; a few letters in a line are harder to read than what the
    /// terminal wraps.
    fn least_width(&self, column: usize) -> usize {
        if self.left.contains(&column) {
            return LEAST_WIDTH;
        }
        let word = self.heading[column].split(' ').map(length).max().unwrap_or(0);
        word.max(self.body_width(column))
    }

    /// One row, of several lines where a cell is wrapped.
    fn line_text(&self, line: &[String], widths: &[usize]) -> String {
        let cells: Vec<Vec<String>> = line.iter().zip(widths).map(|(cell, width)| wrapped(cell, *width)).collect();
        let height = cells.iter().map(Vec::len).max().unwrap_or(1);
        let mut text = String::new();
        for part in 0..height {
            let pieces = cells.iter().zip(widths).enumerate().map(|(column, (pieces, width))| {
                let piece = pieces.get(part).map_or("", String::as_str);
                let padding = " ".repeat(width.saturating_sub(length(piece)));
                if self.left.contains(&column) { format!("{piece}{padding}") } else { format!("{padding}{piece}") }
            });
            text.push_str(pieces.collect::<Vec<_>>().join(&" ".repeat(GAP)).trim_end());
            text.push('\n');
        }
        text
    }
}

/// Columns of the terminal that a cell takes: two for a wide character, none for one that joins the one before.
fn length(cell: &str) -> usize {
    cell.width()
}

/// Spaces between columns.
const GAP: usize = 2;

/// Columns are not wrapped to less than this.
const LEAST_WIDTH: usize = 12;

/// The words of a cell in lines of this many columns; names break after their separators, at hyphens and in the middle of
/// words only where a piece alone is too long.
pub(crate) fn wrapped(cell: &str, width: usize) -> Vec<String> {
    if length(cell) <= width || width == 0 {
        return vec![cell.to_owned()];
    }
    // a marker or an indentation before the words: the other lines start below the words
    let indent = cell.chars().take_while(|character| matches!(character, ' ' | '→')).count().min(width / 2);
    let marker: String = cell.chars().take(indent).collect();
    let (cell, width) = (&cell[marker.len()..], width - indent);
    let mut lines = vec![String::new()];
    for piece in cell.split_inclusive([' ', ',', '+', ':', '/', ';']) {
        let separators: &[char] = if length(piece.trim_end()) > width { &['-'] } else { &[] };
        piece.split_inclusive(separators).for_each(|piece| append(&mut lines, piece, width));
    }
    let lines = lines.iter().map(|line| line.trim_end()).filter(|line| !line.is_empty()).enumerate();
    lines
        .map(|(number, line)| if number == 0 { format!("{marker}{line}") } else { " ".repeat(indent) + line })
        .collect()
}

/// Appends to the last line what fits there, else to a new one.
fn append(lines: &mut Vec<String>, piece: &str, width: usize) {
    let last = lines.last().map_or(0, |line| length(line));
    if last > 0 && last + length(piece.trim_end()) > width {
        lines.push(String::new());
    }
    for character in piece.chars() {
        let own = character.width().unwrap_or(0);
        if lines.last().is_some_and(|line| !line.is_empty() && length(line) + own > width) {
            lines.push(String::new());
        }
        // a line does not start with the space that ended the one before
        if let Some(line) = lines.last_mut().filter(|line| !(line.is_empty() && character == ' ')) {
            line.push(character);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_align_by_characters_not_bytes() {
        let mut table = Table::new(["name", "σ mm"]);
        table.row(vec!["é".to_owned(), "–".to_owned()]);
        table.row(vec!["long".to_owned(), "12.5".to_owned()]);
        assert_eq!(table.text(None), "name  σ mm\né        –\nlong  12.5\n");
    }

    /// A terminal draws 机 in two columns, and an accent that joins its letter in none.
    #[test]
    fn columns_align_where_characters_are_wide_or_join() {
        let mut table = Table::new(["cable", "N"]);
        table.row(vec!["机器人".to_owned(), "1".to_owned()]);
        table.row(vec!["e\u{301}le\u{301}vation".to_owned(), "2".to_owned()]);
        assert_eq!(table.text(None), "cable      N\n机器人     1\ne\u{301}le\u{301}vation  2\n");
    }

    #[test]
    fn the_widest_column_of_words_is_wrapped_to_the_terminal_and_nothing_is_lost() {
        let mut table = Table::new(["candidate", "mean mm", "σ mm"]);
        table.row(vec![
            "→ standard:frame-anchor,platform-anchor,length-offset".to_owned(),
            "4.1".to_owned(),
            "0.2".to_owned(),
        ]);
        table.row(vec!["  standard".to_owned(), "47.25".to_owned(), "1.3".to_owned()]);
        let expected = "\
candidate                    mean    σ
                               mm   mm
→ standard:frame-anchor,      4.1  0.2
  platform-anchor,
  length-offset
  standard                  47.25  1.3
";
        assert_eq!(table.text(Some(38)), expected);
        assert_eq!(table.text(Some(200)), table.text(None));
    }

    #[test]
    fn headings_of_numbers_give_way_before_words_do() {
        let mut table = Table::new(["candidate", "± std. error mm"]);
        table.row(vec!["standard:length-offset".to_owned(), "0.429".to_owned()]);
        let expected = "\
candidate               ± std.
                         error
                            mm
standard:length-offset   0.429
";
        assert_eq!(table.text(Some(30)), expected);
    }

    #[test]
    fn two_columns_of_words_share_what_room_there_is() {
        let mut table = Table::new(["name", "cables", "title"]).left_column(2);
        table.row(vec![
            "cablerobot-simulator-nominal".to_owned(),
            "8".to_owned(),
            "CableRobot Simulator, nominal".to_owned(),
        ]);
        let expected = "\
name             cables  title
cablerobot-           8  CableRobot
simulator-               Simulator,
nominal                  nominal
";
        assert_eq!(table.text(Some(40)), expected);
    }

    #[test]
    fn sentences_wrap_at_spaces_and_numbers_are_never_cut() {
        let mut table = Table::new(["reason", "value"]);
        table.row(vec!["cables 1 and 3 would have to push".to_owned(), "1234567.8901".to_owned()]);
        assert_eq!(
            table.text(Some(28)),
            "reason                 value\ncables 1 and 3  1234567.8901\nwould have to\npush\n"
        );
        // no room at all: the terminal breaks the lines, the numbers stay whole
        assert!(table.text(Some(5)).contains("1234567.8901"));
    }
}
