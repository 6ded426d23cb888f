//! Layout of a table: the line of its column names, and the separators of fields and decimals.

use csv::{ByteRecord, Reader, ReaderBuilder};

use super::content::Columns;
use crate::measurement::columns::Quantity;

/// Separators that are tried; of equal counts the first is used.
const SEPARATORS: [u8; 3] = [b',', b';', b'\t'];

/// Line of the column names, and the separator of fields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Layout<'a> {
    /// Line with the column names.
    pub(super) header: &'a str,
    /// Its number, from 1.
    pub(super) header_line: usize,
    /// Byte at which it starts.
    pub(super) header_start: usize,
    pub(super) separator: u8,
}

/// The decimal mark of a file and the line of the first number that has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Decimals {
    pub(super) mark: u8,
    pub(super) line: usize,
}

impl<'a> Layout<'a> {
    /// Column names are in the first line that is neither blank nor a comment; the separator is the most frequent one
    /// there.
    pub(super) fn of(text: &'a str) -> Self {
        let is_header = |line: &&str| !line.trim().is_empty() && !line.starts_with('#');
        let (index, header) = text.lines().enumerate().find(|(_, line)| is_header(line)).unwrap_or((0, ""));
        let header_start = text.split_inclusive('\n').take(index).map(str::len).sum();
        let count = |separator: u8| unquoted(header).filter(|byte| *byte == separator).count();
        let separator = SEPARATORS.into_iter().rev().max_by_key(|separator| count(*separator)).unwrap_or(b',');
        Self { header, header_line: index + 1, header_start, separator }
    }

    /// A reader of the table; lines that begin with `#` are skipped.
    pub(super) fn reader<'t>(&self, text: &'t str) -> Reader<&'t [u8]> {
        let mut builder = ReaderBuilder::new();
        builder.flexible(true).comment(Some(b'#')).delimiter(self.separator).from_reader(text.as_bytes())
    }

    /// Names of the columns as written in the line.
    pub(super) fn fields(&self) -> Vec<&'a str> {
        self.header.split(char::from(self.separator)).collect()
    }

    /// Character at which a field of the header starts, from 1, and its width.
    pub(super) fn place_of(&self, index: usize) -> (usize, usize) {
        let fields = self.fields();
        let column = fields.iter().take(index).map(|field| field.chars().count() + 1).sum::<usize>() + 1;
        (column, fields.get(index).map_or(1, |field| field.chars().count()).max(1))
    }

    /// The decimal mark of the first number that has one; always a point if fields are separated by commas.
    pub(super) fn decimals(&self, text: &str, columns: &Columns) -> Decimals {
        let point = Decimals { mark: b'.', line: self.header_line };
        if self.separator == b',' {
            return point;
        }
        let numbers: Vec<usize> =
            columns.iter().filter(|(quantity, _)| **quantity != Quantity::Set).map(|(_, column)| column.0).collect();
        let mut reader = self.reader(text);
        let mut record = ByteRecord::new();
        while reader.read_byte_record(&mut record).unwrap_or(false) {
            let fields = numbers.iter().filter_map(|&index| record.get(index));
            // in 1.234,5 the last mark is that of the decimals
            let mark = |field: &[u8]| field.iter().rev().copied().find(|byte| matches!(byte, b',' | b'.'));
            if let Some(mark) = fields.filter(|field| field.iter().any(u8::is_ascii_digit)).find_map(mark) {
                return Decimals { mark, line: line_of(text, &record).0 };
            }
        }
        point
    }

    /// Remark on the file's separators, decimals and encoding; `None` for the standard layout.
    pub(super) fn remark(&self, decimals: Decimals, encoding: Option<&str>) -> Option<String> {
        let separated = match self.separator {
            b';' => Some("; separated"),
            b'\t' => Some("tab separated"),
            _ => None,
        };
        let commas = (decimals.mark == b',').then_some("with decimal commas");
        let fields = [separated, commas].into_iter().flatten().collect::<Vec<_>>().join(" ");
        let parts: Vec<&str> =
            [fields.as_str(), encoding.unwrap_or_default()].into_iter().filter(|part| !part.is_empty()).collect();
        (!parts.is_empty()).then(|| format!("read as {}", parts.join(", ")))
    }
}

/// The line of a row, from 1, and the byte at which it starts, after blank lines and comments that the reader has
/// skipped.
pub(super) fn line_of(text: &str, record: &ByteRecord) -> (usize, usize) {
    let Some(position) = record.position() else { return (0, 0) };
    let (mut line, mut start) = (position.line() as usize, position.byte() as usize);
    loop {
        let rest = text.as_bytes().get(start..).unwrap_or_default();
        let skipped = match rest.first() {
            Some(b'\n' | b'\r') => 1,
            Some(b'#') => rest.iter().position(|byte| *byte == b'\n').map_or(rest.len(), |end| end + 1),
            _ => return (line, start),
        };
        line += usize::from(rest[skipped - 1] == b'\n');
        start += skipped;
    }
}

/// The bytes of a line outside quotes.
fn unquoted(line: &str) -> impl Iterator<Item = u8> {
    let mut is_quoted = false;
    line.bytes().filter(move |byte| {
        is_quoted ^= *byte == b'"';
        !is_quoted
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_header_and_its_separator_are_found_below_comments_and_blank_lines() {
        for (text, header_line, separator) in [
            ("x_m,y_m\n1,2\n", 1, b','),
            ("# May\n\n#;;;\nx_m;y_m\n1;2\n", 4, b';'),
            ("x_m\ty_m\n", 1, b'\t'),
            ("x_m\n1\n", 1, b','),
            ("\"a;b;c\",y_m\n", 1, b','),
        ] {
            let layout = Layout::of(text);
            assert_eq!((layout.header_line, layout.separator), (header_line, separator), "{text}");
        }
    }

    #[test]
    fn rows_keep_the_numbers_of_their_lines() {
        for end in ["\n", "\r\n"] {
            let text = "# May\nx_m;y_m\n\n1;2\n# pause\n\n\n3;4\n5;6\n".replace('\n', end);
            let layout = Layout::of(&text);
            let lines: Vec<usize> =
                layout.reader(&text).byte_records().map(|record| line_of(&text, &record.unwrap()).0).collect();
            assert_eq!(lines, [4, 8, 9], "{end:?}");
        }
    }
}
