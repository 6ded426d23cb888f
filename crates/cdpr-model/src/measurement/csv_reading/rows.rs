//! A measurement file, and one row of it.

use std::borrow::Cow;

use csv::ByteRecord;

use super::content::{Columns, Content};
use super::layout::{Decimals, Layout, line_of};
use super::options::ReadingOptions;
use super::skipping::Skipped;
use crate::reading::ReadError;
use crate::robot::Robot;

/// A file with the options of reading.
pub(super) struct CsvFile<'a> {
    pub(super) text: &'a str,
    pub(super) file_name: &'a str,
    pub(super) robot: &'a Robot,
    pub(super) options: &'a ReadingOptions,
    pub(super) content: Content,
    pub(super) layout: Layout<'a>,
    /// Encoding of the bytes if it is not UTF-8.
    pub(super) encoding: Option<&'static str>,
}

/// The text of a field without blanks around it, and without quotes that blanks stand before.
pub(super) fn plain(field: &[u8]) -> Cow<'_, str> {
    let text = String::from_utf8_lossy(field.trim_ascii());
    match text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        Some(inner) => Cow::Owned(inner.trim().to_owned()),
        None => text,
    }
}

/// One data row with its position in the file.
pub(super) struct Row<'a> {
    pub(super) record: &'a ByteRecord,
    pub(super) header: &'a ByteRecord,
    pub(super) line: usize,
    /// Byte of the text at which the line starts.
    pub(super) start: usize,
}

/// Columns of a file and its decimal mark, with which numbers are read from a row.
pub(super) struct Format {
    pub(super) columns: Columns,
    pub(super) decimals: Decimals,
}

/// Function that takes one row.
pub(super) type TakeRow<'a> = &'a mut dyn FnMut(&Format, &Row<'_>) -> Result<(), ReadError>;

impl CsvFile<'_> {
    /// Reads the header, checks it, passes every row to `take`, and returns the columns and the rows left out.
    pub(super) fn rows(&self, notices: &mut Vec<String>, take: TakeRow<'_>) -> Result<(Format, Skipped), ReadError> {
        if self.text.trim().is_empty() {
            return Err(self.error("csv::empty", "the file is empty").with_help("the first line names the columns"));
        }
        let mut reader = self.layout.reader(self.text);
        let header = reader.byte_headers().map_err(|error| self.unreadable(&error))?.clone();
        let columns = self.columns(&header, notices)?;
        self.check_columns(&columns)?;
        let decimals = self.layout.decimals(self.text, &columns);
        let read_as = self.layout.remark(decimals, self.encoding);
        notices.extend(read_as.map(|remark| format!("{}: {remark}", self.file_name)));
        let format = Format { columns, decimals };
        let mut record = ByteRecord::new();
        let (mut count, mut skipped) = (0, Skipped::default());
        while reader.read_byte_record(&mut record).map_err(|error| self.unreadable(&error))? {
            let (line, start) = line_of(self.text, &record);
            let row = Row { record: &record, header: &header, line, start };
            let taken = if record.len() == header.len() { take(&format, &row) } else { Err(self.ragged(&row)) };
            match taken {
                Err(error) if self.options.skip_invalid => skipped.add(error),
                other => other?,
            }
            count += 1;
        }
        match skipped.first() {
            _ if count == 0 => Err(self.error("csv::no-rows", "the file has column names but no rows")),
            Some(first) if skipped.count() == count => Err(first.clone()),
            _ => Ok((format, skipped)),
        }
    }
}
