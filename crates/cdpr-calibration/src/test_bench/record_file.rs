//! Reader of the CSV file of a record.

use std::collections::BTreeMap;

use csv::{ByteRecord, ReaderBuilder};

use super::Record;
use cdpr_model::reading::{ReadError, Size, TextPlace, help_for_unknown, text_from_bytes};

/// A record with what its reader noticed.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordReading {
    /// The record.
    pub record: Record,
    /// Remarks for the user, e.g. on ignored columns.
    pub notices: Vec<String>,
}

/// Names of columns, their quantity and factor to SI.
const COLUMNS: &[(&str, Quantity, f64)] = &[
    ("elongation_m", Quantity::Elongation, 1.0),
    ("elongation_mm", Quantity::Elongation, 1e-3),
    ("tension_N", Quantity::Tension, 1.0),
    ("tension_kN", Quantity::Tension, 1e3),
    ("direction", Quantity::Direction, 1.0),
];

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Quantity {
    Elongation,
    Tension,
    Direction,
}

struct RecordFile<'a> {
    text: &'a str,
    file_name: &'a str,
}

/// One row, its fields, and its line.
struct Row<'a> {
    fields: &'a ByteRecord,
    line: usize,
}

impl Record {
    /// Reads a CSV with the columns `elongation_m` or `elongation_mm`, `tension_N` or `tension_kN`, and perhaps
    /// `direction` (1 loading, −1 unloading, 0 at rest).
    pub fn from_csv(bytes: &[u8], file_name: &str) -> Result<RecordReading, ReadError> {
        let text = text_from_bytes(bytes, Size::Table, file_name)?.trim_start_matches('\u{feff}');
        RecordFile { text, file_name }.read()
    }
}

impl RecordFile<'_> {
    fn read(&self) -> Result<RecordReading, ReadError> {
        if self.text.trim().is_empty() {
            let help = "the first line names the columns: elongation_m,tension_N";
            return Err(self.error("csv::empty", "the file is empty").with_help(help));
        }
        let mut reader = ReaderBuilder::new().flexible(true).from_reader(self.text.as_bytes());
        let unreadable = |error: csv::Error| self.error("csv::unreadable", error.to_string());
        let header = reader.byte_headers().map_err(unreadable)?.clone();
        let mut notices = Vec::new();
        let columns = self.columns(&header, &mut notices)?;
        let mut record = Record::default();
        let mut directions = Vec::new();
        let mut fields = ByteRecord::new();
        while reader.read_byte_record(&mut fields).map_err(unreadable)? {
            let row = Row { fields: &fields, line: fields.position().map_or(0, |position| position.line() as usize) };
            if fields.len() != header.len() {
                let message =
                    format!("this row has {} fields, the header names {} columns", fields.len(), header.len());
                let error = self.at(&row, fields.len().min(header.len()).saturating_sub(1), "csv::ragged-row", message);
                return Err(error.with_help("is a comma missing, or one too many, or a decimal comma?"));
            }
            for (quantity, &(index, factor)) in &columns {
                let value = factor * self.number(&row, index, *quantity)?;
                match quantity {
                    Quantity::Elongation => record.elongations.push(value),
                    Quantity::Tension => record.tensions.push(value),
                    Quantity::Direction => directions.push(value),
                }
            }
        }
        if record.elongations.is_empty() {
            return Err(self.error("csv::no-rows", "the file has column names but no rows"));
        }
        record.directions = columns.contains_key(&Quantity::Direction).then_some(directions);
        Ok(RecordReading { record, notices })
    }

    fn columns(
        &self,
        header: &ByteRecord,
        notices: &mut Vec<String>,
    ) -> Result<BTreeMap<Quantity, (usize, f64)>, ReadError> {
        let mut columns = BTreeMap::new();
        let mut ignored = Vec::new();
        let row = Row { fields: header, line: 1 };
        for (index, name) in header.iter().enumerate() {
            let name = String::from_utf8_lossy(name).trim().to_owned();
            let Some(&(_, quantity, factor)) = COLUMNS.iter().find(|column| column.0 == name) else {
                if name.starts_with("elongation") || name.starts_with("tension") {
                    let message = format!("column `{name}`: the unit is not known");
                    let known: Vec<&str> = COLUMNS.iter().map(|column| column.0).collect();
                    return Err(self
                        .at(&row, index, "csv::unknown-unit", message)
                        .with_help(help_for_unknown(&name, &known)));
                }
                ignored.push(format!("`{name}`"));
                continue;
            };
            if columns.insert(quantity, (index, factor)).is_some() {
                let message = format!("column `{name}` repeats a quantity that another column already gives");
                return Err(self.at(&row, index, "csv::repeated-column", message).with_help("remove one of the two"));
            }
        }
        for (quantity, name) in [(Quantity::Elongation, "elongation_m"), (Quantity::Tension, "tension_N")] {
            if !columns.contains_key(&quantity) {
                let message = format!("the column `{name}` is missing");
                let help = "a record has elongation_m (or _mm), tension_N (or _kN) and perhaps direction";
                return Err(self.at(&row, 0, "csv::missing-column", message).with_help(help));
            }
        }
        if !ignored.is_empty() {
            notices.push(format!("{}: ignored columns {}", self.file_name, ignored.join(", ")));
        }
        Ok(columns)
    }

    fn number(&self, row: &Row<'_>, index: usize, quantity: Quantity) -> Result<f64, ReadError> {
        let written = String::from_utf8_lossy(&row.fields[index]);
        match written.trim() {
            "loading" if quantity == Quantity::Direction => return Ok(1.0),
            "unloading" if quantity == Quantity::Direction => return Ok(-1.0),
            _ => {}
        }
        match written.trim().parse::<f64>() {
            Ok(value) if value.is_finite() && value.abs() < 1e30 => Ok(value),
            _ => {
                let shown: String = written.trim().chars().take(40).collect();
                let message = format!("`{shown}` is not a number to calculate with");
                let help = match quantity {
                    Quantity::Direction => {
                        "write 1 while loading, -1 while unloading, 0 at rest, or leave the column out"
                    }
                    _ => "write the number with a decimal point and without unit, or remove the row",
                };
                Err(self.at(row, index, "csv::not-a-number", message).with_help(help))
            }
        }
    }

    fn error(&self, code: &'static str, message: impl Into<String>) -> ReadError {
        ReadError::new(self.file_name, code, message)
    }

    fn at(&self, row: &Row<'_>, index: usize, code: &'static str, message: impl Into<String>) -> ReadError {
        let source = self.text.lines().nth(row.line.saturating_sub(1)).unwrap_or_default();
        let width_of = |field: &[u8]| String::from_utf8_lossy(field).chars().count();
        let before: usize = row.fields.iter().take(index).map(|field| width_of(field) + 1).sum();
        let width = row.fields.get(index).map_or(1, width_of).max(1);
        self.error(code, message).at(TextPlace::on_line(source, row.line, before + 1, width))
    }
}
