//! Errors in a measurement file: message, position, and advice.

use super::content::Columns;
use super::layout::Decimals;
use super::rows::{CsvFile, Row};
use crate::geometry::MotionPattern;
use crate::measurement::columns::{Quantity, meaning};
use crate::measurement::header_mistakes;
use crate::measurement::position_columns;
use crate::reading::{ReadError, TextPlace};

impl CsvFile<'_> {
    pub(super) fn error(&self, code: &'static str, message: impl Into<String>) -> ReadError {
        ReadError::new(self.file_name, code, message)
    }

    pub(super) fn header_error(&self, code: &'static str, message: impl Into<String>) -> ReadError {
        // the line as a whole: carets under all of it would add nothing
        self.error(code, message).at(TextPlace::on_line(self.layout.header, self.layout.header_line, 1, 1))
    }

    /// An error at a field: the column counts characters of the line, as an editor does.
    pub(super) fn at(&self, row: &Row<'_>, index: usize, code: &'static str, message: impl Into<String>) -> ReadError {
        let source = self.text.get(row.start..).and_then(|rest| rest.lines().next()).unwrap_or_default();
        // fields without quotes stand as they are read; with quotes the column is only a guess
        let width_of = |field: &[u8]| String::from_utf8_lossy(field).chars().count();
        let before: usize = row.record.iter().take(index).map(|field| width_of(field) + 1).sum();
        let width = row.record.get(index).map_or(1, width_of).max(1);
        self.error(code, message).at(TextPlace::on_line(source, row.line, before + 1, width))
    }

    /// An error about the numbers of a column, at its name.
    pub(super) fn column_error(&self, columns: &Columns, quantity: Quantity, message: String) -> ReadError {
        let index = columns.get(&quantity).map_or(0, |column| column.0);
        self.error("csv::magnitude", message).at(self.header_place(index))
    }

    /// The position of a column's name in the header.
    fn header_place(&self, index: usize) -> TextPlace {
        let (column, width) = self.layout.place_of(index);
        TextPlace::on_line(self.layout.header, self.layout.header_line, column, width)
    }

    /// The error for a missing column, at the column that probably was meant to be it.
    pub(super) fn missing_column(&self, name: &str) -> ReadError {
        let code = "csv::missing-column";
        let fields = self.layout.fields();
        let names: Vec<&str> = fields.iter().map(|field| field.trim().trim_matches('"')).collect();
        let unclaimed: Vec<&str> = names.iter().copied().filter(|name| matches!(meaning(name), Ok(None))).collect();
        if let Some(meant) = header_mistakes::probably_meant(name, &unclaimed) {
            let index = names.iter().position(|name| *name == meant).unwrap_or_default();
            let place = self.header_place(index);
            return self
                .error(code, format!("the column `{name}` is missing; is it this one, `{meant}`?"))
                .at(place)
                .with_help(format!(
                    "name it `{0}`; names are in small letters with the unit at its place (also accepted: mm, deg, kN), \
                     or keep the file and say --columns {0}='{meant}'",
                    header_mistakes::in_its_unit(name, meant)
                ));
        }
        let robot = self.robot;
        let (pattern, cables) = (robot.motion_pattern.name(), robot.cable_count());
        self.header_error(code, format!("the column `{name}` is missing")).with_help(format!(
            "robot \"{}\" has motion pattern {pattern} and {cables} cables: its data have the columns {}",
            robot.name,
            self.needed_columns()
        ))
    }

    /// Refuses a file whose columns count the cables from 0.
    pub(super) fn refuse_cables_from_0(&self) -> Result<(), ReadError> {
        let fields = self.layout.fields();
        let names: Vec<&str> = fields.iter().map(|field| field.trim().trim_matches('"')).collect();
        let m = self.robot.cable_count();
        let counts_from_0 = |name: &&str| {
            let Some(stem) = name.strip_suffix("_0") else { return false };
            let numbered = |cable: usize| format!("{stem}_{cable}");
            let is_cables = meaning(&numbered(1)).is_ok_and(|column| column.is_some_and(|c| c.quantity.is_of_cable()));
            is_cables
                && !names.contains(&numbered(m).as_str())
                && !self.options.columns.values().any(|used| used == name)
        };
        let Some(index) = names.iter().position(counts_from_0) else { return Ok(()) };
        let message = format!("the columns count the cables from 0 (`{}`)", names[index]);
        let help = format!("cables are counted from 1: rename _0 … _{} to _1 … _{m}", m.saturating_sub(1));
        Err(self.error("csv::cable-count", message).at(self.header_place(index)).with_help(help))
    }

    /// Refuses a file in which no column is, or probably was meant to be, one of a pose.
    pub(super) fn refuse_without_poses(&self) -> Result<(), ReadError> {
        let fields = self.layout.fields();
        let names: Vec<&str> = fields.iter().map(|field| field.trim().trim_matches('"')).collect();
        let unclaimed: Vec<&str> = names.iter().copied().filter(|name| matches!(meaning(name), Ok(None))).collect();
        let positions = position_columns(self.robot, "m");
        if positions.iter().any(|name| header_mistakes::probably_meant(name, &unclaimed).is_some()) {
            return Ok(());
        }
        let message = "the file has no poses, and measured ones are needed here";
        let help = format!(
            "add the poses of a tracker's log, or say which columns are {}; robot \"{}\" needs {}",
            positions.join(", "),
            self.robot.name,
            self.needed_columns()
        );
        Err(self.header_error("csv::no-poses", message).with_help(help))
    }

    /// List of the columns that data of this robot must have, for messages.
    fn needed_columns(&self) -> String {
        let pattern = self.robot.motion_pattern;
        let rotation = match pattern {
            MotionPattern::Planar => ", angle_rad",
            MotionPattern::Spatial => ", qx, qy, qz, qw (or rx_rad, ry_rad, rz_rad)",
            _ => "",
        };
        let positions = position_columns(self.robot, "m").join(", ");
        format!("{positions}{rotation}, cable_length_m_1 … cable_length_m_{}", self.robot.cable_count())
    }

    pub(super) fn ragged(&self, row: &Row<'_>) -> ReadError {
        let (found, expected) = (row.record.len(), row.header.len());
        let message = format!("this row has {found} fields, the header names {expected} columns");
        let is_empty = |field: &[u8]| field.trim_ascii().is_empty();
        let help = match () {
            () if found > expected && row.record.iter().skip(expected).all(is_empty) => {
                "remove the comma at the end of the row, or name the column"
            }
            () if found == 2 * expected => "are these decimal commas? numbers are written with a decimal point",
            () => "is a comma missing, or one too many, or a decimal comma?",
        };
        self.at(row, found.min(expected).saturating_sub(1), "csv::ragged-row", message).with_help(help)
    }

    /// Advice for a field that is not a number.
    pub(super) fn help_for_text(&self, written: &str, row: &Row<'_>, decimals: Decimals) -> String {
        let is_text = |field: &[u8]| !field.iter().any(u8::is_ascii_digit);
        if row.line == self.layout.header_line + 1 && row.record.iter().all(is_text) {
            return "is the second line one of units? remove it: the unit is part of the column's name".to_owned();
        }
        let (mark, other) = if decimals.mark == b',' { ("comma", '.') } else { ("point", ',') };
        let is_number = |text: &str| text.replacen(other, ".", 1).replace(',', ".").parse::<f64>().is_ok();
        match (written.matches(other).count(), is_number(written.trim())) {
            (0, _) => format!("numbers are written with a decimal {mark}, without unit"),
            (_, true) if decimals.mark == b'.' && self.layout.separator == b',' => {
                "numbers are written with a decimal point, not with a comma".to_owned()
            }
            _ => format!(
                "line {} has a decimal {mark}, so all numbers have one, and none a separator of thousands",
                decimals.line
            ),
        }
    }

    pub(super) fn unreadable(&self, error: &csv::Error) -> ReadError {
        let place = error.position().map(|position| {
            let line = position.line() as usize;
            TextPlace::on_line(self.text.lines().nth(line.saturating_sub(1)).unwrap_or_default(), line, 1, 1)
        });
        let error = self.error("csv::unreadable", error.to_string());
        place.map_or(error.clone(), |place| error.at(place))
    }
}

pub(super) fn shortened(text: &str) -> String {
    text.trim().chars().take(40).collect()
}
