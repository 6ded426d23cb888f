//! Reader of measurement CSV files; every mistake with its line and column.

use std::collections::BTreeMap;

use csv::{ByteRecord, ReaderBuilder};

use super::Samples;
use super::columns::{Column, Quantity, meaning};
use super::header_mistakes;
use super::magnitudes::{self, Finding};
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
        let mut motor_angles = Vec::new();
        let (mut angles, mut too_far) = (Vec::new(), None);
        let columns = self.rows(&mut notices, &|columns| self.check_cables(columns), &mut |columns, row| {
            samples.poses.push(self.pose(columns, row)?);
            angles.extend(self.angles(columns, row)?);
            too_far = too_far.take().or_else(|| self.too_far(columns, row));
            for cable in 0..m {
                match by_angle(columns) {
                    true => motor_angles.push(self.number(columns, row, Quantity::MotorAngle(cable))?),
                    false => samples.lengths.push(self.number(columns, row, Quantity::Length(cable))?),
                }
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
        let has_motor_angles = columns.keys().any(|quantity| matches!(quantity, Quantity::MotorAngle(_)));
        if has_motor_angles && motor_angles.is_empty() {
            notices.push(format!("{}: the motor angles are not needed, since the lengths are given", self.file_name));
        }
        if !motor_angles.is_empty() {
            samples.lengths = vec![f64::NAN; motor_angles.len()];
            samples.motor_angles = Some(motor_angles);
            return too_far.map_or(Ok(Reading { samples, notices }), Err);
        }
        match magnitudes::judge(self.robot, &samples, &angles) {
            Finding::Wrong { quantity, message, help } => {
                return Err(self.column_error(&columns, quantity, message).with_help(help));
            }
            Finding::Doubtful(words) => notices.push(format!("{}: {words}", self.file_name)),
            Finding::Plausible => {}
        }
        too_far.map_or(Ok(Reading { samples, notices }), Err)
    }

    /// Reads the header, checks it, hands over every row, and returns the columns.
    fn rows(
        &self,
        notices: &mut Vec<String>,
        check: &dyn Fn(&Columns) -> Result<(), ReadError>,
        take: &mut dyn FnMut(&Columns, &Row<'_>) -> Result<(), ReadError>,
    ) -> Result<Columns, ReadError> {
        if self.text.trim().is_empty() {
            return Err(self.error("csv::empty", "the file is empty").with_help("the first line names the columns"));
        }
        if let Some(mistake) = header_mistakes::of_first_line(self.first_line()) {
            let place = Place::on_line(self.first_line(), 1, mistake.column, mistake.width);
            return Err(self.error("csv::separator", mistake.message).at(place).with_help(mistake.help));
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
        Ok(columns)
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
                    let unnamed = || format!("{} (without a name)", index + 1);
                    ignored.push(if name.is_empty() { unnamed() } else { format!("`{name}`") });
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
        let (build, name): (fn(usize) -> Quantity, _) = match by_angle(columns) {
            true => (Quantity::MotorAngle, "motor_angle_rad"),
            false => (Quantity::Length, "cable_length_m"),
        };
        let is_same = |quantity: &Quantity| std::mem::discriminant(quantity) == std::mem::discriminant(&build(0));
        let lengths = columns.keys().filter(|quantity| is_same(quantity)).count();
        let contiguous = (0..lengths).all(|cable| columns.contains_key(&build(cable)));
        if lengths > 0 && lengths != m && contiguous {
            let message = format!("the data have {lengths} cables, robot \"{}\" has {m}", self.robot.name);
            return Err(self.header_error("csv::cable-count", message).with_help("is it the right robot file?"));
        }
        (0..m).try_for_each(|cable| self.require(columns, build(cable), &format!("{name}_{}", cable + 1)))?;
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
        Err(self.missing_column(name))
    }

    /// The error for a column that is not there, at the column that was probably meant to be it.
    fn missing_column(&self, name: &str) -> ReadError {
        let code = "csv::missing-column";
        let fields: Vec<&str> = self.first_line().split(',').collect();
        let names: Vec<&str> = fields.iter().map(|field| field.trim().trim_matches('"')).collect();
        let unclaimed: Vec<&str> = names.iter().copied().filter(|name| matches!(meaning(name), Ok(None))).collect();
        if let Some(meant) = header_mistakes::probably_meant(name, &unclaimed) {
            let index = names.iter().position(|name| *name == meant).unwrap_or_default();
            let column: usize = fields.iter().take(index).map(|field| field.chars().count() + 1).sum::<usize>() + 1;
            let place = Place::on_line(self.first_line(), 1, column, fields[index].chars().count().max(1));
            return self
                .error(code, format!("the column `{name}` is missing; is it this one, `{meant}`?"))
                .at(place)
                .with_help(format!(
                    "name it `{name}`; names are in small letters with the unit at its place (also accepted: mm, deg, kN)"
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

    /// The columns that data of this robot must have, for people.
    fn needed_columns(&self) -> String {
        let pattern = self.robot.motion_pattern;
        let rotation = match pattern {
            MotionPattern::Planar => ", angle_rad",
            MotionPattern::Spatial => ", qx, qy, qz, qw (or rx_rad, ry_rad, rz_rad)",
            _ => "",
        };
        let positions = ["x_m", "y_m", "z_m"][..pattern.translations()].join(", ");
        format!("{positions}{rotation}, cable_length_m_1 … cable_length_m_{}", self.robot.cable_count())
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

    /// The angles of a row as the file gives them (rad), which a pose knows only within a turn.
    fn angles(&self, columns: &Columns, row: &Row<'_>) -> Result<Option<[f64; 3]>, ReadError> {
        match self.robot.motion_pattern {
            MotionPattern::Planar => Ok(Some([self.number(columns, row, Quantity::Angle)?, 0.0, 0.0])),
            MotionPattern::Spatial if columns.contains_key(&Quantity::Euler(0)) => {
                let angle = |k| self.number(columns, row, Quantity::Euler(k));
                Ok(Some([angle(0)?, angle(1)?, angle(2)?]))
            }
            _ => Ok(None),
        }
    }

    /// The error for the first length or coordinate of a row that is beyond all measure of the robot.
    fn too_far(&self, columns: &Columns, row: &Row<'_>) -> Option<ReadError> {
        let farthest = magnitudes::farthest(self.robot);
        let lengths = (0..self.robot.cable_count()).map(Quantity::Length);
        let positions = (0..self.robot.motion_pattern.translations()).map(Quantity::Position);
        positions.chain(lengths).find_map(|quantity| {
            let value = self.number(columns, row, quantity).ok().filter(|value| value.abs() > farthest)?;
            let index = columns.get(&quantity)?.0;
            let column = String::from_utf8_lossy(&row.header[index]).trim().to_owned();
            let message = format!("column `{column}`: {value} m is more than 50 times the size of the robot");
            let help = "is this value in another unit than its column, or is its decimal point lost?";
            Some(self.at(row, index, "csv::magnitude", message).with_help(help))
        })
    }

    /// An error about the numbers of a column, at its name.
    fn column_error(&self, columns: &Columns, quantity: Quantity, message: String) -> ReadError {
        let index = columns.get(&quantity).map_or(0, |column| column.0);
        let fields: Vec<&str> = self.first_line().split(',').collect();
        let column: usize = fields.iter().take(index).map(|field| field.chars().count() + 1).sum::<usize>() + 1;
        let width = fields.get(index).map_or(1, |field| field.chars().count()).max(1);
        self.error("csv::magnitude", message).at(Place::on_line(self.first_line(), 1, column, width))
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
                .with_help(help_for_text(&written, row))),
        }
    }

    fn error(&self, code: &'static str, message: impl Into<String>) -> ReadError {
        ReadError::new(self.file_name, code, message)
    }

    fn first_line(&self) -> &str {
        self.text.lines().next().unwrap_or_default()
    }

    fn header_error(&self, code: &'static str, message: impl Into<String>) -> ReadError {
        let first = self.first_line();
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

    fn unreadable(&self, error: &csv::Error) -> ReadError {
        let place = error.position().map(|position| {
            let line = position.line() as usize;
            Place::on_line(self.text.lines().nth(line.saturating_sub(1)).unwrap_or_default(), line, 1, 1)
        });
        let error = self.error("csv::unreadable", error.to_string());
        place.map_or(error.clone(), |place| error.at(place))
    }
}

/// How to mend a field that is not a number.
fn help_for_text(written: &str, row: &Row<'_>) -> &'static str {
    let is_text = |field: &[u8]| !field.iter().any(u8::is_ascii_digit);
    if row.line == 2 && row.record.iter().all(is_text) {
        return "is the second line one of units? remove it: the unit is part of the column's name";
    }
    match written.trim().replacen(',', ".", 1).parse::<f64>() {
        Ok(_) => "numbers are written with a decimal point, not with a comma",
        Err(_) => "numbers are written with a decimal point, without unit",
    }
}

/// True for a file that gives motor angles in place of lengths.
fn by_angle(columns: &Columns) -> bool {
    let has = |wanted: fn(&Quantity) -> bool| columns.keys().any(wanted);
    has(|quantity| matches!(quantity, Quantity::MotorAngle(_)))
        && !has(|quantity| matches!(quantity, Quantity::Length(_)))
}

fn shortened(text: &str) -> String {
    text.trim().chars().take(40).collect()
}
