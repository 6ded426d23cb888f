//! A table of a result's folder, read back.

use cdpr_model::reading::{ReadError, Size, TextPlace, text_from_bytes};

use crate::NamedFile;

/// Fields under a heading, with the line of each row.
pub(super) struct CsvTable {
    file_name: String,
    pub(super) heading: Vec<String>,
    pub(super) rows: Vec<(usize, Vec<String>)>,
}

impl CsvTable {
    /// The table in the bytes of a file.
    pub(super) fn of(NamedFile { name: file_name, content }: NamedFile) -> Result<Self, ReadError> {
        let text = text_from_bytes(&content, Size::Table, &file_name)?;
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| {
                let line = error.position().map_or(1, |place| usize::try_from(place.line()).unwrap_or(1));
                placed(&file_name, line, format!("this is no table: {error}"))
            })?;
            let line = record.position().map_or(1, |place| usize::try_from(place.line()).unwrap_or(1));
            rows.push((line, record.iter().map(str::to_owned).collect()));
        }
        if rows.is_empty() {
            return Err(placed(&file_name, 1, "the table is empty".to_owned()));
        }
        let (_, heading) = rows.remove(0);
        Ok(Self { file_name, heading, rows })
    }

    /// Number of the column of this name.
    pub(super) fn column(&self, name: &str) -> Result<usize, ReadError> {
        self.heading.iter().position(|known| known == name).ok_or_else(|| {
            placed(&self.file_name, 1, format!("the column `{name}` is missing"))
                .with_help("was the folder written by this version? the command in run.toml makes it again")
        })
    }

    /// The number in a field; NaN for an empty one.
    pub(super) fn number(&self, row: &(usize, Vec<String>), column: usize) -> Result<f64, ReadError> {
        let field = row.1.get(column).map_or("", String::as_str).trim();
        if field.is_empty() {
            return Ok(f64::NAN);
        }
        field.parse().map_err(|_| placed(&self.file_name, row.0, format!("`{field}` is not a number")))
    }
}

fn placed(file_name: &str, line: usize, message: String) -> ReadError {
    ReadError::new(file_name, "result::table", message).at(TextPlace::on_line("", line, 1, 1))
}
