//! Reader of measurement CSV files; every mistake with its line and column.

use std::collections::BTreeMap;

use csv::{ByteRecord, ReaderBuilder};

use super::Samples;
use super::columns::{Column, Quantity, meaning};
use crate::geometry::{MotionPattern, Pose};
use crate::reading::{Place, ReadError, text_from_bytes};
use crate::robot::Robot;

/// A data set with what its reader noticed.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The samples.
    pub samples: Samples,
    /// Remarks for the user, e.g. on ignored columns.
    pub notices: Vec<String>,
}

/// Columns of a file by quantity: their index and factor to SI.
type Columns = BTreeMap<Quantity, (usize, f64)>;

impl Samples {
    /// Reads a measurement CSV of a robot (columns: interface of `cdpr`, `measurement::schema`).
    pub fn from_csv(bytes: &[u8], file_name: &str, robot: &Robot) -> Result<Reading, ReadError> {
        let text = text_from_bytes(bytes, file_name)?;
        CsvFile { text: text.trim_start_matches('\u{feff}'), file_name, robot }.read()
    }
}

/// Poses of a CSV with the pose columns of measurements; other columns are ignored.
pub fn poses_from_csv(bytes: &[u8], file_name: &str, robot: &Robot) -> Result<Vec<Pose>, ReadError> {
    let text = text_from_bytes(bytes, file_name)?;
    let file = CsvFile { text: text.trim_start_matches('\u{feff}'), file_name, robot };
    let mut poses = Vec::new();
    let mut notices = Vec::new();
    file.rows(&mut notices, &|_| Ok(()), &mut |columns, row| {
        poses.push(file.pose(columns, row)?);
        Ok(())
    })?;
    Ok(poses)
}

struct CsvFile<'a> {
    text: &'a str,
    file_name: &'a str,
    robot: &'a Robot,
}

/// One data row with its place in the file.
struct Row<'a> {
    record: &'a ByteRecord,
    header: &'a ByteRecord,
    line: usize,
}

impl CsvFile<'_> {
    fn read(&self) -> Result<Reading, ReadError> {
        let m = self.robot.cable_count();
        let mut samples = Samples { cable_count: m, ..Samples::default() };
        let mut notices = Vec::new();
        let (mut tensions, mut set, mut time) = (Vec::new(), Vec::new(), Vec::new());
        self.rows(&mut notices, &|columns| self.check_cables(columns), &mut |columns, row| {
            samples.poses.push(self.pose(columns, row)?);
            for cable in 0..m {
                samples.lengths.push(self.number(columns, row, Quantity::Length(cable))?);
                if columns.contains_key(&Quantity::Tension(cable)) {
                    tensions.push(self.number(columns, row, Quantity::Tension(cable))?);
                }
            }
            if let Some(&(index, _)) = columns.get(&Quantity::Set) {
                set.push(String::from_utf8_lossy(&row.record[index]).trim().to_owned());
            }
            if columns.contains_key(&Quantity::Time) {
                time.push(self.number(columns, row, Quantity::Time)?);
            }
            Ok(())
        })?;
        samples.tensions = (!tensions.is_empty()).then_some(tensions);
        samples.set = (!set.is_empty()).then_some(set);
        samples.time = (!time.is_empty()).then_some(time);
        Ok(Reading { samples, notices })
    }

    /// Reads the header, checks it, and hands over every row.
    fn rows(
        &self,
        notices: &mut Vec<String>,
        check: &dyn Fn(&Columns) -> Result<(), ReadError>,
        take: &mut dyn FnMut(&Columns, &Row<'_>) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        if self.text.trim().is_empty() {
            return Err(self.error("csv::empty", "the file is empty").with_help("the first line names the columns"));
        }
        let mut reader = ReaderBuilder::new().flexible(true).from_reader(self.text.as_bytes());
        let header = reader.byte_headers().map_err(|error| self.unreadable(&error))?.clone();
        let columns = self.columns(&header, notices)?;
        self.check_pose_columns(&columns)?;
        check(&columns)?;
        let mut record = ByteRecord::new();
        let mut count = 0;
        while reader.read_byte_record(&mut record).map_err(|error| self.unreadable(&error))? {
            let line = record.position().map_or(0, |position| position.line() as usize);
            let row = Row { record: &record, header: &header, line };
            if record.len() != header.len() {
                return Err(self.ragged(&row));
            }
            take(&columns, &row)?;
            count += 1;
        }
        if count == 0 {
            return Err(self.error("csv::no-rows", "the file has column names but no rows"));
        }
        Ok(())
    }

    fn columns(&self, header: &ByteRecord, notices: &mut Vec<String>) -> Result<Columns, ReadError> {
        let mut columns = Columns::new();
        let mut ignored = Vec::new();
        let row = Row { record: header, header, line: 1 };
        for (index, name) in header.iter().enumerate() {
            let name = String::from_utf8_lossy(name).trim().to_owned();
            let Column { quantity, factor } = match meaning(&name) {
                Ok(Some(column)) => column,
                Ok(None) => {
                    ignored.push(format!("`{name}`"));
                    continue;
                }
                Err(unknown) => {
                    let message = format!("column `{name}`: the unit `{}` is not known", unknown.unit);
                    return Err(self.at(&row, index, "csv::unknown-unit", message).with_help(unknown.help));
                }
            };
            if columns.insert(quantity, (index, factor)).is_some() {
                let message = format!("column `{name}` repeats a quantity that another column already gives");
                return Err(self.at(&row, index, "csv::repeated-column", message).with_help("remove one of the two"));
            }
        }
        if !ignored.is_empty() {
            notices.push(format!("{}: ignored columns {}", self.file_name, ignored.join(", ")));
        }
        Ok(columns)
    }

    fn check_pose_columns(&self, columns: &Columns) -> Result<(), ReadError> {
        let pattern = self.robot.motion_pattern;
        for axis in 0..pattern.translations() {
            self.require(columns, Quantity::Position(axis), ["x_m", "y_m", "z_m"][axis])?;
        }
        match pattern {
            MotionPattern::Planar => self.require(columns, Quantity::Angle, "angle_rad"),
            MotionPattern::Spatial if columns.contains_key(&Quantity::Euler(0)) => {
                (0..3).try_for_each(|k| self.require(columns, Quantity::Euler(k), ["rx_rad", "ry_rad", "rz_rad"][k]))
            }
            MotionPattern::Spatial => {
                (0..4).try_for_each(|k| self.require(columns, Quantity::Quaternion(k), ["qx", "qy", "qz", "qw"][k]))
            }
            _ => Ok(()),
        }
    }

    fn check_cables(&self, columns: &Columns) -> Result<(), ReadError> {
        let m = self.robot.cable_count();
        let lengths = columns.keys().filter(|quantity| matches!(quantity, Quantity::Length(_))).count();
        let contiguous = (0..lengths).all(|cable| columns.contains_key(&Quantity::Length(cable)));
        if lengths > 0 && lengths != m && contiguous {
            let message = format!("the data have {lengths} cables, robot \"{}\" has {m}", self.robot.name);
            return Err(self.header_error("csv::cable-count", message).with_help("is it the right robot file?"));
        }
        (0..m).try_for_each(|cable| {
            self.require(columns, Quantity::Length(cable), &format!("cable_length_m_{}", cable + 1))
        })?;
        let has_tensions = columns.keys().any(|quantity| matches!(quantity, Quantity::Tension(_)));
        if has_tensions {
            (0..m).try_for_each(|cable| {
                self.require(columns, Quantity::Tension(cable), &format!("tension_N_{}", cable + 1))
            })?;
        }
        Ok(())
    }

    fn require(&self, columns: &Columns, quantity: Quantity, name: &str) -> Result<(), ReadError> {
        if columns.contains_key(&quantity) {
            return Ok(());
        }
        let message = format!("the column `{name}` is missing");
        let pattern = self.robot.motion_pattern.name();
        let help = format!(
            "robot \"{}\" has motion pattern {pattern} and {} cables",
            self.robot.name,
            self.robot.cable_count()
        );
        Err(self.header_error("csv::missing-column", message).with_help(help))
    }

    fn pose(&self, columns: &Columns, row: &Row<'_>) -> Result<Pose, ReadError> {
        let pattern = self.robot.motion_pattern;
        let mut components = Vec::with_capacity(6);
        for axis in 0..pattern.translations() {
            components.push(self.number(columns, row, Quantity::Position(axis))?);
        }
        match pattern {
            MotionPattern::Planar => components.push(self.number(columns, row, Quantity::Angle)?),
            MotionPattern::Spatial if columns.contains_key(&Quantity::Euler(0)) => {
                for k in 0..3 {
                    components.push(self.number(columns, row, Quantity::Euler(k))?);
                }
            }
            MotionPattern::Spatial => components.extend([0.0; 3]),
            _ => {}
        }
        let place_of_mistake = |message: String| self.at(row, 0, "csv::pose", message);
        let pose = pattern.pose(self.robot.plane, &components).map_err(|error| place_of_mistake(error.to_string()))?;
        if pattern != MotionPattern::Spatial || columns.contains_key(&Quantity::Euler(0)) {
            return Ok(pose);
        }
        let mut xyzw = [0.0; 4];
        for (k, value) in xyzw.iter_mut().enumerate() {
            *value = self.number(columns, row, Quantity::Quaternion(k))?;
        }
        let Some(rotation) = Pose::rotation_from_xyzw(xyzw) else {
            let norm = xyzw.iter().map(|x| x * x).sum::<f64>().sqrt();
            let index = columns.get(&Quantity::Quaternion(0)).map_or(0, |column| column.0);
            let message = format!("the quaternion has norm {norm}; a rotation has norm 1 (within 1 %)");
            return Err(self
                .at(row, index, "csv::quaternion", message)
                .with_help("columns are qx, qy, qz, qw, scalar last"));
        };
        Ok(Pose { rotation, ..pose })
    }

    /// A finite number in SI units.
    fn number(&self, columns: &Columns, row: &Row<'_>, quantity: Quantity) -> Result<f64, ReadError> {
        let Some(&(index, factor)) = columns.get(&quantity) else {
            return Err(self.header_error("csv::missing-column", format!("a column for {quantity:?} is missing")));
        };
        let written = String::from_utf8_lossy(&row.record[index]);
        let column = String::from_utf8_lossy(&row.header[index]);
        let error = |message: String| self.at(row, index, "csv::not-a-number", message);
        match written.trim().parse::<f64>() {
            Ok(value) if value.is_finite() && value.abs() < 1e30 => Ok(value * factor),
            Ok(value) => Err(error(format!("column `{column}`: {value} is not a number to calculate with"))
                .with_help("remove the row, or write the number that was measured")),
            Err(_) if written.trim().is_empty() => {
                Err(error(format!("column `{column}` is empty here")).with_help("remove the row, or write the number"))
            }
            Err(_) => Err(error(format!("column `{column}`: `{}` is not a number", shortened(&written)))
                .with_help("numbers are written with a decimal point, without unit")),
        }
    }

    fn error(&self, code: &'static str, message: impl Into<String>) -> ReadError {
        ReadError::new(self.file_name, code, message)
    }

    fn header_error(&self, code: &'static str, message: impl Into<String>) -> ReadError {
        let first = self.text.lines().next().unwrap_or_default();
        self.error(code, message).at(Place::on_line(first, 1, 1, first.chars().count().max(1)))
    }

    /// An error at a field: the column counts characters of the line, as an editor does.
    fn at(&self, row: &Row<'_>, index: usize, code: &'static str, message: impl Into<String>) -> ReadError {
        let source = self.text.lines().nth(row.line.saturating_sub(1)).unwrap_or_default();
        // fields without quotes stand as they are read; with quotes the place is the best guess
        let width_of = |field: &[u8]| String::from_utf8_lossy(field).chars().count();
        let before: usize = row.record.iter().take(index).map(|field| width_of(field) + 1).sum();
        let width = row.record.get(index).map_or(1, width_of).max(1);
        self.error(code, message).at(Place::on_line(source, row.line, before + 1, width))
    }

    fn ragged(&self, row: &Row<'_>) -> ReadError {
        let (found, expected) = (row.record.len(), row.header.len());
        let message = format!("this row has {found} fields, the header names {expected} columns");
        self.at(row, found.min(expected).saturating_sub(1), "csv::ragged-row", message)
            .with_help("is a comma missing, or one too many, or a decimal comma?")
    }

    fn unreadable(&self, error: &csv::Error) -> ReadError {
        let place = error.position().map(|position| {
            let line = position.line() as usize;
            Place::on_line(self.text.lines().nth(line.saturating_sub(1)).unwrap_or_default(), line, 1, 1)
        });
        let error = self.error("csv::unreadable", error.to_string());
        place.map_or(error.clone(), |place| error.at(place))
    }
}

fn shortened(text: &str) -> String {
    text.trim().chars().take(40).collect()
}
