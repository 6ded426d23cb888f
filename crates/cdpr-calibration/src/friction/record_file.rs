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
    ("motor_speed_rad_per_s", Quantity::Speed, 1.0),
    ("motor_speed_deg_per_s", Quantity::Speed, std::f64::consts::PI / 180.0),
    ("motor_speed_rpm", Quantity::Speed, std::f64::consts::PI / 30.0),
    ("motor_torque_Nm", Quantity::Torque, 1.0),
    ("motor_torque_mNm", Quantity::Torque, 1e-3),
    ("load_Nm", Quantity::Load, 1.0),
    ("t_s", Quantity::Time, 1.0),
    ("motor_position_rad", Quantity::Position, 1.0),
    ("direction", Quantity::Direction, 1.0),
    ("run", Quantity::Run, 1.0),
    ("load_kg", Quantity::Mass, 1.0),
];

/// Beginnings of names whose unit has to be known.
const QUANTITIES: [&str; 2] = ["motor_speed", "motor_torque"];

const HELP: &str = "a record has motor_speed_rad_per_s (lifting positive; or _rpm, _deg_per_s), motor_torque_Nm (against the load positive; or _mNm) and perhaps load_Nm, t_s, \
                    motor_position_rad, direction, run, load_kg";

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Quantity {
    Speed,
    Torque,
    Load,
    Time,
    Position,
    Direction,
    Run,
    Mass,
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
    /// Reads a CSV with the columns `motor_speed_rad_per_s` (or `_rpm`, `_deg_per_s`; lifting positive) and `motor_torque_Nm` (or `_mNm`; against
    /// the load positive), and perhaps `load_Nm`, `t_s`, `motor_position_rad`, `run`, `load_kg`, and `direction` (`up`, `lifting` or 1, `down`,
    /// `lowering` or −1) where speeds have no sign.
    pub fn from_csv(bytes: &[u8], file_name: &str) -> Result<RecordReading, ReadError> {
        let text = text_from_bytes(bytes, Size::Table, file_name)?.trim_start_matches('\u{feff}');
        RecordFile { text, file_name }.read()
    }
}

impl RecordFile<'_> {
    fn read(&self) -> Result<RecordReading, ReadError> {
        if self.text.trim().is_empty() {
            let help = "the first line names the columns: motor_speed_rad_per_s,motor_torque_Nm";
            return Err(self.error("csv::empty", "the file is empty").with_help(help));
        }
        let mut reader = ReaderBuilder::new().flexible(true).from_reader(self.text.as_bytes());
        let unreadable = |error: csv::Error| self.error("csv::unreadable", error.to_string());
        let header = reader.byte_headers().map_err(unreadable)?.clone();
        let mut notices = Vec::new();
        let columns = self.columns(&header, &mut notices)?;
        let mut record = Record::default();
        let mut optional: BTreeMap<Quantity, Vec<f64>> = BTreeMap::new();
        let mut fields = ByteRecord::new();
        while reader.read_byte_record(&mut fields).map_err(unreadable)? {
            let row = Row { fields: &fields, line: fields.position().map_or(0, |position| position.line() as usize) };
            if fields.len() != header.len() {
                let message =
                    format!("this row has {} fields, the header names {} columns", fields.len(), header.len());
                let error = self.at(&row, fields.len().min(header.len()).saturating_sub(1), "csv::ragged-row", message);
                return Err(error.with_help("is a comma missing, or one too many, or a decimal comma?"));
            }
            let mut speed = 0.0;
            for (quantity, &(index, factor)) in &columns {
                let value = factor * self.number(&row, index, *quantity)?;
                match quantity {
                    Quantity::Speed => speed = value,
                    Quantity::Torque => record.torques.push(value),
                    Quantity::Direction => speed = self.directed(&row, index, speed, value)?,
                    other => optional.entry(*other).or_default().push(value),
                }
            }
            record.lines.push(row.line);
            record.speeds.push(speed);
        }
        if record.speeds.is_empty() {
            return Err(self.error("csv::no-rows", "the file has column names but no rows").with_help(HELP));
        }
        record.loads = optional.remove(&Quantity::Load);
        record.times = optional.remove(&Quantity::Time);
        record.positions = optional.remove(&Quantity::Position);
        record.runs = optional.remove(&Quantity::Run);
        record.masses = optional.remove(&Quantity::Mass).filter(|_| record.loads.is_none());
        Ok(RecordReading { record, notices })
    }

    /// A speed with the sign of its direction.
    fn directed(&self, row: &Row<'_>, index: usize, speed: f64, direction: f64) -> Result<f64, ReadError> {
        if speed < 0.0 && direction > 0.0 {
            let message = format!("the speed {speed} rad/s is below zero, and the direction says lifting");
            let help = "speeds are positive while lifting: turn the sign, or leave the column `direction` out";
            return Err(self.at(row, index, "csv::direction", message).with_help(help));
        }
        Ok(if direction == 0.0 { 0.0 } else { speed.abs().copysign(direction) })
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
                if QUANTITIES.iter().any(|own| name.starts_with(own)) && !name.contains("_sd_") {
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
        for (quantity, name) in [(Quantity::Speed, "motor_speed_rad_per_s"), (Quantity::Torque, "motor_torque_Nm")] {
            if !columns.contains_key(&quantity) {
                let message = format!("the column `{name}` is missing");
                return Err(self.at(&row, 0, "csv::missing-column", message).with_help(HELP));
            }
        }
        if columns.contains_key(&Quantity::Mass) && !columns.contains_key(&Quantity::Load) {
            notices.push(format!(
                "{}: load_kg tells loads apart; their torques are fitted. Write load_Nm (m g r, r the radius of the drum) if the radius is known",
                self.file_name
            ));
        }
        if !ignored.is_empty() {
            notices.push(format!("{}: ignored columns {}", self.file_name, ignored.join(", ")));
        }
        Ok(columns)
    }

    fn number(&self, row: &Row<'_>, index: usize, quantity: Quantity) -> Result<f64, ReadError> {
        let written = String::from_utf8_lossy(&row.fields[index]);
        match written.trim() {
            "up" | "lifting" if quantity == Quantity::Direction => return Ok(1.0),
            "down" | "lowering" if quantity == Quantity::Direction => return Ok(-1.0),
            _ => {}
        }
        match written.trim().parse::<f64>() {
            Ok(value) if value.is_finite() && value.abs() < 1e30 => Ok(value),
            _ => {
                let shown: String = written.trim().chars().take(40).collect();
                let message = format!("`{shown}` is not a number to calculate with");
                let help = match quantity {
                    Quantity::Direction => {
                        "write 1 (or up) while lifting, -1 (or down) while lowering, or leave the column out"
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
