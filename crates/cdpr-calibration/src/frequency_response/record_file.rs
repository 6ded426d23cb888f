//! Reader of the CSV file of a record.

use csv::{ByteRecord, ReaderBuilder};

use super::sampling::check_times;
use super::{InputError, Record};
use cdpr_model::reading::{ErrorCode, ReadError, Size, TextPlace, help_for_unknown, text_from_bytes};

/// Columns of a record that are read as input and output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Columns {
    /// Name of the input's column.
    pub input: String,
    /// Name of the output's column.
    pub output: String,
}

impl Default for Columns {
    fn default() -> Self {
        Self { input: "motor_torque_Nm".to_owned(), output: "tension_N".to_owned() }
    }
}

/// A record with what its reader noticed.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordReading {
    /// The record.
    pub record: Record,
    /// Remarks for the user, e.g. on ignored columns.
    pub notices: Vec<String>,
}

/// Columns of the time with their factor to seconds.
const TIMES: [(&str, f64); 3] = [("t_s", 1.0), ("t_ms", 1e-3), ("t_us", 1e-6)];

struct RecordFile<'a> {
    text: &'a str,
    file_name: &'a str,
    columns: &'a Columns,
}

/// One row, its fields, and its line.
struct Row<'a> {
    fields: &'a ByteRecord,
    line: usize,
}

impl Record {
    /// Reads a CSV with the column `t_s` (or `t_ms`, `t_us`) and those of input and output, whose numbers are taken as they are.
    pub fn from_csv(bytes: &[u8], file_name: &str, columns: &Columns) -> Result<RecordReading, ReadError> {
        let text = text_from_bytes(bytes, Size::Table, file_name)?.trim_start_matches('\u{feff}');
        RecordFile { text, file_name, columns }.read()
    }
}

impl RecordFile<'_> {
    fn read(&self) -> Result<RecordReading, ReadError> {
        if self.text.trim().is_empty() {
            let help = format!("the first line names the columns: t_s,{},{}", self.columns.input, self.columns.output);
            return Err(self.error("csv::empty", "the file is empty").with_help(help));
        }
        let mut reader = ReaderBuilder::new().flexible(true).from_reader(self.text.as_bytes());
        let unreadable = |error: csv::Error| self.error("csv::unreadable", error.to_string());
        let header = reader.byte_headers().map_err(unreadable)?.clone();
        let mut notices = Vec::new();
        let (places, factor) = self.places(&header, &mut notices)?;
        let mut record = Record::default();
        let mut lines = Vec::new();
        let mut fields = ByteRecord::new();
        while reader.read_byte_record(&mut fields).map_err(unreadable)? {
            let row = Row { fields: &fields, line: fields.position().map_or(0, |position| position.line() as usize) };
            if fields.len() != header.len() {
                let message =
                    format!("this row has {} fields, the header names {} columns", fields.len(), header.len());
                let error = self.at(&row, fields.len().min(header.len()).saturating_sub(1), "csv::ragged-row", message);
                return Err(error.with_help("is a comma missing, or one too many, or a decimal comma?"));
            }
            let [time, input, output] = places.map(|place| self.number(&row, place));
            record.times.push(factor * time?);
            record.input.push(input?);
            record.output.push(output?);
            lines.push(row.line);
        }
        if record.times.is_empty() {
            return Err(self.error("csv::no-rows", "the file has column names but no rows"));
        }
        check_times(&record.times).map_err(|error| self.wrong_time(&error, &lines, places[0]))?;
        Ok(RecordReading { record, notices })
    }

    /// Places of time, input and output, and the factor of the time.
    fn places(&self, header: &ByteRecord, notices: &mut Vec<String>) -> Result<([usize; 3], f64), ReadError> {
        let names: Vec<String> = header.iter().map(|name| String::from_utf8_lossy(name).trim().to_owned()).collect();
        let row = Row { fields: header, line: 1 };
        let known: Vec<&str> = names.iter().map(String::as_str).collect();
        let place = |name: &str| {
            let mut all = (0..names.len()).filter(|&index| names[index] == name);
            match (all.next(), all.next()) {
                (Some(index), None) => Ok(index),
                (Some(_), Some(second)) => {
                    let message = format!("column `{name}` is there twice");
                    Err(self.at(&row, second, "csv::repeated-column", message).with_help("remove one of the two"))
                }
                _ => {
                    let message = format!("the column `{name}` is missing");
                    let help = format!(
                        "{}; --input COLUMN and --output COLUMN name those of the record",
                        help_for_unknown(name, &known)
                    );
                    Err(self.at(&row, 0, "csv::missing-column", message).with_help(help))
                }
            }
        };
        let Some(&(time, factor)) = TIMES.iter().find(|(name, _)| names.iter().any(|own| own == name)) else {
            if let Some(index) = names.iter().position(|name| name.starts_with("t_")) {
                let message = format!("column `{}`: the unit is not known", names[index]);
                let help = "a time has one of the names t_s, t_ms and t_us";
                return Err(self.at(&row, index, "csv::unknown-unit", message).with_help(help));
            }
            let help = "a record has a column t_s (or t_ms, t_us) with the time of each row";
            return Err(self.at(&row, 0, "csv::missing-column", "the column `t_s` is missing").with_help(help));
        };
        let places = [place(time)?, place(&self.columns.input)?, place(&self.columns.output)?];
        let is_ignored = |index: &usize| !places.contains(index);
        let ignored: Vec<String> = (0..names.len()).filter(is_ignored).map(|k| format!("`{}`", names[k])).collect();
        if !ignored.is_empty() {
            notices.push(format!("{}: ignored columns {}", self.file_name, ignored.join(", ")));
        }
        Ok((places, factor))
    }

    fn number(&self, row: &Row<'_>, index: usize) -> Result<f64, ReadError> {
        let written = String::from_utf8_lossy(&row.fields[index]);
        match written.trim().parse::<f64>() {
            Ok(value) if value.is_finite() && value.abs() < 1e30 => Ok(value),
            _ => {
                let shown: String = written.trim().chars().take(40).collect();
                let message = format!("`{shown}` is not a number to calculate with");
                let help = "write the number with a decimal point and without unit; a record without this row has a gap: cut it there";
                Err(self.at(row, index, "csv::not-a-number", message).with_help(help))
            }
        }
    }

    /// The line at which time is not what sampling needs.
    fn wrong_time(&self, error: &InputError, lines: &[usize], column: usize) -> ReadError {
        let (InputError::TimeOrder { row, .. } | InputError::Uneven { row, .. }) = error else {
            return self.error(error.code(), error.to_string());
        };
        let line = lines[row - 1];
        let source = self.text.lines().nth(line.saturating_sub(1)).unwrap_or_default();
        let field = source.split(',').nth(column).unwrap_or(source).chars().count().max(1);
        let before: usize = source.split(',').take(column).map(|field| field.chars().count() + 1).sum();
        self.error(error.code(), error.to_string()).at(TextPlace::on_line(source, line, before + 1, field))
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
